// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_views.h"

namespace girdle {
namespace {

// Whether the pointer at `offset` points into the buffer that holds all arrays of the struct. The
// pointer of an array without elements may be the buffer's end or null.
bool LeadsIntoBuffer(const void* base, const EngineLayout::Buffer& buffer,
                     std::uint32_t offset) noexcept {
  const auto begin = ReadMember<std::uintptr_t>(base, buffer.begin);
  const auto size = ReadMember<std::uint64_t>(base, buffer.size);
  const auto at = offset == kNoMember ? 0 : ReadMember<std::uintptr_t>(base, offset);
  return at == 0 || (begin != 0 && at >= begin && at - begin <= size);
}

}  // namespace

CompiledView CompiledViewOf(const mjModel& model, const EngineLayout& engine) noexcept {
  CompiledView view{};
  view.model = ViewOf(model, engine);
#define GIRDLE_INIT_VALUE(type, member, name) view.name = ReadMember<type>(&model, engine.name);
#define GIRDLE_INIT_COUNT(member) view.member = ReadCount(model, engine, engine.member);
#define GIRDLE_INIT_ARRAY(type, member) \
  view.member = ReadPointer<const type>(&model, engine.member);
#define GIRDLE_INIT_OPTIONAL_ARRAY(type, member)                  \
  if (engine.member != kNoMember) {                               \
    view.member = ReadPointer<const type>(&model, engine.member); \
  }
#include "plugin/engine_members.inc"
  return view;
}

bool LayoutFits(const mjModel& model, const mjData& data, const EngineLayout& engine, int instance,
                const char* name) noexcept {
  bool fits = true;
#define GIRDLE_MODEL_ARRAY(type, member) \
  fits = fits && LeadsIntoBuffer(&model, engine.model_buffer, engine.member);
#define GIRDLE_INIT_ARRAY(type, member) \
  fits = fits && LeadsIntoBuffer(&model, engine.model_buffer, engine.member);
#define GIRDLE_DATA_ARRAY(type, member) \
  fits = fits && LeadsIntoBuffer(&data, engine.data_buffer, engine.member);
#include "plugin/engine_members.inc"
  if (!fits) {
    return false;
  }
  // If a member before them was added or removed, the names are wrong.
  const ModelView view = ViewOf(model, engine);
  return name == nullptr || name == view.names + view.name_pluginadr[instance];
}

}  // namespace girdle
