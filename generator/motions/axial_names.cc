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

// Words that say a turn about the long axis; gamma is ISB's letter.
constexpr std::string_view kTurns = "axial rotation rot twist thirdangle gamma";

// Words that stand beside them without another meaning.
constexpr std::string_view kBeside =
    "internal external int ext inward outward medial lateral endo exo humeral humerus "
    "humerothoracic ht upper arm shoulder right left long longitudinal axis isb angle turn "
    "measured";

// Internal and external rotation, where nothing stands beside them: more words have these letters.
constexpr auto kAlone = std::to_array<std::string_view>({"ir", "er"});

// Of the words beside, one slip makes ankle of angle.
constexpr std::size_t kShortestToSlipBeside = 6;

// Whether letters are a word, or one with a slip behind its first letter. More letters at its end
// may be a second word: x of `rotation_x` is no slip.
bool IsWord(std::string_view letters, std::string_view word, std::size_t shortest_to_slip) {
  if (letters == word) {
    return true;
  }
  return word.size() >= shortest_to_slip && letters.starts_with(word.front()) &&
         (letters.ends_with(word.back()) || word.starts_with(letters)) &&
         IsOneSlipAway(letters, word);
}

// Calls `with` for each word of a list.
template <typename With>
void ForEachWord(std::string_view words, const With& with) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    with(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
}

}  // namespace

bool MeansAxialTurn(std::string_view column) {
  const std::string stem = PlainStem(column);
  if (std::find(kAlone.begin(), kAlone.end(), stem) != kAlone.end()) {
    return true;
  }
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
    ForEachWord(kTurns, [&](std::string_view word) { take(word, true); });
    ForEachWord(kBeside, [&](std::string_view word) { take(word, false); });
  }
  // A letter at the end says the side.
  return before.back().words_with_turn ||
         (stem.find_last_of("rl") + 1 == stem.size() && !stem.empty() &&
          before[stem.size() - 1].words_with_turn);
}

}  // namespace girdle
