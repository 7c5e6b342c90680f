// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Hands GLM's types to Girdle's library and back, in every way there is: in a structure, by value,
/// by reference and in the headers' own functions. Prints what comes of it.
#include <girdle/kinematics/shoulder_rhythm.h>
#include <girdle/rhythm_tables/built_in_tables.h>

#include <cstdio>
#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace {

void Print(const girdle::Quaternion& q) {
  std::printf("%.9f %.9f %.9f %.9f\n", q.w, q.x, q.y, q.z);
}
void Print(const girdle::Vector3& v) { std::printf("%.9f %.9f %.9f\n", v.x, v.y, v.z); }

}  // namespace

int main() {
  const girdle::ShoulderRhythm rhythm = girdle::BuiltInRhythm();
  const girdle::ArmCommand command{girdle::RadiansFromDegrees(90), girdle::RadiansFromDegrees(30)};
  const girdle::ShoulderSolution solution = rhythm.Solve(command);
  Print(solution.pose.q_TC);
  Print(solution.pose.q_TH());
  std::printf("%.9f %.9f\n", solution.used.elevation_rad, solution.distance_rad);
  Print(girdle::Log(solution.pose.q_CS));
  Print(girdle::Exp({0.1, 0.2, 0.3}));
  Print(
      girdle::Mirrored(girdle::QuaternionFromEuler(girdle::EulerSequence::kXZY, {0.3, 0.2, 0.1})));
  const std::optional<girdle::ShoulderRates> rates = rhythm.SolveRates(command);
  Print(rates.value().joints[2].by_plane);
  Print(rhythm.table().position(0, 0).scapulothoracic_rad.value());
  // What the user has is of GLM's own types.
  const glm::dquat own(solution.pose.q_SH);
  Print(girdle::Quaternion(own));
  Print(glm::dvec3(girdle::Vector3(1, 2, 3)) * 2.0 == glm::dvec3(2, 4, 6)
            ? girdle::Vector3(1, 1, 1)
            : girdle::Vector3(0, 0, 0));
}
