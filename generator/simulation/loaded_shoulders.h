// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A model that MuJoCo has loaded, its state, and the shoulders in it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/assembled_rhythm.h"
#include "rhythm_tables/rhythm_choice.h"
#include "simulation/engine.h"
#include "simulation/shoulder_elements.h"

namespace girdle {

/// Names are those of model_names.h. All shoulders of a model are of one assembly.
class LoadedShoulders {
 public:
  /// `name` stands in messages for the model. Throws InputError if its plugin does not
  /// start, if it lacks an element of a shoulder, or if it steps too coarsely for the servos.
  LoadedShoulders(ModelPointer model, std::string name);

  /// Chooses the shoulder that is looked at, at first the right one if there are two. Throws
  /// InputError if the model has no such side.
  void Watch(Side side);

  [[nodiscard]] const mjModel& model() const noexcept { return *model_; }
  /// For MuJoCo's functions that step and draw, which do not take it as constant.
  [[nodiscard]] mjData& data() noexcept { return *data_; }
  [[nodiscard]] const mjData& data() const noexcept { return *data_; }
  [[nodiscard]] const std::vector<ShoulderElements>& shoulders() const noexcept {
    return shoulders_;
  }
  /// Of the shoulder that is watched.
  [[nodiscard]] const ShoulderElements& elements() const noexcept { return shoulders_[watched_]; }
  [[nodiscard]] bool has_plugin() const noexcept { return shoulders_.front().has_plugin(); }
  /// Of the hinges that are driven; unbounded where the model gives no range.
  [[nodiscard]] const JointRanges& ranges() const noexcept { return ranges_; }
  /// Stiffness of the servos [N m/rad]; 0 for what follows.
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

/// Returns what the model says of the rhythm of the shoulder that is watched. Position servos say
/// nothing.
[[nodiscard]] RhythmChoice OwnChoice(const LoadedShoulders& shoulders);

/// Returns what the model's command for the axial turn is counted from; the rhythm's own turn where
/// there is no such command.
[[nodiscard]] AxialFrom OwnAxialFrom(const LoadedShoulders& shoulders);

/// Returns the rhythm that OwnChoice stands for, as the assembly of the model follows it.
[[nodiscard]] AssembledRhythm OwnRhythm(const LoadedShoulders& shoulders);

}  // namespace girdle
