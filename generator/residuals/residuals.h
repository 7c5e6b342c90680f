// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How far a simulated shoulder is from what was asked: the residual report.
///
/// What MuJoCo computes (body rotations, site positions) is held against what the inverse
/// kinematics says (rotations from the splines). The two meet nowhere else: MuJoCo gets joint
/// angles, the other side never sees one.
#pragma once

#include "anatomy/anatomy.h"
#include "kinematics/assembled_rhythm.h"
#include "residuals/residual.h"
#include "simulation/girdle_motion.h"
#include "simulation/shoulder_simulation.h"
#include "text/sinks.h"

namespace girdle {

/// Visits with every shoulder of the model what residuals/visits.h says, and returns the report:
/// the lines of each group of residuals/residual_groups.h, shoulder by shoulder. A skin is measured
/// as the girdle says; all else is always that of the model. Throws InputError where MuJoCo warns,
/// or if the girdle is frozen and there is no skin.
[[nodiscard]] ResidualReport MeasureResiduals(ShoulderSimulation& simulation,
                                              const AssembledRhythm& rhythm, const Anatomy& anatomy,
                                              const ProgressSink& progress,
                                              GirdleMotion girdle = GirdleMotion::kMeasured);

}  // namespace girdle
