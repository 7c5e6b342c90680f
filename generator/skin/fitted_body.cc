// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/fitted_body.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "anatomy/body_size.h"
#include "anatomy/posed_bones.h"
#include "skin/built_in_files.h"
#include "text/csv.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

constexpr double kMostVertices = 1e6;
constexpr double kFarthest_m = 2;
// Limits of a bone's scale in people.
constexpr double kSmallestScale = 0.3;
constexpr double kLargestScale = 3;

// A row of the file of a fit: a number within bounds, or a text.
struct NumberRow {
  std::string_view name;
  double MakeHumanFit::*value;
  double lower;
  double upper;
};
constexpr NumberRow kNumberRows[] = {
    {"notch_skin_m", &MakeHumanFit::notch_skin_m, 0, kFarthest_m},
    {"shoulder_medially_m", &MakeHumanFit::shoulder_medially_m, -kFarthest_m, kFarthest_m},
    {"elbow_medially_m", &MakeHumanFit::elbow_medially_m, -kFarthest_m, kFarthest_m},
    {"thorax_scale", &MakeHumanFit::thorax_scale, kSmallestScale, kLargestScale},
    {"scapula_scale", &MakeHumanFit::scapula_scale, kSmallestScale, kLargestScale},
    {"waist_below_notch_m", &MakeHumanFit::waist_below_notch_m, 0, kFarthest_m},
    {"neck_above_notch_m", &MakeHumanFit::neck_above_notch_m, 0, kFarthest_m},
};
struct TextRow {
  std::string_view name;
  std::string MakeHumanFit::*value;
};
constexpr TextRow kTextRows[] = {
    {"shoulder_joint", &MakeHumanFit::shoulder_joint},
    {"elbow_joint", &MakeHumanFit::elbow_joint},
    {"wrist_joint", &MakeHumanFit::wrist_joint},
};
constexpr std::string_view kVertexRow = "notch_vertex";

// Place on the upper arm, as a share of its length, where the twist of a turned forearm begins.
constexpr double kTwistBegins = 0.4;

Vector3 Rounded(const Vector3& position_m) {
  const double steps = std::pow(10.0, kLandmarkDecimals);
  return glm::round(position_m * steps) / steps;
}

const Vector3& JointOf(const MakeHumanBody& man, const std::string& name) {
  const auto joint = man.joints_m.find(name);
  if (joint == man.joints_m.end()) throw std::invalid_argument("the body has no '" + name + "'");
  return joint->second;
}

// Returns the surface in the thorax frame.
TriangleMesh InThorax(TriangleMesh surface, const Vector3& notch_m) {
  for (Vector3& vertex : surface.vertices_m) vertex -= notch_m;
  return surface;
}

// Returns the smallest rotation from one unit vector to another. Precondition: they are not
// opposite.
Quaternion RotationBetween(const Vector3& from, const Vector3& to) {
  return glm::normalize(Quaternion(1 + glm::dot(from, to), glm::cross(from, to)));
}

// Returns the humerus in the thorax. Its long axis is `upward`, from the elbow to GH, and its turn
// about that axis is the rhythm's.
Quaternion HumerusInThorax(const Vector3& upward, const ShoulderRhythm& rhythm) {
  const Vector3 y{0, 1, 0};
  const ArmAngles arm = ArmAnglesFromRotation(RotationBetween(y, upward));
  const Quaternion q_TH = rhythm.SolvePose({arm.elevation_rad, arm.plane_rad}).q_TH();
  // With the closure table, or outside its range, the rhythm's own humerus has a slightly other
  // axis.
  return RotationBetween(q_TH * y, upward) * q_TH;
}

// Sets the bones to those of `adult` in other sizes, and sets the pose that they have in the body.
void PlaceBones(const MakeHumanBody& man, const MakeHumanFit& fit, const Vector3& notch_m,
                const Anatomy& adult, const Posture& relaxed, const ShoulderRhythm& rhythm,
                PosedBody& body) {
  const Vector3 shoulder_m =
      JointOf(man, fit.shoulder_joint) - notch_m - Vector3{0, 0, fit.shoulder_medially_m};
  const Vector3 elbow_m =
      JointOf(man, fit.elbow_joint) - notch_m - Vector3{0, 0, fit.elbow_medially_m};
  const Vector3 sc_m = fit.thorax_scale * adult.landmark_m(Landmark::kSC);
  const Quaternion q_TS = relaxed.q_TC * relaxed.q_CS;
  const Vector3 p_TS_m = shoulder_m - q_TS * (fit.scapula_scale * adult.landmark_m(Landmark::kGH));
  const Vector3 clavicle_m = p_TS_m - sc_m;
  const Vector3 humerus_m = shoulder_m - elbow_m;

  const Vector3 z_relaxed = relaxed.q_TC * Vector3{0, 0, 1};
  const Quaternion q_TC = RotationBetween(z_relaxed, glm::normalize(clavicle_m)) * relaxed.q_TC;
  body.pose = {q_TC, glm::conjugate(q_TC) * q_TS,
               glm::conjugate(q_TS) * HumerusInThorax(glm::normalize(humerus_m), rhythm)};

  const SegmentScales scales = {
      fit.thorax_scale, glm::length(clavicle_m) / glm::length(adult.landmark_m(Landmark::kPAC)),
      fit.scapula_scale, glm::length(humerus_m) / glm::length(adult.elbow_m())};
  Anatomy& anatomy = body.anatomy;
  anatomy = adult;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    anatomy.landmarks_m[i] =
        Rounded(scales[static_cast<std::size_t>(kLandmarks[i].segment)] * adult.landmarks_m[i]);
  }
  GrowTissues(adult, ScalesOf(anatomy, adult), anatomy);
  anatomy.has_adult_proportions = false;
  double ground_m = 0;
  for (const Vector3& vertex : man.surface.vertices_m)
    ground_m = std::min(ground_m, vertex.y - notch_m.y);
  anatomy.jugular_notch_height_m = -ground_m;
}

// Returns which vertices move with the arms of these sides.
std::vector<bool> ArmsOf(const SkinWeights& artist, const std::vector<Side>& sides) {
  const auto bones = SkinBonesOf({Side::kRight, Side::kLeft});
  std::vector<bool> is_arm(artist[0].size());
  for (std::size_t i = 0; i < is_arm.size(); ++i) {
    double share = 0;
    for (std::size_t k = 0; k < bones.size(); ++k) {
      const bool is_of_side = std::find(sides.begin(), sides.end(), bones[k].side) != sides.end();
      if (bones[k].segment == Segment::kHumerus && is_of_side) share += artist[k][i];
    }
    is_arm[i] = share > 0.5;
  }
  return is_arm;
}

// Turns the forearms about the humeri until they point in the direction in which the humeri bend
// the elbow: along x.
void TurnForearms(const Vector3& forearm_m, const SkinWeights& artist, PosedBody& body) {
  const Quaternion q_TH = body.pose.q_TH();
  const Vector3 in_humerus = glm::conjugate(q_TH) * forearm_m;
  const double turn_rad = std::atan2(in_humerus.z, in_humerus.x);
  const double length_m = glm::length(body.anatomy.elbow_m());
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const std::vector<bool> is_arm = ArmsOf(artist, {side});
    const Vector3 shoulder_m = InThorax_m(body.anatomy, body.pose, Segment::kHumerus, {0, 0, 0});
    for (std::size_t i = 0; i < is_arm.size(); ++i) {
      if (!is_arm[i]) continue;
      Vector3& vertex = body.surface.vertices_m[i];
      const Vector3 p_H = glm::conjugate(q_TH) * (OnSide(side, vertex) - shoulder_m);
      const double share =
          std::clamp((-p_H.y / length_m - kTwistBegins) / (1 - kTwistBegins), 0.0, 1.0);
      const Quaternion twist = QuaternionFromEuler(EulerSequence::kYXZ, {share * turn_rad, 0, 0});
      vertex = OnSide(side, shoulder_m + q_TH * (twist * p_H));
    }
  }
}

}  // namespace

MakeHumanFit ReadMakeHumanFit(std::istream& in, const std::string& name) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns({"quantity", "value"});
  const std::size_t quantity = csv.Column("quantity");
  const std::size_t value = csv.Column("value");
  std::vector<std::string_view> missing = {kVertexRow};
  for (const NumberRow& row : kNumberRows) missing.push_back(row.name);
  for (const TextRow& row : kTextRows) missing.push_back(row.name);
  MakeHumanFit fit;
  while (csv.Next()) {
    const std::string_view key = csv.Field(quantity);
    const auto found = std::find(missing.begin(), missing.end(), key);
    if (found == missing.end()) {
      csv.Fail("'" + ShortText(key) + "' is not known, or is given twice");
    }
    missing.erase(found);
    if (key == kVertexRow) {
      const double vertex = csv.NumberWithin(value, 0, kMostVertices);
      if (vertex != std::floor(vertex)) csv.Fail("a vertex has a whole number");
      fit.notch_vertex = static_cast<int>(vertex);
    }
    for (const NumberRow& row : kNumberRows) {
      if (row.name == key) fit.*row.value = csv.NumberWithin(value, row.lower, row.upper);
    }
    for (const TextRow& row : kTextRows) {
      if (row.name == key) fit.*row.value = std::string(csv.Field(value));
    }
  }
  if (!missing.empty()) csv.Fail("no row for " + std::string(missing.front()));
  return fit;
}

MakeHumanFit BuiltInMakeHumanFit() {
  std::istringstream in{std::string(built_in_files::kMakeHumanFit)};
  return ReadMakeHumanFit(in, "data/makehuman_fit.csv");
}

FittedBody FitBones(const MakeHumanBody& man, const MakeHumanFit& fit, const Anatomy& adult,
                    const Posture& relaxed, const ShoulderRhythm& rhythm, Head head) {
  const auto notch_vertex = static_cast<std::size_t>(fit.notch_vertex);
  if (notch_vertex >= man.surface.vertices_m.size()) {
    throw std::invalid_argument("the body has no vertex " + std::to_string(fit.notch_vertex));
  }
  const Vector3 notch_m =
      InMedianPlane(man.surface.vertices_m[notch_vertex]) - Vector3{fit.notch_skin_m, 0, 0};
  FittedBody fitted;
  PlaceBones(man, fit, notch_m, adult, relaxed, rhythm, fitted.body);

  fitted.body.surface = InThorax(man.surface, notch_m);
  TurnForearms(JointOf(man, fit.wrist_joint) - JointOf(man, fit.elbow_joint), man.artist,
               fitted.body);

  // The arms are spared, because they hang beside the trunk below its cut.
  const std::vector<Side> both = {Side::kRight, Side::kLeft};
  WeightedSurface surface{std::move(fitted.body.surface), man.artist};
  surface =
      Cut(surface, {{0, -fit.waist_below_notch_m, 0}, {0, -1, 0}}, ArmsOf(surface.weights, both));
  if (head == Head::kCut) {
    surface =
        Cut(surface, {{0, fit.neck_above_notch_m, 0}, {0, 1, 0}}, ArmsOf(surface.weights, both));
  }
  fitted.body.surface = std::move(surface.mesh);
  fitted.artist = std::move(surface.weights);
  return fitted;
}

}  // namespace girdle
