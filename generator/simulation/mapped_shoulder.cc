// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/mapped_shoulder.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "anatomy/bone_frames.h"
#include "kinematics/isb_frames.h"
#include "kinematics/lengths.h"
#include "simulation/named_elements.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Limits for the sides of a landmark triangle, in children and adults [m].
constexpr double kShortestSide_m = 0.01;
constexpr double kLongestSide_m = 1;
constexpr int kMessageDigits = 3;

constexpr std::array<std::pair<Segment, std::string_view>, 3> kTriangleNames = {{
    {Segment::kThorax, "IJ, C7 and the middle of PX and T8"},
    {Segment::kScapula, "PAC, TS and AI"},
    {Segment::kHumerus, "GH, EM and EL"},
}};

// Returns the number of the site or body.
int IdOf(const mjModel& model, const MappedLandmark& landmark, const std::string& file) {
  if (const auto* const site = std::get_if<MappedSite>(&landmark.place)) {
    return FindElement(model, mjOBJ_SITE, site->name, file, landmark.line);
  }
  return FindElement(model, mjOBJ_BODY, std::get<MappedBodyPoint>(landmark.place).body, file,
                     landmark.line);
}

}  // namespace

MappedShoulder::MappedShoulder(const mjModel& model, const ModelMapping& mapping)
    : mapping_(mapping) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const std::optional<MappedLandmark>& landmark = mapping.landmarks[i];
    landmark_ids_[i] = landmark ? IdOf(model, *landmark, mapping.file) : -1;
  }
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const std::optional<MappedBone>& bone = mapping.bones[i];
    body_ids_[i] = bone ? FindElement(model, mjOBJ_BODY, bone->body, mapping.file, bone->line) : -1;
  }
}

Vector3 MappedShoulder::Position(const mjData& data, Landmark landmark) const {
  const auto index = static_cast<std::size_t>(landmark);
  const MappedLandmark& mapped = *mapping_.landmarks[index];
  const int id = landmark_ids_[index];
  const auto* const body_point = std::get_if<MappedBodyPoint>(&mapped.place);
  const mjtNum* p = (body_point == nullptr ? data.site_xpos : data.xpos) + 3 * id;
  Vector3 position_m{p[0], p[1], p[2]};
  if (body_point != nullptr) {
    const mjtNum* q = data.xquat + 4 * id;
    position_m += Quaternion(q[0], q[1], q[2], q[3]) * body_point->point_m;
  }
  // A left shoulder is mirrored into a right one.
  return OnSide(mapping_.side, position_m);
}

bool MappedShoulder::IsByLandmarks(Segment segment) const {
  const std::vector<Landmark>& needed = FrameLandmarks(segment);
  return !mapping_.bone(segment) &&
         std::all_of(needed.begin(), needed.end(),
                     [this](Landmark landmark) { return mapping_.landmark(landmark).has_value(); });
}

std::array<Vector3, 3> MappedShoulder::Triangle(const mjData& data, Segment segment) const {
  const auto at = [&](Landmark landmark) { return Position(data, landmark); };
  switch (segment) {
    case Segment::kThorax:
      return {at(Landmark::kIJ), at(Landmark::kC7), (at(Landmark::kPX) + at(Landmark::kT8)) / 2.0};
    case Segment::kHumerus:
      return {at(Landmark::kGH), at(Landmark::kEM), at(Landmark::kEL)};
    default:
      return {at(Landmark::kPAC), at(Landmark::kTS), at(Landmark::kAI)};
  }
}

Quaternion MappedShoulder::Frame(const mjData& data, Segment segment) const {
  if (const std::optional<MappedBone>& bone = mapping_.bone(segment)) {
    const mjtNum* q = data.xquat + 4 * body_ids_[static_cast<std::size_t>(segment)];
    const Quaternion q_WF = Quaternion(q[0], q[1], q[2], q[3]) * bone->q_BF;
    return OnSide(mapping_.side, q_WF);
  }
  LandmarkPositions p_W_m{};
  for (const Landmark landmark : FrameLandmarks(segment)) {
    p_W_m[static_cast<std::size_t>(landmark)] = Position(data, landmark);
  }
  return BoneRotation(segment, p_W_m);
}

MappedPose MappedShoulder::Observe(const mjData& data) const {
  const Quaternion q_TW = glm::conjugate(Frame(data, Segment::kThorax));
  MappedPose pose;
  pose.q_TS = q_TW * Frame(data, Segment::kScapula);
  pose.q_TH = q_TW * Frame(data, Segment::kHumerus);
  if (mapping_.bone(Segment::kClavicle)) {
    pose.q_TC = q_TW * Frame(data, Segment::kClavicle);
    pose.clavicle_axis_T = *pose.q_TC * Vector3(0, 0, 1);
  } else if (IsByLandmarks(Segment::kClavicle)) {
    pose.clavicle_axis_T =
        q_TW * ClavicleAxis(Position(data, Landmark::kSC), Position(data, Landmark::kPAC));
  }
  if (mapping_.landmark(Landmark::kIJ)) {
    for (std::size_t i = 0; i < kGlidingLandmarks.size(); ++i) {
      const Landmark landmark = kGlidingLandmarks[i];
      if (mapping_.landmark(landmark)) {
        pose.border_T_m[i] = q_TW * (Position(data, landmark) - Position(data, Landmark::kIJ));
      }
    }
  }
  for (const auto& [segment, names] : kTriangleNames) {
    if (IsByLandmarks(segment)) {
      const std::array<Vector3, 3> corners_m = Triangle(data, segment);
      for (std::size_t i = 0; i < corners_m.size(); ++i) {
        pose.bone_lengths_m.push_back(glm::distance(corners_m[i], corners_m[(i + 1) % 3]));
      }
    }
  }
  return pose;
}

std::size_t MappedShoulder::LineOf(Landmark landmark) const {
  return mapping_.landmark(landmark)->line;
}

void MappedShoulder::ExpectSound(const mjData& data) const {
  for (const auto& [segment, names] : kTriangleNames) {
    if (!IsByLandmarks(segment)) {
      continue;
    }
    const std::size_t line = LineOf(FrameLandmarks(segment).back());
    const std::array<Vector3, 3> p = Triangle(data, segment);
    const std::array<double, 3> sides_m = {glm::distance(p[0], p[1]), glm::distance(p[1], p[2]),
                                           glm::distance(p[2], p[0])};
    const auto [shortest_m, longest_m] = std::minmax_element(sides_m.begin(), sides_m.end());
    if (*shortest_m < kShortestSide_m || *longest_m > kLongestSide_m) {
      throw InputError(mapping_.file, line,
                       std::string(names) + " are " + SignificantText(*shortest_m, kMessageDigits) +
                           " to " + SignificantText(*longest_m, kMessageDigits) +
                           " m apart in the model, expected " + NumberText(kShortestSide_m) +
                           " to " + NumberText(kLongestSide_m) +
                           ". Correct the points; the model has to be in meters");
    }
    // Twice the area is side times height. The smallest height belongs to the longest side.
    const double height_m = glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / *longest_m;
    if (height_m < kNearlyOnALine * *longest_m) {
      throw InputError(mapping_.file, line,
                       std::string(names) + " lie nearly on a line, " +
                           SignificantText(kMillimetersPerMeter * height_m, kMessageDigits) +
                           " mm off it, and tell no frame. Correct the points");
    }
  }
  const std::optional<MappedLandmark>& sc = mapping_.landmark(Landmark::kSC);
  if (sc && IsByLandmarks(Segment::kClavicle) &&
      glm::distance(Position(data, Landmark::kSC), Position(data, Landmark::kPAC)) <
          kShortestSide_m) {
    throw InputError(mapping_.file, sc->line,
                     "SC and PAC are in one place, and tell no clavicle. Correct the points");
  }
  const Vector3 scapula_z_T = Observe(data).q_TS * Vector3(0, 0, 1);
  if (scapula_z_T.z <= 0) {
    const std::string side(Name(mapping_.side));
    throw InputError(mapping_.file + ": the scapula points to the middle of the body (z of its " +
                     "frame in the thorax " + RoundedText(scapula_z_T.z, kMessageDigits) +
                     "), which no " + side +
                     " shoulder does. Correct the side, or swap TS and PAC");
  }
}

}  // namespace girdle
