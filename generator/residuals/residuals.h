// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How far a simulated shoulder is from what was asked: the residual report.
///
/// What MuJoCo computes (body rotations, site positions) is held against what the inverse
/// kinematics says (rotations from the splines). The two meet nowhere else: MuJoCo gets joint
/// angles, the other side never sees one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_rhythm.h"
#include "simulation/girdle_motion.h"
#include "simulation/shoulder_simulation.h"
#include "text/sinks.h"

namespace girdle {

/// Which values of a line pass.
enum class Bound {
  kAtMost,    ///< up to the tolerance
  kMoreThan,  ///< above it
};
/// Words for them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kBoundNames = {"at most", "more than"};

/// One line of the report.
struct Residual {
  std::string group;  ///< what is checked: "joint constraint"
  std::string item;   ///< on what: "SC"
  double value = 0;   ///< worst case, or rms where `item` says so
  std::string unit;
  /// Largest value that passes, or what it must be more than; nothing where the value is stated
  /// only.
  std::optional<double> tolerance;
  std::string where;  ///< the pose of the worst case
  Bound bound = Bound::kAtMost;

  /// A value that is not a number does not pass.
  [[nodiscard]] bool passed() const noexcept {
    return !tolerance || (bound == Bound::kAtMost ? value <= *tolerance : value > *tolerance);
  }
};

struct ResidualReport {
  std::string model;   ///< path
  std::string kind;    ///< sides, assembly, what moves the joints
  std::string rhythm;  ///< what the model was held against: interpolation, closure, table
  std::string engine;  ///< MuJoCo's version
  std::vector<Residual> residuals;

  [[nodiscard]] bool passed() const noexcept;
};

/// Runs the standard motions (abduction, scapular plane, flexion, protraction at 90, and up and
/// down once a second) with every shoulder of the model and visits every position of the rhythm's
/// table, and returns the report. A skin is measured as the girdle says; all else is always that of
/// the model. Throws InputError where MuJoCo warns, or if the girdle is frozen and there is no
/// skin.
[[nodiscard]] ResidualReport MeasureResiduals(ShoulderSimulation& simulation,
                                              const AssembledRhythm& rhythm, const Anatomy& anatomy,
                                              const ProgressSink& progress,
                                              GirdleMotion girdle = GirdleMotion::kMeasured);

}  // namespace girdle
