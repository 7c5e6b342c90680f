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

/// Measures the skin over the shoulder that is watched. What it refers to must outlive it.
///
/// MuJoCo's vertices are held against the project's own linear blend; the rest is measured on that
/// blend, in double precision, with the bones where the anatomy and a pose have them: of the rhythm
/// or, with the girdle frozen, of an arm that turns in GH alone on SC and AC as the skin was bound.
class SkinMeter {
 public:
  /// Throws InputError if the skin lacks a bone or a landmark of the shoulder, or hangs on
  /// something else too.
  SkinMeter(ShoulderSimulation& simulation, const AssembledRhythm& rhythm, const Anatomy& anatomy,
            GirdleMotion girdle);

  /// Holds MuJoCo's vertices against the blend where the simulation has got to in a motion;
  /// `motion` and `command` tell in the report where that is.
  void CompareMoving(std::string_view motion, const ArmCommand& command);

  /// Measures all the rest, for which it moves the simulation, and returns the lines.
  [[nodiscard]] std::vector<Residual> Measure();

 private:
  /// The girdle as it is measured here, for an arm that goes where `pose` has it.
  [[nodiscard]] ShoulderPose OnGirdle(const ShoulderPose& pose) const;
  [[nodiscard]] ShoulderPose PoseFor(const ArmCommand& command) const;

  /// Puts the bones into a pose and returns MuJoCo's vertices there, in the thorax frame [m].
  [[nodiscard]] std::vector<Vector3> DrawnVerticesIn_m(const ShoulderPose& pose);
  /// The landmarks of those vertices, each the mean of its own.
  [[nodiscard]] SkinLandmarkPlaces DrawnIn_m(const ShoulderPose& pose);

  /// How far MuJoCo's vertices are from the blend where the simulation stands; the largest.
  [[nodiscard]] double OffBlend_mm() const;
  void ComparePose(const ArmCommand& command);
  /// How MuJoCo's vertices are differentiated across knots, and what passes then.
  struct DrawnDifference {
    double step_rad;
    double tolerance_mm_per_deg;
  };
  /// The noise of single precision, where the AC skin is, is a tenth of the tolerance. Where knots
  /// are too close for the step that this needs, the tolerance is larger.
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
  double size_;         ///< of the clavicle, an adult's being 1
  Extreme at_rest_mm_;  ///< off the blend, in poses without dynamics
  Extreme moving_mm_;   ///< off the blend, while it simulates
  Extreme posed_mm_;
};

}  // namespace girdle
