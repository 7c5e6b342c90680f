// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Names that are nearly others: slips of who types them.
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

/// Shortest word, in letters, of which a slip is still told from another word.
inline constexpr std::size_t kShortestToSlip = 5;

/// Returns whether at most one letter of a word is missing, too much or wrong, or two neighbours
/// are exchanged.
[[nodiscard]] bool IsOneSlipAway(std::string_view a, std::string_view b);

/// Returns whether `name` is nearly `known`, the name of a column such as `axial_deg`, and not
/// `known` itself. Capital letters and characters between words do not matter. It is nearly so if
///
/// - it has the same stem and another unit or none: `axial`, `axial_rad`, `Axial (deg)`, `axials`;
/// - or it is one slip away from a name of `kShortestToSlip` letters and more: `plan_deg`.
[[nodiscard]] bool IsNearly(std::string_view name, std::string_view known);

/// Returns the word of `words` that `typed` is a slip of. Capital letters and characters between
/// letters do not matter.
///
/// A word counts as a slip if one letter is wrong, missing, too much or exchanged with its
/// neighbour; two letters in words of eight letters and more; or if one of the two begins with the
/// other. Returns nothing if no word is that near, or if two words are equally near.
[[nodiscard]] std::optional<std::string_view> NearestWord(std::string_view typed,
                                                          std::span<const std::string_view> words);

/// Returns `Did you mean 'elevation'? ` for a slip that NearestWord finds, otherwise an empty text.
[[nodiscard]] std::string DidYouMean(std::string_view typed,
                                     std::span<const std::string_view> words);

}  // namespace girdle
