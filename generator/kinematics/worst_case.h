// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The worst of many values, the place where it occurs, and the root mean square of all values.
///
/// One rule for NaN holds everywhere: NaN is worse than every number. A check fails if one of its
/// values is NaN, in whatever order the values come. If no value was added, the worst value is NaN
/// too: a check of nothing fails. If two values are equally bad, the first counts.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace girdle {

/// Returns whether `value` is worse than `worst`. Larger magnitudes are worse.
[[nodiscard]] inline bool IsWorse(double value, double worst) noexcept {
  return std::abs(value) > std::abs(worst) || (std::isnan(value) && !std::isnan(worst));
}

/// Returns the worse of two values. The value keeps its sign.
[[nodiscard]] inline double WorseOf(double worst, double value) noexcept {
  return IsWorse(value, worst) ? value : worst;
}

/// The rule that makes one value worse than another.
enum class Worse {
  kLargerMagnitude,
  kSmaller,  ///< compares with the sign: for lengths or depths that must not be too small
};

/// Collects values one by one. `Place` describes where a value occurs: a command, a row of a table.
template <typename Place, Worse Rule = Worse::kLargerMagnitude>
class WorstCase {
 public:
  /// Adds a value. A Place is constructed from `place` only if the value is the worst so far.
  template <typename... From>
  void Add(double value, From&&... place) {
    square_sum_ += value * value;
    ++count_;
    if (count_ == 1 || IsWorst(value)) {
      worst_ = value;
      place_ = Place{std::forward<From>(place)...};
    }
  }

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// The worst value. It keeps its sign.
  [[nodiscard]] double value() const noexcept { return worst_; }
  [[nodiscard]] double magnitude() const noexcept { return std::abs(worst_); }
  /// Root mean square of all values. NaN if no value was added.
  [[nodiscard]] double rms() const noexcept {
    return std::sqrt(square_sum_ / static_cast<double>(count_));
  }
  /// The place of the worst value. If no value was added: a default-constructed Place.
  [[nodiscard]] const Place& place() const noexcept { return place_; }

 private:
  [[nodiscard]] bool IsWorst(double value) const noexcept {
    if constexpr (Rule == Worse::kSmaller) {
      return value < worst_ || (std::isnan(value) && !std::isnan(worst_));
    } else {
      return IsWorse(value, worst_);
    }
  }

  double worst_ = std::numeric_limits<double>::quiet_NaN();
  double square_sum_ = 0;
  std::size_t count_ = 0;
  Place place_{};
};

}  // namespace girdle
