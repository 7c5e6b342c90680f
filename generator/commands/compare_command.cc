// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/compare_command.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "rhythms/comparison.h"
#include "rhythms/comparison_report.h"
#include "rhythms/published_rhythms.h"
#include "tables/input_error.h"
#include "tables/number_text.h"

namespace girdle {
namespace {

// Half-degree steps over all elevations and planes that an arm has; more would fill the memory.
constexpr std::uint64_t kMostPositions = 300'000;

struct CompareArguments {
  RhythmArguments rhythm;
  std::string elevations;
  std::string planes;
  std::string out;
  bool json = false;
};

// One direction of the map.
struct Axis {
  std::string_view option;
  std::string_view example;
  double lower_deg;
  double upper_deg;
};
constexpr Axis kElevation = {"--elevation", "0:180:5", 0, 180};
constexpr Axis kPlane = {"--plane", "-60:135:5", -180, 180};

[[noreturn]] void FailAxis(const Axis& axis, const std::string& text, const std::string& reason) {
  throw InputError(std::string(axis.option) + " '" + text + "': " + reason);
}

std::vector<std::string> SplitAtColons(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double NumberOfAxis(const Axis& axis, const std::string& text, const std::string& part) {
  const std::optional<double> number = FiniteNumber(part);
  if (!number) {
    FailAxis(
        axis, text,
        "'" + part + "' is not a finite number. Give degrees such as " + std::string(axis.example));
  }
  return *number;
}

// The values of FROM:TO:STEP [rad].
std::vector<double> AxisValues(const Axis& axis, const std::string& text) {
  const std::vector<std::string> parts = SplitAtColons(text);
  if (parts.size() != 3) {
    FailAxis(axis, text, "expected FROM:TO:STEP in degrees, such as " + std::string(axis.example));
  }
  const double from_deg = NumberOfAxis(axis, text, parts[0]);
  const double to_deg = NumberOfAxis(axis, text, parts[1]);
  const double step_deg = NumberOfAxis(axis, text, parts[2]);
  for (const double end_deg : {from_deg, to_deg}) {
    if (end_deg < axis.lower_deg || end_deg > axis.upper_deg) {
      FailAxis(axis, text,
               NumberText(end_deg) + " is outside " + NumberText(axis.lower_deg) + " to " +
                   NumberText(axis.upper_deg) + " degrees. Give ends within");
    }
  }
  if (to_deg < from_deg) {
    FailAxis(axis, text, "goes downwards. Give the smaller end first");
  }
  if (step_deg <= 0) {
    FailAxis(axis, text, "the step is " + NumberText(step_deg) + ". Give a positive one");
  }
  const double steps = (to_deg - from_deg) / step_deg;
  if (steps >= static_cast<double>(kMostPositions)) {
    FailAxis(axis, text,
             "more than " + std::to_string(kMostPositions) + " positions. Give a larger step");
  }
  // Of a step: decimals such as 0.1 are not exact.
  constexpr double kWholeSteps = 1e-6;
  if (std::abs(steps - std::round(steps)) > kWholeSteps) {
    FailAxis(axis, text,
             "steps of " + NumberText(step_deg) + " from " + NumberText(from_deg) +
                 " do not meet " + NumberText(to_deg) + ". End at " +
                 NumberText(from_deg + std::floor(steps) * step_deg) + " or change the step");
  }
  const auto count = static_cast<std::size_t>(std::round(steps)) + 1;
  std::vector<double> values_rad;
  values_rad.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // As typed, so that values that stand in the table are met exactly.
    constexpr int kDecimals = 9;
    const double value_deg = from_deg + static_cast<double>(i) * step_deg;
    values_rad.push_back(RadiansFromDegrees(*FiniteNumber(RoundedText(value_deg, kDecimals))));
  }
  return values_rad;
}

ComparisonMap ChosenMap(const CompareArguments& arguments) {
  ComparisonMap map{AxisValues(kElevation, arguments.elevations),
                    AxisValues(kPlane, arguments.planes)};
  const std::uint64_t positions = std::uint64_t{map.elevations_rad.size()} * map.planes_rad.size();
  if (positions > kMostPositions) {
    throw InputError("--elevation '" + arguments.elevations + "' and --plane '" + arguments.planes +
                     "' make " + std::to_string(positions) + " positions, at most " +
                     std::to_string(kMostPositions) + " are compared. Give larger steps");
  }
  return map;
}

enum class Format { kNone, kCsv, kJson };

Format FormatOf(const std::string& path) {
  if (path.empty()) {
    return Format::kNone;
  }
  if (path.ends_with(".csv")) {
    return Format::kCsv;
  }
  if (path.ends_with(".json")) {
    return Format::kJson;
  }
  throw InputError("--out " + path +
                   ": the ending chooses the format. Give a name that ends in .csv (the map) or "
                   ".json (the summary)");
}

void CompareRhythms(const CompareArguments& arguments) {
  const ComparisonMap map = ChosenMap(arguments);
  const Format format = FormatOf(arguments.out);
  const ShoulderRhythm measured = ChosenRhythm(arguments.rhythm);
  const std::vector<PublishedRhythm> published = PublishedRhythms(BuiltInRhythmCoefficients());
  std::optional<OutputFile> out;
  if (format != Format::kNone) {
    out.emplace(arguments.out);
  }
  const Comparison comparison = Compare(measured, published, map);
  if (out) {
    if (format == Format::kCsv) {
      WriteMapCsv(measured, published, map, [&out](std::string_view text) { out->Write(text); });
    } else {
      out->Write(ComparisonAsJson(comparison));
    }
    out->Commit();
  }
  Print(arguments.json ? ComparisonAsJson(comparison) : ComparisonAsText(comparison));
}

}  // namespace

void AddCompareCommand(CLI::App& program) {
  auto arguments = std::make_shared<CompareArguments>();
  arguments->elevations = kElevation.example;
  arguments->planes = kPlane.example;
  CLI::App* verb =
      program.add_subcommand("compare", "Published shoulder rhythms beside the measured one");
  verb->add_option("--elevation", arguments->elevations,
                   "Humeral elevations of the map (default 0:180:5)")
      ->type_name("FROM:TO:STEP");
  verb->add_option("--plane", arguments->planes,
                   "Planes of elevation of the map (default -60:135:5)")
      ->type_name("FROM:TO:STEP");
  verb->add_option(
          "--out", arguments->out,
          "File to write: NAME.csv for the map, a row a rhythm and position; NAME.json for "
          "the summary")
      ->type_name("FILE");
  AddRhythmArguments(*verb, arguments->rhythm);
  verb->add_flag("--json", arguments->json, "The summary as JSON");
  verb->footer(
      "Positions at which the measured rhythm is clamped are left out. In the map a field is empty "
      "where a rhythm says\nnothing.\n"
      "Examples:\n"
      "  girdle compare --out rhythms.csv\n"
      "  girdle compare --elevation 30:120:5 --plane 0:90:10 --json");
  verb->callback([arguments] { CompareRhythms(*arguments); });
}

}  // namespace girdle
