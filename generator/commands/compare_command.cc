// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/compare_command.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands/angle_sweep.h"
#include "commands/named_files.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "rhythms/comparison.h"
#include "rhythms/comparison_report.h"
#include "rhythms/published_rhythms.h"
#include "text/input_error.h"
#include "text/number_text.h"

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

constexpr SweptAngle kElevation = {"--elevation", kWholeElevations, 0, kHalfCircle_deg,
                                   kElevationsFromHanging};
constexpr SweptAngle kPlane = {"--plane", kWholePlanes, -kHalfCircle_deg, kHalfCircle_deg};

ComparisonMap ChosenMap(const CompareArguments& arguments) {
  const auto values_rad = [](const SweptAngle& angle, const std::string& text) {
    std::vector<double> values = SweepValues_deg(angle, text, kMostPositions);
    std::transform(values.begin(), values.end(), values.begin(), RadiansFromDegrees);
    return values;
  };
  ComparisonMap map{values_rad(kElevation, arguments.elevations),
                    values_rad(kPlane, arguments.planes)};
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
  ExpectFilesApart({{"--out", arguments.out}}, {{"--table", TableFile(arguments.rhythm.table)}});
  const ShoulderRhythm measured = ChosenRhythm(arguments.rhythm);
  const std::vector<PublishedRhythm> published = PublishedRhythms(BuiltInRhythmCoefficients());
  std::optional<OutputFile> out;
  if (format != Format::kNone) {
    out.emplace(arguments.out);
  }
  const Comparison comparison = Compare(measured, published, map);
  if (out) {
    std::string content;
    if (format == Format::kCsv) {
      const std::size_t rows = WriteMapCsv(measured, published, map,
                                           [&out](std::string_view text) { out->Write(text); });
      content = CountText(rows, "row");
    } else {
      out->Write(ComparisonAsJson(comparison));
    }
    out->Commit();
    NoteWritten(arguments.out, content);
  }
  Print(arguments.json ? ComparisonAsJson(comparison) : ComparisonAsText(comparison));
}

}  // namespace

void AddCompareCommand(CLI::App& program) {
  auto arguments = std::make_shared<CompareArguments>();
  arguments->elevations = kWholeElevations;
  arguments->planes = kWholePlanes;
  CLI::App* verb =
      program.add_subcommand("compare", "Published shoulder rhythms beside the measured one");
  verb->add_option("--elevation", arguments->elevations,
                   std::string("Humeral elevations of the map (default ") + kWholeElevations + ")")
      ->type_name("FROM:TO:STEP");
  verb->add_option("--plane", arguments->planes,
                   std::string("Planes of elevation of the map (default ") + kWholePlanes + ")")
      ->type_name("FROM:TO:STEP");
  verb->add_option(
          "--out", arguments->out,
          "File to write: NAME.csv for the map, a row a rhythm and position; NAME.json for "
          "the summary")
      ->type_name("FILE");
  AddRhythmArguments(*verb, arguments->rhythm);
  verb->add_flag("--json", arguments->json, "The summary as JSON");
  verb->footer(
      "\nPositions at which the measured rhythm is clamped are left out. In the map a field is "
      "empty where a rhythm says nothing.\n"
      "\nExamples:\n"
      "  girdle compare --out rhythms.csv\n"
      "  girdle compare --elevation 30:120:5 --plane 0:90:10 --json");
  verb->callback([arguments] { CompareRhythms(*arguments); });
}

}  // namespace girdle
