// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/smooth_union.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace girdle {

double SignedDistance_m(const RoundCone& cone, const Vector3& point_m) noexcept {
  const Vector3 axis = cone.to_m - cone.from_m;
  const double length_m = glm::length(axis);
  const double taper_m = cone.from_radius_m - cone.to_radius_m;
  const Vector3 p = point_m - cone.from_m;
  // One ball contains the other.
  if (length_m <= std::abs(taper_m)) {
    return std::min(glm::length(p) - cone.from_radius_m,
                    glm::length(point_m - cone.to_m) - cone.to_radius_m);
  }
  const double along_m = glm::dot(p, axis) / length_m;
  const double across_m = std::sqrt(std::max(glm::dot(p, p) - along_m * along_m, 0.0));
  // The mantle is inclined by this sine: the nearest ball is on the thick side of the foot.
  const double sine = taper_m / length_m;
  const double cosine = std::sqrt(1 - sine * sine);
  const double foot_m = std::clamp(along_m - across_m * sine / cosine, 0.0, length_m);
  const double radius_m = cone.from_radius_m - taper_m * foot_m / length_m;
  return std::hypot(along_m - foot_m, across_m) - radius_m;
}

double SignedDistance_m(const TurnedEllipsoid& ellipsoid, const Vector3& point_m) noexcept {
  const Vector3 p = glm::conjugate(ellipsoid.q_AB) * (point_m - ellipsoid.center_m);
  const Vector3 scaled = p / ellipsoid.radii_m;
  const double k0 = glm::length(scaled);
  const double k1 = glm::length(scaled / ellipsoid.radii_m);
  if (k1 == 0) {  // the centre
    return -std::min({ellipsoid.radii_m.x, ellipsoid.radii_m.y, ellipsoid.radii_m.z});
  }
  return k0 * (k0 - 1) / k1;
}

double SmoothUnion::operator()(const Vector3& point_m) const noexcept {
  double sum = 0;
  const auto add = [&](double distance_m) { sum += std::exp(-distance_m / blend_m); };
  for (const RoundCone& cone : cones) {
    add(SignedDistance_m(cone, point_m));
  }
  for (const TurnedEllipsoid& ellipsoid : ellipsoids) {
    add(SignedDistance_m(ellipsoid, point_m));
  }
  for (const SmoothUnion& part : parts) {
    add(part(point_m));
  }
  double value_m = -blend_m * std::log(sum);
  for (const HalfSpace& cut : cuts) {
    const double beyond_m = glm::dot(point_m - cut.point_m, cut.outward);
    const double larger_m = std::max(value_m, beyond_m);
    const double gap_m = std::abs(value_m - beyond_m);
    value_m = larger_m + rounding_m * std::log1p(std::exp(-gap_m / rounding_m));
  }
  return value_m;
}

}  // namespace girdle
