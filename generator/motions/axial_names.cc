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
constexpr auto kBeside = std::to_array<std::string_view>({"internal",
                                                          "external",
                                                          "int",
                                                          "ext",
                                                          "inward",
                                                          "outward",
                                                          "medial",
                                                          "lateral",
                                                          "endo",
                                                          "exo",
                                                          "humeral",
                                                          "humerus",
                                                          "humerothoracic",
                                                          "ht",
                                                          "upper",
                                                          "arm",
                                                          "shoulder",
                                                          "right",
                                                          "left",
                                                          "r",
                                                          "l",
                                                          "long",
                                                          "longitudinal",
                                                          "axis",
                                                          "isb",
                                                          "angle",
                                                          "turn",
                                                          "measured"});

// Whether letters are a word for a turn, or one with a slip before its end. At its end they may be
// two words: x of `rotation_x` is no slip.
bool IsTurn(std::string_view letters, std::string_view word) {
  return letters == word || (word.size() >= kShortestToSlip && letters.ends_with(word.back()) &&
                             IsOneSlipAway(letters, word));
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
    for (const std::string_view word : kTurns) {
      for (const std::size_t size : {word.size() - 1, word.size(), word.size() + 1}) {
        if (place + size <= stem.size() && IsTurn(stem.substr(place, size), word)) {
          before[place + size].words |= here.words;
          before[place + size].words_with_turn |= here.words;
        }
      }
    }
    for (const std::string_view word : kBeside) {
      if (stem.compare(place, word.size(), word) == 0) {
        before[place + word.size()].words |= here.words;
        before[place + word.size()].words_with_turn |= here.words_with_turn;
      }
    }
  }
  return before.back().words_with_turn;
}

}  // namespace girdle
