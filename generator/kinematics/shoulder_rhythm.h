// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Data-driven shoulder inverse kinematics: from where the arm points to the rotations of SC, AC
/// and GH.
///
/// Kim, Park, Jung, Han, "Data-driven shoulder inverse kinematics"; equation numbers are theirs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "kinematics/rhythm_table.h"
#include "kinematics/rotation_spline.h"
#include "kinematics/shoulder_pose.h"

namespace girdle {

/// How rotations between the measured positions are found.
enum class Interpolation {
  kSquad,  ///< as published: C1 along elevation, continuous along plane
  kSlerp,  ///< the paper's comparison: continuous
};

/// How the three joints are made to agree with the direction commanded.
enum class Closure {
  kTable,  ///< as published: all three joints come from the table, the arm goes where they take it
};

/// Words of the command line and of the plugin's configuration, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kInterpolationNames = {"squad", "slerp"};
inline constexpr std::array<std::string_view, 1> kClosureNames = {"table"};

[[nodiscard]] std::optional<Interpolation> InterpolationFromName(std::string_view name) noexcept;
[[nodiscard]] std::optional<Closure> ClosureFromName(std::string_view name) noexcept;
[[nodiscard]] std::string_view Name(Interpolation interpolation) noexcept;
[[nodiscard]] std::string_view Name(Closure closure) noexcept;

struct RhythmOptions {
  Interpolation interpolation = Interpolation::kSquad;
  Closure closure = Closure::kTable;
};

/// What is asked of the shoulder.
struct ArmCommand {
  double elevation_rad =
      0;  ///< angle between humerus and hanging down; clamped to the table's elevations
  double plane_rad = 0;  ///< 0 frontal, pi/2 sagittal; clamped to the table's planes
  double axial_rad =
      0;  ///< turn about the humerus's own long axis on top of the measured one, internal +
};

/// Cell of the grid that holds a command and the place within it.
struct RhythmCell {
  std::size_t elevation_index;  ///< i of equation (6): the cell lies between knots i and i + 1
  std::size_t plane_index;      ///< j of equation (7)
  double elevation_weight;      ///< t_theta of equation (8), [0, 1]
  double plane_weight;          ///< t_psi of equation (9), [0, 1]
};

/// Result of the inverse kinematics. "Not reached" is part of it, not an error.
struct ShoulderSolution {
  ShoulderPose pose;
  RhythmCell cell;
  /// True if the command lay outside the table and its nearest point was used.
  bool clamped;
  /// Distance of the command from the table's domain in the (elevation, plane) chart [rad]; 0
  /// inside.
  double distance_rad;
};

/// Interpolant of a measured shoulder rhythm. Immutable; evaluation is thread-safe and allocates
/// nothing.
class ShoulderRhythm {
 public:
  /// Throws std::invalid_argument if neighbouring planes differ by 180 degrees or more, so that the
  /// way between them is not determined.
  explicit ShoulderRhythm(RhythmTable table, RhythmOptions options = {});

  /// Returns the pose for a command, equations (4) to (12). Total: outside the table the nearest
  /// point of its domain is used, and a NaN counts as the lowest elevation or plane and as an axial
  /// turn of zero.
  [[nodiscard]] ShoulderSolution Solve(const ArmCommand& command) const noexcept;

  /// Returns how far a command lies outside the table's domain in the (elevation, plane) chart
  /// [rad]; 0 inside, and for a NaN.
  [[nodiscard]] double DistanceOutside(double elevation_rad, double plane_rad) const noexcept;

  [[nodiscard]] const RhythmTable& table() const noexcept { return table_; }
  [[nodiscard]] const RhythmOptions& options() const noexcept { return options_; }

 private:
  /// One plane: the three joints at its elevations, and squad's inner control points.
  struct Series {
    std::vector<JointRotations> knots;
    std::vector<JointRotations> controls;
  };

  void AlignSigns(std::size_t plane, std::size_t elevation);
  [[nodiscard]] JointRotations AlongElevation(std::size_t plane,
                                              const RhythmCell& cell) const noexcept;
  [[nodiscard]] JointRotations RotationsIn(const RhythmCell& cell) const noexcept;

  RhythmTable table_;
  RhythmOptions options_;
  std::vector<Series> series_;  ///< one a plane
};

}  // namespace girdle
