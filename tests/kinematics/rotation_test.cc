// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <ostream>
#include <vector>

#include "kinematics/axis_matrices.h"
#include "kinematics/random_rotations.h"

namespace girdle {

void showValue(EulerSequence sequence, std::ostream& out) {
  constexpr std::array<const char*, 3> kNames = {"Y-X'-Z''", "X-Z'-Y''", "Y-X'-Y''"};
  out << kNames.at(static_cast<std::size_t>(sequence));
}

void PrintTo(const EulerSequence& sequence, std::ostream* out) { showValue(sequence, *out); }

}  // namespace girdle

namespace girdle::rotation_test {
namespace {

// A few dozen roundings of numbers of size one.
constexpr double kRounding = 1e-14;

rc::Gen<EulerSequence> Sequence() {
  return rc::gen::element(EulerSequence::kYXZ, EulerSequence::kXZY, EulerSequence::kYXY);
}

RowMatrix ProductOfTurns(EulerSequence sequence, const Vector3& angles_rad) {
  const auto [a, b, c] = std::array{angles_rad.x, angles_rad.y, angles_rad.z};
  switch (sequence) {
    case EulerSequence::kYXZ:
      return Product(Product(TurnAboutY(a), TurnAboutX(b)), TurnAboutZ(c));
    case EulerSequence::kXZY:
      return Product(Product(TurnAboutX(a), TurnAboutZ(b)), TurnAboutY(c));
    case EulerSequence::kYXY:
      break;
  }
  return Product(Product(TurnAboutY(a), TurnAboutX(b)), TurnAboutY(c));
}

// The range of the second angle.
struct Range {
  double lower_rad;
  double upper_rad;
};

Range SecondAngleRange(EulerSequence sequence) {
  return sequence == EulerSequence::kYXY ? Range{-kPi, 0} : Range{-kPi / 2, kPi / 2};
}

RC_GTEST_PROP(EulerAngles, AreThreeTurnsAboutTheMovingAxes, ()) {
  const EulerSequence sequence = *Sequence();
  const Vector3 angles_rad = *VectorWithin(-kPi, kPi);
  RC_ASSERT(Difference(ProductOfTurns(sequence, angles_rad),
                       QuaternionFromEuler(sequence, angles_rad)) < kRounding);
}

// Written out as in tables of rotation matrices, with s1 the sine of the first angle and so on.
RC_GTEST_PROP(EulerAngles, GiveTheMatricesOfTheTextbook, ()) {
  const Vector3 angles_rad = *VectorWithin(-kPi, kPi);
  const auto [c1, c2, c3] =
      std::array{std::cos(angles_rad.x), std::cos(angles_rad.y), std::cos(angles_rad.z)};
  const auto [s1, s2, s3] =
      std::array{std::sin(angles_rad.x), std::sin(angles_rad.y), std::sin(angles_rad.z)};
  const RowMatrix yxz = {{{c1 * c3 + s1 * s2 * s3, c3 * s1 * s2 - c1 * s3, c2 * s1},
                          {c2 * s3, c2 * c3, -s2},
                          {c1 * s2 * s3 - c3 * s1, s1 * s3 + c1 * c3 * s2, c1 * c2}}};
  const RowMatrix xzy = {{{c2 * c3, -s2, c2 * s3},
                          {s1 * s3 + c1 * c3 * s2, c1 * c2, c1 * s2 * s3 - c3 * s1},
                          {c3 * s1 * s2 - c1 * s3, c2 * s1, c1 * c3 + s1 * s2 * s3}}};
  const RowMatrix yxy = {{{c1 * c3 - c2 * s1 * s3, s1 * s2, c1 * s3 + c2 * c3 * s1},
                          {s2 * s3, c2, -c3 * s2},
                          {-c3 * s1 - c1 * c2 * s3, c1 * s2, c1 * c2 * c3 - s1 * s3}}};
  RC_ASSERT(Difference(yxz, QuaternionFromEuler(EulerSequence::kYXZ, angles_rad)) < kRounding);
  RC_ASSERT(Difference(xzy, QuaternionFromEuler(EulerSequence::kXZY, angles_rad)) < kRounding);
  RC_ASSERT(Difference(yxy, QuaternionFromEuler(EulerSequence::kYXY, angles_rad)) < kRounding);
}

RC_GTEST_PROP(EulerAngles, GiveAUnitQuaternion, ()) {
  const Quaternion q_AB = QuaternionFromEuler(*Sequence(), *VectorWithin(-kPi, kPi));
  RC_ASSERT(std::abs(glm::length(q_AB) - 1) < kRounding);
}

RC_GTEST_PROP(EulerAngles, ComeBackFromTheirQuaternion, ()) {
  // With the second angle this close to the end of its range 1e-16 in the quaternion moves the
  // first and the third by 1e-13.
  constexpr double kMargin_rad = 1e-3;
  constexpr double kTolerance_rad = 1e-12;
  const EulerSequence sequence = *Sequence();
  const Range range = SecondAngleRange(sequence);
  const Vector3 angles_rad = {
      *NumberWithin(-kPi + kMargin_rad, kPi - kMargin_rad),
      *NumberWithin(range.lower_rad + kMargin_rad, range.upper_rad - kMargin_rad),
      *NumberWithin(-kPi + kMargin_rad, kPi - kMargin_rad)};
  const Vector3 back_rad = EulerFromQuaternion(sequence, QuaternionFromEuler(sequence, angles_rad));
  RC_LOG() << "came back as ";
  showValue(back_rad, RC_LOG());
  RC_ASSERT(glm::length(back_rad - angles_rad) < kTolerance_rad);
}

RC_GTEST_PROP(EulerAngles, OfARotationGiveTheRotation, ()) {
  const EulerSequence sequence = *Sequence();
  const Quaternion q_AB = *UnitQuaternion();
  const Quaternion back = QuaternionFromEuler(sequence, EulerFromQuaternion(sequence, q_AB));
  RC_ASSERT(AngleBetween(back, q_AB) < kRounding);
}

RC_GTEST_PROP(EulerAngles, LieWithinTheirRanges, ()) {
  const EulerSequence sequence = *Sequence();
  const Vector3 angles_rad = EulerFromQuaternion(sequence, *UnitQuaternion());
  const Range range = SecondAngleRange(sequence);
  RC_ASSERT(angles_rad.x > -kPi && angles_rad.x <= kPi);
  RC_ASSERT(angles_rad.y >= range.lower_rad && angles_rad.y <= range.upper_rad);
  RC_ASSERT(angles_rad.z > -kPi && angles_rad.z <= kPi);
}

RC_GTEST_PROP(EulerAngles, DoNotDependOnTheSignOfTheQuaternion, ()) {
  const EulerSequence sequence = *Sequence();
  const Quaternion q_AB = *UnitQuaternion();
  const Vector3 difference_rad =
      EulerFromQuaternion(sequence, q_AB) - EulerFromQuaternion(sequence, -q_AB);
  for (int i = 0; i < 3; ++i) {
    RC_ASSERT(std::abs(std::remainder(difference_rad[i], 2 * kPi)) < kRounding);
  }
}

// A second angle at the end of its range: the first and the third axis coincide.
struct GimbalCase {
  EulerSequence sequence;
  double second_rad;
};

void PrintTo(const GimbalCase& gimbal, std::ostream* out) {
  showValue(gimbal.sequence, *out);
  *out << ", second angle " << DegreesFromRadians(gimbal.second_rad) << " deg";
}

class EulerAnglesAtGimbalLock : public testing::TestWithParam<GimbalCase> {
 protected:
  // Some of these are exact in binary, others are not.
  static std::vector<Vector3> SamplesRad() {
    std::vector<Vector3> samples_rad;
    for (const double first_rad : {0.0, 0.3, -1.2, kPi / 2, 3.0}) {
      for (const double third_rad : {0.0, 0.7, -2.5, kPi / 2}) {
        samples_rad.emplace_back(first_rad, GetParam().second_rad, third_rad);
      }
    }
    return samples_rad;
  }
};

TEST_P(EulerAnglesAtGimbalLock, LieWithinTheirRanges) {
  const Range range = SecondAngleRange(GetParam().sequence);
  for (const Vector3& sample_rad : SamplesRad()) {
    for (const double sign : {1.0, -1.0}) {
      const Quaternion q_AB = sign * QuaternionFromEuler(GetParam().sequence, sample_rad);
      const Vector3 angles_rad = EulerFromQuaternion(GetParam().sequence, q_AB);
      EXPECT_TRUE(angles_rad.x > -kPi && angles_rad.x <= kPi) << angles_rad.x;
      EXPECT_TRUE(angles_rad.y >= range.lower_rad && angles_rad.y <= range.upper_rad)
          << angles_rad.y;
      EXPECT_TRUE(angles_rad.z > -kPi && angles_rad.z <= kPi) << angles_rad.z;
    }
  }
}

TEST_P(EulerAnglesAtGimbalLock, StillGiveTheRotation) {
  for (const Vector3& sample_rad : SamplesRad()) {
    const EulerSequence sequence = GetParam().sequence;
    const Quaternion q_AB = QuaternionFromEuler(sequence, sample_rad);
    const Vector3 angles_rad = EulerFromQuaternion(sequence, q_AB);
    EXPECT_LT(AngleBetween(QuaternionFromEuler(sequence, angles_rad), q_AB), kRounding)
        << "first " << sample_rad.x << ", third " << sample_rad.z << "; came back as "
        << angles_rad.x << ", " << angles_rad.y << ", " << angles_rad.z;
  }
}

INSTANTIATE_TEST_SUITE_P(AllSequences, EulerAnglesAtGimbalLock,
                         testing::Values(GimbalCase{EulerSequence::kYXZ, kPi / 2},
                                         GimbalCase{EulerSequence::kYXZ, -kPi / 2},
                                         GimbalCase{EulerSequence::kXZY, kPi / 2},
                                         GimbalCase{EulerSequence::kXZY, -kPi / 2},
                                         GimbalCase{EulerSequence::kYXY, 0},
                                         GimbalCase{EulerSequence::kYXY, -kPi}));

// Sizes of a rotation vector at which formulas of exp and log change or lose digits.
class RotationVector : public testing::TestWithParam<double> {
 protected:
  static std::vector<Vector3> SamplesRad() {
    return {GetParam() * Vector3{1, 0, 0}, GetParam() * Vector3{0, -0.6, 0.8},
            GetParam() * glm::normalize(Vector3{-1, 2, 3})};
  }
};

TEST_P(RotationVector, ComesBackFromItsQuaternion) {
  for (const Vector3& vector_rad : SamplesRad()) {
    EXPECT_LE(glm::length(Log(Exp(vector_rad)) - vector_rad), kRounding * GetParam());
  }
}

TEST_P(RotationVector, GivesCosineAndSineOfHalfItsLength) {
  for (const Vector3& vector_rad : SamplesRad()) {
    const Quaternion q_AB = Exp(vector_rad);
    const double sine_of_half = std::sin(GetParam() / 2);
    EXPECT_NEAR(q_AB.w, std::cos(GetParam() / 2), kRounding);
    const Vector3 expected =
        GetParam() > 0 ? vector_rad * (sine_of_half / GetParam()) : Vector3{0, 0, 0};
    EXPECT_LE(glm::length(Vector3(q_AB.x, q_AB.y, q_AB.z) - expected), kRounding * sine_of_half);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, RotationVector,
                         testing::Values(0.0, 1e-300, 1e-15, 1e-12, 3e-12, 1e-9, 2e-9, 3e-9, 1e-8,
                                         1e-4, 0.1, 1.0, kPi / 2, 3.0, kPi - 1e-4, kPi - 1e-8,
                                         kPi - 1e-12));

TEST(Exp, OfZeroIsExactlyTheIdentity) { EXPECT_EQ(Exp({0, 0, 0}), Quaternion(1, 0, 0, 0)); }

TEST(Log, OfTheIdentityIsExactlyZero) {
  EXPECT_EQ(Log(Quaternion(1, 0, 0, 0)), Vector3(0, 0, 0));
  EXPECT_EQ(Log(Quaternion(-1, 0, 0, 0)), Vector3(0, 0, 0));
}

class LongRotationVector : public testing::TestWithParam<double> {};

TEST_P(LongRotationVector, GivesAUnitQuaternion) {
  for (const Vector3& direction : {Vector3{0, 1, 0}, Vector3{0.6, 0, -0.8}}) {
    EXPECT_NEAR(glm::length(Exp(GetParam() * direction)), 1, kRounding);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LongRotationVector,
                         testing::Values(7.0, 1e3, 1e16, 1e153, 1e160, 1e300));

RC_GTEST_PROP(Exp, OfAWholeTurnMoreIsTheSameRotation, ()) {
  const Vector3 axis = *UnitVector();
  const double angle_rad = *NumberWithin(0, kPi);
  RC_ASSERT(AngleBetween(Exp(angle_rad * axis), Exp((angle_rad + 2 * kPi) * axis)) < kRounding);
}

RC_GTEST_PROP(Exp, IsTheInverseOfLog, ()) {
  const Quaternion q_AB = *UnitQuaternion();
  const Quaternion back = Exp(Log(q_AB));
  RC_ASSERT(std::min(Difference(back, q_AB), Difference(back, -q_AB)) < kRounding);
}

RC_GTEST_PROP(Log, IsAtMostHalfATurn, ()) {
  RC_ASSERT(glm::length(Log(*UnitQuaternion())) <= kPi + kRounding);
}

RC_GTEST_PROP(Log, DoesNotDependOnTheSignOfTheQuaternion, ()) {
  const Quaternion q_AB = *UnitQuaternion();
  RC_PRE(q_AB.w != 0);  // half a turn about n is half a turn about -n
  RC_ASSERT(Log(q_AB) == Log(-q_AB));
}

TEST(Log, OfHalfATurnIsPiAboutItsAxis) {
  const Vector3 vector_rad = Log(Quaternion(0, 0.6, 0, 0.8));
  EXPECT_NEAR(std::abs(glm::dot(vector_rad, Vector3(0.6, 0, 0.8))), kPi, kRounding);
  EXPECT_NEAR(glm::length(vector_rad), kPi, kRounding);
}

class SmallAngle : public testing::TestWithParam<double> {};

// An arc cosine of the quaternions' product would see nothing below 1e-8.
TEST_P(SmallAngle, IsFoundBetweenRotations) {
  const Quaternion a = QuaternionFromEuler(EulerSequence::kYXZ, {0.4, -1.1, 2.3});
  const Vector3 axis = glm::normalize(Vector3{1, -2, 0.5});
  EXPECT_NEAR(AngleBetween(a, a * Exp(GetParam() * axis)), GetParam(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SmallAngle, testing::Values(0.0, 1e-13, 1e-10, 1e-8, 1e-5, 1e-2));

RC_GTEST_PROP(AngleBetween, IsTheAngleOfTheTurnThatLeadsFromOneToTheOther, ()) {
  const Quaternion a = *UnitQuaternion();
  const double angle_rad = *NumberWithin(0, kPi);
  RC_ASSERT(std::abs(AngleBetween(a, a * Exp(angle_rad * *UnitVector())) - angle_rad) < kRounding);
}

RC_GTEST_PROP(AngleBetween, DoesNotDependOnSignsAndOrder, ()) {
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = *UnitQuaternion();
  const double angle_rad = AngleBetween(a, b);
  RC_ASSERT(std::abs(AngleBetween(-a, b) - angle_rad) < kRounding);
  RC_ASSERT(std::abs(AngleBetween(a, -b) - angle_rad) < kRounding);
  RC_ASSERT(std::abs(AngleBetween(b, a) - angle_rad) < kRounding);
}

// The trace of a rotation matrix is 1 + 2 cos(angle).
RC_GTEST_PROP(AngleBetween, AgreesWithTheTraceOfTheMatrix, ()) {
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = *UnitQuaternion();
  const Matrix3 R = glm::mat3_cast(glm::conjugate(a) * b);
  RC_ASSERT(std::abs(1 + 2 * std::cos(AngleBetween(a, b)) - (R[0][0] + R[1][1] + R[2][2])) <
            kRounding);
}

RC_GTEST_PROP(AlignedWith, GivesTheSignThatLiesNearer, ()) {
  const Quaternion q_AB = *UnitQuaternion();
  const Quaternion reference = *UnitQuaternion();
  const Quaternion aligned = AlignedWith(q_AB, reference);
  RC_ASSERT(aligned == q_AB || aligned == -q_AB);
  RC_ASSERT(glm::dot(aligned, reference) >= 0);
}

TEST(Degrees, AreConvertedBothWays) {
  EXPECT_DOUBLE_EQ(RadiansFromDegrees(-180), -kPi);
  EXPECT_DOUBLE_EQ(DegreesFromRadians(kPi / 3), 60);
}

}  // namespace
}  // namespace girdle::rotation_test
