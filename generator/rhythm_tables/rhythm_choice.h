// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Which rhythm is meant, by whoever says something about it: a command line, a model.
///
/// A choice says as much as was said and leaves the rest open. Over puts one choice over another,
/// for example a command line's over a model's. Resolve then fills in the defaults, and MakeRhythm
/// makes the rhythm:
///
///     const RhythmChoice said = {.interpolation = Interpolation::kSquad};
///     const ResolvedRhythm meant = Resolve(Over(said, model_says));
///     const ShoulderRhythm rhythm = MakeRhythm(meant, ranges);
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "kinematics/shoulder_rhythm.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle {

/// A table that was read.
struct ReadTable {
  RhythmTable table;
  std::string file = {};  ///< path; empty for a table that stands in a model
};

/// Which table.
using TableChoice = std::variant<BuiltInTable, ReadTable>;

/// Returns the built-in table of that word or, for any other text, the table in the file of that
/// name. Throws InputError if there is no such file or it is no table.
[[nodiscard]] TableChoice TableFromWordOrFile(const std::string& text);

/// Returns the built-in table of that word or, for any other text, the table of RhythmTableToLine.
/// Throws InputError if it is neither; `place` stands in the message for the file.
[[nodiscard]] TableChoice TableFromWordOrLine(const std::string& text, const std::string& place);

/// Returns what reports call a table: its word, its file, or "the model's own".
[[nodiscard]] std::string TableName(const TableChoice& table);

/// What was said of a rhythm; what was not is empty.
struct RhythmChoice {
  std::optional<Interpolation> interpolation = std::nullopt;
  std::optional<Closure> closure = std::nullopt;
  std::optional<Range> range = std::nullopt;
  std::optional<TableChoice> table = std::nullopt;
};

/// Returns the first choice with what it leaves open taken from the second. A range is the
/// exception: it depends on interpolation and closure. If the first choice says one of these two,
/// the second's range is dropped, and the default of the new pair counts.
[[nodiscard]] RhythmChoice Over(RhythmChoice first, const RhythmChoice& second);

/// Returns the options of a choice, with RhythmOptions' defaults where it is open. The range is
/// there: DefaultRange if nothing was said.
[[nodiscard]] RhythmOptions OptionsOf(const RhythmChoice& choice) noexcept;

/// Returns what reports say of options: `interpolation squad, closure table, range clamp`. They
/// have a range.
[[nodiscard]] std::string TextOf(const RhythmOptions& options);

/// A choice with nothing left open.
struct ResolvedRhythm {
  RhythmTable table;
  TableChoice chosen_table;  ///< which one `table` is
  RhythmOptions options;     ///< with a range

  [[nodiscard]] std::string table_name() const { return TableName(chosen_table); }
  /// Returns the built-in table that `table` is; nothing if it was read.
  [[nodiscard]] std::optional<BuiltInTable> built_in() const noexcept;
  /// Returns what reports say of the rhythm: TextOf its options, `, table measured`.
  [[nodiscard]] std::string text() const;
};

/// Returns the choice with defaults for what it leaves open: OptionsOf, and the DefaultTable of the
/// interpolation.
[[nodiscard]] ResolvedRhythm Resolve(const RhythmChoice& choice);

/// Returns the rhythm, in joint ranges. Throws InputError if the options do not go together or the
/// table is too small for them. Its message begins with the table's file or, for other tables, with
/// `otherwise`.
[[nodiscard]] ShoulderRhythm MakeRhythm(
    const ResolvedRhythm& resolved, const JointRanges& ranges,
    const std::string& otherwise = "these options do not go together: ");

}  // namespace girdle
