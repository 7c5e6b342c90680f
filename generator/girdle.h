// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// All of Girdle that other projects may use: solving poses, reading tables, the built-in anatomy,
/// names in models, and writing models. The declarations of these headers do not change between
/// minor versions. generator/README.md lists them.
///
///     #include <girdle/girdle.h>
///
///     const girdle::ShoulderRhythm rhythm = girdle::BuiltInRhythm();
///     const girdle::ShoulderPose pose =
///         rhythm.SolvePose({.elevation_rad = girdle::RadiansFromDegrees(90)});
///
/// Functions that read or build throw InputError (text/input_error.h) or std::invalid_argument. The
/// message says how to correct the fault. Functions that solve never fail and allocate nothing, and
/// any number of threads may call them at the same time.
#pragma once

// IWYU pragma: begin_exports
#include "anatomy/anatomy.h"
#include "anatomy/bone_frames.h"
#include "anatomy/built_in_anatomy.h"
#include "anatomy/postures.h"
#include "kinematics/arm_directions.h"
#include "kinematics/arm_reach.h"
#include "kinematics/assembly.h"
#include "kinematics/rhythm_table.h"
#include "kinematics/rotation.h"
#include "kinematics/shoulder_pose.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/solve_many.h"
#include "kinematics/words.h"
#include "mjcf/scene.h"
#include "mjcf/shoulder_model.h"
#include "names/model_names.h"
#include "names/side.h"
#include "rhythm_tables/built_in_tables.h"
#include "rhythm_tables/rhythm_choice.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/input_error.h"
// IWYU pragma: end_exports
