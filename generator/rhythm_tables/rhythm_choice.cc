// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/rhythm_choice.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "rhythm_tables/rhythm_table_csv.h"
#include "text/input_error.h"
#include "text/near_names.h"
#include "text/text_file.h"

namespace girdle {
namespace {

// Throws InputError if `text` is the word that named the table smoothed before version 0.2.
void ExpectNotOldWord(const std::string& text, const std::string& place) {
  if (text == "destepped") {
    throw InputError(place + ": the table destepped is now called smoothed");
  }
}

}  // namespace

TableChoice TableFromWordOrFile(const std::string& text) {
  if (const auto built_in = FromName<BuiltInTable>(text)) {
    return *built_in;
  }
  ExpectNotOldWord(text, "--table " + text);
  if (std::error_code unknown; !std::filesystem::exists(text, unknown)) {
    if (const std::optional<std::string_view> meant = NearestWord(text, kBuiltInTableNames)) {
      throw InputError("--table " + text + ": there is no such file. Did you mean the table " +
                       std::string(*meant) + "?");
    }
    if (text.find_first_of("./") == std::string::npos) {
      throw InputError("--table " + text +
                       ": there is no such file. The built-in tables are measured and smoothed");
    }
  }
  std::ifstream in = OpenTextFile(text);
  return ReadTable{ReadRhythmTable(in, text), text};
}

TableChoice TableFromWordOrLine(const std::string& text, const std::string& place) {
  if (const auto built_in = FromName<BuiltInTable>(text)) {
    return *built_in;
  }
  ExpectNotOldWord(text, place);
  return ReadTable{RhythmTableFromLine(text, place)};
}

std::string TableName(const TableChoice& table) {
  if (const auto* const read = std::get_if<ReadTable>(&table)) {
    return read->file.empty() ? "the model's own" : read->file;
  }
  return std::string(Name(std::get<BuiltInTable>(table)));
}

RhythmChoice Over(RhythmChoice first, const RhythmChoice& second) {
  if (!first.range && !first.interpolation && !first.closure) {
    first.range = second.range;
  }
  if (!first.interpolation) {
    first.interpolation = second.interpolation;
  }
  if (!first.closure) {
    first.closure = second.closure;
  }
  if (!first.table) {
    first.table = second.table;
  }
  return first;
}

RhythmOptions OptionsOf(const RhythmChoice& choice) noexcept {
  RhythmOptions options;
  options.interpolation = choice.interpolation.value_or(options.interpolation);
  options.closure = choice.closure.value_or(options.closure);
  options.range = choice.range.value_or(DefaultRange(options.interpolation, options.closure));
  return options;
}

std::optional<BuiltInTable> ResolvedRhythm::built_in() const noexcept {
  const auto* const built_in = std::get_if<BuiltInTable>(&chosen_table);
  return built_in == nullptr ? std::nullopt : std::optional(*built_in);
}

std::string TextOf(const RhythmOptions& options) {
  return "interpolation " + std::string(Name(options.interpolation)) + ", closure " +
         std::string(Name(options.closure)) + ", range " + std::string(Name(options.range.value()));
}

std::string ResolvedRhythm::text() const { return TextOf(options) + ", table " + table_name(); }

ResolvedRhythm Resolve(const RhythmChoice& choice) {
  const RhythmOptions options = OptionsOf(choice);
  TableChoice chosen = choice.table.value_or(DefaultTable(options.interpolation));
  const auto* const read = std::get_if<ReadTable>(&chosen);
  RhythmTable table =
      read != nullptr ? read->table : BuiltInRhythmTable(std::get<BuiltInTable>(chosen));
  return {std::move(table), std::move(chosen), options};
}

ShoulderRhythm MakeRhythm(const ResolvedRhythm& resolved, const JointRanges& ranges,
                          const std::string& otherwise) {
  try {
    return ShoulderRhythm(resolved.table, resolved.options, ranges);
  } catch (const std::invalid_argument& error) {
    const auto* const read = std::get_if<ReadTable>(&resolved.chosen_table);
    const bool has_file = read != nullptr && !read->file.empty();
    throw InputError((has_file ? read->file + ": " : otherwise) + error.what());
  }
}

}  // namespace girdle
