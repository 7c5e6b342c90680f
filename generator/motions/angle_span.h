// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Which angles a file has, to tell radians from degrees.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace girdle {

/// The numbers of a file's elevations and planes, as they stand there.
///
/// Radians look like degrees of an arm that hardly moves. A file looks like radians if it has ten
/// rows or more, its elevations or its planes span more than 0.5, no elevation leaves -3.2 to 3.2,
/// and no plane -6.4 to 6.4: an elevation is half a turn at most, while people count planes from 0
/// to a whole turn, too. Both bounds are somewhat wider.
class AngleSpan {
 public:
  void Add(double elevation, double plane) noexcept;
  /// Adds the rows of another part of the file.
  void Add(const AngleSpan& other) noexcept;

  /// Whether rows that come may still make it look like radians.
  [[nodiscard]] bool IsWithinRadians() const noexcept;
  [[nodiscard]] bool LooksLikeRadians() const noexcept;

  /// Throws InputError, with the options that say which unit it is, if it looks like radians.
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
