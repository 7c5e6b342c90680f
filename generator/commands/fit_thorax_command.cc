// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/fit_thorax_command.h"

#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "commands/anatomy_arguments.h"
#include "commands/named_files.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "fits/gliding_fit.h"
#include "kinematics/lengths.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/input_error.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

constexpr int kMillimeterDecimals = 1;
constexpr int kDistanceDecimals = 2;

struct FitThoraxArguments {
  AnatomyArguments anatomy;
  std::string table;
  std::string out;
  bool json = false;
};

// An ellipsoid and the distances of TS and AI from it.
struct ReportedEllipsoid {
  std::string name;
  Ellipsoid ellipsoid;
  std::array<GlidingDistance, kGlidingLandmarks.size()> distances;

  // Returns the rms distance of both landmarks, which have equally many positions.
  [[nodiscard]] double rms_m() const {
    return std::sqrt(
        (distances[0].rms_m * distances[0].rms_m + distances[1].rms_m * distances[1].rms_m) / 2);
  }
};

struct ThoraxReport {
  std::string table;  // word or file
  std::size_t position_count;
  Ellipsoid deviation;
  ReportedEllipsoid fitted;
  ReportedEllipsoid given;  // the ellipsoid that the anatomy came with
};

// Returns the ellipsoid with its numbers rounded as in the file.
Ellipsoid Rounded(const Ellipsoid& ellipsoid) {
  return {RoundedPlace_m(ellipsoid.center_m), RoundedPlace_m(ellipsoid.radii_m)};
}

EllipsoidFit FitFor(const Anatomy& anatomy, const RhythmTable& table, const std::string& name) {
  try {
    return FitGlidingEllipsoid(anatomy, table);
  } catch (const std::invalid_argument& error) {
    throw InputError(name + ": " + error.what());
  }
}

ThoraxReport ReportOn(const Anatomy& anatomy, const RhythmTable& table, const std::string& name) {
  const EllipsoidFit fit = FitFor(anatomy, table, name);
  const Ellipsoid fitted = Rounded(fit.ellipsoid);
  return {name,
          MeasuredPositionCount(table),
          fit.deviation,
          {"fitted", fitted, MeasureGliding(fitted, anatomy, table)},
          {"the anatomy's", anatomy.gliding, MeasureGliding(anatomy.gliding, anatomy, table)}};
}

// Returns a length with all its decimals, so that lengths align in a column.
std::string MillimetersText(double length_m, int decimals) {
  std::string text = RoundedText(kMillimetersPerMeter * length_m, decimals);
  if (text.find('.') == std::string::npos) {
    text += '.';
  }
  const std::size_t shown = text.size() - text.find('.') - 1;
  return text + std::string(static_cast<std::size_t>(decimals) - shown, '0');
}

// The table is named as typed, because a file of the same name in another folder is another table.
std::vector<std::string> Provenance(const ThoraxReport& report) {
  std::string distances;
  for (const GlidingDistance& distance : report.fitted.distances) {
    distances += (distances.empty() ? "" : ", ") +
                 std::string(DefinitionOf(distance.landmark).name) + " " +
                 MillimetersText(distance.rms_m, kDistanceDecimals) + " mm rms";
  }
  return {
      "# Ellipsoids that stand for the thorax under the scapula, axes as the thorax frame's.",
      "# Sources: ribcage - the anatomy's; gliding - fitted by least squares to TS and AI in the " +
          std::to_string(report.position_count) + " measured positions",
      "#   of the table, pulled weakly towards the ribcage. Left: " + distances + ".",
      "# Made by: girdle fit-thorax --table " + report.table + " --out FILE",
      "# Units: meters, rounded to 0.1 mm. Frame: thorax (origin IJ, x anterior, y up, z right).",
      "# Derived: gliding is a fit, not an anatomical surface."};
}

std::string NumbersLine(const std::string& name, const Ellipsoid& ellipsoid, std::size_t name_width,
                        std::size_t width) {
  std::string line = AlignedLeft(name, name_width);
  for (const Vector3& vector_m : {ellipsoid.center_m, ellipsoid.radii_m}) {
    for (int i = 0; i < 3; ++i) {
      line += AlignedRight(MillimetersText(vector_m[i], kMillimeterDecimals), width);
    }
  }
  return line + "\n";
}

std::string PlaceText(const GlidingDistance& distance) {
  const auto degrees = [](double angle_rad) { return NumberText(TypedDegrees(angle_rad)); };
  return "plane " + degrees(distance.plane_rad) + ", elevation " + degrees(distance.elevation_rad);
}

std::string ReportAsText(const ThoraxReport& report) {
  constexpr std::size_t kNameWidth = 17;
  constexpr std::size_t kNumberWidth = 10;
  constexpr std::size_t kLandmarkWidth = 6;
  constexpr std::size_t kDistanceWidth = 8;
  std::string text = "table  " + report.table + ", " + std::to_string(report.position_count) +
                     " measured positions\n\n" + AlignedLeft("ellipsoid (mm)", kNameWidth);
  for (const char* const column : {"centre x", "y", "z", "radius x", "y", "z"}) {
    text += AlignedRight(column, kNumberWidth);
  }
  text += "\n" +
          NumbersLine(report.fitted.name, report.fitted.ellipsoid, kNameWidth, kNumberWidth) +
          NumbersLine("  +- at least", report.deviation, kNameWidth, kNumberWidth) +
          NumbersLine(report.given.name, report.given.ellipsoid, kNameWidth, kNumberWidth) + "\n" +
          AlignedLeft("distance (mm)", kNameWidth) + AlignedLeft("of", kLandmarkWidth) +
          AlignedRight("rms", kDistanceWidth) + AlignedRight("worst", kDistanceWidth) +
          "  where (outside +)\n";
  for (const ReportedEllipsoid* const reported : {&report.fitted, &report.given}) {
    for (const GlidingDistance& distance : reported->distances) {
      text += AlignedLeft(reported->name, kNameWidth) +
              AlignedLeft(std::string(DefinitionOf(distance.landmark).name), kLandmarkWidth) +
              AlignedRight(MillimetersText(distance.rms_m, kDistanceDecimals), kDistanceWidth) +
              AlignedRight(MillimetersText(distance.worst_m, kDistanceDecimals), kDistanceWidth) +
              "  " + PlaceText(distance) + "\n";
    }
    text += AlignedLeft(reported->name, kNameWidth) + AlignedLeft("both", kLandmarkWidth) +
            AlignedRight(MillimetersText(reported->rms_m(), kDistanceDecimals), kDistanceWidth) +
            "\n";
  }
  return text;
}

nlohmann::ordered_json VectorAsJson(const Vector3& vector) {
  return {vector.x, vector.y, vector.z};
}

nlohmann::ordered_json EllipsoidAsJson(const ReportedEllipsoid& reported) {
  nlohmann::ordered_json json;
  json["center_m"] = VectorAsJson(reported.ellipsoid.center_m);
  json["radii_m"] = VectorAsJson(reported.ellipsoid.radii_m);
  json["rms_mm"] = kMillimetersPerMeter * reported.rms_m();
  for (const GlidingDistance& distance : reported.distances) {
    nlohmann::ordered_json line;
    line["rms_mm"] = kMillimetersPerMeter * distance.rms_m;
    line["worst_mm"] = kMillimetersPerMeter * distance.worst_m;
    line["elevation_deg"] = TypedDegrees(distance.elevation_rad);
    line["plane_deg"] = TypedDegrees(distance.plane_rad);
    json[std::string(DefinitionOf(distance.landmark).name)] = line;
  }
  return json;
}

std::string ReportAsJson(const ThoraxReport& report) {
  nlohmann::ordered_json json;
  json["table"] = report.table;
  json["positions"] = report.position_count;
  json["fitted"] = EllipsoidAsJson(report.fitted);
  json["fitted"]["center_deviation_m"] = VectorAsJson(report.deviation.center_m);
  json["fitted"]["radii_deviation_m"] = VectorAsJson(report.deviation.radii_m);
  json["anatomy"] = EllipsoidAsJson(report.given);
  return JsonText(json);
}

void FitThorax(const FitThoraxArguments& arguments, const Anatomy& anatomy) {
  if (arguments.json && arguments.out == "-") {
    throw InputError(
        "--json and --out - both want standard output. Write the ellipsoids to a file");
  }
  ExpectFilesApart({{"--out", arguments.out}}, {{"--table", TableFile(arguments.table)},
                                                {"--anatomy", arguments.anatomy.file},
                                                {"--ellipsoids", arguments.anatomy.ellipsoids}});
  const ResolvedRhythm chosen = Resolve(ChoiceFrom({.table = arguments.table}));
  const ThoraxReport report = ReportOn(anatomy, chosen.table, chosen.table_name());
  if (!arguments.out.empty()) {
    Anatomy with_fit = anatomy;
    with_fit.gliding = report.fitted.ellipsoid;
    OutputFile out(arguments.out);
    out.Write(ThoraxEllipsoidsToCsv(with_fit, Provenance(report)));
    out.Commit();
    NoteWritten(arguments.out);
    if (arguments.out == "-") {
      return;  // the ellipsoids are the output
    }
  }
  Print(arguments.json ? ReportAsJson(report) : ReportAsText(report));
}

}  // namespace

void AddFitThoraxCommand(CLI::App& program) {
  auto arguments = std::make_shared<FitThoraxArguments>();
  CLI::App* verb = program.add_subcommand(
      "fit-thorax", "The ellipsoid that the scapula glides on, fitted to where TS and AI go");
  AddTableArgument(*verb, arguments->table);
  AddAnatomyArguments(*verb, arguments->anatomy);
  verb->add_option("--out", arguments->out,
                   "File for the fitted ellipsoid, in the format of data/thorax_ellipsoids.csv; - "
                   "for standard output")
      ->type_name("FILE");
  verb->add_flag("--json", arguments->json, "The report as JSON");
  verb->footer(
      "\nThe report shows centre and radii in the thorax frame, how well the points determine "
      "them, and how far TS and AI are from the surface over the table's measured positions; "
      "beside them, the figures of the anatomy's own ellipsoid.\n"
      "\nExamples:\n  girdle fit-thorax --out thorax.csv\n  girdle fit-thorax --anatomy "
      "landmarks.csv");
  verb->callback([arguments] { FitThorax(*arguments, ChosenAnatomy(arguments->anatomy)); });
}

}  // namespace girdle
