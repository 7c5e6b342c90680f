// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/squad_rhythm.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

#include "kinematics/random_rotations.h"

namespace girdle::squad_rhythm_test {
namespace {

// A few hundred roundings of numbers of size one.
constexpr double kRounding = 1e-13;

// Knots with equal steps; every angle within `spread_rad` of the same angle at the other positions.
RhythmTable AnyTable(std::size_t planes, std::size_t elevations, double spread_rad) {
  JointAngles middle_rad;
  for (double& angle_rad : middle_rad) {
    angle_rad = *NumberWithin(-1.5, 1.5);
  }
  std::vector<RhythmPosition> positions(planes * elevations);
  for (RhythmPosition& position : positions) {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      position.angles_rad[k] = middle_rad[k] + *NumberWithin(-spread_rad, spread_rad);
    }
  }
  const auto knots = [](std::size_t size) {
    std::vector<double> knots_rad;
    knots_rad.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
      knots_rad.push_back(0.1 * static_cast<double>(i));
    }
    return knots_rad;
  };
  return {knots(planes), knots(elevations), positions};
}

Quaternion JointAt(const RhythmTable& table, std::size_t plane, std::size_t elevation,
                   std::size_t joint) {
  const ShoulderPose pose = PoseFromAngles(table.position(plane, elevation).angles_rad);
  return joint == 0 ? pose.q_TC : joint == 1 ? pose.q_CS : pose.q_SH;
}

// slerp(a, b, t) = a exp(t log(a^-1 b)), which is equation (1) where a . b >= 0.
Quaternion Between(const Quaternion& a, const Quaternion& b, double t) {
  return a * Exp(t * Log(glm::conjugate(a) * b));
}

// Equations (4) and (5) at t between knots i and i + 1, whatever the others.
Quaternion SquadAlong(const std::vector<Quaternion>& knots, std::size_t i, double t) {
  const auto control = [&knots](std::size_t k) {
    if (k == 0 || k + 1 == knots.size()) {
      return knots[k];
    }
    const Quaternion inverse = glm::conjugate(knots[k]);
    return knots[k] * Exp((Log(inverse * knots[k + 1]) + Log(inverse * knots[k - 1])) / -4.0);
  };
  return Between(Between(knots[i], knots[i + 1], t), Between(control(i), control(i + 1), t),
                 2 * t * (1 - t));
}

// Equations (10) to (12), joint by joint, all planes whether they are needed or not.
Quaternion Expected(const RhythmTable& table, const RhythmCell& cell, std::size_t joint,
                    bool smooths) {
  const auto along = [smooths](const std::vector<Quaternion>& knots, std::size_t i, double t) {
    return smooths ? SquadAlong(knots, i, t) : Between(knots[i], knots[i + 1], t);
  };
  std::vector<Quaternion> planes;
  for (std::size_t j = 0; j < table.planes_rad().size(); ++j) {
    std::vector<Quaternion> knots;
    knots.reserve(table.elevations_rad().size());
    for (std::size_t i = 0; i < table.elevations_rad().size(); ++i) {
      knots.push_back(JointAt(table, j, i, joint));
    }
    planes.push_back(along(knots, cell.elevation_index, cell.elevation_weight));
  }
  return along(planes, cell.plane_index, cell.plane_weight);
}

// Every count of planes and elevations has its own ends; from two the controls fall away, from five
// on a cell does not see all.
RC_GTEST_PROP(SquadRhythm, IsEquations4To12OnAnyGrid, (bool smooths)) {
  const std::size_t planes = *rc::gen::inRange<std::size_t>(2, 7);
  const std::size_t elevations = *rc::gen::inRange<std::size_t>(2, 6);
  // Up to where neighbours may be a right angle apart, and the squads along elevation more.
  const double spread_rad = *rc::gen::element(0.0, 1e-9, 1e-3, 0.02, 0.1, 0.25);
  const RhythmTable table = AnyTable(planes, elevations, spread_rad);
  const RhythmCell cell{*rc::gen::inRange<std::size_t>(0, elevations - 1),
                        *rc::gen::inRange<std::size_t>(0, planes - 1), *NumberWithin(0, 1),
                        *NumberWithin(0, 1)};
  const JointRotations joints = SquadRhythm(table, smooths).RotationsIn(cell);
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    RC_ASSERT(AngleBetween(joints[joint], Expected(table, cell, joint, smooths)) < kRounding);
  }
}

RC_GTEST_PROP(SquadRhythm, PassesThroughEveryPositionOnAnyGrid, (bool smooths)) {
  const RhythmTable table = AnyTable(3, 3, 0.25);
  const SquadRhythm rhythm(table, smooths);
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      const RhythmCell cell = table.CellAt(table.elevations_rad()[i], table.planes_rad()[j]);
      const JointRotations joints = rhythm.RotationsIn(cell);
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        RC_ASSERT(AngleBetween(joints[joint], JointAt(table, j, i, joint)) < 1e-15);
      }
    }
  }
}

// Rotations do not depend on what else is stored in the object: a copy outlives its original.
TEST(SquadRhythm, CanBeCopied) {
  const RhythmTable table({0, 0.5}, {0, 0.1}, std::vector<RhythmPosition>(4));
  std::optional<SquadRhythm> original(std::in_place, table, true);
  const SquadRhythm copy = *original;
  original.reset();
  const JointRotations joints = copy.RotationsIn({0, 0, 0.5, 0.5});
  EXPECT_EQ(joints[0], Quaternion(1, 0, 0, 0));
}

}  // namespace
}  // namespace girdle::squad_rhythm_test
