// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads the texts of a plugin's configuration, one in each line, and makes the rhythm.

#include <sstream>

#include "anatomy/built_in_anatomy.h"
#include "reading.h"
#include "rhythm_tables/rhythm_config.h"

namespace girdle::fuzz {
namespace {

RhythmConfigText ConfigText(const std::string& text) {
  RhythmConfigText config;
  std::istringstream in(text);
  for (std::string* const value :
       {&config.interpolation, &config.closure, &config.range, &config.stiffness, &config.side,
        &config.translation_stiffness, &config.axial_from, &config.table}) {
    std::getline(in, *value);
  }
  return config;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const JointRanges kRanges = BuiltInAnatomy().ranges;
  const auto config = ResultOf([&] { return ParseRhythmConfig(ConfigText(TextOf(bytes, size))); });
  if (!config) {
    return 0;
  }
  for (const double stiffness : config->stiffness_N_m_per_rad) {
    Expect(stiffness >= 0, "no stiffness is negative");
  }
  static_cast<void>(ResultOf([&] { return MakeRhythm(Resolve(config->rhythm), kRanges); }));
  return 0;
}

}  // namespace girdle::fuzz
