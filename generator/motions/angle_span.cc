// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/angle_span.h"

#include <algorithm>

#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr std::size_t kFewestRows = 10;
constexpr double kLeastSpan = 0.5;
// Somewhat more than half a turn and than a whole turn [rad].
constexpr double kFarthestElevation = 3.2;
constexpr double kFarthestPlane = 6.4;

}  // namespace

void AngleSpan::Range::Add(const Range& other) noexcept {
  lowest = std::min(lowest, other.lowest);
  highest = std::max(highest, other.highest);
}

bool AngleSpan::Range::IsWithin(double farthest) const noexcept {
  return lowest >= -farthest && highest <= farthest;
}

void AngleSpan::Add(double elevation, double plane) noexcept {
  ++rows_;
  elevation_.Add({elevation, elevation});
  plane_.Add({plane, plane});
}

void AngleSpan::Add(const AngleSpan& other) noexcept {
  rows_ += other.rows_;
  elevation_.Add(other.elevation_);
  plane_.Add(other.plane_);
}

bool AngleSpan::IsWithinRadians() const noexcept {
  return elevation_.IsWithin(kFarthestElevation) && plane_.IsWithin(kFarthestPlane);
}

bool AngleSpan::LooksLikeRadians() const noexcept {
  const double span =
      std::max(elevation_.highest - elevation_.lowest, plane_.highest - plane_.lowest);
  return rows_ >= kFewestRows && span > kLeastSpan && IsWithinRadians();
}

void AngleSpan::ExpectKnownUnit(const std::string& file) const {
  if (LooksLikeRadians()) {
    const auto text = [](const Range& range) {
      return NumberText(range.lowest) + " to " + NumberText(range.highest);
    };
    throw InputError(file + ": in " + std::to_string(rows_) + " rows elevation_deg is " +
                     text(elevation_) + " and plane_deg " + text(plane_) +
                     ", which look like radians. Give --angles rad, or --angles deg if they are "
                     "degrees");
  }
}

}  // namespace girdle
