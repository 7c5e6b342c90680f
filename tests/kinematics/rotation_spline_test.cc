// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation_spline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <ostream>
#include <vector>

#include "kinematics/random_rotations.h"

namespace girdle::rotation_spline_test {
namespace {

// A few dozen roundings of numbers of size one.
constexpr double kRounding = 1e-14;

// Equation (1) with the arc W known rather than found from the quaternions.
Quaternion FormulaSlerp(const Quaternion& a, const Quaternion& b, double W, double t) {
  return (std::sin((1 - t) * W) / std::sin(W)) * a + (std::sin(t * W) / std::sin(W)) * b;
}

// The quaternion at `arc_rad` from q_AB on the great circle towards q_AB * (0, axis): a turn by
// twice the arc about the axis.
Quaternion AtArc(const Quaternion& q_AB, const Vector3& axis, double arc_rad) {
  return q_AB * Quaternion(std::cos(arc_rad), std::sin(arc_rad) * axis.x,
                           std::sin(arc_rad) * axis.y, std::sin(arc_rad) * axis.z);
}

// Turn about one fixed axis, so that rotations are their angles.
Quaternion AboutAxis(double angle_rad) {
  return AtArc({1, 0, 0, 0}, {0.48, -0.6, 0.64}, angle_rad / 2);
}

// Knots as a spline wants them: each at most 60 deg from the one before, signs aligned.
std::vector<Quaternion> Knots(std::size_t size) {
  std::vector<Quaternion> knots = {*UnitQuaternion()};
  while (knots.size() < size) {
    knots.push_back(AtArc(knots.back(), *UnitVector(), *NumberWithin(0, kPi / 6)));
  }
  return knots;
}

// Squad's curve between the middle two of four knots.
Quaternion MiddleOf(const std::vector<Quaternion>& knots, double t) {
  return Squad(knots[1], knots[2], SquadControl(knots[0], knots[1], knots[2]),
               SquadControl(knots[1], knots[2], knots[3]), t);
}

// An arc between two quaternions, given by its cosine.
class SlerpAcross : public testing::TestWithParam<double> {};

TEST_P(SlerpAcross, IsTheClosedFormula) {
  const double W = std::acos(GetParam());
  // The cosine of the quaternions is rounded to 1e-16: the arc by that over its sine, the formula
  // by that over its sine squared.
  const double tolerance = kRounding / (std::sin(W) * std::sin(W));
  const Quaternion a = QuaternionFromEuler(EulerSequence::kYXZ, {0.4, -1.1, 2.3});
  const Quaternion b = AtArc(a, {0.36, 0.48, -0.8}, W);
  for (const double t : {0.0, 1e-3, 0.25, 0.5, 0.7, 0.999, 1.0}) {
    EXPECT_LT(Difference(Slerp(a, b, t), FormulaSlerp(a, b, W, t)), tolerance) << "t " << t;
  }
}

// The borders of the implementation's branches from both sides, and between them.
INSTANTIATE_TEST_SUITE_P(Cosines, SlerpAcross,
                         testing::Values(1 - 1e-5, 1 - 1.9999e-4, 1 - 2.0001e-4, 0.999,
                                         0.995 + 1e-12, 0.995 - 1e-12, 0.98, 0.965 + 1e-12,
                                         0.965 - 1e-12, 0.9, 0.88 + 1e-12, 0.88 - 1e-12, 0.8,
                                         0.7 + 1e-12, 0.7 - 1e-12, 0.1, 0.0, -0.4, -0.9, -0.99999));

class ShortSlerp : public testing::TestWithParam<double> {};

// Where the formula is 0/0 the arc is a straight line, to the arc's square.
TEST_P(ShortSlerp, IsTheStraightLine) {
  const Quaternion a = QuaternionFromEuler(EulerSequence::kXZY, {-0.2, 0.5, 1.9});
  const Quaternion b = AtArc(a, {0, 0.6, 0.8}, GetParam());
  for (const double t : {0.0, 0.3, 0.5, 1.0}) {
    EXPECT_LT(Difference(Slerp(a, b, t), (1 - t) * a + t * b), GetParam() * GetParam() + kRounding)
        << "t " << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Arcs, ShortSlerp, testing::Values(0.0, 1e-12, 1e-9, 1e-8, 1e-6));

RC_GTEST_PROP(Slerp, IsTheClosedFormula, ()) {
  const double W = *NumberWithin(0.01, kPi - 0.01);
  const double tolerance = kRounding / (std::sin(W) * std::sin(W));  // as in SlerpAcross
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = AtArc(a, *UnitVector(), W);
  const double t = *NumberWithin(0, 1);
  RC_ASSERT(Difference(Slerp(a, b, t), FormulaSlerp(a, b, W, t)) < tolerance);
}

RC_GTEST_PROP(Slerp, StartsAndEndsExactly, ()) {
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = AtArc(a, *UnitVector(), *NumberWithin(0, kPi));
  RC_ASSERT(Slerp(a, b, 0) == a);
  RC_ASSERT(Slerp(a, b, 1) == b);
}

RC_GTEST_PROP(Slerp, TurnsAtAConstantSpeed, ()) {
  const Quaternion a = *UnitQuaternion();
  const double turn_rad = *NumberWithin(0, 0.9 * kPi);
  const Quaternion b = AtArc(a, *UnitVector(), turn_rad / 2);
  const double t = *NumberWithin(0, 0.9);
  RC_ASSERT(std::abs(AngleBetween(Slerp(a, b, t), Slerp(a, b, t + 0.1)) - 0.1 * turn_rad) <
            kRounding);
}

RC_GTEST_PROP(Slerp, StaysAUnitQuaternion, ()) {
  // An arc up to a right angle: what aligned signs leave.
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = AtArc(a, *UnitVector(), *NumberWithin(0, kPi / 2));
  RC_ASSERT(std::abs(glm::length(Slerp(a, b, *NumberWithin(0, 1))) - 1) < kRounding);
}

RC_GTEST_PROP(Slerp, TakesTheLongWayRoundToANegativeQuaternion, ()) {
  const Quaternion a = *UnitQuaternion();
  const double arc_rad = *NumberWithin(0.1, kPi / 2 - 0.1);
  const Quaternion b = AtArc(a, *UnitVector(), arc_rad);
  // Halfway the short way lies between both; the long way is half a turn from that.
  RC_ASSERT(std::abs(AngleBetween(Slerp(a, b, 0.5), Slerp(a, -b, 0.5)) - kPi) < 1e-12);
}

RC_GTEST_PROP(Slerp, OfOppositeQuaternionsIsAUnitQuaternion, ()) {
  const Quaternion a = *UnitQuaternion();
  RC_ASSERT(std::abs(glm::length(Slerp(a, -a, *NumberWithin(0, 1))) - 1) < kRounding);
}

RC_GTEST_PROP(Slerp, OfNegatedQuaternionsIsTheNegatedCurve, ()) {
  const std::vector<Quaternion> knots = Knots(2);
  const double t = *NumberWithin(0, 1);
  RC_ASSERT(Slerp(-knots[0], -knots[1], t) == -Slerp(knots[0], knots[1], t));
}

RC_GTEST_PROP(Slerp, OfKnotsTurnedAlikeIsTheCurveTurned, ()) {
  const std::vector<Quaternion> knots = Knots(2);
  const Quaternion turn = *UnitQuaternion();
  const double t = *NumberWithin(0, 1);
  const Quaternion turned = turn * Slerp(knots[0], knots[1], t);
  RC_ASSERT(Difference(Slerp(turn * knots[0], turn * knots[1], t), turned) < kRounding);
}

// Equation (5) of angles about one axis.
RC_GTEST_PROP(SquadControl, OfOneAxisIsTheScalarFormula, ()) {
  const double angle_rad = *NumberWithin(-kPi / 2, kPi / 2);
  const double previous_rad = angle_rad + *NumberWithin(-1, 1);
  const double next_rad = angle_rad + *NumberWithin(-1, 1);
  const double control_rad = angle_rad - ((next_rad - angle_rad) + (previous_rad - angle_rad)) / 4;
  RC_ASSERT(
      Difference(SquadControl(AboutAxis(previous_rad), AboutAxis(angle_rad), AboutAxis(next_rad)),
                 AboutAxis(control_rad)) < kRounding);
}

RC_GTEST_PROP(SquadControl, OfAnEvenTurnIsTheKnot, ()) {
  const Quaternion q_i = *UnitQuaternion();
  const Vector3 axis = *UnitVector();
  const double arc_rad = *NumberWithin(0, kPi / 4);
  RC_ASSERT(Difference(SquadControl(AtArc(q_i, axis, -arc_rad), q_i, AtArc(q_i, axis, arc_rad)),
                       q_i) < kRounding);
}

// Equation (5) with the exponential and the logarithms written out by sine and arc tangent.
Quaternion FormulaControl(const Quaternion& q_previous, const Quaternion& q_i,
                          const Quaternion& q_next) {
  const auto rotation_vector = [](Quaternion q) {
    if (q.w < 0) q = -q;
    const Vector3 sine{q.x, q.y, q.z};
    const double size = glm::length(sine);
    return size > 0 ? sine * (2 * std::atan2(size, q.w) / size) : sine;
  };
  const Quaternion inverse = glm::conjugate(q_i);
  const Vector3 vector =
      (rotation_vector(inverse * q_next) + rotation_vector(inverse * q_previous)) / -4.0;
  const double angle = glm::length(vector);
  return angle > 0 ? AtArc(q_i, vector / angle, angle / 2) : q_i;
}

RC_GTEST_PROP(SquadControl, IsEquation5, ()) {
  const std::vector<Quaternion> knots = Knots(3);
  RC_ASSERT(Difference(SquadControl(knots[0], knots[1], knots[2]),
                       FormulaControl(knots[0], knots[1], knots[2])) < kRounding);
}

// Arcs between a knot and its neighbours, given by their cosines.
class SquadControlAcross : public testing::TestWithParam<double> {};

// Also beyond a right angle, where the logarithm takes a neighbour's nearer sign.
TEST_P(SquadControlAcross, IsEquation5) {
  const Quaternion q_i = QuaternionFromEuler(EulerSequence::kYXZ, {0.4, -1.1, 2.3});
  const Quaternion previous = AtArc(q_i, {0.36, 0.48, -0.8}, std::acos(GetParam()));
  for (const double arc_rad : {0.0, 1e-9, 0.05, 0.4, 1.2, 1.9, 3.0}) {
    const Quaternion next = AtArc(q_i, {0, 0.6, 0.8}, arc_rad);
    EXPECT_LT(Difference(SquadControl(previous, q_i, next), FormulaControl(previous, q_i, next)),
              kRounding)
        << "arc " << arc_rad;
    EXPECT_LT(Difference(SquadControl(next, q_i, previous), FormulaControl(next, q_i, previous)),
              kRounding)
        << "arc " << arc_rad;
  }
}

// The borders of the implementation's branches from both sides, as of slerp; a knot that is its own
// neighbour, or its neighbour's opposite.
INSTANTIATE_TEST_SUITE_P(Cosines, SquadControlAcross,
                         testing::Values(1.0, 1 - 1.9999e-4, 1 - 2.0001e-4, 0.995 + 1e-12,
                                         0.995 - 1e-12, 0.965 + 1e-12, 0.965 - 1e-12, 0.88 + 1e-12,
                                         0.88 - 1e-12, 0.7 + 1e-12, 0.7 - 1e-12, 0.1, -0.1, -0.7,
                                         -0.99999, -1.0));

RC_GTEST_PROP(Squad, IsEquation4, ()) {
  const std::vector<Quaternion> q = Knots(4);
  const double t = *NumberWithin(0, 1);
  const auto slerp = [](const Quaternion& a, const Quaternion& b, double s) {
    return FormulaSlerp(a, b, std::acos(glm::dot(a, b)), s);
  };
  // The formula loses digits on short arcs.
  RC_PRE(glm::dot(q[0], q[1]) < 0.9999 && glm::dot(q[2], q[3]) < 0.9999);
  const Quaternion outer = slerp(q[0], q[1], t);
  const Quaternion inner = slerp(q[2], q[3], t);
  RC_PRE(std::abs(glm::dot(outer, inner)) < 0.9999);
  const Quaternion expected = slerp(outer, inner, 2 * t * (1 - t));
  constexpr double kArcCosineOfShortArcs = 1e-11;
  RC_ASSERT(Difference(Squad(q[0], q[1], q[2], q[3], t), expected) < kArcCosineOfShortArcs);
}

using ThreePoints = std::array<SpherePoint, 3>;

// Three arcs of any lengths up to a right angle, so that each alone would take a branch of its own.
struct ThreeArcs {
  ThreePoints from;
  ThreePoints to;
  std::array<double, 3> lengths{};

  [[nodiscard]] Arcs Measured() { return MeasuredArcs(from, to, lengths); }
};

ThreeArcs AnyThreeArcsFrom(const ThreePoints& from) {
  ThreeArcs arcs{from, {}};
  for (std::size_t k = 0; k < from.size(); ++k) {
    const double longest_rad = *rc::gen::element(0.0, 1e-9, 0.02, 0.1, 0.26, 0.5, 0.8, kPi / 2);
    arcs.to[k] =
        SpherePoint(AtArc(from[k].quaternion(), *UnitVector(), *NumberWithin(0, longest_rad)));
  }
  return arcs;
}

ThreeArcs AnyThreeArcs() {
  const auto any = [] { return SpherePoint(*UnitQuaternion()); };
  return AnyThreeArcsFrom({any(), any(), any()});
}

RC_GTEST_PROP(Arcs, OfThreeAreSlerpsOfEachAlone, ()) {
  ThreeArcs arcs = AnyThreeArcs();
  const double t = *NumberWithin(0, 1);
  ThreePoints together;
  arcs.Measured().At(t, together);
  for (std::size_t k = 0; k < together.size(); ++k) {
    const Quaternion alone = Slerp(arcs.from[k].quaternion(), arcs.to[k].quaternion(), t);
    RC_ASSERT(Difference(together[k].quaternion(), alone) < kRounding);
  }
}

RC_GTEST_PROP(Arcs, StartAndEndExactly, ()) {
  ThreeArcs arcs = AnyThreeArcs();
  ThreePoints start;
  ThreePoints end;
  arcs.Measured().At(0, start);
  arcs.Measured().At(1, end);
  for (std::size_t k = 0; k < start.size(); ++k) {
    RC_ASSERT(start[k].quaternion() == arcs.from[k].quaternion());
    RC_ASSERT(end[k].quaternion() == arcs.to[k].quaternion());
  }
}

RC_GTEST_PROP(Arcs, OfAPartAreThoseOfTheWhole, ()) {
  ThreeArcs arcs = AnyThreeArcs();
  const double t = *NumberWithin(0, 1);
  ThreePoints whole;
  std::array<SpherePoint, 2> part;
  arcs.Measured().At(t, whole);
  arcs.Measured().Part(1, 2).At(t, part);
  RC_ASSERT(part[0].quaternion() == whole[1].quaternion());
  RC_ASSERT(part[1].quaternion() == whole[2].quaternion());
}

RC_GTEST_PROP(SquadControl, OfThreeIsThatOfEachAlone, ()) {
  ThreeArcs before = AnyThreeArcs();
  ThreeArcs after = AnyThreeArcsFrom(before.to);
  ThreePoints together;
  SquadControl(before.Measured(), after.Measured(), together);
  for (std::size_t k = 0; k < together.size(); ++k) {
    const Quaternion alone = SquadControl(before.from[k].quaternion(), after.from[k].quaternion(),
                                          after.to[k].quaternion());
    RC_ASSERT(Difference(together[k].quaternion(), alone) < kRounding);
  }
}

RC_GTEST_PROP(Squad, OfThreeIsThatOfEachAlone, ()) {
  ThreeArcs knots = AnyThreeArcs();
  const auto near = [](const SpherePoint& q) {
    return SpherePoint(AtArc(q.quaternion(), *UnitVector(), *NumberWithin(0, 0.1)));
  };
  ThreeArcs controls{{near(knots.from[0]), near(knots.from[1]), near(knots.from[2])},
                     {near(knots.to[0]), near(knots.to[1]), near(knots.to[2])}};
  const double t = *NumberWithin(0, 1);
  ThreePoints together;
  Squad<3>(knots.Measured(), controls.Measured(), t, together);
  for (std::size_t k = 0; k < together.size(); ++k) {
    const Quaternion alone = Squad(knots.from[k].quaternion(), knots.to[k].quaternion(),
                                   controls.from[k].quaternion(), controls.to[k].quaternion(), t);
    RC_ASSERT(Difference(together[k].quaternion(), alone) < kRounding);
  }
}

RC_GTEST_PROP(Squad, StartsAndEndsExactlyAtItsKnots, ()) {
  const std::vector<Quaternion> knots = Knots(4);
  RC_ASSERT(MiddleOf(knots, 0) == knots[1]);
  RC_ASSERT(MiddleOf(knots, 1) == knots[2]);
}

RC_GTEST_PROP(Squad, StaysAUnitQuaternion, ()) {
  const std::vector<Quaternion> knots = Knots(4);
  RC_ASSERT(std::abs(glm::length(MiddleOf(knots, *NumberWithin(0, 1))) - 1) < kRounding);
}

// Two knots have no inner ones: the ends of a series are their own control points.
RC_GTEST_PROP(Squad, OfTwoKnotsAloneIsSlerp, ()) {
  const std::vector<Quaternion> knots = Knots(2);
  const double t = *NumberWithin(0, 1);
  RC_ASSERT(Difference(Squad(knots[0], knots[1], knots[0], knots[1], t),
                       Slerp(knots[0], knots[1], t)) < kRounding);
}

// Equations (4) and (5) with straight lines for the arcs.
RC_GTEST_PROP(Squad, AboutOneAxisIsTheSplineOfTheAngle, ()) {
  const double a = *NumberWithin(-1, 1);
  const double b = a + *NumberWithin(-1, 1);
  const double c = b + *NumberWithin(-1, 1);
  const double d = c + *NumberWithin(-1, 1);
  const double t = *NumberWithin(0, 1);
  const auto mix = [](double from, double to, double s) { return (1 - s) * from + s * to; };
  const double control_b = b - ((c - b) + (a - b)) / 4;
  const double control_c = c - ((d - c) + (b - c)) / 4;
  const double angle_rad = mix(mix(b, c, t), mix(control_b, control_c, t), 2 * t * (1 - t));
  RC_ASSERT(Difference(MiddleOf({AboutAxis(a), AboutAxis(b), AboutAxis(c), AboutAxis(d)}, t),
                       AboutAxis(angle_rad)) < kRounding);
}

RC_GTEST_PROP(Squad, OfKnotsTurnedAlikeIsTheCurveTurned, ()) {
  const std::vector<Quaternion> knots = Knots(4);
  const Quaternion turn = *UnitQuaternion();
  const double t = *NumberWithin(0, 1);
  std::vector<Quaternion> turned;
  turned.reserve(knots.size());
  for (const Quaternion& knot : knots) turned.push_back(turn * knot);
  RC_ASSERT(Difference(MiddleOf(turned, t), turn * MiddleOf(knots, t)) < kRounding);
}

RC_GTEST_PROP(Squad, OfTheKnotsInReverseIsTheCurveInReverse, ()) {
  const std::vector<Quaternion> knots = Knots(4);
  const double t = *NumberWithin(0, 1);
  RC_ASSERT(Difference(MiddleOf({knots.rbegin(), knots.rend()}, 1 - t), MiddleOf(knots, t)) <
            kRounding);
}

// Equation (5) is made for this: over evenly spaced knots the velocity is that of both neighbours.
RC_GTEST_PROP(Squad, KeepsItsVelocityOverAKnot, ()) {
  const std::vector<Quaternion> knots = Knots(5);
  const Quaternion& knot = knots[2];
  constexpr double kStep = 1e-6;
  // One-sided differences are off by half the step times the acceleration, which is below 10 for
  // turns of up to 60 deg an interval.
  constexpr double kTolerance = 10 * kStep;
  const Vector3 before =
      Log(glm::conjugate(knot) * MiddleOf({knots[0], knots[1], knots[2], knots[3]}, 1 - kStep)) /
      -kStep;
  const Vector3 after =
      Log(glm::conjugate(knot) * MiddleOf({knots[1], knots[2], knots[3], knots[4]}, kStep)) / kStep;
  RC_ASSERT(glm::length(after - before) < kTolerance);
}

// Squad's velocity at a knot is the mean of the turns on either side, in closed form.
RC_GTEST_PROP(Squad, LeavesAKnotWithTheMeanOfTheTurnsOnEitherSide, ()) {
  const std::vector<Quaternion> knots = Knots(4);
  const Quaternion inverse = glm::conjugate(knots[1]);
  const Vector3 mean_rad = (Log(inverse * knots[2]) - Log(inverse * knots[0])) / 2.0;
  constexpr double kStep = 1e-6;
  constexpr double kTolerance = 10 * kStep;  // as in KeepsItsVelocityOverAKnot
  const Vector3 velocity = Log(inverse * MiddleOf(knots, kStep)) / kStep;
  RC_ASSERT(glm::length(velocity - mean_rad) < kTolerance);
}

}  // namespace
}  // namespace girdle::rotation_spline_test
