// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/smoothness_command.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "commands/exit_status.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "commands/skin_argument.h"
#include "commands/skin_continuity.h"
#include "rhythm_tables/built_in_tables.h"
#include "rhythms/continuity.h"
#include "skin/skin_landmarks.h"
#include "skin/skin_measures.h"
#include "text/input_error.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

constexpr int kDigits = 2;
constexpr int kStatedDigits = 4;  // for numbers that are not compared with a limit

struct SmoothnessArguments {
  RhythmArguments rhythm;
  SkinArguments skin;
  bool json = false;
};

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
            AlignedLeft(std::string(Name(row.direction)), kDirectionWidth);
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
            AlignedRight(SignificantText(check.value, check.is_stated() ? kStatedDigits : kDigits),
                         kNumberWidth) +
            AlignedRight(check.is_stated() ? "-" : SignificantText(check.limit, kDigits),
                         kNumberWidth) +
            "  " + AlignedLeft(check.unit, kUnitWidth) +
            (!check.passed()     ? "FAIL    "
             : check.is_stated() ? "stated  "
                                 : "pass    ") +
            check.where + "\n";
  }
  return text;
}

nlohmann::ordered_json SkinAsJson(const SkinContinuity& skin) {
  nlohmann::ordered_json json;
  json["jumps"] = nlohmann::ordered_json::array();
  for (const SkinJumps& row : skin.jumps) {
    json["jumps"].push_back({{"interpolation", Name(row.interpolation)},
                             {"over", Name(row.direction)},
                             {"ac_skin_mm_per_deg", row.ac_skin.value_mm_per_deg},
                             {"where", row.ac_skin.where},
                             {"all_mm_per_deg", row.all.value_mm_per_deg},
                             {"all_where", row.all.where}});
  }
  json["steps"] = nlohmann::ordered_json::array();
  for (const SkinStep& row : skin.steps) {
    json["steps"].push_back({{"interpolation", Name(row.interpolation)},
                             {"ac_skin_mm_per_deg", row.ac_skin.value_mm_per_deg},
                             {"where", row.ac_skin.where}});
  }
  return json;
}

std::string AsJson(const ResolvedRhythm& checked, const std::vector<InterpolationJumps>& jumps,
                   const std::vector<RhythmCheck>& checks,
                   const std::optional<SkinContinuity>& skin, bool passed) {
  nlohmann::ordered_json json;
  json["rhythm"] = checked.text();
  json["passed"] = passed;
  json["jumps"] = nlohmann::ordered_json::array();
  for (const InterpolationJumps& row : jumps) {
    nlohmann::ordered_json line;
    line["interpolation"] = Name(row.interpolation);
    line["over"] = Name(row.direction);
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
                              {"below", check.is_stated() ? nlohmann::ordered_json(nullptr)
                                                          : nlohmann::ordered_json(check.limit)},
                              {"unit", check.unit},
                              {"passed", check.passed()},
                              {"where", check.where}});
  }
  if (skin) {
    json["skin"] = SkinAsJson(*skin);
  }
  return JsonText(json);
}

// Returns the landmarks of the right shoulder's skin, if the user chose a skin.
std::optional<LandmarkSkin> ChosenSkin(const SkinArguments& arguments) {
  const std::vector<Side> sides = {Side::kRight};
  const std::optional<ChosenBody> body = BodyFor(arguments, {}, sides);
  if (!body) {
    return std::nullopt;
  }
  return LandmarkSkin(SkinOnBones(BoundTo(*body, sides), body->body.anatomy),
                      FindSkinLandmarks(body->body, Side::kRight));
}

bool Measure(const SmoothnessArguments& arguments) {
  const RhythmChoice chosen = ChoiceFrom(arguments.rhythm);
  const ResolvedRhythm checked = Resolve(chosen);
  const ShoulderRhythm rhythm = ChosenRhythm(checked);
  // The interpolations are compared on the chosen table, by default the measured one.
  const ResolvedRhythm compared = Resolve(Over(chosen, {.table = BuiltInTable::kMeasured}));
  const std::optional<LandmarkSkin> landmarks = ChosenSkin(arguments.skin);
  std::vector<InterpolationJumps> jumps;
  std::optional<SkinContinuity> skin;
  try {
    jumps = MeasureJumps(compared.table);
    if (landmarks) {
      skin = MeasureSkin(*landmarks, compared.table);
    }
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
  const std::vector<RhythmCheck> checks = MeasureChecks(rhythm, BuiltInAnatomy().ranges);
  const bool passed = std::all_of(checks.begin(), checks.end(),
                                  [](const RhythmCheck& check) { return check.passed(); });
  if (arguments.json) {
    Print(AsJson(checked, jumps, checks, skin, passed));
    return passed;
  }
  Print("interpolations compared on the table " + compared.table_name() + "\n" +
        JumpsAsText(jumps) + (skin ? "\n" + SkinContinuityAsText(*skin) : "") + "\nrhythm  " +
        checked.text() + "\n" + ChecksAsText(checks) + "\n" +
        (passed ? "all checks pass\n" : "some checks fail\n"));
  return passed;
}

}  // namespace

void AddSmoothnessCommand(CLI::App& program, int& status) {
  auto arguments = std::make_shared<SmoothnessArguments>();
  CLI::App* verb = program.add_subcommand(
      "smoothness", "How smooth the interpolations are, and which checks a rhythm passes");
  AddRhythmArguments(*verb, arguments->rhythm);
  AddSkinArguments(*verb, arguments->skin);
  verb->add_flag("--json", arguments->json, "The report as JSON");
  verb->footer(
      "\nJumps are differences of poses left and right of every line at which a formula changes. "
      "With --skin the report also shows what each interpolation does to the skin over the "
      "shoulder; girdle verify checks that for a model's own rhythm.\n"
      "Exit status 1 if a check fails.\n"
      "\nExamples:\n  girdle smoothness\n  girdle smoothness --skin implicit");
  verb->callback([arguments, &status] { status = Measure(*arguments) ? kFine : kAboveTolerance; });
}

}  // namespace girdle
