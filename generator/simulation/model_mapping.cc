// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/model_mapping.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "text/csv.h"
#include "text/input_error.h"
#include "text/near_names.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

// No point of a shoulder is farther from the origin of its body. Coordinates in millimetres are.
constexpr double kFarthestPoint_m = 1;
// A coordinate turns at most a few times as fast as the arm. If degrees are given for radians, the
// factor is 57 times too large.
constexpr double kLargestFactor = 10;

constexpr std::string_view kSide = "side";
constexpr std::string_view kArm = "arm";
constexpr std::array<std::string_view, 3> kPointColumns = {"x_m", "y_m", "z_m"};
constexpr std::array<std::string_view, 3> kTurnColumns = {"y_deg", "x_deg", "z_deg"};
constexpr std::array<std::string_view, 3> kFactorColumns = {"per_elevation", "per_plane",
                                                            "per_axial"};
constexpr std::string_view kOffsetColumn = "offset_deg";

template <typename Names>
std::string Listed(const Names& names) {
  std::string text;
  for (const std::string_view name : names) {
    text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return text;
}

// Returns a hint at the known part that the user meant. It ends in a blank unless it is empty.
std::string MeantPart(std::string_view part) {
  std::vector<std::string_view> known(kSegmentNames.begin(), kSegmentNames.end());
  for (const std::string_view landmark : kLandmarkNames) {
    known.push_back(landmark);
  }
  known.push_back(kSide);
  known.push_back(kArm);
  return DidYouMean(part, known);
}

std::string Quoted(std::string_view text) { return "'" + ShortText(text) + "'"; }

template <typename Names>
std::optional<std::size_t> IndexOf(const Names& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt
                              : std::optional(static_cast<std::size_t>(found - names.begin()));
}

class MappingReader {
 public:
  MappingReader(std::istream& in, const std::string& name)
      : csv_(in, name),
        part_(csv_.Column("part")),
        by_(csv_.Column("by")),
        name_(csv_.Column("name")) {
    std::vector<std::string_view> known = {"part", "by", "name", kOffsetColumn};
    for (const auto& columns : {kPointColumns, kTurnColumns, kFactorColumns}) {
      known.insert(known.end(), columns.begin(), columns.end());
    }
    csv_.ExpectOnlyColumns(known);
    mapping_.file = name;
  }

  ModelMapping Read() {
    while (csv_.Next()) {
      ReadRow();
    }
    ExpectWhole();
    return std::move(mapping_);
  }

 private:
  using Columns = std::array<std::string_view, 3>;

  void ReadRow() {
    const std::string_view part = csv_.Field(part_);
    if (csv_.Field(name_).empty()) {
      csv_.Fail("the row of " + Quoted(part) + " has no name");
    }
    if (part == kSide) {
      ReadSide();
    } else if (part == kArm) {
      ReadDrive();
    } else if (const auto landmark = IndexOf(kLandmarkNames, part)) {
      ReadLandmark(*landmark);
    } else if (const auto segment = IndexOf(kSegmentNames, part)) {
      ReadBone(*segment);
    } else {
      csv_.Fail("part " + Quoted(part) + " is not known. " + MeantPart(part) +
                "Choose one of: " + std::string(kSide) + ", " + std::string(kArm) + ", " +
                Listed(kSegmentNames) + ", or a landmark: " + Listed(kLandmarkNames));
    }
  }

  void ReadSide() {
    ExpectBy({""});
    if (has_side_) {
      FailTwice();
    }
    const auto side = FromName<Side>(csv_.Field(name_));
    if (!side) {
      csv_.Fail("side " + Quoted(csv_.Field(name_)) + " is not known. " +
                DidYouMean(csv_.Field(name_), kSideNames) + "Choose right or left");
    }
    ExpectOnly({});
    mapping_.side = *side;
    has_side_ = true;
  }

  void ReadLandmark(std::size_t index) {
    std::optional<MappedLandmark>& landmark = mapping_.landmarks[index];
    if (landmark) {
      FailTwice();
    }
    const std::string name(csv_.Field(name_));
    if (ExpectBy({"body", "site"}) == 1) {
      ExpectOnly({});
      landmark = {MappedSite{name}, csv_.line_number()};
      return;
    }
    ExpectOnly({kPointColumns});
    const Vector3 point_m{Needed(kPointColumns[0]), Needed(kPointColumns[1]),
                          Needed(kPointColumns[2])};
    if (glm::length(point_m) > kFarthestPoint_m) {
      csv_.Fail("a point more than 1 m from its body. Give meters, not millimeters");
    }
    landmark = {MappedBodyPoint{name, point_m}, csv_.line_number()};
  }

  void ReadBone(std::size_t index) {
    std::optional<MappedBone>& bone = mapping_.bones[index];
    if (bone) {
      FailTwice();
    }
    ExpectBy({"body"});
    ExpectOnly({kTurnColumns});
    Vector3 turns_rad;
    for (int i = 0; i < 3; ++i) {
      const std::string_view column = kTurnColumns[static_cast<std::size_t>(i)];
      ExpectGiven(column);
      turns_rad[i] = RadiansFromDegrees(
          csv_.NumberWithin(csv_.Column(column), -kFullCircle_deg, kFullCircle_deg));
    }
    bone = {std::string(csv_.Field(name_)), QuaternionFromEuler(EulerSequence::kYXZ, turns_rad),
            csv_.line_number()};
  }

  void ReadDrive() {
    const bool is_actuator = ExpectBy({"joint", "actuator"}) == 1;
    ExpectOnly({kFactorColumns}, true);
    MappedDrive drive;
    drive.name = csv_.Field(name_);
    drive.line = csv_.line_number();
    drive.per_elevation = FactorOr0(kFactorColumns[0]);
    drive.per_plane = FactorOr0(kFactorColumns[1]);
    drive.per_axial = FactorOr0(kFactorColumns[2]);
    if (IsGiven(kOffsetColumn)) {
      drive.offset_rad = RadiansFromDegrees(
          csv_.NumberWithin(csv_.Column(kOffsetColumn), -kFullCircle_deg, kFullCircle_deg));
    }
    if (std::any_of(mapping_.drives.begin(), mapping_.drives.end(),
                    [&](const MappedDrive& other) { return other.name == drive.name; })) {
      FailTwice();
    }
    if (!mapping_.drives.empty() && mapping_.drives_are_actuators != is_actuator) {
      csv_.Fail("the arm is set by joints and by actuators. Name joints alone or actuators alone");
    }
    mapping_.drives_are_actuators = is_actuator;
    mapping_.drives.push_back(std::move(drive));
  }

  // Throws unless every bone but the clavicle and both angles of the arm are mapped.
  void ExpectWhole() const {
    if (!has_side_) {
      FailFile("no row for side. Add one: side,,right");
    }
    for (const Segment segment : {Segment::kThorax, Segment::kScapula, Segment::kHumerus}) {
      if (mapping_.bone(segment)) {
        continue;
      }
      const std::string bone(Name(segment));
      for (const Landmark landmark : FrameLandmarks(segment)) {
        if (!mapping_.landmark(landmark)) {
          FailFile("no row for " + std::string(DefinitionOf(landmark).name) +
                   ", which the frame of the " + bone + " needs. Add it, or a row " + bone +
                   ",body,NAME with y_deg, x_deg and z_deg");
        }
      }
    }
    const auto sets = [this](double MappedDrive::*factor) {
      return std::any_of(mapping_.drives.begin(), mapping_.drives.end(),
                         [factor](const MappedDrive& drive) { return drive.*factor != 0; });
    };
    if (!sets(&MappedDrive::per_elevation)) {
      FailFile("nothing sets the elevation. Add a row arm,joint,NAME with per_elevation");
    }
    if (!sets(&MappedDrive::per_plane)) {
      FailFile("nothing sets the plane. Add a row arm,joint,NAME with per_plane");
    }
  }

  [[noreturn]] void FailFile(const std::string& message) const {
    throw InputError(mapping_.file + ": " + message);
  }
  [[noreturn]] void FailTwice() const {
    csv_.Fail((csv_.Field(part_) == kArm ? Quoted(csv_.Field(name_)) : Quoted(csv_.Field(part_))) +
              " is given twice. Remove one of the rows");
  }

  std::size_t ExpectBy(const std::vector<std::string_view>& known) const {
    const auto found = IndexOf(known, csv_.Field(by_));
    if (!found) {
      csv_.Fail(Quoted(csv_.Field(part_)) + " is given by " + Quoted(csv_.Field(by_)) +
                (known.front().empty() ? ". Leave the column by empty"
                                       : ". Choose one of: " + Listed(known)));
    }
    return *found;
  }

  [[nodiscard]] bool IsGiven(std::string_view column) const {
    return csv_.HasColumn(column) && !csv_.Field(csv_.Column(column)).empty();
  }
  // Throws if a column has a number that means nothing for this part.
  void ExpectOnly(const std::vector<Columns>& wanted, bool wants_offset = false) const {
    for (const Columns& columns : {kPointColumns, kTurnColumns, kFactorColumns}) {
      if (std::find(wanted.begin(), wanted.end(), columns) == wanted.end()) {
        for (const std::string_view column : columns) {
          ExpectNone(column);
        }
      }
    }
    if (!wants_offset) {
      ExpectNone(kOffsetColumn);
    }
  }
  void ExpectNone(std::string_view column) const {
    if (IsGiven(column)) {
      csv_.Fail(Quoted(csv_.Field(part_)) + " by " + Quoted(csv_.Field(by_)) + " has no " +
                std::string(column) + ". Leave it empty");
    }
  }
  void ExpectGiven(std::string_view column) const {
    if (!IsGiven(column)) {
      csv_.Fail(Quoted(csv_.Field(part_)) + " by body needs " + std::string(column));
    }
  }
  [[nodiscard]] double Needed(std::string_view column) const {
    ExpectGiven(column);
    return csv_.Number(csv_.Column(column));
  }
  [[nodiscard]] double FactorOr0(std::string_view column) const {
    return IsGiven(column) ? csv_.NumberWithin(csv_.Column(column), -kLargestFactor, kLargestFactor)
                           : 0;
  }

  CsvReader csv_;
  std::size_t part_;
  std::size_t by_;
  std::size_t name_;
  bool has_side_ = false;
  ModelMapping mapping_;
};

}  // namespace

const std::vector<Landmark>& FrameLandmarks(Segment segment) {
  static const std::array<std::vector<Landmark>, kSegmentCount> kFrames = {{
      {Landmark::kIJ, Landmark::kPX, Landmark::kC7, Landmark::kT8},
      {Landmark::kSC, Landmark::kPAC},
      {Landmark::kPAC, Landmark::kTS, Landmark::kAI},
      {Landmark::kGH, Landmark::kEM, Landmark::kEL},
  }};
  return kFrames[static_cast<std::size_t>(segment)];
}

ModelMapping ReadModelMapping(std::istream& in, const std::string& name) {
  return MappingReader(in, name).Read();
}

}  // namespace girdle
