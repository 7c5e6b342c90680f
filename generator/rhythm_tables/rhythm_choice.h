// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The choice of a rhythm by a command line or a model.
///
/// A choice contains what was chosen and leaves the rest open. Over combines two choices, for
/// example a command line's and a model's: the first one wins. Resolve then fills in the defaults,
/// and MakeRhythm makes the rhythm:
///
///     const RhythmChoice typed = {.interpolation = Interpolation::kSquad};
///     const ResolvedRhythm resolved = Resolve(Over(typed, of_the_model));
///     const ShoulderRhythm rhythm = MakeRhythm(resolved, ranges);
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "kinematics/shoulder_rhythm.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle {

/// A table that was read from a file or from a model.
struct ReadTable {
  RhythmTable table;
  std::string file = {};  ///< path; empty for a table inside a model
};

/// The chosen table.
using TableChoice = std::variant<BuiltInTable, ReadTable>;

/// Returns the built-in table with that word. For any other text, it reads the table from the file
/// of that name. Throws InputError if there is no such file or if the file is not a table.
[[nodiscard]] TableChoice TableFromWordOrFile(const std::string& text);

/// Returns the built-in table with that word. For any other text, it reads the table from the text,
/// in the form of RhythmTableToLine. Throws InputError if the text is neither. Its message begins
/// with `place` instead of a file.
[[nodiscard]] TableChoice TableFromWordOrLine(const std::string& text, const std::string& place);

/// Returns the name of a table for reports: its word, its file, or "the model's own".
[[nodiscard]] std::string TableName(const TableChoice& table);

/// The chosen properties of a rhythm. A member that was not chosen is empty.
struct RhythmChoice {
  std::optional<Interpolation> interpolation = std::nullopt;
  std::optional<Closure> closure = std::nullopt;
  std::optional<Range> range = std::nullopt;
  std::optional<TableChoice> table = std::nullopt;
};

/// Returns the first choice, with its open members taken from the second. The range is an
/// exception, because it depends on interpolation and closure. If the first choice contains one of
/// these two, the second's range is dropped, and the default of the new pair is used.
[[nodiscard]] RhythmChoice Over(RhythmChoice first, const RhythmChoice& second);

/// Returns the options of a choice, with the defaults of RhythmOptions for open members. The range
/// is filled in: it is DefaultRange if it was open.
[[nodiscard]] RhythmOptions OptionsOf(const RhythmChoice& choice) noexcept;

/// Returns the text of options for reports: `interpolation squad, closure table, range clamp`.
/// Precondition: the options have a range.
[[nodiscard]] std::string TextOf(const RhythmOptions& options);

/// A choice with no open member.
struct ResolvedRhythm {
  RhythmTable table;
  TableChoice chosen_table;  ///< the choice that `table` belongs to
  RhythmOptions options;     ///< with a range

  [[nodiscard]] std::string table_name() const { return TableName(chosen_table); }
  /// Returns the built-in table that `table` is, or nothing if it was read.
  [[nodiscard]] std::optional<BuiltInTable> built_in() const noexcept;
  /// Returns the text of the rhythm for reports: TextOf its options, then `, table measured`.
  [[nodiscard]] std::string text() const;
};

/// Returns the choice with defaults for open members: OptionsOf, and the DefaultTable of the
/// interpolation.
[[nodiscard]] ResolvedRhythm Resolve(const RhythmChoice& choice);

/// Returns the rhythm with joint ranges. Throws InputError if the options exclude each other or if
/// the table is too small for them. The message begins with the table's file, or with `otherwise`
/// if the table has no file.
[[nodiscard]] ShoulderRhythm MakeRhythm(
    const ResolvedRhythm& resolved, const JointRanges& ranges,
    const std::string& otherwise = "these options do not go together: ");

}  // namespace girdle
