// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Angles given on the command line as FROM:TO:STEP.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// An option that takes such angles.
struct SweptAngle {
  std::string_view option;   ///< for messages
  std::string_view example;  ///< for messages
  double lower_deg;
  double upper_deg;
  std::string_view because = {};  ///< for messages: the reason for the bounds
};

/// The elevations and planes of a map of all that an arm can reach, from somewhat behind the
/// frontal plane to across the chest.
inline constexpr const char* kWholeElevations = "0:180:5";
inline constexpr const char* kWholePlanes = "-95:135:5";

inline constexpr std::string_view kElevationsFromHanging =
    ": elevation counts from 0, hanging, up to 180";

/// Returns whether a text is meant as FROM:TO:STEP.
[[nodiscard]] bool IsSweep(const std::string& text);

/// Returns the values of FROM:TO:STEP [deg], both ends among them, as they would be typed. Throws
/// InputError, which names the option, unless FROM <= TO lie within the angle's bounds, STEP is
/// positive and meets TO, and there are at most `most` values.
[[nodiscard]] std::vector<double> SweepValues_deg(const SweptAngle& angle, const std::string& text,
                                                  std::uint64_t most);

}  // namespace girdle
