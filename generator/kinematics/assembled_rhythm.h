// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The shoulder rhythm as an assembly of the bones follows it.
///
/// A tree takes SC and AC as they were measured, and where that puts the scapula in the thorax (ST)
/// is what comes out. A loop drives SC and ST, both measured, and what comes out is AC:
///
///     q_TS = q_TC q_CS exp(u),   u = log((q_TC q_CS)^-1 q_TS) of the table's positions
///
/// u, how far the published tables contradict themselves, is interpolated by the splines of
/// surface_spline.h and fades out past the table, smoothly, to be nothing where the arm hangs:
/// there the rule for the whole range knows SC and AC only. GH then closes on the scapula as
/// before.
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

/// Immutable; evaluation is thread-safe and allocates nothing.
class AssembledRhythm {
 public:
  /// Ranges that bound nothing.
  [[nodiscard]] static ScapulothoracicRanges Unbounded() noexcept;

  /// Throws std::invalid_argument if a loop's table has fewer than three planes or elevations. A
  /// table without ST has nothing to correct: u is zero.
  AssembledRhythm(ShoulderRhythm rhythm, Assembly assembly,
                  const ScapulothoracicRanges& st_ranges = Unbounded());

  /// The pose for a command, as ShoulderRhythm::SolvePose; `used` takes the command that it
  /// answers. In a loop the ranges of ST bound offsets, which keep their ratio, and that of GH's
  /// last hinge the axial turn.
  [[nodiscard]] ShoulderPose SolvePose(const ArmCommand& command,
                                       ArmCommand* used = nullptr) const noexcept;

  /// The nine angles [rad] of that pose that the assembly drives.
  [[nodiscard]] JointAngles SolveAngles(const ArmCommand& command,
                                        ArmCommand* used = nullptr) const noexcept;

  [[nodiscard]] const ShoulderRhythm& rhythm() const noexcept { return rhythm_; }
  [[nodiscard]] Assembly assembly() const noexcept { return assembly_; }

 private:
  [[nodiscard]] ShoulderPose Corrected(const ArmCommand& command, ArmCommand& used) const noexcept;
  [[nodiscard]] bool KeepsScapulaWithin(const ShoulderPose& pose) const noexcept;

  /// u over (elevation, plane), and where the table ends.
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
  std::optional<Correction> correction_;  ///< in a loop whose table has ST
};

/// SolveMany of solve_many.h for a rhythm as an assembly follows it: poses and used commands are
/// those of AssembledRhythm::SolvePose, angles those that the assembly drives (DrivenAngles),
/// origins and distances those of its ShoulderRhythm. Offsets and axial turns that the ranges of a
/// loop bound are solved one after the other.
void SolveMany(const AssembledRhythm& rhythm, std::span<const ArmCommand> commands,
               const ManySolutions& solutions, const SolveManyOptions& options = {});

}  // namespace girdle
