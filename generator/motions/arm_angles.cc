// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/arm_angles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "kinematics/rotation.h"

namespace girdle {
namespace {

void ExpectFewTurns(double angle_deg) {
  // Written so that a NaN fails too.
  if (!(std::abs(angle_deg) <= kMostTurned_deg)) {
    throw std::invalid_argument("expected an angle within -3600 to 3600 degrees");
  }
}

// Returns a text on the possible meaning of a sign that the convention does not use.
std::string OtherSignText(bool is_isb, bool has_axial) {
  if (is_isb) {
    return std::string(
               "ISB's Y-X'-Y'' writes the elevation of a raised arm negative, 0 to -180. If here "
               "it is positive, give --convention girdle") +
           (has_axial ? ", and --axial-from isb if axial is ISB's third angle" : "") +
           "; if the arm points to the other side, write (plane + 180, -elevation, axial + 180), "
           "the same rotation";
  }
  return std::string(
             "elevation counts from 0, hanging, up to 180. In ISB's Y-X'-Y'' a raised arm has a "
             "negative elevation: for such angles give --convention isb") +
         (has_axial ? ", which reads axial as ISB's third angle, too. If you turn the sign of the "
                      "elevation yourself instead, leave axial as it is and give --axial-from isb"
                    : "");
}

}  // namespace

double ElevationRead_deg(double elevation_deg, AngleConvention convention, bool has_axial) {
  const bool is_isb = convention == AngleConvention::kIsb;
  const double raised_deg = is_isb ? -elevation_deg : elevation_deg;
  if (raised_deg < -kElevationRounding_deg) {
    throw std::invalid_argument(OtherSignText(is_isb, has_axial));
  }
  if (!(raised_deg <= kHalfCircle_deg + kElevationRounding_deg)) {
    throw std::invalid_argument(is_isb ? "expected 0 to -180 degrees"
                                       : "expected 0 to 180 degrees");
  }
  // ISB's hanging arm gives -0 here. The sum turns -0 into 0.
  return std::clamp(raised_deg, 0.0, kHalfCircle_deg) + 0.0;
}

double PlaneRead_deg(double plane_deg) {
  ExpectFewTurns(plane_deg);
  return std::abs(plane_deg) <= kHalfCircle_deg ? plane_deg
                                                : std::remainder(plane_deg, kFullCircle_deg);
}

double AxialRead_deg(double axial_deg) {
  ExpectFewTurns(axial_deg);
  return axial_deg;
}

}  // namespace girdle
