// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Views of mjModel and mjData in any known version of MuJoCo, with the names of their members.
///
/// A view is made at every call of the engine, because the caller may pass another copy of the
/// model each time. It is valid as long as the struct behind it.
#pragma once

#include <mujoco/mujoco.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "plugin/engine_layout.h"

namespace girdle {

/// Returns the value of type T at `offset` bytes from `base`.
template <typename T>
[[nodiscard]] T ReadMember(const void* base, std::size_t offset) noexcept {
  T value;
  std::memcpy(&value, static_cast<const char*>(base) + offset, sizeof(T));
  return value;
}

/// Returns the pointer to elements of type T that is stored at `offset` bytes from `base`.
template <typename T>
[[nodiscard]] T* ReadPointer(const void* base, std::size_t offset) noexcept {
  return ReadMember<T*>(base, offset);
}

/// Returns the count that is stored at `offset` bytes from the beginning of an mjModel.
[[nodiscard]] inline std::int64_t ReadCount(const mjModel& model, const EngineLayout& engine,
                                            std::size_t offset) noexcept {
  return engine.count_size == sizeof(std::int32_t) ? ReadMember<std::int32_t>(&model, offset)
                                                   : ReadMember<std::int64_t>(&model, offset);
}

/// View of mjModel, read only. Members are those of MuJoCo 4.
struct ModelView {
  const EngineLayout* engine;
#define GIRDLE_MODEL_COUNT(member) std::int64_t member;
#define GIRDLE_MODEL_FLAGS(member, name) int name;
#define GIRDLE_MODEL_ARRAY(type, member) const type* member;
#include "plugin/engine_members.inc"

  /// Index of an actuator's first control, and of its first force.
  [[nodiscard]] int ControlOf(int actuator) const noexcept {
    return actuator_ctrladr == nullptr ? actuator : actuator_ctrladr[actuator];
  }
  [[nodiscard]] int OutputOf(int actuator) const noexcept {
    return actuator_outadr == nullptr ? actuator : actuator_outadr[actuator];
  }
  /// Returns whether option/flag disables the feature of `flag`, which is a constant of the layout.
  [[nodiscard]] bool Disables(int flag) const noexcept { return (disableflags & flag) != 0; }
};

/// View of the further members that only init needs, so no step reads them. Members are those of
/// MuJoCo 4.
struct CompiledView {
  ModelView model;
#define GIRDLE_INIT_VALUE(type, member, name) type name;
#define GIRDLE_INIT_COUNT(member) std::int64_t member;
#define GIRDLE_INIT_ARRAY(type, member) const type* member;
#include "plugin/engine_members.inc"
};

/// View of mjData, to read and to write.
struct DataView {
#define GIRDLE_DATA_ARRAY(type, member) type* member;
#include "plugin/engine_members.inc"
};

[[nodiscard]] inline ModelView ViewOf(const mjModel& model, const EngineLayout& engine) noexcept {
  ModelView view{};
  view.engine = &engine;
#define GIRDLE_MODEL_COUNT(member) view.member = ReadCount(model, engine, engine.member);
#define GIRDLE_MODEL_FLAGS(member, name) view.name = ReadMember<int>(&model, engine.name);
#define GIRDLE_MODEL_ARRAY(type, member) \
  view.member = ReadPointer<const type>(&model, engine.member);
#define GIRDLE_MODEL_OPTIONAL_ARRAY(type, member)                 \
  if (engine.member != kNoMember) {                               \
    view.member = ReadPointer<const type>(&model, engine.member); \
  }
#include "plugin/engine_members.inc"
  return view;
}

[[nodiscard]] CompiledView CompiledViewOf(const mjModel& model,
                                          const EngineLayout& engine) noexcept;

[[nodiscard]] inline DataView ViewOf(mjData& data, const EngineLayout& engine) noexcept {
  DataView view{};
#define GIRDLE_DATA_ARRAY(type, member) view.member = ReadPointer<type>(&data, engine.member);
#include "plugin/engine_members.inc"
  return view;
}

/// Returns whether the engine has the layout of the version that it names. This is so if all arrays
/// of both structs are inside MuJoCo's buffers and if the engine says that an instance of the
/// plugin has the name `name`. A null `name` is not compared.
[[nodiscard]] bool LayoutFits(const mjModel& model, const mjData& data, const EngineLayout& engine,
                              int instance, const char* name) noexcept;

}  // namespace girdle
