// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/arm_reach.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <iomanip>
#include <limits>
#include <ostream>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/jet.h"
#include "kinematics/random_rotations.h"

namespace girdle::arm_reach_test {
namespace {

// A few dozen roundings of angles of some hundred degrees.
constexpr double kRounding_deg = 1e-11;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Direction = ArmDirectionOf<double>;

Direction Direction_deg(double elevation_deg, double plane_deg) {
  return {RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)};
}

// Where the elbow lies, seen from GH.
Vector3 Vector(const Direction& d) {
  return {std::sin(d.elevation_rad) * std::sin(d.plane_rad), -std::cos(d.elevation_rad),
          std::sin(d.elevation_rad) * std::cos(d.plane_rad)};
}

double Apart_deg(const Vector3& a, const Vector3& b) {
  return DegreesFromRadians(2 * std::atan2(glm::length(a - b), glm::length(a + b)));
}

// The plane within half a turn of the middle of the reach.
Direction OnChart(const Direction& d) {
  const double middle_rad = RadiansFromDegrees(20);
  return {d.elevation_rad, middle_rad + std::remainder(d.plane_rad - middle_rad, 2 * kPi)};
}

Direction DirectionOf(const Vector3& v) {
  return OnChart({std::atan2(std::hypot(v.x, v.z), -v.y), std::atan2(v.x, v.z)});
}

// The circle about the direction that no arm takes: 45 deg about an elevation of 107.5, on the far
// side of plane -30, which it touches: the sine of the angle to a plane is the product with its
// normal.
Vector3 CentreTouching(double free_plane_deg) {
  const double plane_rad = RadiansFromDegrees(free_plane_deg);
  const Vector3 normal(std::cos(plane_rad), 0, -std::sin(plane_rad));
  double near_deg = free_plane_deg;
  double far_deg = free_plane_deg - 60;
  for (int i = 0; i < 100; ++i) {
    const double middle_deg = (near_deg + far_deg) / 2;
    const Vector3 centre = Vector(Direction_deg(107.5, middle_deg));
    const bool is_outside = std::asin(-glm::dot(centre, normal)) < RadiansFromDegrees(45);
    (is_outside ? near_deg : far_deg) = middle_deg;
  }
  return Vector(Direction_deg(107.5, near_deg));
}

// Is it reached, by the words of the class comment? With room for rounding.
bool IsReached(const Direction& direction, double room_deg, double free_plane_deg = -30) {
  const Direction d = OnChart(direction);
  const double plane_deg = DegreesFromRadians(d.plane_rad);
  const double elevation_deg = DegreesFromRadians(d.elevation_rad);
  if (elevation_deg < room_deg || elevation_deg > 180 - room_deg) return true;
  if (plane_deg > 135 + room_deg || plane_deg < -95 - room_deg) return false;
  if (plane_deg >= free_plane_deg - room_deg) return true;
  if (elevation_deg <= 62.5 + room_deg) return true;
  // Between the planes: below the circle, in front of its centre.
  const Vector3 centre = CentreTouching(free_plane_deg);
  return elevation_deg < 115.5 && d.plane_rad > DirectionOf(centre).plane_rad &&
         Apart_deg(Vector(d), centre) >= 45 - room_deg;
}

// What a direction is answered by, itself where it is reached.
Direction Answer(const ArmReach& reach, const Direction& direction) {
  const Direction d = OnChart(direction);
  const bool is_reached = d.plane_rad >= reach.LowestPlaneAt(d.elevation_rad) &&
                          d.plane_rad <= ArmReach::kLastPlane_rad;
  return is_reached ? d : reach.AnswerTo(d);
}

rc::Gen<Direction> AnyDirection() {
  return rc::gen::map(UnitVector(), [](const Vector3& v) { return DirectionOf(v); });
}

rc::Gen<Direction> UnreachedDirection() {
  return rc::gen::suchThat(AnyDirection(), [](const Direction& d) { return !IsReached(d, 0); });
}

// Shown with failing samples alone.
void ShowDirection(const Direction& d) {
  RC_LOG() << std::setprecision(17) << "elevation " << DegreesFromRadians(d.elevation_rad)
           << ", plane " << DegreesFromRadians(d.plane_rad) << "\n";
}

struct LimitCase {
  double elevation_deg;
  double plane_deg;
};

void PrintTo(const LimitCase& limit, std::ostream* out) {
  *out << "elevation " << limit.elevation_deg;
}

class LowestPlaneOf : public testing::TestWithParam<LimitCase> {};

TEST_P(LowestPlaneOf, AnElevationIsTheStatedOne) {
  EXPECT_NEAR(
      DegreesFromRadians(ArmReach().LowestPlaneAt(RadiansFromDegrees(GetParam().elevation_deg))),
      GetParam().plane_deg, kRounding_deg);
}

INSTANTIATE_TEST_SUITE_P(Elevations, LowestPlaneOf,
                         testing::Values(LimitCase{0, -95}, LimitCase{30, -95},
                                         LimitCase{62.49999, -95}, LimitCase{115.5, -30},
                                         LimitCase{150, -30}, LimitCase{180, -30}));

TEST(LowestPlane, OfANanIsThatOfHanging) {
  EXPECT_EQ(ArmReach().LowestPlaneAt(kNan), ArmReach::kFirstPlane_rad);
}

RC_GTEST_PROP(LowestPlane, LiesOnTheCircleBetweenTheCorners, ()) {
  static const Vector3 kCentre = CentreTouching(-30);
  const double elevation_deg = *NumberWithin(62.51, 115);
  const double elevation_rad = RadiansFromDegrees(elevation_deg);
  const double plane_rad = ArmReach().LowestPlaneAt(elevation_rad);
  RC_ASSERT(std::abs(Apart_deg(Vector({elevation_rad, plane_rad}), kCentre) - 45) < kRounding_deg);
  RC_ASSERT(plane_rad > ArmReach::kFirstPlane_rad);
  RC_ASSERT(plane_rad < ArmReach::kFreePlane_rad);
}

// The elevation at which a condition of the elevation begins to hold, within the two given.
template <typename Condition>
double FirstElevation_deg(double from_deg, double to_deg, const Condition& holds) {
  for (int i = 0; i < 100; ++i) {
    const double middle_deg = (from_deg + to_deg) / 2;
    (holds(middle_deg) ? to_deg : from_deg) = middle_deg;
  }
  return to_deg;
}

// At 62.5, 45 below the centre, from the first plane to the centre's.
TEST(LowestPlane, JumpsToTheCirclesLowestDirection) {
  const double centre_rad = DirectionOf(CentreTouching(-30)).plane_rad;
  const auto lowest_rad = [](double elevation_deg) {
    return ArmReach().LowestPlaneAt(RadiansFromDegrees(elevation_deg));
  };
  EXPECT_EQ(lowest_rad(62.5 - 1e-9), ArmReach::kFirstPlane_rad);
  // A circle's width goes with the root of the distance from its end.
  EXPECT_NEAR(lowest_rad(62.5 + 1e-9), centre_rad, 1e-5);
  EXPECT_NEAR(DegreesFromRadians(centre_rad), -77.9, 0.05);
}

// Of a table that begins farther behind, the circle's centre is beyond the first plane, which the
// circle crosses.
TEST(LowestPlane, HasItsCornerWhereTheCircleMeetsTheFirstPlane) {
  const double free_rad = RadiansFromDegrees(-60);
  const ArmReach reach(free_rad);
  const Vector3 centre = CentreTouching(-60);
  const double corner_deg = FirstElevation_deg(30, 107.5, [&](double elevation_deg) {
    return Apart_deg(Vector(Direction_deg(elevation_deg, -95)), centre) < 45;
  });
  const auto lowest_deg = [&reach](double elevation_deg) {
    return DegreesFromRadians(reach.LowestPlaneAt(RadiansFromDegrees(elevation_deg)));
  };
  EXPECT_NEAR(lowest_deg(corner_deg - 1e-9), -95, kRounding_deg);
  EXPECT_NEAR(lowest_deg(corner_deg + 1e-9), -95, 1e-8);
  EXPECT_GT(lowest_deg(corner_deg + 0.01), -95 + 0.005);
}

RC_GTEST_PROP(LowestPlane, NeverFallsWithElevation, ()) {
  const double first_rad = RadiansFromDegrees(*NumberWithin(-100, 10));
  const ArmReach reach(first_rad);
  const double lower_rad = *NumberWithin(0, kPi);
  const double upper_rad = *NumberWithin(lower_rad, kPi);
  // At the touch, where the plane stands still, rounding shows.
  RC_ASSERT(reach.LowestPlaneAt(lower_rad) <= reach.LowestPlaneAt(upper_rad) + 1e-15);
}

// A right triangle of the centre, straight up and the point of touch: its cosines multiply.
TEST(LowestPlane, ComesToTheFreePlaneWhereTheCircleTouches) {
  const double touch_rad =
      std::acos(std::cos(RadiansFromDegrees(107.5)) / std::cos(RadiansFromDegrees(45)));
  const ArmReach reach;
  EXPECT_NEAR(DegreesFromRadians(touch_rad), 115, 0.5);
  EXPECT_NEAR(reach.LowestPlaneAt(touch_rad), ArmReach::kFreePlane_rad, 1e-15);
  // It touches: the plane is off by the square of the distance.
  EXPECT_NEAR(reach.LowestPlaneAt(touch_rad - 1e-4), ArmReach::kFreePlane_rad, 2e-8);
  EXPECT_LT(reach.LowestPlaneAt(touch_rad - 1e-4), ArmReach::kFreePlane_rad);
}

// The planes of a table are reached at every elevation.
TEST(LowestPlane, IsNeverAboveTheTablesFirst) {
  for (const double first_deg : {-95.0, -80.0, -60.0, -31.0}) {
    const ArmReach reach(RadiansFromDegrees(first_deg));
    for (const double elevation_deg : Steps(0, 180, 720)) {
      EXPECT_LE(reach.LowestPlaneAt(RadiansFromDegrees(elevation_deg)),
                RadiansFromDegrees(first_deg) + 1e-15);
      EXPECT_GE(reach.LowestPlaneAt(RadiansFromDegrees(elevation_deg)), ArmReach::kFirstPlane_rad);
    }
    EXPECT_NEAR(reach.LowestPlaneAt(kPi), RadiansFromDegrees(first_deg), 1e-15);
  }
}

RC_GTEST_PROP(AnswerTo, IsReached, ()) {
  const Direction d = *UnreachedDirection();
  ShowDirection(d);
  RC_ASSERT(IsReached(ArmReach().AnswerTo(d), 1e-9));
}

// Directions along the limit, each a few hundredths of a degree from the next.
constexpr double kLimitStep_deg = 0.02;
int LimitSteps(double length_deg) { return static_cast<int>(length_deg / kLimitStep_deg); }

std::vector<Vector3> FrontLimit() {
  std::vector<Vector3> limit;
  for (const double elevation_deg : Steps(0, 180, LimitSteps(180))) {
    limit.push_back(Vector(Direction_deg(elevation_deg, 135)));
  }
  return limit;
}

std::vector<Vector3> RearLimit() {
  std::vector<Vector3> limit;
  for (const double elevation_deg : Steps(0, 62.5, LimitSteps(62.5))) {
    limit.push_back(Vector(Direction_deg(elevation_deg, -95)));
  }
  for (const double plane_deg : Steps(-95, -77.9, LimitSteps(17.1))) {
    limit.push_back(Vector(Direction_deg(62.5, plane_deg)));
  }
  for (const double elevation_deg : Steps(115.2, 180, LimitSteps(64.8))) {
    limit.push_back(Vector(Direction_deg(elevation_deg, -30)));
  }
  // The circle turned about its centre, as far as the limit follows it.
  const Vector3 centre = CentreTouching(-30);
  const Vector3 first =
      Vector(Direction_deg(62.5, DegreesFromRadians(DirectionOf(centre).plane_rad)));
  const double touch_rad =
      std::acos(std::cos(RadiansFromDegrees(107.5)) / std::cos(RadiansFromDegrees(45)));
  for (const double turn_deg : Steps(0, 120, LimitSteps(120))) {
    const double turn_rad = RadiansFromDegrees(turn_deg);
    const Vector3 foot = std::cos(turn_rad) * first +
                         std::sin(turn_rad) * glm::cross(centre, first) +
                         (1 - std::cos(turn_rad)) * glm::dot(centre, first) * centre;
    const Direction d = DirectionOf(foot);
    if (d.elevation_rad <= touch_rad) {
      limit.push_back(foot);
    }
  }
  return limit;
}

double Nearest_deg(const std::vector<Vector3>& limit, const Vector3& v) {
  double chord = 2;
  for (const Vector3& other : limit) {
    chord = std::min(chord, glm::length(other - v));
  }
  return DegreesFromRadians(2 * std::asin(chord / 2));
}

// Which of the two sides of the limit is nearest, and how far both are.
struct Sides {
  double near_deg;
  double far_deg;
};

Sides SidesOf(const Vector3& v) {
  static const std::vector<Vector3> kFront = FrontLimit();
  static const std::vector<Vector3> kRear = RearLimit();
  const double front_deg = Nearest_deg(kFront, v);
  const double rear_deg = Nearest_deg(kRear, v);
  return {std::min(front_deg, rear_deg), std::max(front_deg, rear_deg)};
}

TEST(AnswerTo, TheLimitsOfTheseTestsAreSteppedFinely) {
  for (const std::vector<Vector3>& limit : {FrontLimit(), RearLimit()}) {
    for (const Vector3& v : limit) EXPECT_NEAR(glm::length(v), 1, 1e-14);
  }
  EXPECT_GT(RearLimit().size(), (62 + 17 + 64 + 60) / kLimitStep_deg);
}

RC_GTEST_PROP(AnswerTo, IsTheNearestWhereOneSideIsClearlyNearer, ()) {
  const Direction d = *UnreachedDirection();
  const Vector3 v = Vector(d);
  const Sides sides = SidesOf(v);
  RC_PRE(sides.near_deg <= 20 && sides.far_deg >= 1.5 * sides.near_deg);
  ShowDirection(d);
  const double distance_deg = Apart_deg(v, Vector(ArmReach().AnswerTo(d)));
  // Nothing on the limit is nearer; between steps something may be.
  RC_ASSERT(distance_deg < sides.near_deg + 1e-9);
  RC_ASSERT(distance_deg > sides.near_deg - kLimitStep_deg);
}

// More than 44 deg from the reach, by the stated formula.
RC_GTEST_PROP(AnswerTo, IsInTheMiddleFarAway, ()) {
  const double elevation_deg = *NumberWithin(0, 180);
  const double plane_deg = *NumberWithin(150, 250);
  const Direction d = OnChart(Direction_deg(elevation_deg, plane_deg));
  RC_PRE(SidesOf(Vector(d)).near_deg > 44 + kLimitStep_deg);
  const double x = std::clamp((elevation_deg - 90) / 90, 0.0, 1.0);
  const double bump = 1 - x * x * x * (10 - 15 * x + 6 * x * x);
  const Direction answer = ArmReach().AnswerTo(d);
  RC_ASSERT(std::abs(DegreesFromRadians(answer.elevation_rad) -
                     elevation_deg * (1 - (1 - std::cos(RadiansFromDegrees(65))) * bump)) <
            kRounding_deg);
  RC_ASSERT(std::abs(DegreesFromRadians(answer.plane_rad) - 20) < kRounding_deg);
}

struct AnswerCase {
  const char* name;
  Direction given;
  Direction answer;
};

void PrintTo(const AnswerCase& answered, std::ostream* out) { *out << answered.name; }

class AnswerOf : public testing::TestWithParam<AnswerCase> {};

TEST_P(AnswerOf, ADirectionIsTheStatedOne) {
  const Direction answer = ArmReach().AnswerTo(GetParam().given);
  EXPECT_NEAR(DegreesFromRadians(answer.elevation_rad),
              DegreesFromRadians(GetParam().answer.elevation_rad), 1e-10);
  EXPECT_NEAR(DegreesFromRadians(answer.plane_rad), DegreesFromRadians(GetParam().answer.plane_rad),
              1e-10);
}

// Beside a plane, the nearest direction of it: the tangent of its elevation is the one given times
// the cosine of how far beyond the plane the direction is.
Direction OnPlane_deg(double elevation_deg, double beyond_deg, double plane_deg) {
  const double theta = RadiansFromDegrees(elevation_deg);
  return {std::atan2(std::sin(theta) * std::cos(RadiansFromDegrees(beyond_deg)), std::cos(theta)),
          RadiansFromDegrees(plane_deg)};
}

// On the circle, in the middle between the centre and a direction: straight below the centre.
Direction BelowTheCentre_deg(double elevation_deg) {
  return {RadiansFromDegrees(elevation_deg), DirectionOf(CentreTouching(-30)).plane_rad};
}

INSTANTIATE_TEST_SUITE_P(
    Directions, AnswerOf,
    testing::Values(
        AnswerCase{"across the chest", Direction_deg(60, 140), OnPlane_deg(60, 5, 135)},
        AnswerCase{"across the chest, high", Direction_deg(150, 160), OnPlane_deg(150, 25, 135)},
        AnswerCase{"behind, low", Direction_deg(30, -110), OnPlane_deg(30, 15, -95)},
        AnswerCase{"behind, high", Direction_deg(150, -50), OnPlane_deg(150, 20, -30)},
        AnswerCase{"behind the centre", Direction_deg(70, -90), Direction_deg(62.5, -90)},
        AnswerCase{"below the centre", BelowTheCentre_deg(80), BelowTheCentre_deg(62.5)},
        AnswerCase{"level, opposite to the middle", Direction_deg(90, -160),
                   Direction_deg(90 * std::cos(RadiansFromDegrees(65)), 20)},
        AnswerCase{"in the wedge, low", Direction_deg(20, -160),
                   Direction_deg(20 * std::cos(RadiansFromDegrees(65)), 20)},
        AnswerCase{"straight up, from the front", Direction_deg(180, 150), Direction_deg(180, 135)},
        AnswerCase{"straight up, from behind", Direction_deg(180, -60), Direction_deg(180, -30)},
        AnswerCase{"straight up, between both", Direction_deg(180, 232.5 - 360),
                   Direction_deg(180, 52.5)}));

// Every corner: nearly there, the answer is the corner itself or next to it.
TEST(AnswerTo, GoesThroughEveryCorner) {
  const ArmReach reach;
  const double touch_deg = DegreesFromRadians(
      std::acos(std::cos(RadiansFromDegrees(107.5)) / std::cos(RadiansFromDegrees(45))));
  constexpr double kNear_deg = 1e-6;
  for (const Direction& corner :
       {Direction_deg(62.5, -95), BelowTheCentre_deg(62.5), Direction_deg(touch_deg, -30),
        Direction_deg(0, 135), Direction_deg(0, -95), Direction_deg(180, 135),
        Direction_deg(180, -30)}) {
    for (const double turn_deg : Steps(0, 360, 72)) {
      const double turn_rad = RadiansFromDegrees(turn_deg);
      const Vector3 at = Vector(corner);
      const Vector3 across(std::cos(corner.plane_rad), 0, -std::sin(corner.plane_rad));
      const Vector3 beside = glm::normalize(
          at + RadiansFromDegrees(kNear_deg) *
                   (std::cos(turn_rad) * across + std::sin(turn_rad) * glm::cross(at, across)));
      EXPECT_LT(Apart_deg(Vector(Answer(reach, DirectionOf(beside))), at), 11 * kNear_deg)
          << DegreesFromRadians(corner.elevation_rad) << " " << turn_deg;
    }
  }
}

// Beyond both limits that meet behind, their corner is nearest.
TEST(AnswerTo, IsTheCornerBehindWhereThatIsNearest) {
  const Vector3 corner = Vector(Direction_deg(62.5, -95));
  EXPECT_LT(Apart_deg(Vector(ArmReach().AnswerTo(Direction_deg(70, -100))), corner), 1e-9);
}

// Walks: how fast the answer moves along them.
struct Fastest {
  double rate = 0;
  Direction at{};
  Direction before{};

  void Add(const ArmReach& reach, const Direction& from, const Direction& to) {
    const double step_deg = Apart_deg(Vector(from), Vector(to));
    const double moved_deg = Apart_deg(Vector(Answer(reach, from)), Vector(Answer(reach, to)));
    if (!(moved_deg <= rate * step_deg)) {
      rate = moved_deg / step_deg;
      at = to;
    }
  }
};

std::ostream& operator<<(std::ostream& out, const Fastest& fastest) {
  return out << "at elevation " << DegreesFromRadians(fastest.at.elevation_rad) << ", plane "
             << DegreesFromRadians(fastest.at.plane_rad);
}

constexpr double kFastest = 11;
constexpr int kStepsAround = 3600;

class WalkOf : public testing::TestWithParam<double> {
 protected:
  // Limits that compete straight up as well, of a table that begins behind plane -30, are nearer.
  static double Allowed() { return GetParam() < -30 ? 17 : kFastest; }
};

TEST_P(WalkOf, EveryElevationIsNeverFast) {
  const ArmReach reach(RadiansFromDegrees(GetParam()));
  Fastest fastest;
  std::vector<double> elevations_deg = Steps(0.5, 179.5, 358);
  for (const double near_deg : {1e-6, 1e-3, 0.1}) {
    elevations_deg.push_back(near_deg);
    elevations_deg.push_back(180 - near_deg);
  }
  for (const double elevation_deg : elevations_deg) {
    for (int i = 0; i < kStepsAround; ++i) {
      fastest.Add(reach, Direction_deg(elevation_deg, 360.0 * i / kStepsAround),
                  Direction_deg(elevation_deg, 360.0 * (i + 1) / kStepsAround));
    }
  }
  EXPECT_LT(fastest.rate, Allowed()) << fastest;
  EXPECT_GT(fastest.rate, 1) << "no walk leaves the reach";
}

TEST_P(WalkOf, EveryPlaneIsNeverFast) {
  const ArmReach reach(RadiansFromDegrees(GetParam()));
  Fastest fastest;
  for (const double plane_deg : Steps(0, 180, 360)) {
    for (int i = 0; i < kStepsAround; ++i) {
      // Elevations beyond 180 are those of the plane opposite.
      const auto at = [plane_deg](int step) {
        return DirectionOf(Vector(Direction_deg(360.0 * step / kStepsAround, plane_deg)));
      };
      fastest.Add(reach, at(i), at(i + 1));
    }
  }
  EXPECT_LT(fastest.rate, Allowed()) << fastest;
}

TEST_P(WalkOf, GreatCirclesIsNeverFast) {
  const ArmReach reach(RadiansFromDegrees(GetParam()));
  Fastest fastest;
  // Axes spread over half the sphere by the golden angle.
  constexpr int kCircles = 200;
  for (int circle = 0; circle < kCircles; ++circle) {
    const double height = (circle + 0.5) / kCircles;
    const double turn = circle * kPi * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - height * height);
    const Vector3 axis(radius * std::cos(turn), height, radius * std::sin(turn));
    const Vector3 first = glm::normalize(glm::cross(axis, Vector3(std::sin(turn), 0.1, 0.3)));
    const Vector3 second = glm::cross(axis, first);
    const auto at = [&](int i) {
      const double angle = 2 * kPi * i / kStepsAround;
      return DirectionOf(std::cos(angle) * first + std::sin(angle) * second);
    };
    for (int i = 0; i < kStepsAround; ++i) fastest.Add(reach, at(i), at(i + 1));
  }
  EXPECT_LT(fastest.rate, Allowed()) << fastest;
}

INSTANTIATE_TEST_SUITE_P(FirstPlanes, WalkOf, testing::Values(0.0, -45.0, -60.0, -95.0));

// Nothing is lost between steps: over every border of the rule, however narrow.
RC_GTEST_PROP(AnswerTo, IsContinuous, ()) {
  const Vector3 v = *UnitVector();
  const double turn_rad = *NumberWithin(-kPi, kPi);
  const Vector3 across =
      glm::normalize(glm::cross(v, std::abs(v.y) < 0.9 ? Vector3(0, 1, 0) : Vector3(1, 0, 0)));
  const Vector3 along = std::cos(turn_rad) * across + std::sin(turn_rad) * glm::cross(v, across);
  constexpr double kStep_rad = 1e-6;
  const Direction from = DirectionOf(v);
  ShowDirection(from);
  Fastest fastest;
  fastest.Add(ArmReach(), from, DirectionOf(glm::normalize(v + kStep_rad * along)));
  RC_ASSERT(fastest.rate < kFastest);
}

TEST(AnswerTo, IsTheSameOnBothSidesOfTheChartsCut) {
  const ArmReach reach;
  for (const double elevation_deg : Steps(0, 180, 360)) {
    const Direction a = reach.AnswerTo(Direction_deg(elevation_deg, 200));
    const Direction b = reach.AnswerTo(Direction_deg(elevation_deg, -160));
    EXPECT_NEAR(a.elevation_rad, b.elevation_rad, 1e-12) << elevation_deg;
    EXPECT_NEAR(a.plane_rad, b.plane_rad, 1e-12) << elevation_deg;
  }
}

TEST(AnswerTo, HangingHangs) {
  for (const double plane_deg : Steps(-160, 200, 720)) {
    EXPECT_NEAR(ArmReach().AnswerTo(Direction_deg(0, plane_deg)).elevation_rad, 0, 1e-15);
  }
}

// The derivatives of jets, held against differences of the value and of the first derivatives.
template <int Order>
ArmDirectionOf<Jet<double, Order>> JetsAt(const Direction& d) {
  ArmDirectionOf<Jet<double, Order>> jets = {Jet<double, Order>(d.elevation_rad),
                                             Jet<double, Order>(d.plane_rad)};
  jets.elevation_rad.part[kByElevation] = 1;
  jets.plane_rad.part[kByPlane] = 1;
  return ArmReach().AnswerTo(jets);
}

// The five numbers at the parts of the elevation and of the plane that a jet of order 1 has.
std::array<double, 6> FirstParts(const Direction& d) {
  const auto jets = JetsAt<1>(d);
  std::array<double, 6> parts{};
  for (std::size_t i = 0; i < 3; ++i) {
    parts.at(i) = jets.elevation_rad.part.at(i);
    parts.at(3 + i) = jets.plane_rad.part.at(i);
  }
  return parts;
}

std::array<double, 6> CentralDifferences(const Direction& d, bool is_plane, double step_rad) {
  Direction before = d;
  Direction after = d;
  (is_plane ? before.plane_rad : before.elevation_rad) -= step_rad;
  (is_plane ? after.plane_rad : after.elevation_rad) += step_rad;
  std::array<double, 6> difference = FirstParts(after);
  const std::array<double, 6> subtracted = FirstParts(before);
  for (std::size_t i = 0; i < difference.size(); ++i) {
    difference.at(i) = (difference.at(i) - subtracted.at(i)) / (2 * step_rad);
  }
  return difference;
}

double LargestApart(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double apart = std::abs(a.at(i) - b.at(i)) / (1 + std::abs(b.at(i)));
    if (!(apart <= largest)) largest = apart;
  }
  return largest;
}

TEST(AnswerTo, CarriesDerivatives) {
  constexpr double kStep_rad = 1e-5;
  // Differences over two step widths agree this well unless there is a kink between.
  constexpr double kSmooth = 1e-5;
  constexpr double kTolerance = 1e-5;
  int checked = 0;
  int kinked = 0;
  for (const double elevation_deg : Steps(1.3, 178.9, 89)) {
    for (const double plane_deg : Steps(-159.1, 199.3, 173)) {
      const Direction d = Direction_deg(elevation_deg, plane_deg);
      if (IsReached(d, 0.1)) continue;
      const auto jets = JetsAt<2>(d);
      const Direction value = ArmReach().AnswerTo(d);
      const std::array<double, 6> first = FirstParts(d);
      EXPECT_NEAR(jets.elevation_rad.part[kValue], value.elevation_rad, 1e-14);
      EXPECT_NEAR(jets.plane_rad.part[kValue], value.plane_rad, 1e-14);
      for (const bool is_plane : {false, true}) {
        const std::size_t by = is_plane ? kByPlane : kByElevation;
        const auto difference = CentralDifferences(d, is_plane, kStep_rad);
        if (!(LargestApart(CentralDifferences(d, is_plane, 2 * kStep_rad), difference) < kSmooth)) {
          ++kinked;
          continue;
        }
        const std::size_t twice = is_plane ? kByElevationAndPlane : kByElevationTwice;
        const std::array<double, 6> expected = {first.at(by),
                                                jets.elevation_rad.part.at(twice),
                                                jets.elevation_rad.part.at(twice + 1),
                                                first.at(3 + by),
                                                jets.plane_rad.part.at(twice),
                                                jets.plane_rad.part.at(twice + 1)};
        EXPECT_LT(LargestApart(expected, difference), kTolerance)
            << "elevation " << elevation_deg << ", plane " << plane_deg << ", by "
            << (is_plane ? "plane" : "elevation");
        EXPECT_NEAR(jets.elevation_rad.part.at(by), first.at(by),
                    1e-12 * (1 + std::abs(first.at(by))));
        EXPECT_NEAR(jets.plane_rad.part.at(by), first.at(3 + by),
                    1e-12 * (1 + std::abs(first.at(3 + by))));
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 10000);
  EXPECT_LT(kinked, checked / 100);
}

}  // namespace
}  // namespace girdle::arm_reach_test
