// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/continuity_command.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "rhythm_tables/built_in_tables.h"
#include "rhythms/continuity.h"
#include "text/input_error.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

constexpr int kDigits = 2;

struct ContinuityArguments {
  RhythmArguments rhythm;
  bool json = false;
};

std::string_view DirectionName(Direction direction) {
  return kDirectionNames[static_cast<std::size_t>(direction)];
}

std::string RhythmText(const ShoulderRhythm& rhythm) {
  const RhythmOptions& options = rhythm.options();
  return "interpolation " + std::string(Name(options.interpolation)) + ", closure " +
         std::string(Name(options.closure)) + ", range " + std::string(Name(*options.range));
}

std::string JumpsAsText(const std::vector<InterpolationJumps>& jumps) {
  constexpr std::size_t kNameWidth = 15;
  constexpr std::size_t kDirectionWidth = 11;
  constexpr std::size_t kNumberWidth = 11;
  std::string text =
      "largest jump over the table's inner knots: of velocity (deg/deg), of acceleration "
      "(deg/deg^2)\n" +
      AlignedLeft("interpolation", kNameWidth) + AlignedLeft("over", kDirectionWidth);
  for (const char* order : {" velocity", " accel."}) {
    for (const std::string_view joint : kJointNames) {
      text += AlignedRight(std::string(joint) + order, kNumberWidth + 1);
    }
  }
  text += "\n";
  for (const InterpolationJumps& row : jumps) {
    text += AlignedLeft(std::string(Name(row.interpolation)), kNameWidth) +
            AlignedLeft(std::string(DirectionName(row.direction)), kDirectionWidth);
    for (const auto order : {&JumpSummary::first, &JumpSummary::second}) {
      for (const JumpSummary& joint : row.joints) {
        text += AlignedRight(SignificantText(joint.*order, kDigits), kNumberWidth + 1);
      }
    }
    text += "\n";
  }
  return text;
}

std::string ChecksAsText(const std::vector<RhythmCheck>& checks) {
  constexpr std::size_t kNameWidth = 56;
  constexpr std::size_t kNumberWidth = 8;
  constexpr std::size_t kUnitWidth = 11;
  std::string text = AlignedLeft("check", kNameWidth) + AlignedRight("value", kNumberWidth) +
                     AlignedRight("below", kNumberWidth) + "  " + AlignedLeft("unit", kUnitWidth) +
                     "result  where\n";
  for (const RhythmCheck& check : checks) {
    text += AlignedLeft(check.name, kNameWidth) +
            AlignedRight(SignificantText(check.value, kDigits), kNumberWidth) +
            AlignedRight(SignificantText(check.limit, kDigits), kNumberWidth) + "  " +
            AlignedLeft(check.unit, kUnitWidth) + (check.passed() ? "pass    " : "FAIL    ") +
            check.where + "\n";
  }
  return text;
}

std::string AsJson(const ShoulderRhythm& rhythm, const std::vector<InterpolationJumps>& jumps,
                   const std::vector<RhythmCheck>& checks, bool passed) {
  nlohmann::ordered_json json;
  json["rhythm"] = RhythmText(rhythm);
  json["passed"] = passed;
  json["jumps"] = nlohmann::ordered_json::array();
  for (const InterpolationJumps& row : jumps) {
    nlohmann::ordered_json line;
    line["interpolation"] = Name(row.interpolation);
    line["over"] = DirectionName(row.direction);
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      line[std::string(kJointNames[joint])] = {
          {"velocity_deg_per_deg", row.joints[joint].first},
          {"acceleration_deg_per_deg2", row.joints[joint].second}};
    }
    json["jumps"].push_back(line);
  }
  json["checks"] = nlohmann::ordered_json::array();
  for (const RhythmCheck& check : checks) {
    json["checks"].push_back({{"name", check.name},
                              {"value", check.value},
                              {"below", check.limit},
                              {"unit", check.unit},
                              {"passed", check.passed()},
                              {"where", check.where}});
  }
  return JsonText(json);
}

bool Measure(const ContinuityArguments& arguments) {
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  // The interpolations are compared on the rhythm's own table, by default the measured one.
  const RhythmTable table =
      arguments.rhythm.table.empty() ? BuiltInRhythmTable(BuiltInTable::kMeasured) : rhythm.table();
  const std::vector<InterpolationJumps> jumps = [&table] {
    try {
      return MeasureJumps(table);
    } catch (const std::invalid_argument& error) {
      throw InputError(error.what());
    }
  }();
  const std::vector<RhythmCheck> checks = MeasureChecks(rhythm, BuiltInAnatomy().ranges);
  const bool passed = std::all_of(checks.begin(), checks.end(),
                                  [](const RhythmCheck& check) { return check.passed(); });
  if (arguments.json) {
    Print(AsJson(rhythm, jumps, checks, passed));
    return passed;
  }
  const std::string table_name =
      arguments.rhythm.table.empty() ? "measured" : arguments.rhythm.table;
  Print("table   " + table_name + "\n" + JumpsAsText(jumps) + "\nrhythm  " + RhythmText(rhythm) +
        "\n" + ChecksAsText(checks) + "\n" + (passed ? "all checks pass\n" : "some checks fail\n"));
  return passed;
}

}  // namespace

void AddContinuityCommand(CLI::App& program, int& status) {
  auto arguments = std::make_shared<ContinuityArguments>();
  CLI::App* verb = program.add_subcommand(
      "continuity", "How smooth the interpolations are, and what a rhythm keeps");
  AddRhythmArguments(*verb, arguments->rhythm);
  verb->add_flag("--json", arguments->json, "The same as JSON");
  verb->footer(
      "Measured on poses by differences left and right of every line where a formula changes.\n"
      "Exit status 1 if a check fails.\n"
      "Example:\n  girdle continuity");
  verb->callback([arguments, &status] { status = Measure(*arguments) ? 0 : 1; });
}

}  // namespace girdle
