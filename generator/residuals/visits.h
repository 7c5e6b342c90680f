// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The motions and poses that a shoulder is taken through for its residual report.
///
/// - Motions: abduction, scapular plane, flexion, protraction at 90, each with a rest after it.
///   Every step is shown, and so are poses along the motion without dynamics.
/// - Cycles once a second, over the table's elevations in each of its planes, and over its planes.
/// - Every position of the rhythm's table.
/// - A grid over all that the arm reaches.
/// - Every keyframe of the model that has a known meaning.
///
/// Only visits.cc knows this list. residual_group.h defines the kinds of poses and steps.
#pragma once

#include <vector>

#include "residuals/residual_groups.h"
#include "text/sinks.h"

namespace girdle {

/// Takes the shoulder that the simulation watches through all visits, and shows them to the groups.
/// `progress` counts the motions only, which take nearly all of the time. Throws InputError if
/// MuJoCo warns.
void ShowVisits(ShoulderSimulation& simulation, const MeasuredShoulder& shoulder,
                const std::vector<ResidualGroupPointer>& groups, const ProgressSink& progress);

}  // namespace girdle
