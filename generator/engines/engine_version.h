// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Versions of MuJoCo, and which of them Girdle works with.
#pragma once

#include <compare>
#include <string>

namespace girdle {

struct EngineVersion {
  int major = 0;
  int minor = 0;
  int patch = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy takes the comparison's zero for a pointer
  auto operator<=>(const EngineVersion&) const = default;
};

/// Returns the version that mj_version and mjVERSION_HEADER give as one number: 4000001 is 4.0.1;
/// early releases wrote 337 for 3.3.7.
[[nodiscard]] EngineVersion EngineVersionFromNumber(int number);

/// Returns "4.0.1".
[[nodiscard]] std::string Text(const EngineVersion& version);

/// The oldest that Girdle is built and tested with, and the newest.
[[nodiscard]] EngineVersion OldestEngine();
[[nodiscard]] EngineVersion NewestEngine();

/// Returns why Girdle does not work with this version, or nothing if it does. Later ones than are
/// tested count as good.
[[nodiscard]] std::string WhyRefused(const EngineVersion& version);

/// Returns what pip calls the package with the library of this version.
[[nodiscard]] std::string PipPackage(const EngineVersion& version);

}  // namespace girdle
