// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The residual report: differences between a simulated shoulder and the chosen rhythm and anatomy.
///
/// The report compares rotations and positions that MuJoCo computes with rotations that the inverse
/// kinematics takes from the splines. The two sides are independent: MuJoCo is given joint angles,
/// and the inverse kinematics never uses one.
#pragma once

#include "anatomy/anatomy.h"
#include "kinematics/assembled_rhythm.h"
#include "residuals/residual.h"
#include "simulation/girdle_motion.h"
#include "simulation/shoulder_simulation.h"
#include "text/sinks.h"

namespace girdle {

/// Takes every shoulder of the model through the visits of residuals/visits.h and returns the
/// report: the lines of each group of residuals/residual_groups.h, shoulder by shoulder. A skin is
/// measured on a girdle that moves as `girdle` says; all other residuals are of the model's own
/// girdle. Throws InputError if MuJoCo warns, or if the girdle is frozen and the model has no skin.
[[nodiscard]] ResidualReport MeasureResiduals(ShoulderSimulation& simulation,
                                              const AssembledRhythm& rhythm, const Anatomy& anatomy,
                                              const ProgressSink& progress,
                                              GirdleMotion girdle = GirdleMotion::kMeasured);

}  // namespace girdle
