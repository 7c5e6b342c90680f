// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Solves many commands at once: the answers of ShoulderRhythm::Solve, in less time.
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

/// Destinations of the answers. Element i of each span answers command i. Every member is
/// optional. The spans must not overlap each other or the commands.
struct ManySolutions {
  /// Rotations of SC, AC and GH (ShoulderSolution::pose).
  std::optional<std::span<ShoulderPose>> poses = std::nullopt;
  /// Joint coordinates [rad] in the order of kCoordinateNames: AnglesFromPose of the pose.
  std::optional<std::span<JointAngles>> angles_rad = std::nullopt;
  /// The command that the pose answers (ShoulderSolution::used), angles in radians.
  /// ShoulderRhythm::IsClamped says whether it differs from the command given.
  std::optional<std::span<ArmCommand>> used = std::nullopt;
  /// Whether the answer is measured, derived or modelled (ShoulderSolution::origin).
  std::optional<std::span<Origin>> origins = std::nullopt;
  /// Angle [rad] between the direction and the nearest direction of the table's domain, 0 inside
  /// (ShoulderSolution::distance_rad).
  std::optional<std::span<double>> distances_rad = std::nullopt;
};

/// Which instructions of the processor are used. The answers have the same bits with all of them.
enum class Instructions {
  kQuickest,  ///< the fastest that this processor has
  kPortable,  ///< those of every processor: one command after the other
  kAvx2,      ///< those of x86-64 processors since 2013: four commands at the same time
};

/// Returns whether this processor has these instructions and Girdle's compiler supports them.
[[nodiscard]] bool HasInstructions(Instructions instructions) noexcept;

/// How SolveMany uses the machine. No option changes an answer.
struct SolveManyOptions {
  /// Number of threads, at least 1. The calling thread is one of them. Fewer are started if there
  /// is less work.
  std::size_t threads = 1;
  Instructions instructions = Instructions::kQuickest;
};

/// Answers every command. Each answer has the bits of `rhythm.Solve(command)`, for any number of
/// threads, any instructions and any other commands. No command is an error: not a NaN, not an
/// infinity, not a direction that no arm reaches.
///
/// With Interpolation::kSmooth and AVX2, four poses are computed at the same time. With squad and
/// slerp, commands are solved one after the other.
///
/// Throws std::invalid_argument before anything is written if a span of `solutions` has another
/// size than `commands`, if `threads` is 0, or if the processor does not have the instructions. If
/// the system gives fewer threads than requested, those do all the work.
void SolveMany(const ShoulderRhythm& rhythm, std::span<const ArmCommand> commands,
               const ManySolutions& solutions, const SolveManyOptions& options = {});

}  // namespace girdle
