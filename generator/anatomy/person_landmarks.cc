// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/person_landmarks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "anatomy/body_size.h"
#include "kinematics/isb_frames.h"
#include "text/csv.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// A frame that is turned by less is the frame itself: some roundings of numbers of size one.
constexpr double kRounding_rad = 1e-12;

// A humerus whose own frame is turned half round about its y, and hardly otherwise, has EM and EL
// in each other's place; so near a given rotation no frame comes by chance (once in a thousand).
constexpr double kNearHalfTurn_rad = 15 * kRadiansPerDegree;

// A landmark serves two segments where one hangs on the other.
struct Origin {
  Landmark landmark;
  Segment segment;  // whose origin it is
};
constexpr Origin kOrigins[] = {{Landmark::kSC, Segment::kClavicle},
                               {Landmark::kPAC, Segment::kScapula},
                               {Landmark::kGH, Segment::kHumerus}};
constexpr Landmark kOptional[] = {Landmark::kACJ, Landmark::kGC};

// A distance between two landmarks of one segment.
struct Bone {
  Landmark from;
  Landmark to;
  Segment segment;
  // How many times as short and as long as an adult's a person's may be.
  double shorter = 3;
  double longer = 3;
};
constexpr Bone kBones[] = {
    {Landmark::kIJ, Landmark::kPX, Segment::kThorax},
    {Landmark::kIJ, Landmark::kC7, Segment::kThorax},
    {Landmark::kC7, Landmark::kT8, Segment::kThorax},
    // The joint lies beside IJ, so near that measuring counts.
    {Landmark::kIJ, Landmark::kSC, Segment::kThorax, 10, 10},
    {Landmark::kSC, Landmark::kPAC, Segment::kClavicle},
    {Landmark::kPAC, Landmark::kTS, Segment::kScapula},
    {Landmark::kTS, Landmark::kAI, Segment::kScapula},
    {Landmark::kPAC, Landmark::kAA, Segment::kScapula, 4, 3},
    {Landmark::kPAC, Landmark::kPC, Segment::kScapula},
    {Landmark::kPAC, Landmark::kGH, Segment::kScapula},
    {Landmark::kPAC, Landmark::kACJ, Segment::kScapula, 10, 4},
    {Landmark::kGH, Landmark::kGC, Segment::kScapula},
    {Landmark::kGH, Landmark::kEM, Segment::kHumerus},
    {Landmark::kGH, Landmark::kEL, Segment::kHumerus},
    {Landmark::kEM, Landmark::kEL, Segment::kHumerus},
};

std::string_view NameOf(Landmark landmark) { return DefinitionOf(landmark).name; }

std::optional<Landmark> LandmarkFromName(std::string_view name) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    if (kLandmarks[i].name == name) {
      return static_cast<Landmark>(i);
    }
  }
  // ISB's name.
  return name == "AC" ? std::optional(Landmark::kPAC) : std::nullopt;
}

// The segment that a landmark is the origin of.
std::optional<Segment> SegmentFrom(Landmark origin) {
  for (const Origin& known : kOrigins) {
    if (known.landmark == origin) {
      return known.segment;
    }
  }
  return std::nullopt;
}

Segment SegmentOf(Landmark landmark) { return DefinitionOf(landmark).segment; }

// What the file says of one landmark in one segment's frame.
struct Row {
  Vector3 position_m{0, 0, 0};
  std::size_t line_number = 0;  // 0 if there is no row
};

// The rows of a file, each under its landmark and the segment in whose frame it stands.
class MeasuredLandmarks {
 public:
  MeasuredLandmarks(std::istream& in, const std::string& name) : csv_(in, name) {
    csv_.ExpectOnlyColumns({"landmark", "segment", "x_m", "y_m", "z_m"});
    const std::size_t landmark_column = csv_.Column("landmark");
    const std::size_t segment_column = csv_.Column("segment");
    const std::size_t columns[] = {csv_.Column("x_m"), csv_.Column("y_m"), csv_.Column("z_m")};
    while (csv_.Next()) {
      const Landmark landmark = KnownLandmark(csv_.Field(landmark_column));
      TakeFrame(landmark, csv_.Field(segment_column));
      Row& row = is_lab_ ? RowIn(SegmentOf(landmark), landmark)
                         : RowIn(SegmentNamed(csv_.Field(segment_column)), landmark);
      if (row.line_number != 0) {
        csv_.Fail("'" + std::string(csv_.Field(landmark_column)) + "' stands in line " +
                  std::to_string(row.line_number) + " already" +
                  (landmark == Landmark::kPAC ? ", AC and PAC being the same" : "") +
                  ". Remove one of the rows");
      }
      row = {{csv_.Number(columns[0]), csv_.Number(columns[1]), csv_.Number(columns[2])},
             csv_.line_number()};
    }
    ExpectAll();
  }

  [[nodiscard]] bool is_lab() const noexcept { return is_lab_; }

  // Returns whether the file gives this landmark.
  [[nodiscard]] bool Has(Landmark landmark) const {
    return RowIn(SegmentOf(landmark), landmark).line_number != 0;
  }

  // Position in the frame of `segment` that the file uses, or in that of the laboratory.
  [[nodiscard]] Vector3 In(Segment segment, Landmark landmark) const {
    return RowIn(is_lab_ ? SegmentOf(landmark) : segment, landmark).position_m;
  }

  // Throws at the row of a landmark, in the frame of `segment` if it stands there.
  [[noreturn]] void Fail(Segment segment, Landmark landmark, const std::string& message) const {
    const std::size_t line_number = RowIn(segment, landmark).line_number;
    throw InputError(
        csv_.name(),
        line_number != 0 ? line_number : RowIn(SegmentOf(landmark), landmark).line_number, message);
  }

 private:
  [[nodiscard]] const Row& RowIn(Segment segment, Landmark landmark) const {
    return rows_[static_cast<std::size_t>(segment)][static_cast<std::size_t>(landmark)];
  }
  [[nodiscard]] Row& RowIn(Segment segment, Landmark landmark) {
    return rows_[static_cast<std::size_t>(segment)][static_cast<std::size_t>(landmark)];
  }

  [[nodiscard]] Landmark KnownLandmark(std::string_view name) const {
    const std::optional<Landmark> landmark = LandmarkFromName(name);
    if (!landmark) {
      std::string known;
      for (const LandmarkDefinition& definition : kLandmarks) {
        known += (known.empty() ? "" : " ") + std::string(definition.name);
      }
      csv_.Fail("'" + std::string(name) + "' is not a landmark. Known are " + known +
                ", and AC for PAC");
    }
    return *landmark;
  }

  // The segment of this name; only where TakeFrame found it right.
  static Segment SegmentNamed(std::string_view name) {
    return static_cast<Segment>(std::find(kSegmentNames.begin(), kSegmentNames.end(), name) -
                                kSegmentNames.begin());
  }

  // Checks that a landmark may stand in this frame, and that all stand in the same kind.
  void TakeFrame(Landmark landmark, std::string_view frame) {
    const bool is_lab = frame == kLaboratory;
    if (!has_rows_) {
      is_lab_ = is_lab;
      has_rows_ = true;
    }
    if (is_lab != is_lab_) {
      csv_.Fail(std::string(NameOf(landmark)) + " is given in the frame '" + std::string(frame) +
                "', the rows above " +
                (is_lab_ ? "in the laboratory's" : "each in that of its segment") +
                ". Give all landmarks in '" + std::string(kLaboratory) +
                "', or each in the frame of its segment");
    }
    const std::string_view own = Name(SegmentOf(landmark));
    const std::optional<Segment> child = SegmentFrom(landmark);
    if (is_lab || frame == own || (child && frame == Name(*child))) {
      return;
    }
    csv_.Fail(std::string(NameOf(landmark)) + " is given in the frame '" + std::string(frame) +
              "', expected '" + std::string(own) + "'" +
              (child ? " (or '" + std::string(Name(*child)) + "', whose origin it is)" : "") +
              ", or '" + std::string(kLaboratory) + "' in every row");
  }

  void ExpectAll() const {
    std::string missing;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const auto landmark = static_cast<Landmark>(i);
      const bool is_optional =
          std::find(std::begin(kOptional), std::end(kOptional), landmark) != std::end(kOptional);
      if (!is_optional && !Has(landmark)) {
        missing +=
            (missing.empty() ? "" : ", ") + std::string(NameOf(landmark)) +
            (landmark == Landmark::kPAC ? " (or AC)" : "") +
            (is_lab_ ? "" : " in the frame '" + std::string(Name(SegmentOf(landmark))) + "'");
      }
    }
    if (!missing.empty()) {
      csv_.Fail("no row for " + missing + ". Add it; only ACJ and GC may be left out");
    }
  }

  CsvReader csv_;
  bool has_rows_ = false;
  bool is_lab_ = false;
  std::array<std::array<Row, kLandmarkCount>, kSegmentCount> rows_{};
};

std::string LengthText(double length_m) { return SignificantText(length_m, 3) + " m"; }

// What the unit of a length seems to be, if not meters.
std::string UnitAdvice(double times_adult) {
  constexpr double kCentimeters = 30;
  constexpr double kMillimeters = 300;
  constexpr double kTooMuch = 3000;
  if (times_adult > kCentimeters && times_adult < kTooMuch) {
    return std::string("Give meters, not ") +
           (times_adult < kMillimeters ? "centimeters" : "millimeters");
  }
  return "Correct the positions";
}

double AdultLength_m(const Bone& bone, const Anatomy& adult) {
  const auto position = [&](Landmark landmark) {
    // An origin is 0 0 0 of its segment; so is IJ.
    return SegmentFrom(landmark) == bone.segment ? Vector3{0, 0, 0} : adult.landmark_m(landmark);
  };
  return glm::distance(position(bone.from), position(bone.to));
}

// Refuses distances between landmarks that no person has.
void CheckLengths(const MeasuredLandmarks& measured, const Anatomy& adult) {
  for (const Bone& bone : kBones) {
    if (!measured.Has(bone.from) || !measured.Has(bone.to)) {
      continue;
    }
    const double adult_m = AdultLength_m(bone, adult);
    const double length_m =
        glm::distance(measured.In(bone.segment, bone.from), measured.In(bone.segment, bone.to));
    const double shortest_m = adult_m / bone.shorter;
    const double longest_m = adult_m * bone.longer;
    if (length_m >= shortest_m && length_m <= longest_m) {
      continue;
    }
    const std::string from(NameOf(bone.from));
    const std::string to(NameOf(bone.to));
    if (length_m == 0) {
      measured.Fail(bone.segment, bone.to, from + " and " + to + " are the same point");
    }
    measured.Fail(bone.segment, bone.to,
                  from + " to " + to + " is " + LengthText(length_m) + ", expected " +
                      LengthText(shortest_m) + " to " + LengthText(longest_m) + ". " +
                      UnitAdvice(length_m / adult_m));
  }
}

// The segments' frames in the frames that the file uses.
struct MeasuredFrames {
  std::array<Quaternion, kSegmentCount> q_AB;
  std::array<Vector3, kSegmentCount> p_AB_m;
};

MeasuredFrames FramesOf(const MeasuredLandmarks& measured) {
  const auto at = [&](Segment segment, Landmark landmark) {
    return measured.In(segment, landmark);
  };
  const ThoraxPoints thorax = {
      at(Segment::kThorax, Landmark::kIJ), at(Segment::kThorax, Landmark::kPX),
      at(Segment::kThorax, Landmark::kC7), at(Segment::kThorax, Landmark::kT8),
      at(Segment::kThorax, Landmark::kSC)};
  const ScapulaPoints scapula = {
      at(Segment::kScapula, Landmark::kPAC), at(Segment::kScapula, Landmark::kTS),
      at(Segment::kScapula, Landmark::kAI), at(Segment::kScapula, Landmark::kAA),
      at(Segment::kScapula, Landmark::kPC)};
  const HumerusPoints humerus = {at(Segment::kHumerus, Landmark::kGH),
                                 at(Segment::kHumerus, Landmark::kEM),
                                 at(Segment::kHumerus, Landmark::kEL)};
  if (const auto flaw = FlawOfRightShoulder(thorax, scapula, humerus)) {
    const Landmark landmark = *LandmarkFromName(flaw->landmark);
    measured.Fail(SegmentOf(landmark), landmark, flaw->message);
  }
  MeasuredFrames frames;
  frames.q_AB = {ThoraxFrame(thorax.ij_m, thorax.px_m, thorax.c7_m, thorax.t8_m),
                 // Of the clavicle only its length is used, which no frame changes.
                 Quaternion(1, 0, 0, 0), ScapulaFrame(scapula.pac_m, scapula.ts_m, scapula.ai_m),
                 HumerusFrame(humerus.gh_m, humerus.em_m, humerus.el_m)};
  frames.p_AB_m = {thorax.ij_m, at(Segment::kClavicle, Landmark::kSC), scapula.pac_m, humerus.gh_m};
  return frames;
}

// Refuses a humerus whose epicondyles seem to have each other's place.
void CheckEpicondyles(const MeasuredLandmarks& measured, const MeasuredFrames& frames) {
  const auto q_AB = [&](Segment segment) { return frames.q_AB[static_cast<std::size_t>(segment)]; };
  if (measured.is_lab()) {
    if (IsHumerusTurnedAround(glm::conjugate(q_AB(Segment::kThorax)) * q_AB(Segment::kHumerus))) {
      measured.Fail(Segment::kHumerus, Landmark::kEL,
                    "the humerus is turned about its long axis as no shoulder turns it: EM and EL "
                    "have each other's place. Swap their names");
    }
  } else if (AngleBetween(q_AB(Segment::kHumerus), Quaternion(0, 0, 1, 0)) < kNearHalfTurn_rad) {
    measured.Fail(Segment::kHumerus, Landmark::kEL,
                  "EL lies to the left of EM: they have each other's place. Swap their names, or "
                  "if they are right, negate x_m and z_m in the humerus's rows");
  }
}

// Landmarks of the file, each in the ISB frame of its segment; the others stay.
void ExpressInSegments(const MeasuredLandmarks& measured, const MeasuredFrames& frames,
                       Anatomy& anatomy) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    if (!measured.Has(landmark)) {
      continue;
    }
    const Segment segment = SegmentOf(landmark);
    const Quaternion& q_AB = frames.q_AB[static_cast<std::size_t>(segment)];
    const Vector3 from_origin_m =
        measured.In(segment, landmark) - frames.p_AB_m[static_cast<std::size_t>(segment)];
    anatomy.landmarks_m[i] = AngleBetween(q_AB, Quaternion(1, 0, 0, 0)) < kRounding_rad
                                 ? from_origin_m
                                 : glm::conjugate(q_AB) * from_origin_m;
  }
  // The clavicle's z goes through PAC.
  Vector3& pac_m = anatomy.landmarks_m[static_cast<std::size_t>(Landmark::kPAC)];
  pac_m = {0, 0, glm::length(pac_m)};
}

Anatomy AnatomyOf(const MeasuredLandmarks& measured, const MeasuredFrames& frames,
                  const Anatomy& adult) {
  Anatomy anatomy = adult;
  ExpressInSegments(measured, frames, anatomy);
  const SegmentScales scales = ScalesOf(anatomy, adult);
  const double scapula_scale = scales[static_cast<std::size_t>(Segment::kScapula)];
  const auto set = [&](Landmark landmark, const Vector3& position_m) {
    if (!measured.Has(landmark)) {
      anatomy.landmarks_m[static_cast<std::size_t>(landmark)] = position_m;
    }
  };
  set(Landmark::kACJ, scapula_scale * adult.landmark_m(Landmark::kACJ));
  set(Landmark::kGC,
      anatomy.landmark_m(Landmark::kGH) +
          scapula_scale * (adult.landmark_m(Landmark::kGC) - adult.landmark_m(Landmark::kGH)));
  GrowTissues(adult, scales, anatomy);
  anatomy.jugular_notch_height_m =
      scales[static_cast<std::size_t>(Segment::kThorax)] * adult.jugular_notch_height_m;
  anatomy.has_adult_proportions = false;
  return anatomy;
}

// The frames of a file whose landmarks are right.
MeasuredFrames CheckedFrames(const MeasuredLandmarks& measured, const Anatomy& adult) {
  CheckLengths(measured, adult);
  const MeasuredFrames frames = FramesOf(measured);
  CheckEpicondyles(measured, frames);
  return frames;
}

}  // namespace

Anatomy ReadPersonAnatomy(std::istream& in, const std::string& name, const Anatomy& adult) {
  const MeasuredLandmarks measured(in, name);
  return AnatomyOf(measured, CheckedFrames(measured, adult), adult);
}

DigitizedPerson ReadDigitizedPerson(std::istream& in, const std::string& name,
                                    const Anatomy& adult) {
  const MeasuredLandmarks measured(in, name);
  if (!measured.is_lab()) {
    measured.Fail(Segment::kThorax, Landmark::kIJ,
                  "landmarks in the frames of their segments do not say how the person stood. Give "
                  "all in one frame, with '" +
                      std::string(kLaboratory) + "' as the segment of every row");
  }
  const MeasuredFrames frames = CheckedFrames(measured, adult);
  const auto q_AB = [&](Segment segment) { return frames.q_AB[static_cast<std::size_t>(segment)]; };
  DigitizedPerson person;
  person.anatomy = AnatomyOf(measured, frames, adult);
  person.q_AT = q_AB(Segment::kThorax);
  person.p_AT_m = frames.p_AB_m[static_cast<std::size_t>(Segment::kThorax)];
  const Quaternion q_AC = ClavicleFrame(measured.In(Segment::kClavicle, Landmark::kSC),
                                        measured.In(Segment::kClavicle, Landmark::kPAC),
                                        person.q_AT * Vector3{0, 1, 0});
  person.pose = {glm::conjugate(person.q_AT) * q_AC, glm::conjugate(q_AC) * q_AB(Segment::kScapula),
                 glm::conjugate(q_AB(Segment::kScapula)) * q_AB(Segment::kHumerus)};
  return person;
}

}  // namespace girdle
