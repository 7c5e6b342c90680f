// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/rhythm_config.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "names/joint_dynamics.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

template <std::size_t N>
std::string OneOf(const std::array<std::string_view, N>& names) {
  std::string text;
  for (const std::string_view name : names) {
    text += (text.empty() ? "\"" : " or \"") + std::string(name) + "\"";
  }
  return text;
}

[[noreturn]] void Fail(const char* key, const std::string& value, const std::string& fix) {
  throw InputError(std::string(key) + " is \"" + ShortText(value) + "\", expected " + fix);
}

// Returns the value of a word; nothing if none is given.
template <HasWords Enumeration>
std::optional<Enumeration> Chosen(const char* key, const std::string& word) {
  const std::optional<Enumeration> value = FromName<Enumeration>(word);
  if (!value && !word.empty()) {
    Fail(key, word, OneOf(WordsOf(Enumeration{})));
  }
  return value;
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

}  // namespace

RhythmConfig ParseRhythmConfig(const RhythmConfigText& text) {
  RhythmChoice rhythm{Chosen<Interpolation>(kInterpolationKey, text.interpolation),
                      Chosen<Closure>(kClosureKey, text.closure),
                      Chosen<Range>(kRangeKey, text.range)};
  std::array<double, kCoordinateCount> stiffness{};
  stiffness.fill(kDefaultStiffness_N_m_per_rad);
  if (!text.stiffness.empty()) {
    stiffness = ParseStiffness(text.stiffness);
  }
  const Side side = Chosen<Side>(kSideKey, text.side).value_or(Side::kRight);
  double translation_stiffness_N_per_m = kLeadingTranslation.stiffness_N_per_m;
  if (!text.translation_stiffness.empty()) {
    const std::optional<double> number = FiniteNumber(text.translation_stiffness);
    if (!number || *number <= 0) {
      Fail(kTranslationStiffnessKey, text.translation_stiffness, "a positive number of N/m");
    }
    translation_stiffness_N_per_m = *number;
  }
  if (!text.table.empty()) {
    rhythm.table = TableFromWordOrLine(text.table, "config key \"" + std::string(kTableKey) + "\"");
  }
  const AxialFrom axial_from =
      Chosen<AxialFrom>(kAxialFromKey, text.axial_from).value_or(AxialFrom::kRhythm);
  return {std::move(rhythm), stiffness, side, translation_stiffness_N_per_m, axial_from};
}

}  // namespace girdle
