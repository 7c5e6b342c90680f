// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Where MuJoCo's structs have the members that the plugin touches, for each version of MuJoCo.
///
/// One binary serves all of them, although members move at nearly every release: element types and
/// meanings stay, and a table has the offsets. scripts/engine_layouts makes it from the headers of
/// each version.
#pragma once

#include <cstdint>
#include <string>

namespace girdle {

/// The structs of one version. Offsets are in bytes from the struct's begin.
struct EngineLayout {
  int version;            ///< as mj_version gives it: 330 for 3.3.0, 3010000 for 3.10.0
  int count_size;         ///< of a count in mjModel [bytes], 4 or 8
  struct Buffer {         ///< where all arrays of a struct lie
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

/// Stands for the offset of a member that a version does not have. Before 3.11 there are no
/// actuator_ctrladr and actuator_outadr: actuator, control and force then have one number. Earlier
/// ones have no jnt_stiffnesspoly and dof_dampingpoly: spring and damper are then linear.
inline constexpr std::uint32_t kNoMember = 0xffffffff;

/// Returns the layout of the version that mj_version gives as `version`, or null if it is not
/// known.
[[nodiscard]] const EngineLayout* FindEngineLayout(int version) noexcept;

/// Returns the versions that are known, for a message: "3.2.7 to 4.0.1".
[[nodiscard]] std::string KnownEngineVersions();

/// Returns "4.0.1" for a number of mj_version.
[[nodiscard]] std::string EngineVersionText(int version);

}  // namespace girdle
