// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "fits/table_smoothing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"

namespace girdle::table_smoothing_test {
namespace {

using Series = std::vector<Quaternion>;
using JointSeries = std::array<Series, kJointCount>;

constexpr std::size_t kRowCount = 12;
// Euler angles that go there and back lose half the digits beside a gimbal lock; elsewhere, and in
// what the steps leave, this is far more than rounding.
constexpr double kRounding_rad = 1e-7;

// All three joints smoothed alike.
constexpr SmoothingOptions kSameForAll = {.penalty = 10, .gh_low_share = 1};

std::vector<double> EvenElevations(std::size_t count = kRowCount) {
  std::vector<double> elevations_rad;
  elevations_rad.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    elevations_rad.push_back(RadiansFromDegrees(15 + 5 * static_cast<double>(i)));
  }
  return elevations_rad;
}

// Steps of elevation between 2 and 8 degrees.
std::vector<double> UnevenElevations() {
  std::vector<double> elevations_rad = {RadiansFromDegrees(10)};
  while (elevations_rad.size() < kRowCount) {
    elevations_rad.push_back(elevations_rad.back() + RadiansFromDegrees(*NumberWithin(2, 8)));
  }
  return elevations_rad;
}

// The series in both of two planes.
RhythmTable TableOfSeries(const std::vector<double>& elevations_rad, const JointSeries& series) {
  std::vector<RhythmPosition> positions;
  for (int plane = 0; plane < 2; ++plane) {
    for (std::size_t i = 0; i < elevations_rad.size(); ++i) {
      JointAngles& angles_rad = positions.emplace_back().angles_rad;
      angles_rad = AnglesFromPose({series[0][i], series[1][i], series[2][i]});
      // A table has it within half a turn.
      double& axial_rad = angles_rad[kGhAxialIndex];
      axial_rad = std::clamp(std::remainder(axial_rad, 2 * kPi), -kPi, kPi);
    }
  }
  return {{0, RadiansFromDegrees(40)}, elevations_rad, positions};
}

RhythmTable TableOfSeries(const std::vector<double>& elevations_rad, const Series& series) {
  return TableOfSeries(elevations_rad, JointSeries{series, series, series});
}

Quaternion RotationAt(const RhythmTable& table, std::size_t joint, std::size_t plane,
                      std::size_t elevation) {
  const ShoulderPose pose = PoseFromAngles(table.position(plane, elevation).angles_rad);
  return std::array{pose.q_TC, pose.q_CS, pose.q_SH}.at(joint);
}

JointSeries SeriesOf(const RhythmTable& table, std::size_t plane = 0) {
  JointSeries series;
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    for (std::size_t i = 0; i < table.elevations_rad().size(); ++i) {
      series[joint].push_back(RotationAt(table, joint, plane, i));
    }
  }
  return series;
}

Series Multiplied(const Quaternion& left, const Series& series, const Quaternion& right) {
  Series product;
  for (const Quaternion& rotation : series) product.push_back(left * rotation * right);
  return product;
}

double LargestAngle(const Series& a, const Series& b) {
  double largest_rad = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double angle_rad = AngleBetween(a[i], b[i]);
    if (!(angle_rad <= largest_rad)) largest_rad = angle_rad;
  }
  return largest_rad;
}

// A series that turns by up to 15 degrees a row, in any way.
Series RoughSeries(std::size_t count = kRowCount) {
  Series series = {*UnitQuaternion()};
  while (series.size() < count) {
    const Vector3 way_rad = *VectorWithin(-RadiansFromDegrees(8), RadiansFromDegrees(8));
    series.push_back(glm::normalize(series.back() * Exp(way_rad)));
  }
  return series;
}

// Divided difference of Newton's interpolation, of order values.size() - 1.
Vector3 DividedDifference(const std::vector<double>& x, const std::vector<Vector3>& values) {
  if (values.size() == 1) return values.front();
  const Vector3 upper =
      DividedDifference({x.begin() + 1, x.end()}, {values.begin() + 1, values.end()});
  const Vector3 lower =
      DividedDifference({x.begin(), x.end() - 1}, {values.begin(), values.end() - 1});
  return (upper - lower) / (x.back() - x.front());
}

// Sum (1), with the third differences of the ways added up from each group's first row.
double SumToBeLeast(const std::vector<double>& x, const Series& q, const Series& r,
                    double penalty) {
  double sum = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Vector3 e = Log(glm::conjugate(q[i]) * r[i]);
    sum += glm::dot(e, e);
  }
  for (std::size_t i = 0; i + 3 < r.size(); ++i) {
    std::vector<Vector3> values = {Vector3(0)};
    for (std::size_t k = i; k < i + 3; ++k) {
      values.push_back(values.back() + Log(glm::conjugate(r[k]) * r[k + 1]));
    }
    const double step = (x[i + 3] - x[i]) / 3;
    const Vector3 t =
        6 * step * step * step * DividedDifference({x[i], x[i + 1], x[i + 2], x[i + 3]}, values);
    sum += penalty * glm::dot(t, t);
  }
  return sum;
}

RC_GTEST_PROP(Smoothed, LeavesAConstantRateAboutAFixedAxis, ()) {
  const std::vector<double> x = UnevenElevations();
  const Quaternion first = *UnitQuaternion();
  const Vector3 axis = *UnitVector();
  const double rate = *NumberWithin(0, 2);
  Series series;
  for (const double elevation_rad : x) series.push_back(first * Exp(rate * elevation_rad * axis));
  const JointSeries result = SeriesOf(Smoothed(TableOfSeries(x, series), kSameForAll));
  for (const Series& joint : result) RC_ASSERT(LargestAngle(joint, series) < kRounding_rad);
}

// A rate that changes evenly has no third difference either.
RC_GTEST_PROP(Smoothed, LeavesAConstantAccelerationAboutAFixedAxis, ()) {
  const std::vector<double> x = UnevenElevations();
  const Quaternion first = *UnitQuaternion();
  const Vector3 axis = *UnitVector();
  const double rate = *NumberWithin(-1, 1);
  const double acceleration = *NumberWithin(-1, 1);
  Series series;
  for (const double elevation_rad : x) {
    const double turn_rad = rate * elevation_rad + acceleration * elevation_rad * elevation_rad;
    series.push_back(first * Exp(turn_rad * axis));
  }
  const JointSeries result = SeriesOf(Smoothed(TableOfSeries(x, series), kSameForAll));
  for (const Series& joint : result) RC_ASSERT(LargestAngle(joint, series) < kRounding_rad);
}

RC_GTEST_PROP(Smoothed, TurnsWithItsRowsFromTheLeftAndFromTheRight, ()) {
  const std::vector<double> x = UnevenElevations();
  const Series series = RoughSeries();
  const Quaternion left = *UnitQuaternion();
  const Quaternion right = *UnitQuaternion();
  const JointSeries plain = SeriesOf(Smoothed(TableOfSeries(x, series)));
  const JointSeries turned = SeriesOf(Smoothed(TableOfSeries(x, Multiplied(left, series, right))));
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    RC_ASSERT(LargestAngle(turned[joint], Multiplied(left, plain[joint], right)) < kRounding_rad);
  }
}

// The definition itself: no small turn of any row lowers the sum.
RC_GTEST_PROP(Smoothed, MakesTheSumLeast, ()) {
  const std::vector<double> x = UnevenElevations();
  const Series q = RoughSeries();
  const double penalty = *rc::gen::element(0.1, 10.0, 1000.0);
  const Series r = SeriesOf(Smoothed(TableOfSeries(x, q), {penalty, 1}))[0];
  const std::size_t row = *rc::gen::inRange<std::size_t>(0, kRowCount);
  constexpr double kSmallTurn_rad = 1e-3;
  Series other = r;
  other[row] = other[row] * Exp(kSmallTurn_rad * *UnitVector());
  // Turned by d from the least, the sum of squares grows by |d|^2 at least, less what is of higher
  // order in d.
  RC_ASSERT(SumToBeLeast(x, q, other, penalty) >
            SumToBeLeast(x, q, r, penalty) + 0.5 * kSmallTurn_rad * kSmallTurn_rad);
}

// About one axis the rows are numbers and the fit is linear: solved here without Newton, without a
// band and without Cholesky, as the fixed point (1 + lambda D^T D) r = q.
RC_GTEST_PROP(Smoothed, IsTheScalarSmootherAboutAFixedAxis, ()) {
  const Vector3 axis = *UnitVector();
  std::vector<double> turns_rad;
  Series q;
  for (std::size_t i = 0; i < kRowCount; ++i) {
    turns_rad.push_back(*NumberWithin(-0.3, 0.3));
    q.push_back(Exp(turns_rad.back() * axis));
  }
  const double penalty = *NumberWithin(0.1, 100);
  const Series r = SeriesOf(Smoothed(TableOfSeries(EvenElevations(), q), {penalty, 1}))[0];
  std::vector<double> sum;
  for (const Quaternion& rotation : r) sum.push_back(glm::dot(Log(rotation), axis));
  const std::vector<double> fitted_rad = sum;
  constexpr std::array<double, 4> kDifference = {-1, 3, -3, 1};
  for (std::size_t i = 0; i + 3 < kRowCount; ++i) {
    double difference = 0;
    for (std::size_t k = 0; k < 4; ++k) difference += kDifference.at(k) * fitted_rad[i + k];
    for (std::size_t k = 0; k < 4; ++k) sum[i + k] += penalty * kDifference.at(k) * difference;
  }
  for (std::size_t i = 0; i < kRowCount; ++i) {
    RC_ASSERT(std::abs(sum[i] - turns_rad[i]) < kRounding_rad * (1 + penalty));
  }
}

RC_GTEST_PROP(Smoothed, LeavesNoThirdDifferenceUnderALargePenalty, ()) {
  const Series series = RoughSeries();
  const RhythmTable table = TableOfSeries(EvenElevations(), series);
  const Series r = SeriesOf(Smoothed(table, {kLargestPenalty, 1}))[0];
  constexpr double kVerySmall_rad = 1e-4;
  for (std::size_t i = 0; i + 3 < kRowCount; ++i) {
    const Vector3 third = Log(glm::conjugate(r[i]) * r[i + 1]) -
                          2.0 * Log(glm::conjugate(r[i + 1]) * r[i + 2]) +
                          Log(glm::conjugate(r[i + 2]) * r[i + 3]);
    RC_ASSERT(glm::length(third) < kVerySmall_rad);
  }
}

RC_GTEST_PROP(Smoothed, ChangesNothingWithoutAPenalty, ()) {
  const RhythmTable table = TableOfSeries(UnevenElevations(), RoughSeries());
  const RhythmTable result = Smoothed(table, {.penalty = 0});
  for (std::size_t i = 0; i < kRowCount; ++i) {
    RC_ASSERT(result.position(1, i).angles_rad == table.position(1, i).angles_rad);
  }
}

RC_GTEST_PROP(Smoothed, ChangesNextToNothingWithNextToNoPenalty, ()) {
  const Series series = RoughSeries();
  const RhythmTable table = TableOfSeries(EvenElevations(), series);
  const JointSeries result = SeriesOf(Smoothed(table, {.penalty = 1e-9}));
  for (const Series& joint : result) RC_ASSERT(LargestAngle(joint, series) < kRounding_rad);
}

TEST(Smoothed, KeepsEverythingButTheAngles) {
  const RhythmTable source = TableOf(MeasuredRows());
  std::vector<RhythmPosition> positions;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t i = 0; i < 22; ++i) {
      RhythmPosition position = source.position(plane, i);
      position.measured = i % 3 == 0;
      position.scapulothoracic_rad = Vector3(0.01 * static_cast<double>(i), 0.1, 0.2);
      positions.push_back(position);
    }
  }
  const RhythmTable table(source.planes_rad(), source.elevations_rad(), positions);
  const RhythmTable result = Smoothed(table);
  EXPECT_EQ(result.planes_rad(), table.planes_rad());
  EXPECT_EQ(result.elevations_rad(), table.elevations_rad());
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t i = 0; i < 22; ++i) {
      EXPECT_EQ(result.position(plane, i).measured, table.position(plane, i).measured);
      EXPECT_EQ(result.position(plane, i).scapulothoracic_rad,
                table.position(plane, i).scapulothoracic_rad);
      EXPECT_NE(result.position(plane, i).angles_rad, table.position(plane, i).angles_rad);
    }
  }
}

TEST(Smoothed, TakesEachPlaneAndEachJointByItself) {
  const RhythmTable source = TableOf(MeasuredRows());
  std::vector<RhythmPosition> positions;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t i = 0; i < 22; ++i) positions.push_back(source.position(plane, i));
  }
  positions[22 + 7].angles_rad[4] += RadiansFromDegrees(2);  // AC in the second plane
  const RhythmTable changed(source.planes_rad(), source.elevations_rad(), positions);
  const RhythmTable a = Smoothed(source);
  const RhythmTable b = Smoothed(changed);
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t i = 0; i < 22; ++i) {
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        const bool is_same = RotationAt(a, joint, plane, i) == RotationAt(b, joint, plane, i);
        EXPECT_EQ(is_same, plane != 1 || joint != 1) << joint << " " << plane << " " << i;
      }
    }
  }
}

TEST(Smoothed, LeavesTheLowestRowsOfGhToThemselvesIfTold) {
  const RhythmTable table = TableOf(MeasuredRows());
  const RhythmTable result = Smoothed(table, {.gh_low_share = 0});
  constexpr std::size_t kFirstFromThirty = 3;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t i = 0; i < kFirstFromThirty; ++i) {
      EXPECT_LT(AngleBetween(RotationAt(table, 2, plane, i), RotationAt(result, 2, plane, i)),
                kRounding_rad);
    }
  }
}

struct RefusedOptions {
  const char* name;
  std::size_t elevations;
  SmoothingOptions options;
  const char* message;
};

void PrintTo(const RefusedOptions& refused, std::ostream* out) { *out << refused.name; }

class RefusedSmoothing : public testing::TestWithParam<RefusedOptions> {};

TEST_P(RefusedSmoothing, SaysWhatIsExpected) {
  const Series series(GetParam().elevations, Quaternion(1, 0, 0, 0));
  const RhythmTable table = TableOfSeries(EvenElevations(series.size()), series);
  try {
    static_cast<void>(Smoothed(table, GetParam().options));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, RefusedSmoothing,
    testing::Values(RefusedOptions{"three elevations",
                                   3,
                                   {},
                                   "elevations: 3 given, at least 4 are needed to smooth"},
                    RefusedOptions{"a negative penalty",
                                   4,
                                   {.penalty = -1},
                                   "penalty is -1.000000, expected 0 to 1000000.000000"},
                    RefusedOptions{"a penalty that is not a number",
                                   4,
                                   {.penalty = std::nan("")},
                                   "penalty is nan, expected 0 to 1000000.000000"},
                    RefusedOptions{"a penalty too large",
                                   4,
                                   {.penalty = 2e6},
                                   "penalty is 2000000.000000, expected 0 to 1000000.000000"},
                    RefusedOptions{"a share above one",
                                   4,
                                   {.gh_low_share = 1.5},
                                   "gh_low_share is 1.500000, expected 0 to 1.000000"}));

TEST(Smoothed, TakesFourElevations) {
  const Series series(4, Quaternion(1, 0, 0, 0));
  EXPECT_NO_THROW(static_cast<void>(Smoothed(TableOfSeries(EvenElevations(4), series))));
}

// One row of GH turned by a known angle, in a series that stands still.
TEST(ChangesBetween, FindsTheRowThatMovedAndTheRowThatBends) {
  constexpr double kTurn_rad = 0.02;
  constexpr std::size_t kRow = 5;
  const Series still(kRowCount, Quaternion(1, 0, 0, 0));
  Series turned = still;
  turned[kRow] = Exp({kTurn_rad, 0, 0});
  const RhythmTable before = TableOfSeries(EvenElevations(), still);
  const RhythmTable after = TableOfSeries(EvenElevations(), JointSeries{still, still, turned});
  const auto [sc, ac, gh] = ChangesBetween(before, after);
  EXPECT_EQ(sc.move.value(), 0);
  EXPECT_EQ(ac.after.rotation.value(), 0);
  EXPECT_NEAR(gh.move.value(), kTurn_rad, kRounding_rad);
  EXPECT_EQ(gh.move.place().elevation, kRow);
  EXPECT_EQ(gh.before.rotation.value(), 0);
  EXPECT_NEAR(gh.after.rotation.value(), 2 * kTurn_rad, kRounding_rad);
  EXPECT_EQ(gh.after.rotation.place().elevation, kRow);
  EXPECT_NEAR(gh.after.euler.value(), 2 * kTurn_rad, kRounding_rad);
  EXPECT_EQ(gh.after.euler.place().elevation, kRow);
}

RC_GTEST_PROP(ChangesBetween, SeesNoBendInAConstantRateOverUnevenElevations, ()) {
  const std::vector<double> x = UnevenElevations();
  const Vector3 axis = *UnitVector();
  Series series;
  for (const double elevation_rad : x) series.push_back(Exp(elevation_rad * axis));
  const RhythmTable table = TableOfSeries(x, series);
  for (const JointChange& change : ChangesBetween(table, table)) {
    RC_ASSERT(change.move.value() < kRounding_rad);
    RC_ASSERT(change.after.rotation.value() < kRounding_rad);
  }
}

// From 179 to -179 degrees it is two degrees, not 358.
TEST(ChangesBetween, GoesTheShortWayRoundFromAngleToAngle) {
  Series series;
  for (std::size_t i = 0; i < kRowCount; ++i) {
    series.push_back(Exp({0, RadiansFromDegrees(170 + 2 * static_cast<double>(i)), 0}));
  }
  const RhythmTable table = TableOfSeries(EvenElevations(), series);
  for (const JointChange& change : ChangesBetween(table, table)) {
    EXPECT_LT(change.after.euler.value(), kRounding_rad);
  }
}

TEST(ChangesBetween, RefusesTablesOfDifferentElevations) {
  const Series series(kRowCount, Quaternion(1, 0, 0, 0));
  const Series shorter(4, Quaternion(1, 0, 0, 0));
  EXPECT_THROW(static_cast<void>(ChangesBetween(TableOfSeries(EvenElevations(), series),
                                                TableOfSeries(EvenElevations(4), shorter))),
               std::invalid_argument);
}

}  // namespace
}  // namespace girdle::table_smoothing_test
