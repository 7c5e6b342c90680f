// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engines/engine_version.h"

namespace girdle {
namespace {

// From the build, which finds its own MuJoCo by them.
constexpr EngineVersion kOldest = {GIRDLE_OLDEST_MUJOCO};
constexpr EngineVersion kNewest = {GIRDLE_NEWEST_MUJOCO};
constexpr EngineVersion kWrong = {4, 0, 0};
// From here on the wheel with the library has a name of its own.
constexpr EngineVersion kFirstOfCoreWheel = {4, 0, 0};

}  // namespace

EngineVersion EngineVersionFromNumber(int number) {
  return number < 1000 ? EngineVersion{number / 100, number / 10 % 10, number % 10}
                       : EngineVersion{number / 1000000, number / 1000 % 1000, number % 1000};
}

std::string Text(const EngineVersion& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.patch);
}

EngineVersion OldestEngine() { return kOldest; }
EngineVersion NewestEngine() { return kNewest; }

std::string WhyRefused(const EngineVersion& version) {
  if (version < kOldest) {
    return "too old: Girdle needs " + Text(kOldest) + " or later";
  }
  if (version == kWrong) {
    return "gives wrong results: its sparse factorisation is wrong, mended in 4.0.1";
  }
  return "";
}

std::string PipPackage(const EngineVersion& version) {
  return (version < kFirstOfCoreWheel ? "mujoco==" : "mujoco-core==") + Text(version);
}

}  // namespace girdle
