// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The lines of the residual report on a model's skin.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/assembled_rhythm.h"
#include "residuals/extreme.h"
#include "residuals/residual.h"
#include "simulation/girdle_motion.h"
#include "simulation/model_skin.h"
#include "simulation/shoulder_simulation.h"
#include "skin/skin_measures.h"

namespace girdle {

/// Measures the skin of the shoulder that the simulation watches. All that it refers to must
/// outlive it.
///
/// MuJoCo's vertices are compared with the project's own linear blend. All else is measured on that
/// blend in double precision, with the bones of the anatomy in poses of the rhythm. If the girdle
/// is frozen, only GH turns, and SC and AC stay as they were when the skin was bound.
class SkinMeter {
 public:
  /// Throws InputError if the skin lacks a bone or a landmark of the shoulder, or is bound to any
  /// other body.
  SkinMeter(ShoulderSimulation& simulation, const AssembledRhythm& rhythm, const Anatomy& anatomy,
            GirdleMotion girdle);

  /// Compares MuJoCo's vertices with the blend in the present state of a motion. `motion` and
  /// `command` name that state in the report.
  void CompareMoving(std::string_view motion, const ArmCommand& command);

  /// Measures all other residuals and returns the lines. Moves the simulation.
  [[nodiscard]] std::vector<Residual> Measure();

 private:
  /// The pose with the girdle as it is measured here, for an arm in the direction of `pose`.
  [[nodiscard]] ShoulderPose OnGirdle(const ShoulderPose& pose) const;
  [[nodiscard]] ShoulderPose PoseFor(const ArmCommand& command) const;

  /// Puts the bones into a pose and returns MuJoCo's vertices there, in the thorax frame [m].
  [[nodiscard]] std::vector<Vector3> DrawnVerticesIn_m(const ShoulderPose& pose);
  /// Returns the landmarks of those vertices, each the mean of its own vertices.
  [[nodiscard]] SkinLandmarkPlaces DrawnIn_m(const ShoulderPose& pose);

  /// Returns the largest distance of MuJoCo's vertices from the blend in the present state.
  [[nodiscard]] double OffBlend_mm() const;
  void ComparePose(const ArmCommand& command);
  /// Step and tolerance of the difference quotients of MuJoCo's vertices across knots.
  struct DrawnDifference {
    double step_rad;
    double tolerance_mm_per_deg;
  };
  /// The tolerance is ten times the noise of single precision at the AC skin. If knots are too
  /// close for the step that this needs, the tolerance is larger.
  [[nodiscard]] DrawnDifference DifferenceOfDrawn(Direction direction);

  void AddRises(std::vector<Residual>& lines) const;
  void AddAreas(std::vector<Residual>& lines) const;
  void AddSteps(std::vector<Residual>& lines) const;
  void AddJumps(std::vector<Residual>& lines, Direction direction);
  void AddDepths(std::vector<Residual>& lines) const;

  ShoulderSimulation& simulation_;
  const AssembledRhythm& rhythm_;
  GirdleMotion girdle_;
  Side side_;
  ModelSkin skin_;
  SkinOnBones on_bones_;
  SkinLandmarkVertices vertices_;
  LandmarkSkin landmarks_;
  ShoulderPose bind_;
  double size_;         ///< of the clavicle; 1 for an adult
  Extreme at_rest_mm_;  ///< distance from the blend, in poses without dynamics
  Extreme moving_mm_;   ///< distance from the blend, during motions
  Extreme posed_mm_;
};

}  // namespace girdle
