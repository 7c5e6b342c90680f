// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/rhythm_config.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "rhythm_tables/built_in_tables.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Of all nine servos if the configuration does not say.
constexpr double kDefaultStiffness_N_m_per_rad = 500;
// Of the servos of the scapula's place, if there are any.
constexpr double kDefaultTranslationStiffness_N_per_m = 10000;

template <std::size_t N>
std::string OneOf(const std::array<std::string_view, N>& names) {
  std::string text;
  for (const std::string_view name : names) {
    text += (text.empty() ? "\"" : " or \"") + std::string(name) + "\"";
  }
  return text;
}

[[noreturn]] void Fail(const char* key, const std::string& value, const std::string& fix) {
  throw InputError(std::string(key) + " is \"" + value + "\", expected " + fix);
}

// Sets `chosen` to the value of a word, if one is given.
template <typename Chosen, typename FromName, std::size_t N>
void Choose(const char* key, const std::string& word, const FromName& from_name,
            const std::array<std::string_view, N>& known, Chosen& chosen) {
  if (word.empty()) {
    return;
  }
  const auto value = from_name(word);
  if (!value) {
    Fail(key, word, OneOf(known));
  }
  chosen = *value;
}

RhythmTable ParseTable(const std::string& text, Interpolation interpolation) {
  if (text.empty()) {
    return BuiltInRhythmTable(DefaultTable(interpolation));
  }
  if (const auto built_in = BuiltInTableFromName(text)) {
    return BuiltInRhythmTable(*built_in);
  }
  return RhythmTableFromLine(text, "config key \"" + std::string(kTableKey) + "\"");
}

std::array<double, kCoordinateCount> ParseStiffness(const std::string& text) {
  constexpr const char* kExpected =
      "one positive number of N m/rad, or nine in the order sc, ac, gh";
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::optional<double> number = FiniteNumber(word);
    if (!number || *number < 0) {
      Fail(kStiffnessKey, text, kExpected);
    }
    numbers.push_back(*number);
  }
  std::array<double, kCoordinateCount> stiffness{};
  if (numbers.size() == 1 && numbers.front() > 0) {
    stiffness.fill(numbers.front());
  } else if (numbers.size() == kCoordinateCount) {
    std::copy(numbers.begin(), numbers.end(), stiffness.begin());
  } else {
    Fail(kStiffnessKey, text, kExpected);
  }
  return stiffness;
}

std::optional<Side> SideFromName(std::string_view name) {
  const auto found = std::find(kSideNames.begin(), kSideNames.end(), name);
  return found == kSideNames.end() ? std::nullopt
                                   : std::optional(static_cast<Side>(found - kSideNames.begin()));
}

}  // namespace

RhythmConfig ParseRhythmConfig(const RhythmConfigText& text) {
  RhythmOptions options;
  Choose(kInterpolationKey, text.interpolation, InterpolationFromName, kInterpolationNames,
         options.interpolation);
  Choose(kClosureKey, text.closure, ClosureFromName, kClosureNames, options.closure);
  Choose(kRangeKey, text.range, RangeFromName, kRangeNames, options.range);
  std::array<double, kCoordinateCount> stiffness{};
  stiffness.fill(kDefaultStiffness_N_m_per_rad);
  if (!text.stiffness.empty()) {
    stiffness = ParseStiffness(text.stiffness);
  }
  Side side = Side::kRight;
  Choose(kSideKey, text.side, SideFromName, kSideNames, side);
  double translation_stiffness_N_per_m = kDefaultTranslationStiffness_N_per_m;
  if (!text.translation_stiffness.empty()) {
    const std::optional<double> number = FiniteNumber(text.translation_stiffness);
    if (!number || *number <= 0) {
      Fail(kTranslationStiffnessKey, text.translation_stiffness, "a positive number of N/m");
    }
    translation_stiffness_N_per_m = *number;
  }
  return {ParseTable(text.table, options.interpolation), options, stiffness, side,
          translation_stiffness_N_per_m};
}

ShoulderRhythm ConfiguredRhythm(const RhythmConfig& config, const JointRanges& ranges) {
  try {
    return ShoulderRhythm(config.table, config.options, ranges);
  } catch (const std::invalid_argument& error) {
    throw InputError("config: " + std::string(error.what()));
  }
}

}  // namespace girdle
