// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_layout.h"

#include <algorithm>
#include <iterator>

namespace girdle {
namespace {

// In ascending order of versions.
constexpr EngineLayout kLayouts[] = {
#include "plugin/engine_layouts.inc"
};

}  // namespace

const EngineLayout* FindEngineLayout(int version) noexcept {
  const auto* const found =
      std::find_if(std::begin(kLayouts), std::end(kLayouts),
                   [version](const EngineLayout& layout) { return layout.version == version; });
  return found == std::end(kLayouts) ? nullptr : found;
}

std::string KnownEngineVersions() {
  return EngineVersionText(std::begin(kLayouts)->version) + " to " +
         EngineVersionText(std::prev(std::end(kLayouts))->version);
}

std::string EngineVersionText(int version) {
  // Versions before 3.4 have three digits.
  const int base = version < 1000 ? 10 : 1000;
  return std::to_string(version / (base * base)) + "." + std::to_string(version / base % base) +
         "." + std::to_string(version % base);
}

}  // namespace girdle
