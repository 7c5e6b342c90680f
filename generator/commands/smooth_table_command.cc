// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/smooth_table_command.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands/named_files.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "fits/table_smoothing.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/csv.h"
#include "text/input_error.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"
#include "text/text_file.h"

namespace girdle {
namespace {

// Decimals of an angle [deg] in the file: finer than any measurement, coarser than the rounding in
// which machines differ.
constexpr int kAngleDecimals = 4;
// Decimals of planes and elevations [deg] in reports.
constexpr int kKnotDecimals = 6;

struct SmoothTableArguments {
  std::string in;
  std::string out;
  std::string penalty;
  bool json = false;
};

// A table and the comments before it.
struct CommentedTable {
  RhythmTable table;
  std::vector<std::string> comments;
};

CommentedTable ReadCommentedTable(const std::string& path) {
  std::ifstream file = OpenTextFile(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::istringstream rows(text);
  RhythmTable table = ReadRhythmTable(rows, path);
  std::istringstream header(text);
  return {std::move(table), CsvReader(header, path).comments()};
}

SmoothingOptions ChosenSmoothing(const SmoothTableArguments& arguments) {
  SmoothingOptions options;
  if (!arguments.penalty.empty()) {
    options.penalty = NumberArgument("--penalty", arguments.penalty);
    if (options.penalty < 0 || options.penalty > kLargestPenalty) {
      throw InputError("--penalty " + arguments.penalty + ": expected 0 to " +
                       RoundedText(kLargestPenalty, 0));
    }
  }
  return options;
}

std::string DegreesText(double angle_rad) {
  return RoundedText(DegreesFromRadians(angle_rad), kKnotDecimals);
}

// Returns comments on the origin of the table, to stand before the source's own comments.
std::vector<std::string> Provenance(const std::string& source, const SmoothingOptions& options,
                                    const std::vector<std::string>& source_comments) {
  const std::string lambda = NumberText(options.penalty);
  const std::string least =
      "#   least; t_i is the third difference of r_i .. r_i+3 on the rotation group, in row steps. "
      "lambda = ";
  std::vector<std::string> lines = {
      "# Smoothed: " + source + " without the steps of its means where people drop out.",
      "# Method: in place of the source's rotations q_i, per joint and plane, the r_i that make",
      "#     sum |log(q_i^-1 r_i)|^2 + lambda sum p_i |t_i|^2",
      least + lambda + ".",
      "#   p_i = 1, but " + NumberText(options.gh_low_share) +
          " for GH where row i is below elevation " + DegreesText(options.gh_low_elevation_rad) +
          ".",
      "# Made by: girdle smooth-table --in " + source + " --penalty " + lambda + " --out FILE",
      "# Units: degrees, rounded to " + std::to_string(kAngleDecimals) +
          " decimals. Frames, sequences and signs: as in the source.",
      "# Derived: all angles of SC, AC and GH. The origins of rows and ST are the source's."};
  if (!source_comments.empty()) {
    lines.emplace_back("# The source says:");
  }
  for (const std::string& comment : source_comments) {
    lines.push_back("#  " + comment.substr(1));
  }
  return lines;
}

// One line of the report.
struct ReportedChange {
  std::string_view joint;
  const char* quantity;
  LargestOnGrid largest;
};

std::vector<ReportedChange> Reported(const std::array<JointChange, kJointCount>& changes) {
  std::vector<ReportedChange> lines;
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    const JointChange& change = changes[joint];
    const std::string_view name = kJointNames[joint];
    lines.push_back({name, "move", change.move});
    lines.push_back({name, "second difference before", change.before.rotation});
    lines.push_back({name, "second difference after", change.after.rotation});
    lines.push_back({name, "Euler second difference before", change.before.euler});
    lines.push_back({name, "Euler second difference after", change.after.euler});
  }
  return lines;
}

std::string ReportAsText(const SmoothTableArguments& arguments, const SmoothingOptions& options,
                         const RhythmTable& table,
                         const std::array<JointChange, kJointCount>& changes) {
  constexpr int kDecimals = 3;
  constexpr std::size_t kQuantityWidth = 32;
  constexpr std::size_t kJointWidth = 5;
  constexpr std::size_t kValueWidth = 7;
  std::string text = "table    " + arguments.out + "\npenalty  " + NumberText(options.penalty) +
                     "\n\n" + AlignedLeft("largest", kQuantityWidth) +
                     AlignedLeft("of", kJointWidth) + AlignedLeft("deg", kValueWidth) + "where\n";
  for (const auto& [joint, quantity, largest] : Reported(changes)) {
    text += AlignedLeft(quantity, kQuantityWidth) + AlignedLeft(std::string(joint), kJointWidth) +
            AlignedLeft(RoundedText(DegreesFromRadians(largest.value()), kDecimals), kValueWidth) +
            "plane " + DegreesText(table.planes_rad()[largest.place().plane]) + ", elevation " +
            DegreesText(table.elevations_rad()[largest.place().elevation]) + "\n";
  }
  return text;
}

std::string ReportAsJson(const SmoothTableArguments& arguments, const SmoothingOptions& options,
                         const RhythmTable& table,
                         const std::array<JointChange, kJointCount>& changes) {
  nlohmann::ordered_json json;
  json["table"] = arguments.out;
  json["penalty"] = options.penalty;
  json["largest"] = nlohmann::ordered_json::array();
  for (const auto& [joint, quantity, largest] : Reported(changes)) {
    nlohmann::ordered_json line;
    line["quantity"] = quantity;
    line["joint"] = joint;
    line["value_deg"] = DegreesFromRadians(largest.value());
    line["plane_deg"] = DegreesFromRadians(table.planes_rad()[largest.place().plane]);
    line["elevation_deg"] = DegreesFromRadians(table.elevations_rad()[largest.place().elevation]);
    json["largest"].push_back(line);
  }
  return JsonText(json);
}

RhythmTable SmoothedFrom(const std::string& path, const RhythmTable& table,
                         const SmoothingOptions& options) {
  try {
    return Smoothed(table, options);
  } catch (const std::invalid_argument& error) {
    throw InputError(path + ": " + error.what());
  }
}

void SmoothTable(const SmoothTableArguments& arguments) {
  if (arguments.json && arguments.out == "-") {
    throw InputError("--json and --out - both want standard output. Write the table to a file");
  }
  ExpectFilesApart({{"--out", arguments.out}}, {{"--in", arguments.in}});
  const SmoothingOptions options = ChosenSmoothing(arguments);
  const auto [table, comments] = ReadCommentedTable(arguments.in);
  const RhythmTable smoothed = SmoothedFrom(arguments.in, table, options);
  const std::string source = std::filesystem::path(arguments.in).filename().string();
  OutputFile out(arguments.out);
  out.Write(RhythmTableToCsv(smoothed, Provenance(source, options, comments), kAngleDecimals));
  out.Commit();
  NoteWritten(
      arguments.out,
      CountText(smoothed.elevations_rad().size() * smoothed.planes_rad().size(), "position"));
  if (arguments.out == "-") {
    return;  // the table is the output
  }
  const std::array<JointChange, kJointCount> changes = ChangesBetween(table, smoothed);
  Print(arguments.json ? ReportAsJson(arguments, options, table, changes)
                       : ReportAsText(arguments, options, table, changes));
}

}  // namespace

void AddSmoothTableCommand(CLI::App& program) {
  auto arguments = std::make_shared<SmoothTableArguments>();
  CLI::App* verb = program.add_subcommand(
      "smooth-table", "A measured table without the steps of people who drop out");
  verb->add_option("--in", arguments->in, "Measured table as CSV")->type_name("FILE")->required();
  verb->add_option("--out", arguments->out, "Table to write; - for standard output")
      ->type_name("FILE")
      ->required();
  verb->add_option("--penalty", arguments->penalty,
                   "Weight of third differences along elevation, in row steps (default 10); 0 "
                   "changes nothing")
      ->type_name("NUMBER");
  verb->add_flag("--json", arguments->json, "The report as JSON");
  verb->footer(
      "\nThe report shows how far rows moved, and how far the table bends: the second difference "
      "along elevation, from row to row, of the rotations and of their Euler angles.\n"
      "\nExample:\n  girdle smooth-table --in data/ludewig2009.csv --out smooth.csv");
  verb->callback([arguments] { SmoothTable(*arguments); });
}

}  // namespace girdle
