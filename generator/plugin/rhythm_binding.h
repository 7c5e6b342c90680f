// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Which elements of a model make one shoulder's rhythm, found and checked.
///
/// The actuators are those of one instance of `girdle.rhythm`. Those whose gear is 0 are commands:
/// elevation, plane and axial, and in some models offsets and rates. The others are servos, one a
/// hinge. Their set tells the assembly (assembly.h): those of AC make a tree, those of the scapula
/// on the thorax a loop, where three more may drive the scapula's place.
///
/// An actuator's role is the name of model_names.h that stands last in its own name, so that
/// `him_elevation_r` and `elevation_r` are the same.
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
  /// In the order of kAllCommandNames.
  std::array<BoundControl, kAllCommandCount> commands{};
  /// The nine coordinates that the assembly drives, in their order.
  std::array<BoundServo, kCoordinateCount> servos{};
  /// The scapula's place, where servos drive it.
  std::array<BoundServo, 3> place_servos{};
  bool has_place_servos = false;
  bool has_rates = false;  ///< at least one command of a rate
  std::vector<BoundSensor> sensors;
  int thorax_body = 0;
  int clavicle_body = 0;
  int scapula_body = 0;
  int humerus_body = 0;
  JointRanges ranges{};  ///< of the nine hinges; unbounded where the model gives none
  /// The clavicle's origin in the thorax and the AC joint on the clavicle, both as of a right
  /// shoulder [m]. AC's place is missing where nothing says it: it is where the scapula hangs, or
  /// in a loop where a connect holds it. Where servos drive the scapula's place it is always there.
  Vector3 p_TC_m{0, 0, 0};
  std::optional<Vector3> p_CS_m;
  /// Of a loop, the equalities that connect a site of the clavicle to one of the scapula. AC is
  /// where the first one is.
  std::vector<int> closing_connects;
};

/// Finds the elements of an instance and checks them and the configuration against each other.
/// Throws std::runtime_error that names the element and the fix: an instance without actuators, an
/// actuator without a role, two of one role, a role that nothing has, a servo on another kind of
/// joint or with a gear, a joint that nothing holds, rates where there are none.
[[nodiscard]] RhythmBinding BindRhythm(const ModelView& model, int instance,
                                       const RhythmConfig& config);

}  // namespace girdle
