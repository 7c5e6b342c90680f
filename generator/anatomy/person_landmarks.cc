// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/person_landmarks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/bone_frames.h"
#include "anatomy/found_gh.h"
#include "anatomy/landmark_places.h"
#include "anatomy/measured_landmarks.h"
#include "anatomy/posed_bones.h"
#include "kinematics/isb_frames.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// A frame that is turned by less counts as the frame itself: a few roundings of numbers near one.
constexpr double kRounding_rad = 1e-12;

// If a humerus's own frame is turned by half a turn about its y, and hardly otherwise, EM and EL
// are exchanged. A frame comes so near to a given rotation by chance once in a thousand.
constexpr double kNearHalfTurn_rad = 15 * kRadiansPerDegree;

// A distance between two landmarks of one segment.
struct Bone {
  Landmark from;
  Landmark to;
  Segment segment;
  // A person's length may be this many times as short or as long as an adult's.
  double shorter = 3;
  double longer = 3;
};
constexpr Bone kBones[] = {
    {Landmark::kIJ, Landmark::kPX, Segment::kThorax},
    {Landmark::kIJ, Landmark::kC7, Segment::kThorax},
    {Landmark::kC7, Landmark::kT8, Segment::kThorax},
    // The joint is so near to IJ that errors of the measurement matter.
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

std::string LengthText(double length_m) { return SignificantText(length_m, 3) + " m"; }

// Returns advice on the unit that a length seems to have, if not meters.
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
    // The origin of a segment is 0 0 0 in it, and so is IJ in the thorax.
    return SegmentFrom(landmark) == bone.segment ? Vector3{0, 0, 0} : adult.landmark_m(landmark);
  };
  return glm::distance(position(bone.from), position(bone.to));
}

// Throws if a distance between landmarks is outside the range of people.
void CheckLengths(const MeasuredLandmarks& measured, const Anatomy& adult) {
  for (const Bone& bone : kBones) {
    if (!measured.Has(bone.from) || !measured.Has(bone.to)) {
      continue;
    }
    const double adult_m = AdultLength_m(bone, adult);
    const double length_m =
        glm::distance(measured.In_m(bone.segment, bone.from), measured.In_m(bone.segment, bone.to));
    const double shortest_m = adult_m / bone.shorter;
    const double longest_m = adult_m * bone.longer;
    if (length_m >= shortest_m && length_m <= longest_m) {
      continue;
    }
    const std::string from(Name(bone.from));
    const std::string to(Name(bone.to));
    if (length_m == 0) {
      measured.Fail(bone.segment, bone.to, from + " and " + to + " are the same point");
    }
    measured.Fail(bone.segment, bone.to,
                  from + " to " + to + " is " + LengthText(length_m) + ", expected " +
                      LengthText(shortest_m) + " to " + LengthText(longest_m) + ". " +
                      UnitAdvice(length_m / adult_m));
  }
}

// Returns positions of landmarks in the frame that the file uses for one segment.
LandmarkPositions PositionsIn(const MeasuredLandmarks& measured, Segment segment) {
  LandmarkPositions p_A_m{};
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    p_A_m[i] = measured.In_m(segment, static_cast<Landmark>(i));
  }
  return p_A_m;
}

// Returns the segments' frames in the frames that the file uses. If no thorax is given in the frame
// of the clavicle, the clavicle's frame is the file's own: only its length is used, which no frame
// changes.
BoneFrames FramesOf(const MeasuredLandmarks& measured) {
  if (measured.is_lab()) {
    return BoneFramesOf(PositionsIn(measured, Segment::kThorax));
  }
  BoneFrames frames;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const auto segment = static_cast<Segment>(i);
    const LandmarkPositions p_A_m = PositionsIn(measured, segment);
    frames.q_AB[i] =
        segment == Segment::kClavicle ? Quaternion(1, 0, 0, 0) : BoneRotation(segment, p_A_m);
    frames.p_AB_m[i] = BoneFramesOf(p_A_m).p_AB_m[i];
  }
  return frames;
}

// Throws unless the landmarks are those of a right shoulder. A mesh in the frames of the file must
// be mirrored with them.
void CheckShape(const MeasuredLandmarks& measured, const std::string& mesh_file) {
  const auto at = [&](Segment segment, Landmark landmark) {
    return measured.In_m(segment, landmark);
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
    const Landmark landmark = FromName<Landmark>(flaw->landmark).value();
    measured.Fail(
        SegmentOf(landmark), landmark,
        flaw->message + (flaw->is_left_shoulder && !mesh_file.empty()
                             ? ", and mirror the mesh with them: negate the third "
                               "coordinate of every vertex of " +
                                   mesh_file + " and turn the order of the corners of every face"
                             : ""));
  }
}

// Throws if two landmarks have each other's names.
void CheckNames(const MeasuredLandmarks& measured, const Anatomy& adult) {
  const std::optional<ExchangedLandmarks> exchange =
      ExchangeIn(measured.Places(), measured.is_lab(), adult);
  if (!exchange) {
    return;
  }
  const std::string first = measured.NameIn(exchange->first);
  const std::string second = measured.NameIn(exchange->second);
  const bool is_first = exchange->misplaced == exchange->first;
  const std::string misplaced = is_first ? first : second;
  const Landmark blamed = measured.LineOf(exchange->first) < measured.LineOf(exchange->second)
                              ? exchange->first
                              : exchange->second;
  measured.Fail(SegmentOf(blamed), blamed,
                measured.NameIn(exchange->seen_from) + " to " + misplaced + " is " +
                    MillimeterText(exchange->distance_m) + " and to " +
                    (is_first ? second : first) + " " + MillimeterText(exchange->other_m) +
                    ", where bones of this size have " + misplaced + " at " +
                    MillimeterText(exchange->expected_m) + ": " + first + " and " + second +
                    " have each other's place. Swap their names, or measure " + misplaced +
                    " again if they are right");
}

// Throws if landmarks are from both sides of the body.
void CheckSides(const MeasuredLandmarks& measured, const Anatomy& adult) {
  if (!measured.is_lab()) {
    return;
  }
  if (const std::optional<StrayLandmark> stray = StrayIn(measured.Places(), adult)) {
    measured.Fail(SegmentOf(stray->landmark), stray->landmark,
                  measured.NameIn(stray->landmark) + " lies " + MillimeterText(stray->beyond_m) +
                      " to the " + (stray->is_left ? "left" : "right") +
                      " of the plane through IJ, C7 and the middle of PX and T8, " +
                      measured.NameIn(stray->other) +
                      " on its other side: these are landmarks of two sides. Give all of one side");
  }
}

// Throws if the epicondyles of a humerus seem to be exchanged.
void CheckEpicondyles(const MeasuredLandmarks& measured, const BoneFrames& frames) {
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

// Expresses the landmarks of the file in the ISB frames of their segments. Other landmarks stay.
void ExpressInSegments(const MeasuredLandmarks& measured, const BoneFrames& frames,
                       Anatomy& anatomy) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    if (!measured.Has(landmark)) {
      continue;
    }
    const Segment segment = SegmentOf(landmark);
    const Quaternion& q_AB = frames.q_AB[static_cast<std::size_t>(segment)];
    const Vector3 from_origin_m =
        measured.In_m(segment, landmark) - frames.p_AB_m[static_cast<std::size_t>(segment)];
    anatomy.landmarks_m[i] = AngleBetween(q_AB, Quaternion(1, 0, 0, 0)) < kRounding_rad
                                 ? from_origin_m
                                 : glm::conjugate(q_AB) * from_origin_m;
  }
  // The clavicle's z goes through PAC.
  Vector3& pac_m = anatomy.landmarks_m[static_cast<std::size_t>(Landmark::kPAC)];
  pac_m = {0, 0, glm::length(pac_m)};
}

// The landmarks of a file after all checks, with the frames that follow from them.
class CheckedLandmarks {
 public:
  CheckedLandmarks(std::istream& in, const std::string& name, const Anatomy& adult,
                   const std::string& mesh_file)
      : measured_(in, name) {
    CheckNames(measured_, adult);
    CheckSides(measured_, adult);
    gh_origin_ = FindGh(measured_, adult);
    CheckLengths(measured_, adult);
    CheckShape(measured_, mesh_file);
    frames_ = FramesOf(measured_);
    CheckEpicondyles(measured_, frames_);
  }

  [[nodiscard]] const MeasuredLandmarks& measured() const noexcept { return measured_; }
  [[nodiscard]] const BoneFrames& frames() const noexcept { return frames_; }
  [[nodiscard]] const std::string& gh_origin() const noexcept { return gh_origin_; }

 private:
  MeasuredLandmarks measured_;
  BoneFrames frames_;
  std::string gh_origin_;
};

Anatomy AnatomyOf(const CheckedLandmarks& checked, const Anatomy& adult) {
  const MeasuredLandmarks& measured = checked.measured();
  Anatomy anatomy = adult;
  anatomy.gh_origin = checked.gh_origin();
  ExpressInSegments(measured, checked.frames(), anatomy);
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

}  // namespace

Anatomy ReadPersonAnatomy(std::istream& in, const std::string& name, const Anatomy& adult) {
  return AnatomyOf(CheckedLandmarks(in, name, adult, ""), adult);
}

DigitizedPerson ReadDigitizedPerson(std::istream& in, const std::string& name, const Anatomy& adult,
                                    const std::string& mesh_file) {
  const CheckedLandmarks checked(in, name, adult, mesh_file);
  if (!checked.measured().is_lab()) {
    checked.measured().Fail(
        Segment::kThorax, Landmark::kIJ,
        "landmarks in the frames of their segments do not say how the person stood. Give "
        "all in one frame, with '" +
            std::string(kLaboratory) + "' as the segment of every row");
  }
  DigitizedPerson person;
  person.anatomy = AnatomyOf(checked, adult);
  person.q_AT = checked.frames().q_AB[static_cast<std::size_t>(Segment::kThorax)];
  person.p_AT_m = checked.frames().p_AB_m[static_cast<std::size_t>(Segment::kThorax)];
  person.pose = PoseOfBones(Side::kRight, checked.frames().q_AB);
  return person;
}

}  // namespace girdle
