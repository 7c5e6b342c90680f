// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Commands in degrees, how they are shown when a test fails, and poses held against each other.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <ostream>
#include <vector>

#include "kinematics/random_rotations.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/worst_case.h"

namespace girdle {

inline void showValue(Interpolation interpolation, std::ostream& out) {
  out << Name(interpolation);
}
inline void PrintTo(const Interpolation& interpolation, std::ostream* out) {
  showValue(interpolation, *out);
}

inline void showValue(Closure closure, std::ostream& out) { out << Name(closure); }
inline void PrintTo(const Closure& closure, std::ostream* out) { showValue(closure, *out); }

inline void showValue(const ArmCommand& command, std::ostream& out) {
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << "elevation "
      << DegreesFromRadians(command.elevation_rad) << " deg, plane "
      << DegreesFromRadians(command.plane_rad) << " deg, axial "
      << DegreesFromRadians(command.axial_rad) << " deg from " << Name(command.axial_from)
      << ", shrug " << DegreesFromRadians(command.shrug_rad) << " deg, protraction "
      << DegreesFromRadians(command.protraction_rad) << " deg";
}
inline void PrintTo(const ArmCommand& command, std::ostream* out) { showValue(command, *out); }
inline std::ostream& operator<<(std::ostream& out, const ArmCommand& command) {
  showValue(command, out);
  return out;
}

inline void showValue(AxialFrom zero, std::ostream& out) { out << Name(zero); }
inline void PrintTo(const AxialFrom& zero, std::ostream* out) { showValue(zero, *out); }

inline ArmCommand Command_deg(double elevation_deg, double plane_deg, double axial_deg = 0,
                              double shrug_deg = 0, double protraction_deg = 0) {
  return {RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg),
          RadiansFromDegrees(axial_deg), RadiansFromDegrees(shrug_deg),
          RadiansFromDegrees(protraction_deg)};
}

/// A command within the table.
inline rc::Gen<ArmCommand> InnerCommand() {
  return rc::gen::exec([] { return Command_deg(*NumberWithin(15, 120), *NumberWithin(0, 90)); });
}

inline rc::Gen<AxialFrom> AnyAxialFrom() {
  return rc::gen::element(AxialFrom::kRhythm, AxialFrom::kIsb, AxialFrom::kSwing);
}

/// From `first` to `last` in even steps.
inline std::vector<double> Steps(double first, double last, int count) {
  std::vector<double> steps(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) {
    steps[static_cast<std::size_t>(i)] = first + (last - first) * i / count;
  }
  return steps;
}

inline std::array<Quaternion, kJointCount> Joints(const ShoulderPose& pose) {
  return {pose.q_TC, pose.q_CS, pose.q_SH};
}

/// Largest angle between the joints of two poses; no number if one is none.
inline double Apart_rad(const ShoulderPose& a, const ShoulderPose& b) {
  double apart_rad = 0;
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    apart_rad = WorseOf(apart_rad, AngleBetween(Joints(a)[joint], Joints(b)[joint]));
  }
  return apart_rad;
}

inline bool SameBits(const ShoulderPose& a, const ShoulderPose& b) {
  const auto joints_a = Joints(a);
  const auto joints_b = Joints(b);
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    for (int i = 0; i < 4; ++i) {
      if (std::bit_cast<std::uint64_t>(joints_a[joint][i]) !=
          std::bit_cast<std::uint64_t>(joints_b[joint][i])) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace girdle
