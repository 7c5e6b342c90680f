// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A model that MuJoCo has loaded, its state, and its shoulders.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/assembled_rhythm.h"
#include "rhythm_tables/rhythm_choice.h"
#include "simulation/engine.h"
#include "simulation/shoulder_elements.h"

namespace girdle {

/// A loaded model and its shoulders. Names of elements are those of model_names.h. All shoulders of
/// a model have the same assembly.
class LoadedShoulders {
 public:
  /// `name` is the model's name in messages. Throws InputError if the model's plugin does not
  /// start, if an element of a shoulder is missing, or if the time step is too long for the servos.
  LoadedShoulders(ModelPointer model, std::string name);

  /// Selects the watched shoulder. Without a call it is the right one if there are two. Throws
  /// InputError if the model does not have that side.
  void Watch(Side side);

  [[nodiscard]] const mjModel& model() const noexcept { return *model_; }
  /// Not constant, for MuJoCo's functions that step and draw.
  [[nodiscard]] mjData& data() noexcept { return *data_; }
  [[nodiscard]] const mjData& data() const noexcept { return *data_; }
  [[nodiscard]] const std::vector<ShoulderElements>& shoulders() const noexcept {
    return shoulders_;
  }
  /// Elements of the watched shoulder.
  [[nodiscard]] const ShoulderElements& elements() const noexcept { return shoulders_[watched_]; }
  [[nodiscard]] bool has_plugin() const noexcept { return shoulders_.front().has_plugin(); }
  /// Ranges of the driven hinges; unbounded if the model gives none.
  [[nodiscard]] const JointRanges& ranges() const noexcept { return ranges_; }
  /// Stiffness of the servos [N m/rad]; 0 for a coordinate that follows.
  [[nodiscard]] const JointAngles& stiffness() const noexcept { return stiffness_N_m_per_rad_; }
  [[nodiscard]] double timestep_s() const noexcept { return model_->opt.timestep; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  std::string name_;
  ModelPointer model_;
  DataPointer data_;
  std::vector<ShoulderElements> shoulders_;
  std::size_t watched_ = 0;
  JointRanges ranges_;
  JointAngles stiffness_N_m_per_rad_;
};

/// Returns what the model defines about the rhythm of the watched shoulder. A model with position
/// servos defines nothing.
[[nodiscard]] RhythmChoice OwnChoice(const LoadedShoulders& shoulders);

/// Returns the zero of the model's command for the axial turn. If there is no such command, it is
/// the rhythm's own turn.
[[nodiscard]] AxialFrom OwnAxialFrom(const LoadedShoulders& shoulders);

/// Returns the rhythm of OwnChoice, for the assembly of the model.
[[nodiscard]] AssembledRhythm OwnRhythm(const LoadedShoulders& shoulders);

}  // namespace girdle
