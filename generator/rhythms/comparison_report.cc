// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/comparison_report.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

using Row = std::vector<std::string>;

constexpr std::string_view kNothing = "-";
// Decimals of a degree: far below any measurement, far above rounding.
constexpr int kMapDecimals = 6;
constexpr std::string_view kRatioDefinition =
    "(change of humeral elevation - change of upward rotation) / change of upward rotation";

// Common names of the differences, in the order of ComparedAngle.
constexpr std::array<std::string_view, kDifferenceCount> kDifferenceLabels = {
    "SC",
    "AC",
    "GH",
    "clavicle protraction",
    "clavicle elevation",
    "scapula internal rotation",
    "scapula upward rotation",
    "scapula tilt"};

// Returns the alignments of two columns of words and further columns of numbers.
std::vector<Alignment> WordsFirst() {
  return {Alignment::kLeft, Alignment::kLeft, Alignment::kRight};
}

// Returns a place of a grid in degrees as typed.
std::string PlaceText(double angle_rad) {
  constexpr int kDecimals = 9;
  return RoundedText(DegreesFromRadians(angle_rad), kDecimals);
}

double PlaceNumber(double angle_rad) { return *FiniteNumber(PlaceText(angle_rad)); }

std::string RangeText(double from_rad, double to_rad) {
  return PlaceText(from_rad) + " to " + PlaceText(to_rad);
}

// Returns a number with exactly `decimals` places, so that the points of a column align.
std::string FixedText(double value, int decimals) {
  std::string text = RoundedText(value, decimals);
  std::size_t point = text.find('.');
  if (point == std::string::npos) {
    point = text.size();
    text += '.';
  }
  text.resize(point + 1 + static_cast<std::size_t>(decimals), '0');
  return text;
}

std::string AngleText(double angle_rad) { return FixedText(DegreesFromRadians(angle_rad), 1); }

void AppendSummary(Row& row, const std::optional<DifferenceSummary>& summary) {
  if (!summary) {
    row.insert(row.end(), 3, std::string(kNothing));
    return;
  }
  row.push_back(AngleText(summary->rms_rad));
  row.push_back(AngleText(summary->largest_rad));
  row.push_back(PlaceText(summary->elevation_rad) +
                (summary->plane_rad ? "/" + PlaceText(*summary->plane_rad) : ""));
}

std::string DifferenceTable(const Comparison& comparison) {
  std::vector<Row> rows = {
      {"difference", "rhythm", "table rms", "largest", "at", "map rms", "largest", "at"}};
  for (std::size_t k = 0; k < kDifferenceCount; ++k) {
    std::string label(kDifferenceLabels[k]);
    for (const RhythmComparison& rhythm : comparison.rhythms) {
      Row row = {std::exchange(label, ""), std::string(rhythm.rhythm.name)};
      AppendSummary(row, rhythm.in_table[k]);
      AppendSummary(row, rhythm.on_map[k]);
      rows.push_back(std::move(row));
    }
  }
  return ColumnsText(rows, WordsFirst());
}

std::string RatioTable(const Comparison& comparison) {
  constexpr int kDecimals = 2;
  const auto ratio_text = [](const std::optional<double>& ratio) {
    return ratio ? FixedText(*ratio, kDecimals) : std::string(kNothing);
  };
  std::vector<Row> rows = {{"plane", "elevation", std::string(kMeasuredName)}};
  for (const RhythmComparison& rhythm : comparison.rhythms) {
    rows.front().emplace_back(rhythm.rhythm.name);
  }
  for (const RatioRow& ratios : comparison.ratios) {
    Row row = {PlaceText(ratios.plane_rad), PlaceText(ratios.elevation_rad),
               ratio_text(ratios.measured)};
    for (const std::optional<double>& ratio : ratios.published) {
      row.push_back(ratio_text(ratio));
    }
    rows.push_back(std::move(row));
  }
  return ColumnsText(rows, {Alignment::kRight});
}

nlohmann::ordered_json SummaryAsJson(const std::optional<DifferenceSummary>& summary) {
  if (!summary) {
    return nullptr;
  }
  return {
      {"rms_deg", DegreesFromRadians(summary->rms_rad)},
      {"largest_deg", DegreesFromRadians(summary->largest_rad)},
      {"elevation_deg", PlaceNumber(summary->elevation_rad)},
      {"plane_deg",
       summary->plane_rad ? nlohmann::ordered_json(PlaceNumber(*summary->plane_rad)) : nullptr}};
}

nlohmann::ordered_json RatioAsJson(const std::optional<double>& ratio) {
  return ratio ? nlohmann::ordered_json(*ratio) : nullptr;
}

nlohmann::ordered_json RhythmAsJson(const RhythmComparison& comparison) {
  nlohmann::ordered_json json;
  json["name"] = comparison.rhythm.name;
  json["source"] = comparison.rhythm.source;
  json["says"] = comparison.rhythm.says;
  for (std::size_t k = 0; k < kDifferenceCount; ++k) {
    json["differences"].push_back({{"of", kDifferenceNames[k]},
                                   {"in_table", SummaryAsJson(comparison.in_table[k])},
                                   {"on_map", SummaryAsJson(comparison.on_map[k])}});
  }
  return json;
}

void AppendMapRow(std::string& text, std::string_view name, const MapPosition& position,
                  const GirdlePose& girdle, const DefinedAngles& defined) {
  const auto append = [&text](bool is_said, double angle_rad) {
    text += ',';
    if (is_said) {
      text += RoundedText(DegreesFromRadians(angle_rad), kMapDecimals);
    }
  };
  text += std::string(name) + "," + PlaceText(position.elevation_rad) + "," +
          PlaceText(position.plane_rad) + (position.is_in_table ? ",1" : ",0");
  const ShoulderPose pose = WithHumerus(girdle, position.measured.q_TH());
  const Vector3 sc_rad = EulerFromQuaternion(kJointSequences[0], pose.q_TC);
  const Vector3 ac_rad = EulerFromQuaternion(kJointSequences[1], pose.q_CS);
  const Vector3 gh_rad = EulerFromQuaternion(kJointSequences[2], pose.q_SH);
  const Vector3 st_rad = EulerFromQuaternion(EulerSequence::kYXZ, girdle.q_TS);
  append(defined.angles[0], sc_rad.x);
  append(defined.angles[1], sc_rad.y);
  append(defined.angles[2], sc_rad.z);
  for (int k = 0; k < 3; ++k) {
    append(defined.Clavicle() && defined.Scapula(), ac_rad[k]);
  }
  for (int k = 0; k < 3; ++k) {
    append(defined.Scapula(), gh_rad[k]);
  }
  append(defined.angles[3], st_rad.x);
  append(defined.angles[4], st_rad.y);
  append(defined.angles[5], st_rad.z);
  for (const std::optional<double>& difference_rad : DifferencesAt(position, girdle, defined)) {
    append(difference_rad.has_value(), difference_rad.value_or(0));
  }
  text += '\n';
}

std::string MapHeader() {
  std::string text = "rhythm,elevation_deg,plane_deg,in_table";
  for (const std::string_view name : kCoordinateNames) {
    text += "," + std::string(name) + "_deg";
  }
  for (std::size_t k = 3; k < kGirdleAngleCount; ++k) {
    text += "," + std::string(kGirdleAngleNames[k]) + "_deg";
  }
  for (const std::string_view name : kDifferenceNames) {
    text += "," + std::string(name) + "_difference_deg";
  }
  return text + "\n";
}

}  // namespace

std::string ComparisonAsText(const Comparison& comparison) {
  const auto& map = comparison.map;
  const std::size_t clamped = comparison.position_count() - comparison.compared_on_map;
  std::string text =
      "measured  " + std::string(kMeasuredName) + ", " +
      std::string(Name(comparison.options.interpolation)) + ", closure " +
      std::string(Name(comparison.options.closure)) + "\ntable     elevation " +
      RangeText(comparison.table_from_elevation_rad, comparison.table_to_elevation_rad) +
      ", plane " + RangeText(comparison.table_from_plane_rad, comparison.table_to_plane_rad) +
      ": " + CountText(comparison.compared_in_table, "position") + "\nmap       elevation " +
      RangeText(map.elevations_rad.front(), map.elevations_rad.back()) + ", plane " +
      RangeText(map.planes_rad.front(), map.planes_rad.back()) + ": " +
      CountText(comparison.compared_on_map, "position");
  if (clamped > 0) {
    text += "; " + std::to_string(clamped) + " left out, beyond Girdle's reach";
  }
  std::vector<Row> says;
  says.reserve(comparison.rhythms.size());
  for (const RhythmComparison& rhythm : comparison.rhythms) {
    says.push_back({std::string(rhythm.rhythm.name), std::string(rhythm.rhythm.says)});
  }
  text += "\n\n" + ColumnsText(says, WordsFirst()) + "\n" + DifferenceTable(comparison);
  text +=
      "\nDegrees, at elevation/plane; at elevation 0 and 180 an arm has no plane. SC, AC, GH: "
      "angle "
      "of the rotation\nbetween the two; with the same humerus, GH's is also that of the scapula "
      "in "
      "the thorax. The others: rhythm\nminus measured, Y-X'-Z'' angles in the thorax, protraction "
      "+, elevation -, internal rotation +, upward\nrotation -, posterior tilt +.\n-: the rhythm "
      "does not say it.\n";
  text += "\nscapulohumeral ratio from elevation " + PlaceText(kRatioFrom_rad) + " on:\n" +
          std::string(kRatioDefinition) + "\n\n" + RatioTable(comparison);
  return text;
}

std::string ComparisonAsJson(const Comparison& comparison) {
  const auto range = [](double from_rad, double to_rad) {
    return nlohmann::ordered_json{{"from", PlaceNumber(from_rad)}, {"to", PlaceNumber(to_rad)}};
  };
  const auto& map = comparison.map;
  nlohmann::ordered_json json;
  json["interpolation"] = Name(comparison.options.interpolation);
  json["closure"] = Name(comparison.options.closure);
  json["table"] = {
      {"elevation_deg",
       range(comparison.table_from_elevation_rad, comparison.table_to_elevation_rad)},
      {"plane_deg", range(comparison.table_from_plane_rad, comparison.table_to_plane_rad)},
      {"compared", comparison.compared_in_table}};
  json["map"] = {{"elevation_deg", range(map.elevations_rad.front(), map.elevations_rad.back())},
                 {"plane_deg", range(map.planes_rad.front(), map.planes_rad.back())},
                 {"compared", comparison.compared_on_map},
                 {"clamped", comparison.position_count() - comparison.compared_on_map}};
  for (const RhythmComparison& rhythm : comparison.rhythms) {
    json["rhythms"].push_back(RhythmAsJson(rhythm));
  }
  nlohmann::ordered_json ratio;
  ratio["definition"] = kRatioDefinition;
  ratio["from_elevation_deg"] = PlaceNumber(kRatioFrom_rad);
  for (const RatioRow& row : comparison.ratios) {
    nlohmann::ordered_json line;
    line["plane_deg"] = PlaceNumber(row.plane_rad);
    line["elevation_deg"] = PlaceNumber(row.elevation_rad);
    line[std::string(kMeasuredName)] = RatioAsJson(row.measured);
    for (std::size_t i = 0; i < row.published.size(); ++i) {
      line[std::string(comparison.rhythms[i].rhythm.name)] = RatioAsJson(row.published[i]);
    }
    ratio["rows"].push_back(line);
  }
  json["scapulohumeral_ratio"] = ratio;
  return JsonText(json);
}

std::size_t WriteMapCsv(const ShoulderRhythm& measured,
                        const std::vector<PublishedRhythm>& published, const ComparisonMap& map,
                        const std::function<void(std::string_view)>& write) {
  constexpr std::size_t kBufferSize = 1 << 16;
  const std::vector<MapPosition> positions = PositionsOf(measured, map);
  std::string text = MapHeader();
  const auto append = [&](std::string_view name, const DefinedAngles& defined,
                          const auto& girdle_at) {
    for (const MapPosition& position : positions) {
      AppendMapRow(text, name, position, girdle_at(position), defined);
      if (text.size() > kBufferSize) {
        write(text);
        text.clear();
      }
    }
  };
  append(kMeasuredName, {{true, true, true, true, true, true}}, [](const MapPosition& position) {
    return GirdlePose{position.measured.q_TC, position.measured.q_TS()};
  });
  for (const PublishedRhythm& rhythm : published) {
    append(rhythm.name, rhythm.defined, [&rhythm](const MapPosition& position) {
      return rhythm.girdle(position.elevation_rad, position.plane_rad);
    });
  }
  write(text);
  return positions.size() * (1 + published.size());
}

}  // namespace girdle
