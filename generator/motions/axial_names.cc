// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/axial_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "text/near_names.h"

namespace girdle {
namespace {

// Words that mean a turn about the long axis. gamma is ISB's letter.
constexpr std::array<std::string_view, 6> kTurns = {"axial", "rotation",   "rot",
                                                    "twist", "thirdangle", "gamma"};

// Words that may stand beside those and do not change their meaning.
constexpr std::array<std::string_view, 26> kBeside = {
    "internal", "external", "int",      "ext",     "inward",  "outward",        "medial",
    "lateral",  "endo",     "exo",      "humeral", "humerus", "humerothoracic", "ht",
    "upper",    "arm",      "shoulder", "right",   "left",    "long",           "longitudinal",
    "axis",     "isb",      "angle",    "turn",    "measured"};

// Internal and external rotation. They count only without other words, because longer words contain
// these letters.
constexpr std::array<std::string_view, 2> kAlone = {"ir", "er"};

// Letters of the shortest word of kBeside whose slips count: in shorter ones, one slip turns angle
// into ankle.
constexpr std::size_t kShortestToSlipBeside = 6;

// Letters of the longest name that is looked at. Longer ones say more than the axial turn.
constexpr std::size_t kLongestStem = 128;

// Whether letters are a word, or the word with a slip after its first letter. Extra letters at the
// end may be a second word: x in `rotation_x` is no slip.
bool IsWord(std::string_view letters, std::string_view word, std::size_t shortest_to_slip) {
  if (letters == word) {
    return true;
  }
  return word.size() >= shortest_to_slip && letters.starts_with(word.front()) &&
         (letters.ends_with(word.back()) || word.starts_with(letters)) &&
         IsOneSlipAway(letters, word);
}

}  // namespace

bool MeansAxialTurn(std::string_view column) {
  const std::string stem = PlainStem(column);
  if (std::find(kAlone.begin(), kAlone.end(), stem) != kAlone.end()) {
    return true;
  }
  if (stem.size() > kLongestStem) {
    return false;
  }
  // Whether the letters before each place consist of known words, without and with a turn.
  struct Before {
    bool words = false;
    bool words_with_turn = false;
  };
  std::vector<Before> before(stem.size() + 1);
  before[0].words = true;
  for (std::size_t place = 0; place < stem.size(); ++place) {
    const Before here = before[place];
    if (!here.words) {
      continue;
    }
    const auto take = [&](std::string_view word, bool is_turn) {
      for (const std::size_t size : {word.size() - 1, word.size(), word.size() + 1}) {
        if (place + size <= stem.size() &&
            IsWord(std::string_view(stem).substr(place, size), word,
                   is_turn ? kShortestToSlip : kShortestToSlipBeside)) {
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
  // A letter at the end may be the side.
  return before.back().words_with_turn ||
         ((stem.ends_with('r') || stem.ends_with('l')) && before[stem.size() - 1].words_with_turn);
}

}  // namespace girdle
