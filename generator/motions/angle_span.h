// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The spans of the angles in a file, which tell radians from degrees.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace girdle {

/// Collects the elevations and planes of a file, as numbers without unit.
///
/// Radians look like degrees of an arm that hardly moves. A file looks like radians if it has at
/// least ten rows, if its elevations or its planes span more than 0.5, if all elevations are within
/// -3.2 to 3.2, and if all planes are within -6.4 to 6.4. An elevation is at most half a turn. A
/// plane may be a whole turn, because some people count it from 0 to 360 degrees. Both bounds are
/// slightly wider than that.
class AngleSpan {
 public:
  void Add(double elevation, double plane) noexcept;
  /// Adds the rows of another part of the file.
  void Add(const AngleSpan& other) noexcept;

  /// Returns whether all rows so far are within the bounds of radians, so that further rows may
  /// still make the file look like radians.
  [[nodiscard]] bool IsWithinRadians() const noexcept;
  [[nodiscard]] bool LooksLikeRadians() const noexcept;

  /// Throws InputError if the file looks like radians. The message names the options that give the
  /// unit.
  void ExpectKnownUnit(const std::string& file) const;

 private:
  struct Range {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    void Add(const Range& other) noexcept;
    [[nodiscard]] bool IsWithin(double farthest) const noexcept;
  };

  std::size_t rows_ = 0;
  Range elevation_;
  Range plane_;
};

}  // namespace girdle
