// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The path of the arm from one command to the next.
///
/// The humerus points in a direction on a sphere. Elevation and plane are its coordinates, as
/// latitude and longitude are on the globe. The path follows the great circle at constant speed, so
/// it is the shortest one for any numbers of the planes: from plane 1 to plane 359 it is two
/// degrees long, and past hanging it is straight. The axial turn takes the short way round. Offsets
/// change linearly.
///
/// Exactly opposite directions have no shortest path. The arm then goes past hanging, so both
/// directions are in one vertical plane. Between hanging and straight up it goes in the plane of
/// the row that is straight up.
///
/// An axial turn from ISB's zero has a meaning together with the plane only: if the arm hangs, both
/// jump together. On the path the whole turn of the humerus, plane + axial (axial_zero.h), takes
/// the short way.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// A command with its time.
struct TimedCommand {
  double time_s = 0;
  ArmCommand command;
};

/// Commands in order of their times, and the path from each to the next.
///
/// All planes are the same direction if the arm hangs. The planes of rows that hang have no meaning
/// and are not used, unless all rows hang. The commanded plane is instead that of the path: on the
/// way to hanging it is the plane of that way, it turns while the arm hangs, and when the arm
/// leaves it is the plane of the new way. Straight up the humerus turns with the plane, and the
/// planes of rows are used.
///
/// The commanded plane jumps where the arm passes hanging, where the arm is straight up in another
/// plane than that of the path, and from 180 to -180. It is continuous elsewhere and always within
/// [-pi, pi].
class ArmPath {
 public:
  /// Precondition: at least one row; all rows count axial turns from one zero; times increase;
  /// elevations are within [0, pi] and planes within [-pi, pi].
  explicit ArmPath(const std::vector<TimedCommand>& commands);

  /// Returns the command at a time [s]. The first command holds before the first row, the last one
  /// after the last row. At the time of a row the result has the bits of that row, with two
  /// exceptions: the plane of a row that hangs, and an axial turn from ISB's zero, which belongs to
  /// the same humerus.
  [[nodiscard]] ArmCommand At(double time_s) const noexcept;

 private:
  /// The path from one row to the next.
  struct Stretch {
    TimedCommand from;
    TimedCommand to;
  };

  /// Gives the rows [begin, end), which hang, the planes of the path.
  void TakePlanesOfTheWay(const std::vector<TimedCommand>& rows, std::size_t begin,
                          std::size_t end);

  std::vector<Stretch>
      stretches_;  ///< at least one; an axial turn from ISB's zero is stored as the whole turn
};

/// Fills `between` with commands at even steps of the path from `before` to `after`.
void BridgeCommands(const ArmCommand& before, const ArmCommand& after,
                    std::span<ArmCommand> between);

/// Returns the number at a share of the straight line from one number to another.
[[nodiscard]] double Between(double from, double to, double share) noexcept;

/// Returns `to_rad - from_rad` by the short way round, within [-pi, pi].
[[nodiscard]] double ShortWay_rad(double from_rad, double to_rad) noexcept;

}  // namespace girdle
