// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Writes the bits of solved poses to standard output, so that builds can be held against each
/// other (scripts/fingerprint).
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <optional>
#include <random>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/solve_many.h"
#include "rhythm_tables/rhythm_choice.h"

namespace girdle {
namespace {

constexpr std::size_t kRandomPoses = 10'000;

// In [from, to); std::uniform_real_distribution differs between standard libraries.
double Draw(std::mt19937_64& random, double from, double to) {
  constexpr int kMantissaBits = 53;
  const auto whole = static_cast<double>(random() >> (64 - kMantissaBits));
  return from + (to - from) * (whole / static_cast<double>(std::uint64_t{1} << kMantissaBits));
}

std::vector<ArmCommand> RandomCommands() {
  std::mt19937_64 random(20090815);
  std::vector<ArmCommand> commands(kRandomPoses);
  for (ArmCommand& command : commands) {
    // Beyond both ends of what is reached; every other one with a turn and offsets.
    command.elevation_rad = Draw(random, -0.1, kPi + 0.1);
    command.plane_rad = Draw(random, -2 * kPi, 2 * kPi);
    if (random() % 2 == 0) {
      command.axial_from = static_cast<AxialFrom>(random() % kAxialFromNames.size());
      command.axial_rad =
          command.axial_from == AxialFrom::kRhythm ? Draw(random, -1, 1) : Draw(random, -kPi, kPi);
      command.shrug_rad = Draw(random, -0.3, 0.6);
      command.protraction_rad = Draw(random, -0.4, 0.5);
    }
  }
  return commands;
}

std::vector<ArmCommand> SweptCommands() {
  std::vector<ArmCommand> commands;
  for (int elevation_deg = 0; elevation_deg <= 180; ++elevation_deg) {
    for (int plane_deg = -180; plane_deg <= 180; plane_deg += 5) {
      commands.push_back({RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)});
    }
  }
  return commands;
}

template <typename T>
void Write(const std::vector<T>& numbers) {
  // Squad and slerp have no rates.
  if (!numbers.empty() &&
      std::fwrite(numbers.data(), sizeof(T), numbers.size(), stdout) != numbers.size()) {
    throw std::runtime_error("standard output cannot be written");
  }
}

void Append(std::vector<double>& numbers, const Vector3& vector) {
  numbers.insert(numbers.end(), {vector.x, vector.y, vector.z});
}

// Angles, the command that was used, origin and distance; with smooth, also rates. All as doubles.
void WriteSolutions(const ShoulderRhythm& rhythm, const std::vector<ArmCommand>& commands,
                    std::size_t threads) {
  std::vector<JointAngles> angles_rad(commands.size());
  std::vector<ArmCommand> used(commands.size());
  std::vector<Origin> origins(commands.size());
  std::vector<double> distances_rad(commands.size());
  if (threads > 0) {
    SolveMany(rhythm, commands,
              {.angles_rad = angles_rad,
               .used = used,
               .origins = origins,
               .distances_rad = distances_rad},
              {.threads = threads});
  } else {
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const ShoulderSolution solution = rhythm.Solve(commands[i]);
      angles_rad[i] = AnglesFromPose(solution.pose);
      used[i] = solution.used;
      origins[i] = solution.origin;
      distances_rad[i] = solution.distance_rad;
    }
  }
  std::vector<double> origin_numbers;
  origin_numbers.reserve(origins.size());
  for (const Origin origin : origins) {
    origin_numbers.push_back(static_cast<double>(origin));
  }
  std::vector<double> used_rad;
  for (const ArmCommand& command : used) {
    used_rad.insert(used_rad.end(), {command.elevation_rad, command.plane_rad, command.axial_rad,
                                     command.shrug_rad, command.protraction_rad});
  }
  Write(angles_rad);
  Write(used_rad);
  Write(origin_numbers);
  Write(distances_rad);
  std::vector<double> rates;
  for (const ArmCommand& command : commands) {
    if (const std::optional<ShoulderRates> solved = rhythm.SolveRates(command)) {
      for (const AngularRate& rate : solved->joints) {
        Append(rates, rate.by_elevation);
        Append(rates, rate.by_plane);
      }
    }
  }
  Write(rates);
}

void WriteBits(std::string_view which, std::size_t threads) {
  const std::vector<ArmCommand> commands = which == "sweep" ? SweptCommands() : RandomCommands();
  for (const RhythmChoice& choice :
       {RhythmChoice{.interpolation = Interpolation::kSmooth},
        RhythmChoice{.interpolation = Interpolation::kSquad, .closure = Closure::kTable},
        RhythmChoice{.interpolation = Interpolation::kSlerp}}) {
    const ShoulderRhythm rhythm = MakeRhythm(Resolve(choice), BuiltInAnatomy().ranges);
    WriteSolutions(rhythm, commands, threads);
  }
}

}  // namespace
}  // namespace girdle

int main(int argc, char** argv) {
  try {
    const std::string_view which = argc == 3 ? argv[1] : "";
    std::size_t threads = 0;
    const std::string_view count = argc == 3 ? argv[2] : "";
    const auto read = std::from_chars(count.data(), count.data() + count.size(), threads);
    if ((which != "random" && which != "sweep") || read.ec != std::errc() ||
        read.ptr != count.data() + count.size()) {
      std::fputs("usage: pose_bits random|sweep THREADS (0: one by one)\n", stderr);
      return 2;
    }
    girdle::WriteBits(which, threads);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
