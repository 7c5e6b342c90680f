// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation_algebra.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "kinematics/euler_angles.h"
#include "kinematics/random_rotations.h"

namespace girdle::rotation_algebra_test {
namespace {

// A few dozen roundings of numbers of size one.
constexpr double kRounding = 1e-14;

QuaternionOf<double> Plain(const Quaternion& q) { return {q.w, q.x, q.y, q.z}; }
Quaternion Plain(const QuaternionOf<double>& q) { return {q.w, q.x, q.y, q.z}; }
VectorOf<double> Plain(const Vector3& v) { return {v.x, v.y, v.z}; }
Vector3 Plain(const VectorOf<double>& v) { return {v[0], v[1], v[2]}; }

RC_GTEST_PROP(QuaternionOf, MultipliesAndInvertsAsGlmDoes, ()) {
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = *UnitQuaternion();
  RC_ASSERT(Difference(Plain(Plain(a) * Plain(b)), a * b) < kRounding);
  RC_ASSERT(Difference(Plain(Inverse(Plain(a))), glm::conjugate(a)) == 0);
}

// Where one series gives way to the next, and at the ends.
TEST(CosineAndSineOfRoot, AreCosineAndSine) {
  for (const double x : {0.0, 1e-300, 1e-9, 0.049, std::nextafter(0.05, 0), 0.05, 0.2,
                         std::nextafter(0.4, 0), 0.4, 1.0, 2.0, kPi * kPi / 4}) {
    const double root = std::sqrt(x);
    const auto [cosine, sine_over_root] = CosineAndSineOfRoot(x);
    EXPECT_NEAR(cosine, std::cos(root), 4e-16) << x;
    EXPECT_NEAR(sine_over_root, x == 0 ? 1 : std::sin(root) / root, 4e-16) << x;
  }
}

// d cos(sqrt x) = -sin(sqrt x) / (2 sqrt x), d (sin(sqrt x) / sqrt x) = (cos - sin / sqrt x) / 2x.
TEST(CosineAndSineOfRoot, HaveTheDerivativesOfTheClosedForm) {
  // The closed form divides by x up to three times.
  constexpr double kTolerance = 1e-12;
  for (const double x : {0.04, std::nextafter(0.05, 0), 0.05, 0.2, std::nextafter(0.4, 0), 0.4, 1.0,
                         kPi * kPi / 4}) {
    const double root = std::sqrt(x);
    const double c = std::cos(root);
    const double s = std::sin(root) / root;
    const double s_1 = (c - s) / (2 * x);
    const double s_2 = (-0.5 * s - 3 * s_1) / (2 * x);
    Jet<double, 2> variable(x);
    variable.part[kByElevation] = 1;
    const auto jets = CosineAndSineOfRoot(variable);
    EXPECT_NEAR(jets.cosine.part[kByElevation], -s / 2, kTolerance) << x;
    EXPECT_NEAR(jets.cosine.part[kByElevationTwice], -s_1 / 2, kTolerance) << x;
    EXPECT_NEAR(jets.sine_over_root.part[kByElevation], s_1, kTolerance) << x;
    EXPECT_NEAR(jets.sine_over_root.part[kByElevationTwice], s_2, kTolerance) << x;
    const auto dual = CosineAndSineOfRoot(Dual<double>(x, 1));
    EXPECT_NEAR(dual.cosine.slope, -s / 2, kTolerance) << x;
    EXPECT_NEAR(dual.sine_over_root.slope, s_1, kTolerance) << x;
  }
}

RC_GTEST_PROP(ExpOf, IsExpUpToHalfATurn, ()) {
  const Vector3 u = *NumberWithin(0, kPi) * *UnitVector();
  RC_ASSERT(Difference(Plain(ExpOf(Plain(u))), Exp(u)) < kRounding);
}

RC_GTEST_PROP(LogOf, IsLogUpToARightAngle, ()) {
  const Vector3 u = *NumberWithin(0, kPi / 2) * *UnitVector();
  const Vector3 back = Plain(LogOf(Plain(Exp(u))));
  RC_ASSERT(glm::length(back - u) < kRounding);
}

TEST(LogOf, TheIdentityIsZero) {
  const VectorOf<double> zero = LogOf(QuaternionOf<double>{1, 0, 0, 0});
  EXPECT_EQ(zero, (VectorOf<double>{0, 0, 0}));
}

TEST(LogOf, ATinyTurnIsTheTurn) {
  const VectorOf<double> u = LogOf(ExpOf(VectorOf<double>{1e-9, -2e-9, 3e-300}));
  EXPECT_NEAR(u[0], 1e-9, 1e-24);
  EXPECT_NEAR(u[1], -2e-9, 1e-24);
  EXPECT_NEAR(u[2], 3e-300, 1e-314);
}

// "At 120 deg 1e-10."
RC_GTEST_PROP(LogOf, IsALittleOffBeyondARightAngle, ()) {
  const Vector3 u = RadiansFromDegrees(*NumberWithin(90, 120)) * *UnitVector();
  RC_ASSERT(glm::length(Plain(LogOf(Plain(Exp(u)))) - u) < 1e-9);
}

RC_GTEST_PROP(AboutYOf, TurnsAboutY, ()) {
  const double angle_rad = *NumberWithin(-2 * kPi, 2 * kPi);
  RC_ASSERT(Difference(Plain(AboutYOf(angle_rad)), Exp(Vector3(0, angle_rad, 0))) < kRounding);
}

// A rotation that turns as e goes by: exp(u + e v) q.
QuaternionOf<Dual<double>> Turning(const Vector3& u, const Vector3& v, const Quaternion& q) {
  const VectorOf<Dual<double>> way = {Dual<double>(u.x, v.x), Dual<double>(u.y, v.y),
                                      Dual<double>(u.z, v.z)};
  return ExpOf(way) * Plain(q);
}

RC_GTEST_PROP(ParentVelocity, IsThatOfDifferencesInTheParent, ()) {
  constexpr double kStep = 1e-5;
  const Vector3 u = *NumberWithin(0, 3) * *UnitVector();
  const Vector3 v = *VectorWithin(-1, 1);
  const Quaternion q = *UnitQuaternion();
  const auto at = [&](double e) { return Exp(u + e * v) * q; };
  const Vector3 expected = Log(at(kStep) * glm::conjugate(at(-kStep))) / (2 * kStep);
  const Vector3 velocity = Plain(ParentVelocity(Turning(u, v, q)));
  RC_ASSERT(glm::length(velocity - expected) < 1e-9);
}

RC_GTEST_PROP(TurningExp, HasTheVelocityOfDifferences, ()) {
  constexpr double kStep = 1e-5;
  const Vector3 u = *NumberWithin(0, 3) * *UnitVector();
  const Vector3 v = *VectorWithin(-1, 1);
  const Quaternion m = *UnitQuaternion();
  const auto at = [&](double e) { return Exp(u + e * v) * m; };
  const Vector3 expected = Log(at(kStep) * glm::conjugate(at(-kStep))) / (2 * kStep);
  const TurningRotation<double> turning = TurningExp(Plain(u), Plain(v), Plain(m));
  RC_ASSERT(Difference(Plain(turning.q), at(0)) < kRounding);
  RC_ASSERT(glm::length(Plain(turning.w) - expected) < 1e-9);
}

RC_GTEST_PROP(ParentVelocity, DoesNotChangeWithTheChildsFrame, ()) {
  const Vector3 u = *NumberWithin(0, 3) * *UnitVector();
  const Vector3 v = *VectorWithin(-1, 1);
  const Quaternion p = *UnitQuaternion();
  const QuaternionOf<Dual<double>> q = Turning(u, v, *UnitQuaternion());
  const QuaternionOf<Dual<double>> fixed = {Dual<double>(p.w), Dual<double>(p.x), Dual<double>(p.y),
                                            Dual<double>(p.z)};
  RC_ASSERT(glm::length(Plain(ParentVelocity(q * fixed)) - Plain(ParentVelocity(q))) < kRounding);
}

// exp and log over jets against differences of first derivatives.
RC_GTEST_PROP(LogOf, OfExpOverJetsGivesTheJetsBack, ()) {
  constexpr double kTolerance = 1e-11;
  VectorOf<Jet<double, 2>> u;
  for (Jet<double, 2>& component : u) {
    for (double& part : component.part) part = *NumberWithin(-0.8, 0.8);
  }
  const VectorOf<Jet<double, 2>> back = LogOf(ExpOf(u));
  for (std::size_t k = 0; k < u.size(); ++k) {
    for (std::size_t part = 0; part < u[k].part.size(); ++part) {
      RC_ASSERT(std::abs(back[k].part[part] - u[k].part[part]) < kTolerance);
    }
  }
}

TEST(WithinHalfTurn, TakesTheUpperEnd) {
  EXPECT_EQ(WithinHalfTurn(kPi), kPi);
  EXPECT_EQ(WithinHalfTurn(-kPi), kPi);
  EXPECT_EQ(WithinHalfTurn(1.5 * kPi), -0.5 * kPi);
  EXPECT_EQ(WithinHalfTurn(-1.5 * kPi), 0.5 * kPi);
  const Pair pair = WithinHalfTurn(Pair(-kPi, 1.5 * kPi));
  EXPECT_EQ(pair[0], kPi);
  EXPECT_EQ(pair[1], -0.5 * kPi);
}

// Both sequences whose axes go around in the order 3, 2, 1.
VectorOf<double> AnglesOf(EulerSequence sequence, const Quaternion& q) {
  return sequence == EulerSequence::kYXZ ? EulerAngles(q.w, q.y, q.x, q.z)
                                         : EulerAngles(q.w, q.x, q.z, q.y);
}

RC_GTEST_PROP(EulerAnglesOf, ARotationGiveItBack, ()) {
  const EulerSequence sequence = *rc::gen::element(EulerSequence::kYXZ, EulerSequence::kXZY);
  const Quaternion q = AlignedWith(*UnitQuaternion(), {1, 0, 0, 0});
  const VectorOf<double> angles_rad = AnglesOf(sequence, q);
  RC_ASSERT(AngleBetween(QuaternionFromEuler(sequence, Plain(angles_rad)), q) < 1e-13);
  for (const double angle_rad : angles_rad) {
    RC_ASSERT(angle_rad >= -kPi);
    RC_ASSERT(angle_rad <= kPi);
  }
}

RC_GTEST_PROP(EulerAnglesOf, AnglesAreTheAngles, ()) {
  // Beside a gimbal lock digits are lost.
  constexpr double kHighest_rad = 1.5;
  const EulerSequence sequence = *rc::gen::element(EulerSequence::kYXZ, EulerSequence::kXZY);
  const Vector3 angles_rad(*NumberWithin(-kPi, kPi), *NumberWithin(-kHighest_rad, kHighest_rad),
                           *NumberWithin(-kPi, kPi));
  const Quaternion q = AlignedWith(QuaternionFromEuler(sequence, angles_rad), {1, 0, 0, 0});
  const VectorOf<double> back_rad = AnglesOf(sequence, q);
  for (std::size_t k = 0; k < back_rad.size(); ++k) {
    const double off_rad = back_rad[k] - angles_rad[static_cast<int>(k)];
    RC_ASSERT(std::abs(std::remainder(off_rad, 2 * kPi)) < 1e-13);
  }
}

TEST(EulerAnglesOf, GimbalLockGiveTheRotation) {
  for (const EulerSequence sequence : {EulerSequence::kYXZ, EulerSequence::kXZY}) {
    for (const double second_rad : {kPi / 2, -kPi / 2}) {
      const Quaternion q =
          AlignedWith(QuaternionFromEuler(sequence, {0.4, second_rad, -1.1}), {1, 0, 0, 0});
      const VectorOf<double> angles_rad = AnglesOf(sequence, q);
      // The second angle is known to the root of a rounding.
      EXPECT_LT(AngleBetween(QuaternionFromEuler(sequence, Plain(angles_rad)), q), 1e-7);
    }
  }
}

RC_GTEST_PROP(EulerAnglesOf, PairsAreThoseOfBoth, ()) {
  constexpr double kRounding_rad = 1e-14;
  const Quaternion a = AlignedWith(*UnitQuaternion(), {1, 0, 0, 0});
  const Quaternion b = AlignedWith(*UnitQuaternion(), {1, 0, 0, 0});
  const VectorOf<Pair> both =
      EulerAngles(Pair(a.w, b.w), Pair(a.y, b.y), Pair(a.x, b.x), Pair(a.z, b.z));
  for (std::size_t i = 0; i < 2; ++i) {
    const VectorOf<double> alone = AnglesOf(EulerSequence::kYXZ, i == 0 ? a : b);
    for (std::size_t k = 0; k < alone.size(); ++k) {
      RC_ASSERT(std::abs(both[k][i] - alone[k]) < kRounding_rad);
    }
  }
}

}  // namespace
}  // namespace girdle::rotation_algebra_test
