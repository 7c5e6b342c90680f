// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Offsets of the members of MuJoCo's structs that the plugin uses, for each version of MuJoCo.
///
/// One binary serves all versions, although members move at nearly every release. Element types and
/// meanings do not change, and a table contains the offsets. scripts/engine_layouts makes the table
/// from the headers of each version.
/// each version.
#pragma once

#include <cstdint>
#include <string>

namespace girdle {

/// The structs of one version. Offsets are in bytes from the beginning of the struct.
struct EngineLayout {
  int version;            ///< number of mj_version: 330 for 3.3.0, 3010000 for 3.10.0
  int count_size;         ///< of a count in mjModel [bytes], 4 or 8
  struct Buffer {         ///< the memory of all arrays of a struct
    std::uint32_t begin;  ///< offset of the pointer to it
    std::uint32_t size;   ///< offset of its size in bytes, which has 64 bits
  };
  Buffer model_buffer;
  Buffer data_buffer;

#define GIRDLE_MODEL_COUNT(member) std::uint32_t member;
#define GIRDLE_MODEL_FLAGS(member, name) std::uint32_t name;
#define GIRDLE_MODEL_ARRAY(type, member) std::uint32_t member;
#define GIRDLE_INIT_VALUE(type, member, name) std::uint32_t name;
#define GIRDLE_INIT_COUNT(member) std::uint32_t member;
#define GIRDLE_INIT_ARRAY(type, member) std::uint32_t member;
#define GIRDLE_DATA_ARRAY(type, member) std::uint32_t member;
#define GIRDLE_CONSTANT(enumerator, name) int name;
#include "plugin/engine_members.inc"
};

/// The offset of a member that a version does not have. Versions before 3.11 do not have
/// actuator_ctrladr and actuator_outadr: there actuator, control and force have the same index.
/// Still earlier ones do not have jnt_stiffnesspoly and dof_dampingpoly: there springs and dampers
/// are linear.
inline constexpr std::uint32_t kNoMember = 0xffffffff;

/// Returns the layout of a version, given as the number of mj_version, or null if it is unknown.
[[nodiscard]] const EngineLayout* FindEngineLayout(int version) noexcept;

/// Returns the known versions for a message: "3.2.7 to 4.0.1".
[[nodiscard]] std::string KnownEngineVersions();

/// Returns the text of a number of mj_version, for example "4.0.1".
[[nodiscard]] std::string EngineVersionText(int version);

}  // namespace girdle
