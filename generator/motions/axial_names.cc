// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/axial_names.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "text/near_names.h"

namespace girdle {
namespace {

// Words that say a turn about the long axis; ir and er are internal and external rotation, gamma is
// ISB's letter.
constexpr auto kTurns = std::to_array<std::string_view>(
    {"axial", "rotation", "rot", "twist", "thirdangle", "gamma", "ir", "er"});

// Words that stand beside them without another meaning.
constexpr auto kBeside = std::to_array<std::string_view>(
    {"internal",     "external", "int",      "ext",     "inward", "outward",  "medial", "lateral",
     "endo",         "exo",      "humeral",  "humerus", "humero", "thoracic", "ht",     "th",
     "upper",        "arm",      "shoulder", "right",   "left",   "r",        "l",      "long",
     "longitudinal", "axis",     "isb",      "angle",   "turn",   "measured"});

// How many letters a word has, and how many if one slipped.
std::array<std::size_t, 3> SizesOfSlips(std::string_view word) {
  return {word.size() - 1, word.size(), word.size() + 1};
}

// Whether letters are a word with a slip before its end. At its end they may be two words: x of
// `rotation_x` is no slip.
bool IsSlipWithin(std::string_view letters, std::string_view word) {
  return word.size() >= kShortestToSlip && letters.ends_with(word.back()) &&
         IsOneSlipAway(letters, word);
}

}  // namespace

bool MeansAxialTurn(std::string_view column) {
  const std::string stem = PlainStem(column);
  // Which words the letters before each place make, one behind the other.
  struct Before {
    bool words = false;
    bool words_with_turn = false;
  };
  std::vector<Before> before(stem.size() + 1);
  before[0].words = true;
  for (std::size_t place = 0; place < stem.size(); ++place) {
    const Before here = before[place];
    const auto take = [&](std::string_view word, bool is_turn) {
      for (const std::size_t size : SizesOfSlips(word)) {
        if (place + size > stem.size()) {
          continue;
        }
        const std::string_view letters = std::string_view(stem).substr(place, size);
        if (letters == word || IsSlipWithin(letters, word)) {
          Before& behind = before[place + size];
          behind.words |= here.words;
          behind.words_with_turn |= here.words_with_turn || (is_turn && here.words);
        }
      }
    };
    for (const std::string_view word : kTurns) {
      take(word, true);
    }
    for (const std::string_view word : kBeside) {
      take(word, false);
    }
  }
  return before.back().words_with_turn;
}

}  // namespace girdle
