// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Values that the sections of an emitted model share: the options, and everything that is computed
/// from them once.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "anatomy/ligament_slack.h"
#include "kinematics/assembled_rhythm.h"
#include "mjcf/shoulder_model.h"

namespace girdle {

/// The plan of one model. Anatomy and options must outlive it.
struct ModelPlan {
  /// Throws std::invalid_argument like ShoulderModelXml.
  ModelPlan(const Anatomy& model_anatomy, const ShoulderRhythm& rhythm,
            const ShoulderModelOptions& model_options);

  const Anatomy& anatomy;
  const ShoulderModelOptions& options;
  AssembledRhythm assembled;
  std::vector<Side> sides;  ///< in the order in which the model has them
  /// Stems of the names of the nine coordinates that the assembly drives.
  std::array<std::string_view, kCoordinateCount> coordinates;
  ShoulderPose rest;     ///< the pose that controls of zero lead to
  JointAngles rest_rad;  ///< the driven coordinates of `rest`
  /// The length from which on each ligament pulls.
  LigamentLengths slack_m{};

  [[nodiscard]] const ShoulderRhythm& rhythm() const noexcept { return assembled.rhythm(); }
  [[nodiscard]] bool is_loop() const noexcept { return options.assembly == Assembly::kLoop; }
  [[nodiscard]] bool has_plugin() const noexcept { return options.actuation == Actuation::kPlugin; }
  /// Whether servos drive the scapula's position.
  [[nodiscard]] bool drives_place() const noexcept { return options.lead == Lead::kScapula; }

  /// Range of a driven coordinate.
  [[nodiscard]] const CoordinateRange& RangeOf(std::size_t coordinate) const noexcept;
  /// Stiffness of the servo of a driven coordinate [N m/rad]; 0 for a coordinate that follows.
  [[nodiscard]] double StiffnessOf(std::size_t coordinate) const noexcept;
  /// PAC in the thorax frame [m], as the clavicle determines it.
  [[nodiscard]] Vector3 PlaceOfScapula(const ShoulderPose& pose) const noexcept;
};

}  // namespace girdle
