// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Which parts of somebody else's model are the bones of a shoulder, and what moves its arm.
///
/// A file has the columns `part`, `by`, `name` and, where a row needs them, numbers; an empty cell
/// is no number. A row is one of
///
///     part                      by        name     numbers
///     side                                right    none (or left)
///     a bony landmark           site      a site   none
///     a bony landmark           body      a body   x_m, y_m, z_m: the point in the body's frame
///     thorax, clavicle,         body      a body   y_deg, x_deg, z_deg: the turns Y-X'-Z'' that
///     scapula, humerus                             take the body's axes into the bone's
///     arm                       joint     a hinge  per_elevation, per_plane, per_axial, offset_deg
///     arm                       actuator  one      the same
///
/// A bone's axes are those of the ISB: x forward, y up, z to the right, on both sides of the body.
/// A joint's coordinate, or an actuator's control, is
///
///     per_elevation theta + per_plane psi + per_axial gamma + offset        [rad]
///
/// of the direction (theta, psi) and the turn about the long axis (gamma, internal +) that the
/// humerus is to have in the thorax: q_TH = Y(psi) X(-theta) Y(gamma). Absent factors are 0.
#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/rotation.h"
#include "names/model_names.h"

namespace girdle {

/// A site of a model.
struct MappedSite {
  std::string name;
};

/// A point of one of a model's bodies.
struct MappedBodyPoint {
  std::string body;
  Vector3 point_m{0, 0, 0};  ///< in the body's frame
};

/// Where a landmark is in a model.
struct MappedLandmark {
  std::variant<MappedSite, MappedBodyPoint> place;
  std::size_t line = 0;  ///< of the file, from 1
};

/// A bone whose frame F is fixed in a body B.
struct MappedBone {
  std::string body;
  Quaternion q_BF{1, 0, 0, 0};
  std::size_t line = 0;
};

/// A joint or an actuator that sets the arm.
struct MappedDrive {
  std::string name;
  double per_elevation = 0;
  double per_plane = 0;
  double per_axial = 0;
  double offset_rad = 0;
  std::size_t line = 0;
};

/// Every bone but the clavicle is given, by its own row or by the landmarks of its frame.
struct ModelMapping {
  std::string file;  ///< stands in messages for it
  Side side = Side::kRight;
  std::array<std::optional<MappedLandmark>, kLandmarkCount> landmarks;  ///< in Landmark's order
  std::array<std::optional<MappedBone>, kSegmentCount> bones;           ///< in Segment's order
  std::vector<MappedDrive> drives;                                      ///< all of one kind
  bool drives_are_actuators = false;

  [[nodiscard]] const std::optional<MappedLandmark>& landmark(Landmark landmark) const noexcept {
    return landmarks[static_cast<std::size_t>(landmark)];
  }
  [[nodiscard]] const std::optional<MappedBone>& bone(Segment segment) const noexcept {
    return bones[static_cast<std::size_t>(segment)];
  }
};

/// Landmarks that make a bone's frame. PAC is the end of the clavicle and the scapula's origin, as
/// in data/landmarks.csv.
[[nodiscard]] const std::vector<Landmark>& FrameLandmarks(Segment segment);

/// Reads a mapping. Throws InputError, with file and line, at the first row that cannot be: an
/// unknown word, a part that stands twice, a number where none belongs or none where one does, a
/// point more than a meter from its body (millimetres where metres are meant), joints and actuators
/// together; and if a bone or what sets elevation or plane is missing.
[[nodiscard]] ModelMapping ReadModelMapping(std::istream& in, const std::string& name);

}  // namespace girdle
