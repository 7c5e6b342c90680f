// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/shoulder_rhythm.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "kinematics/axial_zero.h"
#include "kinematics/clamped.h"
#include "kinematics/euler_angles.h"
#include "kinematics/humerus_rotation.h"
#include "kinematics/smooth_rhythm.h"
#include "kinematics/squad_rhythm.h"

namespace girdle {
namespace {

double FiniteOrZero(double value) noexcept { return std::isfinite(value) ? value : 0; }

Quaternion Plain(const QuaternionOf<double>& q) noexcept { return {q.w, q.x, q.y, q.z}; }

// Returns the part of `added_rad` that keeps an angle in its range. An angle outside its range may
// only move back.
double Bounded(double angle_rad, double added_rad, const CoordinateRange& range) noexcept {
  return std::clamp(added_rad, std::min(range.lower_rad - angle_rad, 0.0),
                    std::max(range.upper_rad - angle_rad, 0.0));
}

// Returns x if it equals its bounded value, else the bound, which does not change with the command.
template <typename T>
T BoundedTo(double bounded, const T& x) noexcept {
  return ValueOf(x) == bounded ? x : T(bounded);
}

// Returns one part of a rotation's jets.
template <typename L, int Order>
QuaternionOf<L> Part(const QuaternionOf<Jet<L, Order>>& q, JetPart part) noexcept {
  return {q.w.part[part], q.x.part[part], q.y.part[part], q.z.part[part]};
}

template <typename L>
VectorOf<L> TwiceVector(const QuaternionOf<L>& q) noexcept {
  return {2.0 * q.x, 2.0 * q.y, 2.0 * q.z};
}

Vector3 Plain(const VectorOf<double>& v) noexcept { return {v[0], v[1], v[2]}; }
Vector3 Plain(const VectorOf<Pair>& v, std::size_t i) noexcept {
  return {v[0][i], v[1][i], v[2][i]};
}

// Angular velocities of the child in the parent, parent's axes: w = 2 dq q^-1.
template <typename L>
struct Velocities {
  VectorOf<L> by_elevation;
  VectorOf<L> by_plane;
};
template <typename L, int Order>
Velocities<L> VelocitiesOf(const QuaternionOf<Jet<L, Order>>& q) noexcept {
  const QuaternionOf<L> inverse = Inverse(Part(q, kValue));
  return {TwiceVector(Part(q, kByElevation) * inverse), TwiceVector(Part(q, kByPlane) * inverse)};
}

// Derivatives of x by theta and psi become those by t and p, of which theta and psi are functions:
//   x_i = x_theta theta_i + x_psi psi_i,
//   x_ij = x_theta theta_ij + x_psi psi_ij
//          + x_thetatheta theta_i theta_j + x_thetapsi (theta_i psi_j + theta_j psi_i)
//          + x_psipsi psi_i psi_j
template <typename L, int Order>
Jet<L, Order> Chained(const Jet<L, Order>& x,
                      const ArmDirectionOf<Jet<double, Order>>& used) noexcept {
  const auto& theta = used.elevation_rad.part;
  const auto& psi = used.plane_rad.part;
  Jet<L, Order> result(x.part[kValue]);
  for (std::size_t i = kByElevation; i < result.part.size(); ++i) {
    result.part[i] = theta[i] * x.part[kByElevation] + psi[i] * x.part[kByPlane];
  }
  if constexpr (Order == 2) {
    const auto add_second = [&](JetPart ij, JetPart i, JetPart j) {
      result.part[ij] = result.part[ij] + theta[i] * theta[j] * x.part[kByElevationTwice] +
                        (theta[i] * psi[j] + theta[j] * psi[i]) * x.part[kByElevationAndPlane] +
                        psi[i] * psi[j] * x.part[kByPlaneTwice];
    };
    add_second(kByElevationTwice, kByElevation, kByElevation);
    add_second(kByElevationAndPlane, kByElevation, kByPlane);
    add_second(kByPlaneTwice, kByPlane, kByPlane);
  }
  return result;
}

template <typename T>
VectorOf<T> EulerJets(EulerSequence sequence, const QuaternionOf<T>& q_AB) noexcept {
  const QuaternionOf<T> q =
      q_AB.w.part[kValue] < 0 ? QuaternionOf<T>{-q_AB.w, -q_AB.x, -q_AB.y, -q_AB.z} : q_AB;
  return sequence == EulerSequence::kYXZ ? EulerAngles(q.w, q.y, q.x, q.z)
                                         : EulerAngles(q.w, q.x, q.z, q.y);
}

// Returns an angle plus the used part of the wanted turn. At the end of its range the angle is
// constant.
template <int Order>
Jet<double, Order> Added(const Jet<double, Order>& angle_rad, double used_rad, double wanted_rad,
                         const CoordinateRange& range) noexcept {
  constexpr double kRounding_rad = 1e-9;
  const Jet<double, Order> sum = angle_rad + Jet<double, Order>(used_rad);
  const double value_rad = sum.part[kValue];
  const bool is_at_end = std::abs(value_rad - range.lower_rad) < kRounding_rad ||
                         std::abs(value_rad - range.upper_rad) < kRounding_rad;
  return used_rad != wanted_rad && is_at_end ? Jet<double, Order>(value_rad) : sum;
}

// Returns the clavicle with its offsets: Ry(a + protraction) Rx(b - shrug) Rz(c).
template <int Order>
QuaternionOf<Jet<Pair, Order>> WithOffsetsOf(const QuaternionOf<Jet<Pair, Order>>& q_TC_CS,
                                             const ArmCommand& used, const ArmCommand& wanted,
                                             const JointRanges& ranges) noexcept {
  if (used.shrug_rad == 0 && used.protraction_rad == 0) {
    return q_TC_CS;
  }
  using T = Jet<double, Order>;
  const VectorOf<T> angles = EulerJets(EulerSequence::kYXZ, Element(q_TC_CS, 0));
  const SineAndCosine<T> x =
      SineAndCosineOf(T(0.5 * Added(angles[1], -used.shrug_rad, -wanted.shrug_rad, ranges[1])));
  const SineAndCosine<T> z = SineAndCosineOf(T(0.5 * angles[2]));
  const QuaternionOf<T> q_TC =
      AboutYOf(Added(angles[0], used.protraction_rad, wanted.protraction_rad, ranges[0])) *
      QuaternionOf<T>{x.cosine, x.sine, T(0.0), T(0.0)} *
      QuaternionOf<T>{z.cosine, T(0.0), T(0.0), z.sine};
  QuaternionOf<Jet<Pair, Order>> offset = q_TC_CS;
  const auto replace_first = [](Jet<Pair, Order>& pair, const T& first) {
    for (std::size_t i = 0; i < pair.part.size(); ++i) {
      pair.part[i] = {first.part[i], pair.part[i][1]};
    }
  };
  replace_first(offset.w, q_TC.w);
  replace_first(offset.x, q_TC.x);
  replace_first(offset.y, q_TC.y);
  replace_first(offset.z, q_TC.z);
  return offset;
}

// Returns GH with its axial turn, which changes with `axial_rad` unless GH's range limits it.
template <int Order>
QuaternionOf<Jet<double, Order>> WithAxialOf(const QuaternionOf<Jet<double, Order>>& q_SH,
                                             Jet<double, Order> axial_rad, const ArmCommand& used,
                                             const ArmCommand& wanted,
                                             const JointRanges& ranges) noexcept {
  if (used.axial_rad == wanted.axial_rad) {
    axial_rad.part[kValue] = used.axial_rad;
    return q_SH * AboutYOf(axial_rad);
  }
  const Jet<double, Order> angle_rad = EulerJets(EulerSequence::kXZY, q_SH)[2];
  return q_SH * AboutYOf(Added(angle_rad, used.axial_rad, wanted.axial_rad, ranges[kGhAxialIndex]) -
                         angle_rad);
}

// Throws if the table has planes beyond an arm's reach. The rule for the whole range continues from
// the table's planes to the planes of the reach.
void CheckPlanes(const ArmRectangle& table) {
  for (const double plane_rad : {table.first_plane_rad, table.last_plane_rad}) {
    if (plane_rad < ArmReach::kFirstPlane_rad || plane_rad > ArmReach::kLastPlane_rad) {
      const auto whole_deg = [](double limit_rad) {
        return std::to_string(std::lround(DegreesFromRadians(limit_rad)));
      };
      throw std::invalid_argument(
          "the table's plane " + std::to_string(DegreesFromRadians(plane_rad)) +
          " deg is beyond what an arm reaches, " + whole_deg(ArmReach::kFirstPlane_rad) + " to " +
          whole_deg(ArmReach::kLastPlane_rad) + " deg. Choose the range clamp");
    }
  }
}

// Returns the options with the range that they imply.
RhythmOptions WithRangeSaid(RhythmOptions options) {
  const Range range_by_default = DefaultRange(options.interpolation, options.closure);
  options.range = options.range.value_or(range_by_default);
  if (options.range == Range::kWhole && range_by_default == Range::kClamp) {
    throw std::invalid_argument(
        "the range whole needs the interpolation smooth and the closure exact: with others nothing "
        "is known outside the table. Choose the range clamp");
  }
  return options;
}

}  // namespace

Range DefaultRange(Interpolation interpolation, Closure closure) noexcept {
  return interpolation == Interpolation::kSmooth && closure == Closure::kExact ? Range::kWhole
                                                                               : Range::kClamp;
}

JointRanges ShoulderRhythm::Unbounded() noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  JointRanges ranges{};
  ranges.fill({-kInfinity, kInfinity});
  return ranges;
}

ShoulderRhythm::Interpolant ShoulderRhythm::InterpolantOf(const RhythmTable& table,
                                                          Interpolation interpolation) {
  if (interpolation == Interpolation::kSmooth) {
    return std::make_shared<const SmoothRhythm>(table);
  }
  return std::make_shared<const SquadRhythm>(table, interpolation == Interpolation::kSquad);
}

ShoulderRhythm::ShoulderRhythm(RhythmTable table, RhythmOptions options, const JointRanges& ranges)
    : table_(std::move(table)),
      options_(WithRangeSaid(options)),
      ranges_(ranges),
      measured_{table_.elevations_rad().front(), table_.elevations_rad().back(),
                table_.planes_rad().front(), table_.planes_rad().back()},
      reach_(measured_.first_plane_rad),
      domain_(measured_),
      interpolant_(InterpolantOf(table_, options_.interpolation)) {
  if (options_.range == Range::kWhole) {
    CheckPlanes(measured_);
    smooth()->CheckWholeRange(table_);
    domain_ = {0, kPi, ArmReach::kFirstPlane_rad, ArmReach::kLastPlane_rad};
  }
}

double ShoulderRhythm::DistanceOutside(double elevation_rad, double plane_rad) const noexcept {
  if (measured_.Holds(elevation_rad, plane_rad)) {
    return 0;
  }
  const double distance_rad = AngleFromRectangle(measured_, elevation_rad, plane_rad);
  return std::isnan(distance_rad) ? 0 : distance_rad;
}

double ShoulderRhythm::PlaneOnChart(double plane_rad) const noexcept {
  const double middle_rad = (domain_.first_plane_rad + domain_.last_plane_rad) / 2;
  const double from_middle_rad = plane_rad - middle_rad;
  return std::abs(from_middle_rad) <= kPi ? plane_rad
                                          : middle_rad + std::remainder(from_middle_rad, 2 * kPi);
}

template <typename T>
ArmDirectionOf<T> ShoulderRhythm::AskedDirection(
    const ArmDirectionOf<T>& direction) const noexcept {
  const double elevation_rad = Clamped(ValueOf(direction.elevation_rad), 0, kPi);
  const double plane_rad = ValueOf(direction.plane_rad);
  const double chart_rad = PlaneOnChart(plane_rad);
  // The value of this sum is that of the chart to the last bit.
  const T asked_plane_rad = std::isfinite(chart_rad)
                                ? T(T(chart_rad) + (direction.plane_rad - T(plane_rad)))
                                : T(LowestPlaneAt(elevation_rad));
  return {BoundedTo(elevation_rad, direction.elevation_rad), asked_plane_rad};
}

template <typename T>
ArmDirectionOf<T> ShoulderRhythm::AnswerTo(const ArmDirectionOf<T>& asked) const noexcept {
  const double elevation_rad = std::clamp(
      ValueOf(asked.elevation_rad), domain_.lowest_elevation_rad, domain_.highest_elevation_rad);
  const double plane_rad = ValueOf(asked.plane_rad);
  const double lowest_rad = LowestPlaneAt(elevation_rad);
  ArmDirectionOf<T> used = {BoundedTo(elevation_rad, asked.elevation_rad), asked.plane_rad};
  if (plane_rad >= lowest_rad && plane_rad <= domain_.last_plane_rad) {
    return used;
  }
  if (options_.range == Range::kWhole) {
    return reach_.AnswerTo(used);
  }
  used.plane_rad =
      BoundedTo(std::clamp(plane_rad, lowest_rad, domain_.last_plane_rad), used.plane_rad);
  return used;
}

double ShoulderRhythm::DistanceFor(const ArmCommand& command,
                                   const ArmCommand& used) const noexcept {
  return std::max(DistanceOutside(command.elevation_rad, command.plane_rad),
                  DistanceOutside(used.elevation_rad, used.plane_rad));
}

Origin ShoulderRhythm::OriginFor(const ArmCommand& command, const RhythmCell& cell) const noexcept {
  if (options_.range == Range::kWhole &&
      !measured_.Holds(command.elevation_rad, PlaneOnChart(command.plane_rad))) {
    return Origin::kModelled;
  }
  // A corner of the cell without weight has no influence on the pose.
  const std::size_t first_i = cell.elevation_index + (cell.elevation_weight == 1 ? 1 : 0);
  const std::size_t last_i = cell.elevation_index + (cell.elevation_weight == 0 ? 0 : 1);
  const std::size_t first_j = cell.plane_index + (cell.plane_weight == 1 ? 1 : 0);
  const std::size_t last_j = cell.plane_index + (cell.plane_weight == 0 ? 0 : 1);
  for (std::size_t j = first_j; j <= last_j; ++j) {
    for (std::size_t i = first_i; i <= last_i; ++i) {
      if (!table_.position(j, i).measured) {
        return Origin::kDerived;
      }
    }
  }
  return Origin::kMeasured;
}

Quaternion ShoulderRhythm::Closed(const ShoulderPose& pose, const Quaternion& q_TH) noexcept {
  return glm::conjugate(pose.q_TS()) * q_TH;
}

void ShoulderRhythm::AddOffsets(ShoulderPose& pose, ArmCommand& used) const noexcept {
  const ShoulderPose rhythm = pose;
  const Quaternion q_TH = pose.q_TH();
  const Vector3 angles_rad = EulerFromQuaternion(kJointSequences[0], pose.q_TC);
  used.protraction_rad = Bounded(angles_rad.x, used.protraction_rad, ranges_[0]);
  used.shrug_rad = -Bounded(angles_rad.y, -used.shrug_rad, ranges_[1]);
  // Returns the pose with a share of the offsets.
  const auto offset_by = [&](double share) {
    ShoulderPose moved = rhythm;
    moved.q_TC = QuaternionFromEuler(
        kJointSequences[0], angles_rad + share * Vector3(used.protraction_rad, -used.shrug_rad, 0));
    if (options_.closure == Closure::kExact) {
      moved.q_SH = Closed(moved, q_TH);
    }
    return moved;
  };
  pose = offset_by(1);
  if (KeepsGhWithin(pose, rhythm)) {
    return;
  }
  // GH, which compensates for the girdle, reaches its range first: the offsets are reduced to its
  // room.
  double possible = 0;
  double impossible = 1;
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (possible + impossible) / 2;
    (KeepsGhWithin(offset_by(middle), rhythm) ? possible : impossible) = middle;
  }
  used.protraction_rad *= possible;
  used.shrug_rad *= possible;
  pose = offset_by(1);
}

// Where GH is outside its range without offsets, it may not move farther out.
bool ShoulderRhythm::KeepsGhWithin(const ShoulderPose& pose,
                                   const ShoulderPose& rhythm) const noexcept {
  constexpr double kRounding_rad = 1e-12;
  const JointAngles angles_rad = AnglesFromPose(pose);
  const JointAngles own_rad = AnglesFromPose(rhythm);
  for (std::size_t k = 3 * (kJointCount - 1); k < kCoordinateCount; ++k) {
    if (angles_rad[k] < std::min(ranges_[k].lower_rad, own_rad[k]) - kRounding_rad ||
        angles_rad[k] > std::max(ranges_[k].upper_rad, own_rad[k]) + kRounding_rad) {
      return false;
    }
  }
  return true;
}

template <typename T>
T ShoulderRhythm::ZeroOf(AxialFrom zero, const ArmDirectionOf<T>& asked,
                         const ArmDirectionOf<T>& used, const T& tau_rad) const noexcept {
  switch (zero) {
    case AxialFrom::kIsb:
      return asked.plane_rad + CarriedTurn(asked, used);
    case AxialFrom::kSwing:
      return SwingZero(used);
    case AxialFrom::kRhythm:
      break;
  }
  return tau_rad;
}

double ShoulderRhythm::WholeTurnOf(const ShoulderPose& pose,
                                   const ArmDirectionOf<double>& used) const noexcept {
  const Quaternion q_TH = pose.q_TH();
  // With closure exact, S is that of the direction. It has a defined turn straight up as well.
  const Quaternion turn =
      options_.closure == Closure::kTable
          ? q_TH
          : glm::conjugate(Plain(HumerusRotation(used.elevation_rad, used.plane_rad, 0.0))) * q_TH;
  return std::remainder(TurnAboutY<double>({turn.w, turn.x, turn.y, turn.z}), 2 * kPi);
}

template <typename T>
T ShoulderRhythm::ShareOf(AxialFrom zero, const ArmDirectionOf<T>& asked,
                          const ArmDirectionOf<T>& used) noexcept {
  return zero == AxialFrom::kIsb ? ShareOfCarried(asked, used) : T(1.0);
}

template <typename T>
T ShoulderRhythm::AxialFromRhythm(const ArmCommand& command, const ArmDirectionOf<T>& asked,
                                  const ArmDirectionOf<T>& used,
                                  const OwnTurnOf<T>& own) const noexcept {
  if (command.axial_from == AxialFrom::kRhythm) {
    return T(command.axial_rad);
  }
  const T turn_rad =
      ZeroOf(command.axial_from, asked, used, own.tau_rad) - own.tau_rad + T(command.axial_rad);
  // All whole turns are possible. The result is the one with GH nearest to the middle of its range.
  const double value_rad = ValueOf(turn_rad);
  const double nearest_rad =
      std::remainder(own.gh_from_middle_rad + value_rad, 2 * kPi) - own.gh_from_middle_rad;
  return ShareOf(command.axial_from, asked, used) * (T(nearest_rad) + (turn_rad - T(value_rad)));
}

ShoulderRhythm::OwnTurnOf<double> ShoulderRhythm::OwnTurn(
    const ArmDirectionOf<double>& used) const noexcept {
  const ShoulderPose rhythm = RhythmPoseFor(used.elevation_rad, used.plane_rad);
  return {WholeTurnOf(rhythm, used), AnglesFromPose(rhythm)[kGhAxialIndex] - kGhAxialMiddle_rad};
}

double ShoulderRhythm::AxialFromRhythm(const ArmCommand& command,
                                       const ArmDirectionOf<double>& asked,
                                       const ArmDirectionOf<double>& used) const noexcept {
  if (command.axial_from == AxialFrom::kRhythm) {
    return command.axial_rad;
  }
  return AxialFromRhythm(command, asked, used, OwnTurn(used));
}

double ShoulderRhythm::AxialCountedFrom(AxialFrom zero, const ArmCommand& command) const noexcept {
  if (zero == command.axial_from) {
    return command.axial_rad;
  }
  const ArmCommand within = WithinRange(command);
  if (zero == AxialFrom::kRhythm) {
    return within.axial_rad;
  }
  const ArmDirectionOf<double> asked =
      AskedDirection<double>({command.elevation_rad, command.plane_rad});
  const ArmDirectionOf<double> used = {within.elevation_rad, within.plane_rad};
  const OwnTurnOf<double> own = OwnTurn(used);
  const double share = ShareOf(zero, asked, used);
  // The limit is smaller than pi, so that rounding does not move the angle to the other end.
  constexpr double kMost_rad = kPi - 1e-9;
  const double turn_rad =
      share < 1 ? Clamped(within.axial_rad / share, -kMost_rad - own.gh_from_middle_rad,
                          kMost_rad - own.gh_from_middle_rad)
                : within.axial_rad;
  return turn_rad + own.tau_rad - ZeroOf(zero, asked, used, own.tau_rad);
}

double ShoulderRhythm::AxialShare(const ArmCommand& command) const noexcept {
  const ArmDirectionOf<double> asked =
      AskedDirection<double>({command.elevation_rad, command.plane_rad});
  return ShareOf(command.axial_from, asked, AnswerTo(asked));
}

double ShoulderRhythm::AxialOf(AxialFrom zero, const ShoulderPose& pose,
                               const ArmCommand& used) const noexcept {
  const ArmDirectionOf<double> direction = {used.elevation_rad, used.plane_rad};
  const double whole_rad = WholeTurnOf(pose, direction);
  const double axial_rad =
      whole_rad - ZeroOf(zero, direction, direction, whole_rad - used.axial_rad);
  return std::remainder(axial_rad, 2 * kPi);
}

ArmCommand ShoulderRhythm::WithinRange(const ArmCommand& command) const noexcept {
  const ArmDirectionOf<double> asked =
      AskedDirection<double>({command.elevation_rad, command.plane_rad});
  const ArmDirectionOf<double> used = AnswerTo(asked);
  const double axial_rad =
      std::isfinite(command.axial_rad) ? AxialFromRhythm(command, asked, used) : 0.0;
  return {used.elevation_rad, used.plane_rad, axial_rad, FiniteOrZero(command.shrug_rad),
          FiniteOrZero(command.protraction_rad)};
}

// A turn about the humerus's own y is the last one in X-Z'-Y'', so that it adds to GH's axial
// angle.
void ShoulderRhythm::AddAxialTurn(ShoulderPose& pose, ArmCommand& used) const noexcept {
  used.axial_rad =
      Bounded(AnglesFromPose(pose)[kGhAxialIndex], used.axial_rad, ranges_[kGhAxialIndex]);
  pose.q_SH = pose.q_SH * AboutY(used.axial_rad);
}

ShoulderPose ShoulderRhythm::PoseFor(ArmCommand& used) const noexcept {
  ShoulderPose pose = RhythmPoseFor(used.elevation_rad, used.plane_rad);
  AddExtras(pose, used);
  return pose;
}

ShoulderPose ShoulderRhythm::RhythmPoseFor(double elevation_rad, double plane_rad) const noexcept {
  ShoulderPose pose;  // NOLINT(*-member-init): every member is set below
  const bool exact = options_.closure == Closure::kExact;
  double turn_rad = 0;
  const SmoothRhythm* const smooth = this->smooth();
  if (smooth != nullptr && exact) {
    const GirdleOf<double> girdle = smooth->Girdle<double>(elevation_rad, plane_rad);
    pose.q_TC = Plain(Element(girdle.q_TC_CS, 0));
    pose.q_CS = Plain(Element(girdle.q_TC_CS, 1));
    turn_rad = girdle.turn_rad;
  } else if (smooth != nullptr) {
    const JointsOf<double> joints = smooth->Joints<double>(elevation_rad, plane_rad);
    pose = {Plain(Element(joints.q_TC_CS, 0)), Plain(Element(joints.q_TC_CS, 1)),
            Plain(joints.q_SH)};
  } else {
    const SquadRhythm& squad = **std::get_if<std::shared_ptr<const SquadRhythm>>(&interpolant_);
    const JointRotations rotations = squad.RotationsIn(table_.CellAt(elevation_rad, plane_rad));
    pose = {rotations[0], rotations[1], rotations[2]};
    if (exact) {
      const Quaternion q_TH = pose.q_TH();
      turn_rad = 2 * std::atan2(q_TH.y, q_TH.w);
    }
  }
  if (exact) {
    pose.q_SH = Closed(pose, Plain(HumerusRotation(elevation_rad, plane_rad, turn_rad)));
  }
  return pose;
}

ShoulderPose ShoulderRhythm::SolvePose(const ArmCommand& command,
                                       ArmCommand* used_out) const noexcept {
  ArmCommand used = IsPlain(command) ? command : WithinRange(command);
  const ShoulderPose pose = PoseFor(used);
  if (used_out != nullptr) {
    *used_out = used;
  }
  return pose;
}

bool ShoulderRhythm::IsClamped(const ArmCommand& command, const ArmCommand& used) const noexcept {
  ArmCommand same_plane = command;
  if (command.axial_from != AxialFrom::kRhythm) {
    const ArmDirectionOf<double> asked =
        AskedDirection<double>({command.elevation_rad, command.plane_rad});
    same_plane.axial_rad =
        std::isfinite(command.axial_rad)
            ? AxialFromRhythm(command, asked, {used.elevation_rad, used.plane_rad})
            : command.axial_rad;
    same_plane.axial_from = AxialFrom::kRhythm;
  }
  const bool is_hanging = command.elevation_rad == 0 && used.elevation_rad == 0;
  same_plane.plane_rad = is_hanging && std::isfinite(command.plane_rad)
                             ? used.plane_rad
                             : PlaneOnChart(command.plane_rad);
  return !(used == same_plane);
}

ShoulderSolution ShoulderRhythm::Solve(const ArmCommand& command) const noexcept {
  ShoulderSolution solution;  // NOLINT(*-member-init): every member is set below
  solution.used = WithinRange(command);
  solution.pose = PoseFor(solution.used);
  solution.clamped = IsClamped(command, solution.used);
  solution.cell = table_.CellAt(solution.used.elevation_rad, solution.used.plane_rad);
  solution.distance_rad = DistanceFor(command, solution.used);
  solution.origin = OriginFor(command, solution.cell);
  return solution;
}

// Returns the joints' rotations as functions of the commanded elevation and plane.
template <int Order>
struct ShoulderRhythm::Jets {
  QuaternionOf<Jet<Pair, Order>> q_TC_CS;
  QuaternionOf<Jet<double, Order>> q_SH;
};

template <int Order>
ShoulderRhythm::Jets<Order> ShoulderRhythm::JetsFor(const ArmCommand& command) const noexcept {
  using Scalar = Jet<double, Order>;
  ArmDirectionOf<Scalar> direction = {Scalar(command.elevation_rad), Scalar(command.plane_rad)};
  direction.elevation_rad.part[kByElevation] = 1;
  direction.plane_rad.part[kByPlane] = 1;
  const ArmDirectionOf<Scalar> asked = AskedDirection(direction);
  const ArmDirectionOf<Scalar> answer = AnswerTo(asked);
  const double elevation_rad = ValueOf(answer.elevation_rad);
  const double plane_rad = ValueOf(answer.plane_rad);
  ArmCommand used = command;
  ArmCommand wanted = command;
  if (command.axial_rad != 0 || command.shrug_rad != 0 || command.protraction_rad != 0 ||
      command.axial_from != AxialFrom::kRhythm) {
    wanted = WithinRange(command);
    used = Solve(command).used;
  }
  Jets<Order> jets;
  Scalar tau_rad;
  // Derivatives by the elevation and plane used become those by the commanded ones by the chain
  // rule.
  if (options_.closure == Closure::kExact) {
    const GirdleOf<Scalar> girdle = smooth()->Girdle<Scalar>(elevation_rad, plane_rad);
    jets.q_TC_CS = WithOffsetsOf(girdle.q_TC_CS, used, wanted, ranges_);
    Scalar theta(elevation_rad);
    Scalar psi(plane_rad);
    theta.part[kByElevation] = 1;
    psi.part[kByPlane] = 1;
    jets.q_SH = Inverse(Element(jets.q_TC_CS, 0) * Element(jets.q_TC_CS, 1)) *
                HumerusRotation(theta, psi, girdle.turn_rad);
    tau_rad = girdle.turn_rad;
  } else {
    const JointsOf<Scalar> joints = smooth()->Joints<Scalar>(elevation_rad, plane_rad);
    jets.q_TC_CS = WithOffsetsOf(joints.q_TC_CS, used, wanted, ranges_);
    jets.q_SH = joints.q_SH;
    tau_rad = TurnAboutY(Element(joints.q_TC_CS, 0) * Element(joints.q_TC_CS, 1) * joints.q_SH);
  }
  if (elevation_rad != command.elevation_rad || plane_rad != command.plane_rad) {
    const auto chain = [&answer](auto& q) {
      for (auto* component : {&q.w, &q.x, &q.y, &q.z}) {
        *component = Chained(*component, answer);
      }
    };
    chain(jets.q_TC_CS);
    chain(jets.q_SH);
    tau_rad = Chained(tau_rad, answer);
  }
  if (command.axial_from != AxialFrom::kRhythm && std::isfinite(command.axial_rad)) {
    const OwnTurnOf<Scalar> own = {tau_rad, OwnTurn({elevation_rad, plane_rad}).gh_from_middle_rad};
    jets.q_SH =
        WithAxialOf(jets.q_SH, AxialFromRhythm(command, asked, answer, own), used, wanted, ranges_);
  } else if (used.axial_rad != 0) {
    jets.q_SH = WithAxialOf(jets.q_SH, Scalar(used.axial_rad), used, wanted, ranges_);
  }
  return jets;
}

// With closure exact, d is the direction of the arm, and n = (-cos psi, 0, sin psi) is the axis
// about which the arm is raised. The rotation q_TH = S Ry(tau) of humerus_rotation.h has the
// angular velocities
//   w_TH = n + dtau/dtheta (-d) with theta,   w_TH = y + (dtau/dpsi - 1) (-d) with psi,
// and w_SH = q_TS^-1 (w_TH - w_TS), w_TS = w_TC + q_TC w_CS.
ShoulderRates ShoulderRhythm::PlainRates(double elevation_rad, double plane_rad) const noexcept {
  ShoulderRates rates;  // NOLINT(*-member-init): every member is set below
  const auto set_girdle = [&rates](const MovingRotation<Pair>& girdle) {
    rates.pose.q_TC = Plain(Element(girdle.q, 0));
    rates.pose.q_CS = Plain(Element(girdle.q, 1));
    rates.joints[0] = {Plain(girdle.w_1, 0), Plain(girdle.w_2, 0)};
    rates.joints[1] = {Plain(girdle.w_1, 1), Plain(girdle.w_2, 1)};
  };
  if (options_.closure == Closure::kTable) {
    const JointRates joints = smooth()->RatesOfJoints(elevation_rad, plane_rad);
    set_girdle(joints.q_TC_CS);
    rates.pose.q_SH = Plain(joints.q_SH.q);
    rates.joints[2] = {Plain(joints.q_SH.w_1), Plain(joints.q_SH.w_2)};
    return rates;
  }
  const GirdleRates girdle = smooth()->RatesOfGirdle(elevation_rad, plane_rad);
  set_girdle(girdle.q_TC_CS);
  const Quaternion q_TS = rates.pose.q_TS();
  const Quaternion q_ST = glm::conjugate(q_TS);
  const double sine = std::sin(elevation_rad);
  const double plane_sine = std::sin(plane_rad);
  const double plane_cosine = std::cos(plane_rad);
  const Vector3 up_the_arm{-sine * plane_sine, std::cos(elevation_rad), -sine * plane_cosine};
  const Vector3 w_TH_elevation =
      Vector3(-plane_cosine, 0, plane_sine) + girdle.turn_by_elevation * up_the_arm;
  const Vector3 w_TH_plane = Vector3(0, 1, 0) + (girdle.turn_by_plane - 1) * up_the_arm;
  const auto w_SH = [&](const Vector3& w_TH, const Vector3& w_TC, const Vector3& w_CS) {
    return q_ST * (w_TH - w_TC - rates.pose.q_TC * w_CS);
  };
  rates.pose.q_SH = q_ST * Plain(HumerusRotation(elevation_rad, plane_rad, girdle.turn_rad));
  rates.joints[2] = {
      w_SH(w_TH_elevation, rates.joints[0].by_elevation, rates.joints[1].by_elevation),
      w_SH(w_TH_plane, rates.joints[0].by_plane, rates.joints[1].by_plane)};
  return rates;
}

std::optional<ShoulderRates> ShoulderRhythm::SolveRates(const ArmCommand& command) const noexcept {
  if (smooth() == nullptr) {
    return std::nullopt;
  }
  if (IsPlain(command)) {
    return PlainRates(command.elevation_rad, command.plane_rad);
  }
  const Jets<1> jets = JetsFor<1>(command);
  const QuaternionOf<Pair> q_TC_CS = Part(jets.q_TC_CS, kValue);
  const Velocities<Pair> girdle = VelocitiesOf(jets.q_TC_CS);
  const Velocities<double> gh = VelocitiesOf(jets.q_SH);
  return ShoulderRates{
      {Plain(Element(q_TC_CS, 0)), Plain(Element(q_TC_CS, 1)), Plain(Part(jets.q_SH, kValue))},
      {{{Plain(girdle.by_elevation, 0), Plain(girdle.by_plane, 0)},
        {Plain(girdle.by_elevation, 1), Plain(girdle.by_plane, 1)},
        {Plain(gh.by_elevation), Plain(gh.by_plane)}}}};
}

std::optional<AngleRates> ShoulderRhythm::SolveAngleRates(
    const ArmCommand& command) const noexcept {
  const std::optional<ShoulderRates> rates = SolveRates(command);
  if (!rates) {
    return std::nullopt;
  }
  const JointAngles angles_rad = AnglesFromPose(rates->pose);
  AngleRates result;  // NOLINT(*-member-init): filled below
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    const std::size_t first = 3 * joint;
    const Vector3 joint_rad{angles_rad[first], angles_rad[first + 1], angles_rad[first + 2]};
    const Vector3 by_elevation =
        EulerRates(kJointSequences[joint], joint_rad, rates->joints[joint].by_elevation);
    const Vector3 by_plane =
        EulerRates(kJointSequences[joint], joint_rad, rates->joints[joint].by_plane);
    for (int k = 0; k < 3; ++k) {
      result.by_elevation[first + k] = by_elevation[k];
      result.by_plane[first + k] = by_plane[k];
    }
  }
  return result;
}

// w_i is the vector part of 2 q_i q^-1. Its derivative is 2 (q_ij q^-1 + q_i q_j^-1). For i = j the
// second term is a number, so that its vector part is zero.
std::optional<ShoulderDerivatives> ShoulderRhythm::SolveDerivatives(
    const ArmCommand& command) const noexcept {
  if (smooth() == nullptr) {
    return std::nullopt;
  }
  const Jets<2> jets = JetsFor<2>(command);
  const std::array<QuaternionOf<Jet<double, 2>>, kJointCount> joints = {
      Element(jets.q_TC_CS, 0), Element(jets.q_TC_CS, 1), jets.q_SH};
  ShoulderDerivatives derivatives;  // NOLINT(*-member-init): every member is set below
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    const QuaternionOf<Jet<double, 2>>& q = joints[joint];
    const QuaternionOf<double> inverse = Inverse(Part(q, kValue));
    const Velocities<double> velocities = VelocitiesOf(q);
    derivatives.joints[joint] = {
        {Plain(velocities.by_elevation), Plain(velocities.by_plane)},
        Plain(TwiceVector(Part(q, kByElevationTwice) * inverse)),
        Plain(TwiceVector(Part(q, kByElevationAndPlane) * inverse)) +
            Plain(TwiceVector(Part(q, kByElevation) * Inverse(Part(q, kByPlane)))),
        Plain(TwiceVector(Part(q, kByPlaneTwice) * inverse))};
    const VectorOf<Jet<double, 2>> angles = EulerJets(kJointSequences[joint], q);
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const auto& part = angles[k].part;
      derivatives.angles[3 * joint + k] = {part[kByElevation], part[kByPlane],
                                           part[kByElevationTwice], part[kByElevationAndPlane],
                                           part[kByPlaneTwice]};
    }
  }
  return derivatives;
}

}  // namespace girdle
