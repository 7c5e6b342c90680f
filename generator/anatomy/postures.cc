// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/postures.h"

#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "text/csv.h"
#include "text/input_error.h"

namespace girdle {
namespace {

constexpr std::size_t kGirdleCoordinates = 6;

}  // namespace

Posture ReadPosture(std::istream& in, const std::string& name, const std::string& posture) {
  CsvReader csv(in, name);
  const std::size_t posture_column = csv.Column("posture");
  std::array<std::size_t, kGirdleCoordinates> columns{};
  for (std::size_t k = 0; k < kGirdleCoordinates; ++k) {
    columns[k] = csv.Column(std::string(kCoordinateNames[k]) + "_deg");
  }
  std::optional<Posture> found;
  while (csv.Next()) {
    JointAngles angles_rad{};
    for (std::size_t k = 0; k < kGirdleCoordinates; ++k) {
      angles_rad[k] =
          RadiansFromDegrees(csv.NumberWithin(columns[k], -kHalfCircle_deg, kHalfCircle_deg));
    }
    if (csv.Field(posture_column) != posture) {
      continue;
    }
    if (found) {
      csv.Fail("posture '" + posture + "' is given twice. Remove one of the rows");
    }
    const ShoulderPose pose = PoseFromAngles(angles_rad);
    found = {pose.q_TC, pose.q_CS};
  }
  if (!found) {
    throw InputError(name + ": has no posture '" + posture + "'. Add a row for it");
  }
  return *found;
}

ShoulderPose HangingIn(const Posture& posture, const ShoulderRhythm& rhythm) noexcept {
  // If the rhythm does not go down to 0, its lowest arm is lowered to hanging, and keeps its turn
  // about the long axis only.
  const Quaternion lowest = rhythm.SolvePose({}).q_TH();
  const double half_rad = std::atan2(lowest.y, lowest.w);
  const Quaternion q_TH{std::cos(half_rad), 0, std::sin(half_rad), 0};
  return {posture.q_TC, posture.q_CS, glm::conjugate(posture.q_TC * posture.q_CS) * q_TH};
}

}  // namespace girdle
