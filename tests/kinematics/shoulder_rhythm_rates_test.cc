// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How the joints turn with the command: derivatives, and what they do over knots and borders.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle::shoulder_rhythm_rates_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const ShoulderRhythm& Exact() {
  static const ShoulderRhythm kRhythm(TableOf(MeasuredRows()));
  return kRhythm;
}

const ShoulderRhythm& OfTable() {
  static const ShoulderRhythm kRhythm(TableOf(MeasuredRows()),
                                      {Interpolation::kSmooth, Closure::kTable, std::nullopt});
  return kRhythm;
}

const ShoulderRhythm& With(Closure closure) {
  return closure == Closure::kExact ? Exact() : OfTable();
}

double Length(const Vector3& v) { return glm::length(v); }

// Where the rule has another form, and where an arm's reach ends [deg].
constexpr std::array kFormElevations_deg = {0.0, 15.0, 90.0, 120.0, 135.0, 150.0, 180.0};
constexpr std::array kFormPlanes_deg = {0.0, 90.0, 135.0};

// Far enough from all of them, and from the knots and the limit of an arm's reach, that
// differences do not see them.
bool StaysInOneForm(const ArmCommand& command, double margin_deg = 0.01) {
  const double elevation_deg = DegreesFromRadians(command.elevation_rad);
  const double plane_deg = DegreesFromRadians(command.plane_rad);
  const auto far_from = [margin_deg](double a_deg, double b_deg) {
    return std::abs(a_deg - b_deg) > margin_deg;
  };
  const double nearest_knot_deg = 5 * std::round(elevation_deg / 5);
  const double limit_deg = DegreesFromRadians(Exact().LowestPlaneAt(command.elevation_rad));
  return std::all_of(kFormElevations_deg.begin(), kFormElevations_deg.end(),
                     [&](double form_deg) { return far_from(elevation_deg, form_deg); }) &&
         std::all_of(kFormPlanes_deg.begin(), kFormPlanes_deg.end(),
                     [&](double form_deg) { return far_from(plane_deg, form_deg); }) &&
         far_from(elevation_deg, nearest_knot_deg) && far_from(plane_deg, limit_deg);
}

bool IsReached(const ArmCommand& command) {
  return command.plane_rad >= Exact().LowestPlaneAt(command.elevation_rad) &&
         command.plane_rad <= Exact().domain().last_plane_rad;
}

// Any elevation and plane within the range, a little below hanging and above straight up and, of
// `With(kTable)`, a little beside its table, with or without the rest.
ArmCommand AnyCommand() {
  ArmCommand command = Command_deg(*NumberWithin(-10, 190), *NumberWithin(-95, 135));
  RC_PRE(IsReached(command));
  if (*rc::gen::arbitrary<bool>()) {
    command.axial_rad = *NumberWithin(-1, 1);
    command.shrug_rad = *NumberWithin(-0.3, 0.3);
    command.protraction_rad = *NumberWithin(-0.3, 0.3);
    command.axial_from = *AnyAxialFrom();
  }
  RC_PRE(StaysInOneForm(command));
  return command;
}

ArmCommand Moved(ArmCommand command, double elevation_rad, double plane_rad) {
  command.elevation_rad += elevation_rad;
  command.plane_rad += plane_rad;
  return command;
}

// With what is added counted from every zero.
std::vector<ArmCommand> PlainAndWith(const ArmCommand& added, const ArmCommand& plain) {
  std::vector<ArmCommand> commands = {plain};
  for (const AxialFrom zero : {AxialFrom::kRhythm, AxialFrom::kIsb, AxialFrom::kSwing}) {
    commands.push_back(Moved(added, plain.elevation_rad, plain.plane_rad));
    commands.back().axial_from = zero;
  }
  return commands;
}

// Central differences over two of these are off by its square times a sixth of the third
// derivative, which is below 1e3 in the table and beside it.
constexpr double kStep_rad = 1e-5;
constexpr double kDifferenceTolerance = 1e-7;
constexpr double kSecondTolerance = 1e-6;

// Angular velocities in the parent, from poses alone.
AngularRate DifferenceRate(const ShoulderRhythm& rhythm, const ArmCommand& command,
                           std::size_t joint) {
  const auto along = [&](double elevation_rad, double plane_rad) {
    const Quaternion before =
        Joints(rhythm.SolvePose(Moved(command, -elevation_rad, -plane_rad)))[joint];
    const Quaternion after =
        Joints(rhythm.SolvePose(Moved(command, elevation_rad, plane_rad)))[joint];
    return Log(after * glm::conjugate(before)) / (2 * kStep_rad);
  };
  return {along(kStep_rad, 0), along(0, kStep_rad)};
}

rc::Gen<Closure> AnyClosure() { return rc::gen::element(Closure::kExact, Closure::kTable); }

class Smoothness : public testing::TestWithParam<Closure> {};

INSTANTIATE_TEST_SUITE_P(Closures, Smoothness, testing::Values(Closure::kExact, Closure::kTable),
                         [](const auto& tested) { return std::string(Name(tested.param)); });

// Largest difference of the product's rates from those of poses, in deg per deg. A NaN is the
// largest of all.
double RateError(const ShoulderRhythm& rhythm, const ArmCommand& command) {
  const auto rates = rhythm.SolveRates(command);
  double largest = rates ? 0 : kNan;
  for (std::size_t joint = 0; rates && joint < kJointCount; ++joint) {
    const AngularRate expected = DifferenceRate(rhythm, command, joint);
    const AngularRate& rate = rates->joints[joint];
    for (const double error : {Length(rate.by_elevation - expected.by_elevation),
                               Length(rate.by_plane - expected.by_plane)}) {
      if (!(error <= largest)) largest = error;
    }
  }
  return largest;
}

// Largest difference of the product's second derivatives from differences of its first ones.
double SecondError(const ShoulderRhythm& rhythm, const ArmCommand& command) {
  const auto derivatives = rhythm.SolveDerivatives(command);
  double largest = derivatives ? 0 : kNan;
  const auto rates_at = [&](double elevation_rad, double plane_rad) {
    return rhythm.SolveRates(Moved(command, elevation_rad, plane_rad))->joints;
  };
  const auto behind = rates_at(-kStep_rad, 0);
  const auto ahead = rates_at(kStep_rad, 0);
  const auto left = rates_at(0, -kStep_rad);
  const auto right = rates_at(0, kStep_rad);
  const auto grow = [&largest](const Vector3& derivative, const Vector3& before,
                               const Vector3& after) {
    const double error = Length(derivative - (after - before) / (2 * kStep_rad));
    if (!(error <= largest)) largest = error;
  };
  for (std::size_t k = 0; derivatives && k < kJointCount; ++k) {
    const RotationDerivatives& joint = derivatives->joints[k];
    grow(joint.by_elevation_twice, behind[k].by_elevation, ahead[k].by_elevation);
    grow(joint.by_elevation_and_plane, left[k].by_elevation, right[k].by_elevation);
    grow(joint.by_plane_twice, left[k].by_plane, right[k].by_plane);
  }
  return largest;
}

RC_GTEST_PROP(Rates, AreThoseOfDifferencesOfPoses, ()) {
  const Closure closure = *AnyClosure();
  RC_ASSERT(RateError(With(closure), AnyCommand()) < kDifferenceTolerance);
}

// All over the range, with and without the rest.
TEST_P(Smoothness, HasTheDerivativesOfDifferencesEverywhere) {
  const ArmCommand rest = Command_deg(0, 0, 30, 12, -9);
  int checked = 0;
  for (const double elevation_deg : Steps(-4.3, 184.3, 71)) {
    for (const double plane_deg : Steps(-94.7, 134.7, 61)) {
      const ArmCommand plain = Command_deg(elevation_deg, plane_deg);
      if (!StaysInOneForm(plain) || !IsReached(plain)) continue;
      for (const ArmCommand& command : PlainAndWith(rest, plain)) {
        EXPECT_LT(RateError(With(GetParam()), command), kDifferenceTolerance) << command;
        EXPECT_LT(SecondError(With(GetParam()), command), kSecondTolerance) << command;
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 3000);
}

RC_GTEST_PROP(Rates, ComeWithThePose, ()) {
  const Closure closure = *AnyClosure();
  const ArmCommand command = AnyCommand();
  const auto rates = With(closure).SolveRates(command);
  RC_ASSERT(rates.has_value());
  RC_ASSERT(Apart_rad(rates->pose, With(closure).SolvePose(command)) < 1e-13);
}

RC_GTEST_PROP(Derivatives, BeginWithTheRates, ()) {
  const Closure closure = *AnyClosure();
  const ArmCommand command = AnyCommand();
  const auto rates = With(closure).SolveRates(command);
  const auto derivatives = With(closure).SolveDerivatives(command);
  RC_ASSERT(rates.has_value() && derivatives.has_value());
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    const AngularRate& a = rates->joints[joint];
    const AngularRate& b = derivatives->joints[joint].rate;
    RC_ASSERT(Length(a.by_elevation - b.by_elevation) < 1e-12);
    RC_ASSERT(Length(a.by_plane - b.by_plane) < 1e-12);
  }
}

RC_GTEST_PROP(Derivatives, AreThoseOfDifferencesOfRates, ()) {
  const Closure closure = *AnyClosure();
  RC_ASSERT(SecondError(With(closure), AnyCommand()) < kSecondTolerance);
}

RC_GTEST_PROP(Derivatives, OfAnglesAreThoseOfDifferencesOfAngles, ()) {
  const Closure closure = *AnyClosure();
  const ArmCommand command = AnyCommand();
  const auto derivatives = With(closure).SolveDerivatives(command);
  RC_ASSERT(derivatives.has_value());
  const auto derivatives_at = [&](double elevation_rad, double plane_rad) {
    return With(closure).SolveDerivatives(Moved(command, elevation_rad, plane_rad))->angles;
  };
  const auto angles_at = [&](double elevation_rad, double plane_rad) {
    return AnglesFromPose(With(closure).SolvePose(Moved(command, elevation_rad, plane_rad)));
  };
  const auto behind = derivatives_at(-kStep_rad, 0);
  const auto ahead = derivatives_at(kStep_rad, 0);
  const auto left = derivatives_at(0, -kStep_rad);
  const auto right = derivatives_at(0, kStep_rad);
  const JointAngles angles_behind = angles_at(-kStep_rad, 0);
  const JointAngles angles_ahead = angles_at(kStep_rad, 0);
  const JointAngles angles_left = angles_at(0, -kStep_rad);
  const JointAngles angles_right = angles_at(0, kStep_rad);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const AngleDerivatives& angle = derivatives->angles[k];
    // Angles run faster beside a gimbal lock, and the faster the larger their derivatives.
    const double size = 1 + std::abs(angle.by_elevation_twice) + std::abs(angle.by_plane_twice);
    const auto near = [size](double derivative, double difference) {
      return std::abs(derivative - difference / (2 * kStep_rad)) <
             10 * kDifferenceTolerance * size * size;
    };
    const auto turned = [](double before_rad, double after_rad) {
      return std::remainder(after_rad - before_rad, 2 * kPi);
    };
    RC_ASSERT(near(angle.by_elevation, turned(angles_behind[k], angles_ahead[k])));
    RC_ASSERT(near(angle.by_plane, turned(angles_left[k], angles_right[k])));
    RC_ASSERT(near(angle.by_elevation_twice, ahead[k].by_elevation - behind[k].by_elevation));
    RC_ASSERT(near(angle.by_elevation_and_plane, right[k].by_elevation - left[k].by_elevation));
    RC_ASSERT(near(angle.by_plane_twice, right[k].by_plane - left[k].by_plane));
  }
}

// What the range of the clavicle or of the axial turn stops stays where it is.
TEST_P(Smoothness, HoldsWhereARangeBindsWhatIsAdded) {
  JointRanges ranges = ShoulderRhythm::Unbounded();
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}, kGhAxialIndex}) {
    ranges.at(k) = ShippedJointRanges().at(k);
  }
  const ShoulderRhythm rhythm(TableOf(MeasuredRows()),
                              {Interpolation::kSmooth, GetParam(), std::nullopt}, ranges);
  for (const auto& [asked, added_deg] :
       {std::pair{&ArmCommand::shrug_rad, 50.0}, std::pair{&ArmCommand::protraction_rad, 80.0},
        std::pair{&ArmCommand::protraction_rad, -80.0}, std::pair{&ArmCommand::axial_rad, 150.0},
        std::pair{&ArmCommand::axial_rad, -170.0}}) {
    ArmCommand command = Command_deg(62, 43);
    command.*asked = RadiansFromDegrees(added_deg);
    EXPECT_TRUE(rhythm.Solve(command).clamped) << command;
    EXPECT_LT(RateError(rhythm, command), kDifferenceTolerance) << command;
    EXPECT_LT(SecondError(rhythm, command), kSecondTolerance) << command;
  }
}

TEST(Rates, AreOnlyOfTheSmoothInterpolation) {
  for (const Interpolation interpolation : {Interpolation::kSquad, Interpolation::kSlerp}) {
    const ShoulderRhythm rhythm(TableOf(MeasuredRows()),
                                {interpolation, Closure::kTable, std::nullopt});
    EXPECT_FALSE(rhythm.SolveRates(Command_deg(60, 40)).has_value());
    EXPECT_FALSE(rhythm.SolveDerivatives(Command_deg(60, 40)).has_value());
  }
}

struct Clamped {
  const char* name;
  Closure closure;
  ArmCommand command;
  bool elevation;  // clamped in
  bool plane;
};

void PrintTo(const Clamped& clamped, std::ostream* out) { *out << clamped.name; }

class ClampedCommand : public testing::TestWithParam<Clamped> {};

TEST_P(ClampedCommand, DoesNotTurnTheJointsTheWayItIsClamped) {
  const Clamped& clamped = GetParam();
  const auto derivatives = With(clamped.closure).SolveDerivatives(clamped.command);
  ASSERT_TRUE(derivatives.has_value());
  for (const RotationDerivatives& joint : derivatives->joints) {
    if (clamped.elevation) {
      EXPECT_EQ(Length(joint.rate.by_elevation), 0);
      EXPECT_EQ(Length(joint.by_elevation_twice), 0);
    } else {
      EXPECT_GT(Length(joint.rate.by_elevation), 0);
    }
    if (clamped.plane) {
      EXPECT_EQ(Length(joint.rate.by_plane), 0);
      EXPECT_EQ(Length(joint.by_plane_twice), 0);
    } else {
      EXPECT_GT(Length(joint.rate.by_plane), 0);
    }
    if (clamped.elevation || clamped.plane) {
      EXPECT_EQ(Length(joint.by_elevation_and_plane), 0);
    }
  }
  for (const AngleDerivatives& angle : derivatives->angles) {
    EXPECT_EQ(angle.by_elevation == 0, clamped.elevation);
    EXPECT_EQ(angle.by_plane == 0, clamped.plane);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Commands, ClampedCommand,
    testing::Values(Clamped{"not at all", Closure::kExact, Command_deg(60, 40), false, false},
                    Clamped{"below hanging", Closure::kExact, Command_deg(-3, 40), true, false},
                    Clamped{"a plane that is no number", Closure::kExact, {1, kNan}, false, true},
                    Clamped{"above the table", Closure::kTable, Command_deg(130, 40), true, false},
                    Clamped{"below the table", Closure::kTable, Command_deg(5, 40), true, false},
                    Clamped{"beside the table", Closure::kTable, Command_deg(60, 100), false, true},
                    Clamped{"no number at all", Closure::kTable, {kNan, kNan}, true, true}));

// Beyond the reach the pose is that of the answer, and so are its rates: the differences of poses.
// The answer moves up to ten times as fast as the command and bends as much more, so that plain
// differences are too coarse: with two step widths the error is of the fourth order of the step.
class BeyondTheReach {
 public:
  explicit BeyondTheReach(const ArmCommand& command) : command_(command) {}

  // Whether nothing has a kink as far as the differences look: those of two widths agree there.
  [[nodiscard]] bool IsSmooth() const {
    constexpr double kKink = 1e-3;
    for (const bool is_plane : {false, true}) {
      const auto [once, twice] = UsedDifferences(is_plane);
      for (const auto& [a, b] : {std::pair{once.elevation_rad, twice.elevation_rad},
                                 std::pair{once.plane_rad, twice.plane_rad}}) {
        if (!(std::abs(a - b) < kKink * (1 + std::abs(a)))) return false;
      }
    }
    return true;
  }

  // Largest difference of the product's rates from those of poses, as a share of their size.
  [[nodiscard]] double RateError() const {
    const auto rates = Exact().SolveRates(command_);
    double largest = rates ? 0 : kNan;
    for (std::size_t joint = 0; rates && joint < kJointCount; ++joint) {
      const auto turned = [&](double elevation_rad, double plane_rad) {
        const Quaternion before =
            Joints(Exact().SolvePose(Moved(command_, -elevation_rad, -plane_rad)))[joint];
        const Quaternion after =
            Joints(Exact().SolvePose(Moved(command_, elevation_rad, plane_rad)))[joint];
        return Log(after * glm::conjugate(before));
      };
      Grow(largest, rates->joints[joint].by_elevation, turned(kWide_rad, 0),
           turned(2 * kWide_rad, 0));
      Grow(largest, rates->joints[joint].by_plane, turned(0, kWide_rad), turned(0, 2 * kWide_rad));
    }
    return largest;
  }

  // The same of the second derivatives from those of rates.
  [[nodiscard]] double SecondError() const {
    const auto derivatives = Exact().SolveDerivatives(command_);
    double largest = derivatives ? 0 : kNan;
    for (std::size_t k = 0; derivatives && k < kJointCount; ++k) {
      const auto changed = [&](double elevation_rad, double plane_rad, Vector3 AngularRate::*rate) {
        return Exact().SolveRates(Moved(command_, elevation_rad, plane_rad))->joints[k].*rate -
               Exact().SolveRates(Moved(command_, -elevation_rad, -plane_rad))->joints[k].*rate;
      };
      const RotationDerivatives& joint = derivatives->joints[k];
      Grow(largest, joint.by_elevation_twice, changed(kWide_rad, 0, &AngularRate::by_elevation),
           changed(2 * kWide_rad, 0, &AngularRate::by_elevation));
      Grow(largest, joint.by_elevation_and_plane, changed(0, kWide_rad, &AngularRate::by_elevation),
           changed(0, 2 * kWide_rad, &AngularRate::by_elevation));
      Grow(largest, joint.by_plane_twice, changed(0, kWide_rad, &AngularRate::by_plane),
           changed(0, 2 * kWide_rad, &AngularRate::by_plane));
    }
    return largest;
  }

 private:
  static constexpr double kWide_rad = 5e-5;

  // f'(0) = (8 (f(h) - f(-h)) - (f(2h) - f(-2h))) / (12 h)
  static void Grow(double& largest, const Vector3& derivative, const Vector3& once,
                   const Vector3& twice) {
    const Vector3 expected = (8.0 * once - twice) / (12 * kWide_rad);
    const double error = Length(derivative - expected) / (1 + Length(expected));
    if (!(error <= largest)) largest = error;
  }

  [[nodiscard]] std::pair<ArmCommand, ArmCommand> UsedDifferences(bool is_plane) const {
    const auto difference = [&](double step_rad) {
      const double elevation_rad = is_plane ? 0 : step_rad;
      const double plane_rad = is_plane ? step_rad : 0;
      const ArmCommand before = Exact().Solve(Moved(command_, -elevation_rad, -plane_rad)).used;
      const ArmCommand after = Exact().Solve(Moved(command_, elevation_rad, plane_rad)).used;
      return ArmCommand{(after.elevation_rad - before.elevation_rad) / (2 * step_rad),
                        (after.plane_rad - before.plane_rad) / (2 * step_rad)};
    };
    return {difference(kWide_rad), difference(2 * kWide_rad)};
  }

  ArmCommand command_;
};

TEST(Rates, FollowWhatAnswersADirectionThatIsNotReached) {
  constexpr double kShareTolerance = 1e-6;
  // Differences look 0.006 deg far, and the answer moves up to eleven times as far.
  constexpr double kMargin_deg = 0.1;
  const ArmCommand rest = Command_deg(0, 0, 30, 12, -9);
  int checked = 0;
  int kinked = 0;
  for (const double elevation_deg : Steps(2.3, 178.1, 48)) {
    for (const double plane_deg : Steps(-224.3, 134.3, 119)) {
      const ArmCommand plain = Command_deg(elevation_deg, plane_deg);
      const ShoulderSolution solution = Exact().Solve(plain);
      if (!solution.clamped) continue;
      // On the limit itself the form is that of within; inside it may be any.
      ArmCommand used = solution.used;
      const double lowest_rad = Exact().LowestPlaneAt(used.elevation_rad);
      if (used.plane_rad < lowest_rad + RadiansFromDegrees(kMargin_deg)) {
        used.plane_rad = lowest_rad + RadiansFromDegrees(2 * kMargin_deg);
      }
      used.plane_rad = std::min(used.plane_rad, RadiansFromDegrees(135 - 2 * kMargin_deg));
      if (!StaysInOneForm(used, kMargin_deg)) continue;
      for (const ArmCommand& command : PlainAndWith(rest, plain)) {
        const BeyondTheReach beyond(command);
        if (!beyond.IsSmooth()) {
          ++kinked;
          continue;
        }
        EXPECT_LT(beyond.RateError(), kShareTolerance) << command;
        EXPECT_LT(beyond.SecondError(), kShareTolerance) << command;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 1500);
  EXPECT_LT(kinked, checked / 50);
}

// Whole turns of the plane change no rate.
TEST(Rates, AreThoseOfThePlaneAWholeTurnBefore) {
  for (const double plane_deg : {-170.0, -100.0, -60.0, 40.0, 120.0, 150.0}) {
    for (const double elevation_deg : {33.0, 88.0, 128.0}) {
      const auto near = Exact().SolveRates(Command_deg(elevation_deg, plane_deg));
      const auto far = Exact().SolveRates(Command_deg(elevation_deg, plane_deg + 360));
      ASSERT_TRUE(near.has_value() && far.has_value());
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        const AngularRate& a = near->joints[joint];
        const AngularRate& b = far->joints[joint];
        EXPECT_LT(Length(a.by_elevation - b.by_elevation), 1e-10);
        EXPECT_LT(Length(a.by_plane - b.by_plane), 1e-10);
      }
    }
  }
}

// Jumps of the first and second derivatives, in deg per deg and deg per deg^2.
struct Jump {
  double first = 0;
  double second = 0;
};

Jump JumpBetween(const ShoulderRhythm& rhythm, const ArmCommand& before, const ArmCommand& after) {
  const auto a = rhythm.SolveDerivatives(before);
  const auto b = rhythm.SolveDerivatives(after);
  Jump jump;
  const auto grow = [](double& largest, const Vector3& x, const Vector3& y) {
    // Written so that a NaN is the largest of all.
    if (!(Length(x - y) <= largest)) largest = Length(x - y);
  };
  for (std::size_t k = 0; k < kJointCount; ++k) {
    const RotationDerivatives& x = a->joints[k];
    const RotationDerivatives& y = b->joints[k];
    grow(jump.first, x.rate.by_elevation, y.rate.by_elevation);
    grow(jump.first, x.rate.by_plane, y.rate.by_plane);
    grow(jump.second, x.by_elevation_twice, y.by_elevation_twice);
    grow(jump.second, x.by_elevation_and_plane, y.by_elevation_and_plane);
    grow(jump.second, x.by_plane_twice, y.by_plane_twice);
  }
  jump.second *= kRadiansPerDegree;
  return jump;
}

// On a line and a hair to both sides of it.
Jump JumpOver(const ShoulderRhythm& rhythm, const ArmCommand& at, double ArmCommand::*direction) {
  ArmCommand below = at;
  ArmCommand above = at;
  below.*direction = std::nextafter(at.*direction, -10);
  above.*direction = std::nextafter(at.*direction, 10);
  const Jump first = JumpBetween(rhythm, below, at);
  const Jump second = JumpBetween(rhythm, at, above);
  return {std::max(first.first, second.first), std::max(first.second, second.second)};
}

constexpr double kLargestFirstJump = 1e-9;
constexpr double kLargestSecondJump = 1e-7;

TEST_P(Smoothness, HasTwoContinuousDerivativesOverEveryElevation) {
  const ShoulderRhythm& rhythm = With(GetParam());
  const std::vector<double>& knots_rad = rhythm.table().elevations_rad();
  for (std::size_t i = 1; i + 1 < knots_rad.size(); ++i) {
    for (const double plane_deg : Steps(0.5, 89.5, 89)) {
      const ArmCommand command{knots_rad[i], RadiansFromDegrees(plane_deg)};
      const Jump jump = JumpOver(rhythm, command, &ArmCommand::elevation_rad);
      EXPECT_LT(jump.first, kLargestFirstJump) << command;
      EXPECT_LT(jump.second, kLargestSecondJump) << command;
    }
  }
}

TEST_P(Smoothness, HasTwoContinuousDerivativesOverEveryPlane) {
  const ShoulderRhythm& rhythm = With(GetParam());
  for (const double elevation_deg : Steps(15.25, 119.75, 209)) {
    const ArmCommand command{RadiansFromDegrees(elevation_deg), rhythm.table().planes_rad()[1]};
    const Jump jump = JumpOver(rhythm, command, &ArmCommand::plane_rad);
    EXPECT_LT(jump.first, kLargestFirstJump) << command;
    EXPECT_LT(jump.second, kLargestSecondJump) << command;
  }
}

// The same of a table with four planes, which has cubics in both directions and a knot to cross.
TEST_P(Smoothness, HoldsForATableWithManyUnevenPlanes) {
  std::vector<MeasuredRow> rows;
  const std::vector<MeasuredRow> measured = MeasuredRows();
  const std::array planes_deg = {0.0, 25.0, 40.0, 70.0, 90.0};
  const std::array<std::size_t, 5> sources = {0, 1, 1, 2, 2};
  for (std::size_t plane = 0; plane < planes_deg.size(); ++plane) {
    for (std::size_t i = 0; i < 22; ++i) {
      MeasuredRow row = measured[22 * sources[plane] + i];
      row.plane_deg = planes_deg[plane];
      for (double& angle_deg : row.angles_deg) {
        angle_deg += 2 * std::sin(static_cast<double>(3 * plane + i));
      }
      rows.push_back(row);
    }
  }
  const ShoulderRhythm rhythm(TableOf(rows), {Interpolation::kSmooth, GetParam(), std::nullopt});
  for (const double elevation_deg : Steps(15.25, 119.75, 50)) {
    for (std::size_t j = 1; j < 4; ++j) {
      const ArmCommand command{RadiansFromDegrees(elevation_deg), rhythm.table().planes_rad()[j]};
      const Jump jump = JumpOver(rhythm, command, &ArmCommand::plane_rad);
      EXPECT_LT(jump.first, kLargestFirstJump) << command;
      EXPECT_LT(jump.second, kLargestSecondJump) << command;
    }
  }
}

// The same without the product's derivatives: one-sided differences of poses.

// First and second one-sided derivative of a joint's way from a place, by Newton's forward
// differences over six steps.
struct OneSided {
  Vector3 first;
  Vector3 second;
};

std::array<OneSided, kJointCount> OneSidedAt(const ShoulderRhythm& rhythm, const ArmCommand& at,
                                             double ArmCommand::*direction, double step_deg) {
  const double step_rad = RadiansFromDegrees(step_deg);
  const auto here = Joints(rhythm.SolvePose(at));
  std::array<std::array<Vector3, 7>, kJointCount> ways{};
  for (std::size_t i = 1; i < 7; ++i) {
    ArmCommand command = at;
    command.*direction += static_cast<double>(i) * step_rad;
    const auto there = Joints(rhythm.SolvePose(command));
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      ways[joint][i] = Log(there[joint] * glm::conjugate(here[joint]));
    }
  }
  std::array<OneSided, kJointCount> derivatives{};
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    std::array<Vector3, 7> differences = ways[joint];
    std::array<Vector3, 7> forward{};  // of order i, at the place
    for (std::size_t order = 1; order < 7; ++order) {
      for (std::size_t i = 0; i + order < 7; ++i) {
        differences[i] = differences[i + 1] - differences[i];
      }
      forward[order] = differences[0];
    }
    // h f' = D - D^2/2 + D^3/3 - ..., h^2 f'' = D^2 - D^3 + 11/12 D^4 - 5/6 D^5 + 137/180 D^6
    for (std::size_t order = 1; order < 7; ++order) {
      const double sign = order % 2 == 1 ? 1 : -1;
      derivatives[joint].first += sign / static_cast<double>(order) * forward[order];
    }
    derivatives[joint].second = forward[2] - forward[3] + 11.0 / 12 * forward[4] -
                                5.0 / 6 * forward[5] + 137.0 / 180 * forward[6];
    derivatives[joint].first /= step_rad;
    derivatives[joint].second /= step_rad * step_rad;
  }
  return derivatives;
}

Jump DifferenceJumpOver(const ShoulderRhythm& rhythm, const ArmCommand& at,
                        double ArmCommand::*direction, double step_deg) {
  const auto before = OneSidedAt(rhythm, at, direction, -step_deg);
  const auto after = OneSidedAt(rhythm, at, direction, step_deg);
  Jump jump;
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    jump.first = std::max(jump.first, Length(after[joint].first - before[joint].first));
    jump.second = std::max(jump.second, Length(after[joint].second - before[joint].second));
  }
  jump.second *= kRadiansPerDegree;
  return jump;
}

// Steps of this size are small enough for the seventh derivative and large enough for rounding:
// first derivatives to 1e-11, second ones to 1e-8.
constexpr double kOneSidedStep_deg = 0.05;

TEST_P(Smoothness, IsSeenInOneSidedDifferencesOverEveryElevation) {
  const ShoulderRhythm& rhythm = With(GetParam());
  const std::vector<double>& knots_rad = rhythm.table().elevations_rad();
  for (std::size_t i = 1; i + 1 < knots_rad.size(); ++i) {
    for (const double plane_deg : Steps(0.5, 89.5, 20)) {
      const ArmCommand command{knots_rad[i], RadiansFromDegrees(plane_deg)};
      const Jump jump =
          DifferenceJumpOver(rhythm, command, &ArmCommand::elevation_rad, kOneSidedStep_deg);
      EXPECT_LT(jump.first, kLargestFirstJump) << command;
      EXPECT_LT(jump.second, kLargestSecondJump) << command;
    }
  }
}

TEST_P(Smoothness, IsSeenInOneSidedDifferencesOverEveryPlane) {
  const ShoulderRhythm& rhythm = With(GetParam());
  for (const double elevation_deg : Steps(15.5, 119.5, 104)) {
    const ArmCommand command{RadiansFromDegrees(elevation_deg), rhythm.table().planes_rad()[1]};
    const Jump jump =
        DifferenceJumpOver(rhythm, command, &ArmCommand::plane_rad, kOneSidedStep_deg);
    EXPECT_LT(jump.first, kLargestFirstJump) << command;
    EXPECT_LT(jump.second, kLargestSecondJump) << command;
  }
}

// Borders of the table and of the rule's forms.

constexpr double kLargestBorderJump = 1e-6;

struct Border {
  const char* name;
  double ArmCommand::*direction;
  double at_deg;
};

void PrintTo(const Border& border, std::ostream* out) { *out << border.name; }

class BorderLine : public testing::TestWithParam<Border> {
 protected:
  // Places along the line, its crossings with the others among them.
  static std::vector<ArmCommand> Places() {
    std::vector<ArmCommand> places;
    const bool is_elevation = GetParam().direction == &ArmCommand::elevation_rad;
    for (const double along_deg : is_elevation ? Steps(-30, 135, 165) : Steps(0, 180, 180)) {
      places.push_back(is_elevation ? Command_deg(GetParam().at_deg, along_deg)
                                    : Command_deg(along_deg, GetParam().at_deg));
    }
    return places;
  }
};

TEST_P(BorderLine, HasNoJumpOfTheFirstDerivative) {
  for (const ArmCommand& command : Places()) {
    const bool at_end = command.elevation_rad == 0 || command.elevation_rad >= kPi;
    if (at_end) continue;
    EXPECT_LT(JumpOver(Exact(), command, GetParam().direction).first, kLargestBorderJump)
        << command;
  }
}

TEST_P(BorderLine, HasNoJumpInOneSidedDifferences) {
  for (const ArmCommand& command : Places()) {
    const double elevation_deg = DegreesFromRadians(command.elevation_rad);
    const bool at_end = elevation_deg < 1 || elevation_deg > 179;
    if (at_end) continue;
    EXPECT_LT(DifferenceJumpOver(Exact(), command, GetParam().direction, kOneSidedStep_deg).first,
              kLargestBorderJump)
        << command;
  }
}

INSTANTIATE_TEST_SUITE_P(Lines, BorderLine,
                         testing::Values(Border{"elevation 15", &ArmCommand::elevation_rad, 15},
                                         Border{"elevation 90", &ArmCommand::elevation_rad, 90},
                                         Border{"elevation 120", &ArmCommand::elevation_rad, 120},
                                         Border{"elevation 135", &ArmCommand::elevation_rad, 135},
                                         Border{"elevation 150", &ArmCommand::elevation_rad, 150},
                                         Border{"plane 0", &ArmCommand::plane_rad, 0},
                                         Border{"plane 40", &ArmCommand::plane_rad, 40},
                                         Border{"plane 90", &ArmCommand::plane_rad, 90}));

// "The theta derivative is zero there": the girdle comes to rest at hanging and straight up.
TEST(Borders, BringTheGirdleToRestWhereThePlaneHasNoMeaning) {
  for (const double elevation_deg : {0.0, 180.0}) {
    for (const double plane_deg : Steps(-30, 135, 33)) {
      const auto rates = Exact().SolveRates(Command_deg(elevation_deg, plane_deg));
      ASSERT_TRUE(rates.has_value());
      for (std::size_t joint = 0; joint < 2; ++joint) {
        EXPECT_LT(Length(rates->joints[joint].by_elevation), 1e-12);
        EXPECT_LT(Length(rates->joints[joint].by_plane), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace girdle::shoulder_rhythm_rates_test
