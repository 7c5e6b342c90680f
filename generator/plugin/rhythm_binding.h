// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The elements of a model that make one shoulder's rhythm, found and checked.
///
/// The actuators are those of one instance of `girdle.rhythm`. Actuators with gear 0 are commands:
/// elevation, plane and axial, and in some models offsets and rates. The others are servos, one for
/// each hinge. The set of servos determines the assembly (assembly.h). Servos of AC make a tree.
/// Servos of the scapula in the thorax make a loop, where three more may drive the scapula's
/// position.
///
/// An actuator's role is the name of model_names.h at the end of its own name. So `him_elevation_r`
/// and `elevation_r` have the same role.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "kinematics/assembled_rhythm.h"
#include "names/model_names.h"
#include "plugin/bound_elements.h"
#include "plugin/engine_views.h"
#include "rhythm_tables/rhythm_config.h"

namespace girdle {

struct RhythmBinding {
  Side side = Side::kRight;
  Assembly assembly = Assembly::kTree;
  /// Commands in the order of kAllCommandNames.
  std::array<BoundControl, kAllCommandCount> commands{};
  /// Servos of the nine coordinates that the assembly drives, in the order of DrivenCoordinates.
  std::array<BoundServo, kCoordinateCount> servos{};
  /// Servos of the scapula's position, if the model has them.
  std::array<BoundServo, 3> place_servos{};
  bool has_place_servos = false;
  bool has_rates = false;  ///< at least one command is a rate
  std::vector<BoundSensor> sensors;
  int thorax_body = 0;
  int clavicle_body = 0;
  int scapula_body = 0;
  int humerus_body = 0;
  JointRanges ranges{};  ///< of the nine hinges; unbounded if the model gives none
  /// The clavicle's origin in the thorax and the AC joint on the clavicle [m], both mirrored to a
  /// right shoulder. AC is where the scapula hangs on the clavicle, or in a loop where a connect
  /// holds it. It is empty if the model has neither. If servos drive the scapula's position, it is
  /// never empty.
  Vector3 p_TC_m{0, 0, 0};
  std::optional<Vector3> p_CS_m;
  /// Equalities of a loop that connect a site of the clavicle to a site of the scapula. AC is where
  /// the first one is.
  std::vector<int> closing_connects;
};

/// Finds the elements of an instance and checks them and the configuration against each other.
/// Throws std::runtime_error that names the element and the fix. Faults are: an instance without
/// actuators; an actuator without a role; two actuators of one role; a role without an actuator; a
/// servo on another kind of joint or with a gear; a joint that nothing holds; rate commands with an
/// interpolation or an assembly that has no rates.
[[nodiscard]] RhythmBinding BindRhythm(const ModelView& model, int instance,
                                       const RhythmConfig& config);

}  // namespace girdle
