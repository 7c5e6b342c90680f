// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The way of the arm from one command to the next.
///
/// The humerus points in a direction on the sphere, of which elevation and plane are coordinates as
/// latitude and longitude are on the globe. The way goes along the great circle with constant
/// speed, so that it is the shortest whatever the planes are called: from plane 1 to plane 359 it
/// is two degrees long, and past hanging it goes straight. The axial turn goes the short way round;
/// offsets go straight.
///
/// Exactly opposite directions have no shortest way. The arm then goes past hanging, where both are
/// in one vertical plane; between hanging and straight up, in the plane of the row that is straight
/// up.
///
/// An axial turn from ISB's zero has a meaning together with the plane alone: hanging, it jumps
/// with it. On the way the whole turn of the humerus, plane + axial (axial_zero.h), goes the short
/// way.
#pragma once

#include <cstddef>
#include <vector>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// A command at a time.
struct TimedCommand {
  double time_s = 0;
  ArmCommand command;
};

/// Commands in order of their times, with the way from each to the next.
///
/// Hanging is one direction in every plane. The plane commanded is there that of the way to it,
/// turns while the arm hangs, and is that of the way from it when the arm leaves: the planes of
/// rows that hang have no meaning and are not used, unless all rows hang. Straight up the humerus
/// turns with the plane, and the planes of rows are used.
///
/// The plane commanded jumps in an instant where the arm passes hanging, or is straight up in
/// another plane than that of the way to it; and it goes on from 180 as -180. It is continuous
/// elsewhere, and within [-pi, pi].
class ArmPath {
 public:
  /// Precondition: one row or more, which count axial turns from one zero, times increasing,
  /// elevations within [0, pi], planes within [-pi, pi].
  explicit ArmPath(const std::vector<TimedCommand>& commands);

  /// The command at a time [s]; held before the first row and after the last. At the time of a row
  /// it is the row's own, to the last bit, but for the plane of one that hangs and, counted from
  /// ISB's zero, its axial turn, which is the same humerus's.
  [[nodiscard]] ArmCommand At(double time_s) const noexcept;

 private:
  /// From one row to the next.
  struct Stretch {
    TimedCommand from;
    TimedCommand to;
  };

  /// Gives rows [begin, end), which hang, their planes.
  void TakePlanesOfTheWay(const std::vector<TimedCommand>& rows, std::size_t begin,
                          std::size_t end);

  std::vector<Stretch> stretches_;  ///< one at least; axial from ISB's zero is the whole turn
};

/// Returns the number that is a share of the straight way from one to another.
[[nodiscard]] double Between(double from, double to, double share) noexcept;

/// Returns `to_rad - from_rad` the short way round, within [-pi, pi].
[[nodiscard]] double ShortWay_rad(double from_rad, double to_rad) noexcept;

}  // namespace girdle
