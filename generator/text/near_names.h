// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Names that differ from known ones by a typing mistake.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace girdle {

/// Returns the letters and digits of a name, letters small, without the unit that it ends in:
/// `axialrotation` for `Axial rotation (deg)`.
[[nodiscard]] std::string PlainStem(std::string_view name);

/// Letters of the shortest word whose typing mistakes can be told from other words.
inline constexpr std::size_t kShortestToSlip = 5;

/// Returns whether the words differ by at most one letter that is missing, extra or wrong, or by
/// two neighbouring letters that are exchanged.
[[nodiscard]] bool IsOneSlipAway(std::string_view a, std::string_view b);

/// Returns whether `name` is nearly `known`, the name of a column such as `axial_deg`, but not
/// equal to it. Capital letters and characters between words do not matter. A name is nearly
/// `known` if
///
/// - it has the same stem as `known` but another unit or none: `axial`, `axial_rad`, `Axial (deg)`,
///   `axials`;
/// - or it is one slip away from a name of `kShortestToSlip` or more letters: `plan_deg`.
[[nodiscard]] bool IsNearly(std::string_view name, std::string_view known);

/// Returns the word of `words` that `typed` is a slip of. Capital letters and characters between
/// letters do not matter.
///
/// A word counts as a slip if one letter is wrong, missing, extra or exchanged with its neighbour.
/// In words of eight or more letters, two such letters are allowed. A word also counts if one of
/// the two begins with the other. Returns nothing if no word is near enough, or if two words are
/// equally near.
[[nodiscard]] std::optional<std::string_view> NearestWord(std::string_view typed,
                                                          std::span<const std::string_view> words);

/// Returns `Did you mean 'elevation'? ` for a slip that NearestWord finds, otherwise an empty text.
[[nodiscard]] std::string DidYouMean(std::string_view typed,
                                     std::span<const std::string_view> words);

}  // namespace girdle
