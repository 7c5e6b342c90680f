// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/near_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace girdle {
namespace {

constexpr std::array<std::string_view, 11> kUnits = {
    "radians", "radian", "degrees", "degree", "seconds", "degs", "rads", "deg", "rad", "sec", "s"};

// Returns the letters and digits of a name, with letters in lower case.
std::string Plain(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') {
      plain += static_cast<char>(c - 'A' + 'a');
    } else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      plain += c;
    }
  }
  return plain;
}

// Returns a plain name without the unit that it ends in.
std::string_view Stem(std::string_view plain) {
  for (const std::string_view unit : kUnits) {
    if (plain.size() > unit.size() && plain.ends_with(unit)) {
      return plain.substr(0, plain.size() - unit.size());
    }
  }
  return plain;
}

// Returns the least number of letters that are wrong, missing, extra or exchanged with a neighbour
// (optimal string alignment).
std::size_t SlipsBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1,
                         last[j - 1] + (a[i - 1] == b[j - 1] ? std::size_t{0} : std::size_t{1})});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

// Words longer than this are longer than any known word. They are no slips and are not compared.
constexpr std::size_t kLongestWord = 64;

// Returns the distance of a plain typed word from a plain known one; nothing if it is no slip.
std::optional<std::size_t> DistanceOfSlip(std::string_view typed, std::string_view known) {
  constexpr std::size_t kShortestBeginning = 2;
  constexpr std::size_t kLettersForTwoSlips = 8;
  if (typed.size() < kShortestBeginning || typed.size() > kLongestWord) {
    return std::nullopt;
  }
  const std::size_t slips = SlipsBetween(typed, known);
  if (slips <= (known.size() >= kLettersForTwoSlips ? std::size_t{2} : std::size_t{1}) &&
      slips < known.size()) {
    return slips;
  }
  const bool is_beginning =
      known.starts_with(typed) || (known.size() >= kShortestBeginning && typed.starts_with(known));
  // A beginning counts as farther than any slip. Two words with one beginning are equally far.
  return is_beginning ? std::optional(kLongestWord) : std::nullopt;
}

}  // namespace

std::optional<std::string_view> NearestWord(std::string_view typed,
                                            std::span<const std::string_view> words) {
  const std::string plain = Plain(typed.substr(0, 2 * kLongestWord));
  std::optional<std::string_view> nearest;
  std::size_t least = 0;
  bool are_two = false;
  for (const std::string_view word : words) {
    const std::optional<std::size_t> slips = DistanceOfSlip(plain, Plain(word));
    if (slips && (!nearest || *slips <= least)) {
      are_two = nearest && *slips == least;
      nearest = word;
      least = *slips;
    }
  }
  return are_two ? std::nullopt : nearest;
}

std::string DidYouMean(std::string_view typed, std::span<const std::string_view> words) {
  const std::optional<std::string_view> meant = NearestWord(typed, words);
  return meant ? "Did you mean '" + std::string(*meant) + "'? " : std::string();
}

std::string PlainStem(std::string_view name) {
  const std::string plain = Plain(name);
  return std::string(Stem(plain));
}

bool IsOneSlipAway(std::string_view a, std::string_view b) {
  return std::max(a.size(), b.size()) <= kLongestWord && SlipsBetween(a, b) <= 1;
}

bool IsNearly(std::string_view name, std::string_view known) {
  if (name == known) {
    return false;
  }
  const std::string plain = Plain(name);
  const std::string plain_known = Plain(known);
  return Stem(plain) == Stem(plain_known) ||
         (plain_known.size() >= kShortestToSlip && IsOneSlipAway(plain, plain_known));
}

}  // namespace girdle
