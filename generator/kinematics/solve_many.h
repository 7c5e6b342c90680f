// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Many commands at once: what ShoulderRhythm::Solve answers one by one, in less time.
///
///     std::vector<ArmCommand> commands = ...;
///     std::vector<ShoulderPose> poses(commands.size());
///     std::vector<double> distances_rad(commands.size());
///     SolveMany(rhythm, commands, {.poses = poses, .distances_rad = distances_rad});
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Where the answers go. Element i of each span answers command i. A member may be left away. The
/// spans must not overlap each other or the commands.
struct ManySolutions {
  /// Rotations of SC, AC and GH (ShoulderSolution::pose).
  std::optional<std::span<ShoulderPose>> poses = std::nullopt;
  /// Joint coordinates [rad] in the order of kCoordinateNames: AnglesFromPose of the pose.
  std::optional<std::span<JointAngles>> angles_rad = std::nullopt;
  /// The command that the pose answers [rad] (ShoulderSolution::used). ShoulderRhythm::IsClamped
  /// says whether that is not the one given.
  std::optional<std::span<ArmCommand>> used = std::nullopt;
  /// Whether the answer is measured, derived or modelled (ShoulderSolution::origin).
  std::optional<std::span<Origin>> origins = std::nullopt;
  /// Angle between the direction and the nearest one of the table's domain [rad], 0 inside
  /// (ShoulderSolution::distance_rad).
  std::optional<std::span<double>> distances_rad = std::nullopt;
};

/// Which instructions of the processor are used. The answers have the same bits with all of them.
enum class Instructions {
  kQuickest,  ///< the quickest that this processor has
  kPortable,  ///< those that every processor has: one command after the other
  kAvx2,      ///< those of x86-64 processors from 2013 on: four commands at the same time
};

/// Returns whether this processor, and the compiler that Girdle was built with, have them.
[[nodiscard]] bool HasInstructions(Instructions instructions) noexcept;

struct SolveManyOptions {
  /// At least 1. The calling thread is one of them; no more are started than there is work for.
  std::size_t threads = 1;
  Instructions instructions = Instructions::kQuickest;
};

/// Answers every command. Every answer has the bits that `rhythm.Solve(command)` gives, whatever
/// the number of threads, the instructions, and the commands beside it; like there, nothing that a
/// command says is an error: not a NaN, not an infinity, not a direction that no arm reaches.
///
/// With Interpolation::kSmooth and AVX2 four poses are computed at the same time; with squad and
/// slerp commands are solved one after the other.
///
/// Throws std::invalid_argument, before anything is written, if a span of `solutions` has another
/// size than `commands`, if there are no threads, or if the processor does not have the
/// instructions. Where the system gives fewer threads than asked for, those do all the work.
void SolveMany(const ShoulderRhythm& rhythm, std::span<const ArmCommand> commands,
               const ManySolutions& solutions, const SolveManyOptions& options = {});

}  // namespace girdle
