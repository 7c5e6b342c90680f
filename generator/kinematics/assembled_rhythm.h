// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The shoulder rhythm for each assembly of the bones.
///
/// A tree uses SC and AC as measured. The scapula in the thorax (ST) results from both. A loop
/// drives SC and ST, both measured, and AC results:
///
///     q_TS = q_TC q_CS exp(u),   u = log((q_TC q_CS)^-1 q_TS) of the table's positions
///
/// u measures how far the published tables contradict each other. It is interpolated by the splines
/// of surface_spline.h. Outside the table it fades out smoothly and is zero where the arm hangs,
/// because the rule for the whole range knows SC and AC only. With closure exact, GH then closes
/// the chain: q_SH = q_TS^-1 q_TH.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "kinematics/assembly.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/solve_many.h"
#include "kinematics/surface_spline.h"

namespace girdle {

/// Ranges of the scapula in the thorax, in the order of kScapulothoracicNames.
using ScapulothoracicRanges = std::array<CoordinateRange, kScapulothoracicNames.size()>;

/// Answers arm commands with poses and driven angles of one assembly. Immutable. Evaluation is
/// thread-safe and allocates nothing.
class AssembledRhythm {
 public:
  /// Ranges that limit nothing.
  [[nodiscard]] static ScapulothoracicRanges Unbounded() noexcept;

  /// Throws std::invalid_argument if the assembly is a loop and the table has fewer than three
  /// planes or elevations. If the table has no ST angles, u is zero.
  AssembledRhythm(ShoulderRhythm rhythm, Assembly assembly,
                  const ScapulothoracicRanges& st_ranges = Unbounded());

  /// Returns the pose for a command, like ShoulderRhythm::SolvePose. If `used` is not null, it
  /// receives the command that the pose answers. In a loop the ranges of ST limit the offsets,
  /// which keep their ratio, and the range of GH's last hinge limits the axial turn.
  [[nodiscard]] ShoulderPose SolvePose(const ArmCommand& command,
                                       ArmCommand* used = nullptr) const noexcept;

  /// Returns the nine angles [rad] of that pose which the assembly drives.
  [[nodiscard]] JointAngles SolveAngles(const ArmCommand& command,
                                        ArmCommand* used = nullptr) const noexcept;

  [[nodiscard]] const ShoulderRhythm& rhythm() const noexcept { return rhythm_; }
  [[nodiscard]] Assembly assembly() const noexcept { return assembly_; }

 private:
  [[nodiscard]] ShoulderPose Corrected(const ArmCommand& command, ArmCommand& used) const noexcept;
  [[nodiscard]] bool KeepsScapulaWithin(const ShoulderPose& pose) const noexcept;

  /// u over (elevation, plane), and the limits of the table.
  struct Correction {
    SurfaceGrid grid;
    SurfaceSpline<double, 3> surface;
    ArmRectangle measured;

    [[nodiscard]] Vector3 At(double elevation_rad, double plane_rad) const noexcept;
  };
  [[nodiscard]] static std::optional<Correction> CorrectionOf(const RhythmTable& table);

  ShoulderRhythm rhythm_;
  Assembly assembly_;
  ScapulothoracicRanges st_ranges_;
  std::optional<Correction> correction_;  ///< only in a loop whose table has ST
};

/// Solves many commands for one assembly, like SolveMany of solve_many.h. Poses and used commands
/// are those of AssembledRhythm::SolvePose. Angles are those that the assembly drives
/// (DrivenAngles). Origins and distances are those of its ShoulderRhythm. Commands whose offsets or
/// axial turn are limited by the ranges of a loop are solved one after the other.
void SolveMany(const AssembledRhythm& rhythm, std::span<const ArmCommand> commands,
               const ManySolutions& solutions, const SolveManyOptions& options = {});

}  // namespace girdle
