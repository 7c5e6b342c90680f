// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The worst of many values, with the place where it is, and their root mean square.
///
/// One rule for NaN holds everywhere: NaN is worse than every number. A check whose worst case is
/// NaN fails, whenever the NaN comes. If no value was added, the worst case is NaN too: a check of
/// nothing fails. Of two values that are equally bad, the first counts.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace girdle {

/// Returns whether `value` is worse than `worst` where larger magnitudes are worse.
[[nodiscard]] inline bool IsWorse(double value, double worst) noexcept {
  return std::abs(value) > std::abs(worst) || (std::isnan(value) && !std::isnan(worst));
}

/// Returns the worse of two values, with its sign.
[[nodiscard]] inline double WorseOf(double worst, double value) noexcept {
  return IsWorse(value, worst) ? value : worst;
}

/// What makes a value worse than another.
enum class Worse {
  kLargerMagnitude,
  kSmaller,  ///< with its sign: of lengths or depths that must not be too small
};

/// Values that are added one by one. `Place` says where a value is: a command, a row of a table.
template <typename Place, Worse Rule = Worse::kLargerMagnitude>
class WorstCase {
 public:
  /// Adds a value. The place is made from `place` only if the value is the worst so far.
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
  /// The worst value, with its sign.
  [[nodiscard]] double value() const noexcept { return worst_; }
  [[nodiscard]] double magnitude() const noexcept { return std::abs(worst_); }
  /// Root mean square of all values. NaN if there is none.
  [[nodiscard]] double rms() const noexcept {
    return std::sqrt(square_sum_ / static_cast<double>(count_));
  }
  /// Where the worst value is. Where there is none: a place as it is made from nothing.
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
