// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/near_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace girdle {
namespace {

constexpr std::array<std::string_view, 11> kUnits = {
    "radians", "radian", "degrees", "degree", "seconds", "degs", "rads", "deg", "rad", "sec", "s"};

// Letters and digits alone, letters small.
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

// A plain name without the unit that it ends in.
std::string_view Stem(std::string_view plain) {
  for (const std::string_view unit : kUnits) {
    if (plain.size() > unit.size() && plain.ends_with(unit)) {
      return plain.substr(0, plain.size() - unit.size());
    }
  }
  return plain;
}

}  // namespace

std::string PlainStem(std::string_view name) {
  const std::string plain = Plain(name);
  return std::string(Stem(plain));
}

bool IsOneSlipAway(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) {
    std::swap(a, b);
  }
  const auto [at_a, at_b] = std::mismatch(a.begin(), a.end(), b.begin());
  const auto first = static_cast<std::size_t>(at_a - a.begin());
  if (first == a.size()) {
    return b.size() - a.size() <= 1;
  }
  if (a.size() != b.size()) {
    return a.substr(first) == b.substr(first + 1);
  }
  const bool is_wrong_letter = a.substr(first + 1) == b.substr(first + 1);
  const bool is_exchange = first + 1 < a.size() && a[first] == b[first + 1] &&
                           a[first + 1] == b[first] && a.substr(first + 2) == b.substr(first + 2);
  return is_wrong_letter || is_exchange;
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
