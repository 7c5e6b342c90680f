// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The parts of a foreign model that are the bones of a shoulder, and the joints or actuators that
/// move its arm.
///
/// A file has the columns `part`, `by`, `name` and, for rows that need them, numbers. An empty cell
/// is no number. A row is one of these:
///
///     part                      by        name     numbers
///     side                                right    none (or left)
///     a bony landmark           site      a site   none
///     a bony landmark           body      a body   x_m, y_m, z_m: the point in the body's frame
///     thorax, clavicle,         body      a body   y_deg, x_deg, z_deg: the turns Y-X'-Z'' that
///     scapula, humerus                             take the body's axes into the bone's
///     arm                       joint     a hinge  per_elevation, per_plane, per_axial, offset_deg
///     arm                       actuator  one      per_elevation, per_plane, per_axial, offset_deg
///
/// A bone's axes are those of the ISB: x forward, y up, z to the right, on both sides of the body.
/// The coordinate of a joint, or the control of an actuator, is
///
///     per_elevation theta + per_plane psi + per_axial gamma + offset        [rad]
///
/// Here (theta, psi) is the direction of the humerus in the thorax and gamma its turn about the
/// long axis (internal +): q_TH = Y(psi) X(-theta) Y(gamma). Absent factors are 0.
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

/// The place of a landmark in a model.
struct MappedLandmark {
  std::variant<MappedSite, MappedBodyPoint> place;
  std::size_t line = 0;  ///< line of the file, from 1
};

/// A bone. Its frame F is fixed in a body B.
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

/// A mapping. Every bone except the clavicle is given, either by its own row or by the landmarks of
/// its frame.
struct ModelMapping {
  std::string file;  ///< the mapping's name in messages
  Side side = Side::kRight;
  std::array<std::optional<MappedLandmark>, kLandmarkCount> landmarks;  ///< in Landmark's order
  std::array<std::optional<MappedBone>, kSegmentCount> bones;           ///< in Segment's order
  std::vector<MappedDrive> drives;  ///< either all joints or all actuators
  bool drives_are_actuators = false;

  [[nodiscard]] const std::optional<MappedLandmark>& landmark(Landmark landmark) const noexcept {
    return landmarks[static_cast<std::size_t>(landmark)];
  }
  [[nodiscard]] const std::optional<MappedBone>& bone(Segment segment) const noexcept {
    return bones[static_cast<std::size_t>(segment)];
  }
};

/// Returns the landmarks that define a bone's frame. PAC is the end of the clavicle and the origin
/// of the scapula, as in data/landmarks.csv.
[[nodiscard]] const std::vector<Landmark>& FrameLandmarks(Segment segment);

/// Reads a mapping. Throws InputError, with file and line, at the first invalid row: an unknown
/// word, a repeated part, a number too many or too few, a point more than a meter from its body
/// (millimetres instead of metres), or joints and actuators together. Throws it also if a bone is
/// missing, or the row that sets elevation or plane.
[[nodiscard]] ModelMapping ReadModelMapping(std::istream& in, const std::string& name);

}  // namespace girdle
