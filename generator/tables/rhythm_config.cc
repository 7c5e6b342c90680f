// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "tables/rhythm_config.h"

#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "kinematics/model_names.h"
#include "tables/built_in.h"
#include "tables/number_text.h"
#include "tables/rhythm_table_csv.h"

namespace girdle {
namespace {

// Of all nine servos if the configuration does not say.
constexpr double kDefaultStiffness_N_m_per_rad = 500;

template <std::size_t N>
std::string OneOf(const std::array<std::string_view, N>& names) {
  std::string text;
  for (const std::string_view name : names) {
    text += (text.empty() ? "\"" : " or \"") + std::string(name) + "\"";
  }
  return text;
}

[[noreturn]] void Fail(const char* key, const std::string& value, const std::string& fix) {
  throw std::runtime_error(std::string(key) + " is \"" + value + "\", expected " + fix);
}

std::array<double, kCoordinateCount> ParseStiffness(const std::string& text) {
  constexpr const char* kExpected =
      "one positive number of N m/rad, or nine in the order sc, ac, gh";
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::optional<double> number = FiniteNumber(word);
    if (!number || *number <= 0) {
      Fail(kStiffnessKey, text, kExpected);
    }
    numbers.push_back(*number);
  }
  std::array<double, kCoordinateCount> stiffness{};
  if (numbers.size() == 1) {
    stiffness.fill(numbers.front());
  } else if (numbers.size() == kCoordinateCount) {
    std::copy(numbers.begin(), numbers.end(), stiffness.begin());
  } else {
    Fail(kStiffnessKey, text, kExpected);
  }
  return stiffness;
}

}  // namespace

RhythmConfig ParseRhythmConfig(const RhythmConfigText& text) {
  RhythmOptions options;
  if (!text.interpolation.empty()) {
    const auto interpolation = InterpolationFromName(text.interpolation);
    if (!interpolation) {
      Fail(kInterpolationKey, text.interpolation, OneOf(kInterpolationNames));
    }
    options.interpolation = *interpolation;
  }
  if (!text.closure.empty()) {
    const auto closure = ClosureFromName(text.closure);
    if (!closure) {
      Fail(kClosureKey, text.closure, OneOf(kClosureNames));
    }
    options.closure = *closure;
  }
  RhythmTable table =
      text.table.empty()
          ? BuiltInRhythmTable()
          : RhythmTableFromLine(text.table, "config key \"" + std::string(kTableKey) + "\"");
  std::array<double, kCoordinateCount> stiffness{};
  stiffness.fill(kDefaultStiffness_N_m_per_rad);
  if (!text.stiffness.empty()) {
    stiffness = ParseStiffness(text.stiffness);
  }
  try {
    return {ShoulderRhythm(std::move(table), options), stiffness};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("config key \"" + std::string(kTableKey) + "\": " + error.what());
  }
}

}  // namespace girdle
