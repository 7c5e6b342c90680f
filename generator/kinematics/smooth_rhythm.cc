// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/smooth_rhythm.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>

namespace girdle {
namespace {

// ---- The rule's constants, from the in-vivo sets named in the header.

// Turn of clavicle and scapula (in AC) about the parent's y, per degree that a level arm goes
// beyond the last plane: Bourne's scapula turns by 0.5 to 0.6, three times the table's last slope.
const Pair kAcross{0.34, 0.11};
// Over this many radians beyond the first or last plane the table's own slope fades out.
constexpr double kPlaneFading_rad = 5 * kRadiansPerDegree;
// The mean rate over so much elevation below the table's top goes on above it; the slope at the
// very top is bad, because subjects drop out of the last rows.
constexpr double kRateSpan_rad = 30 * kRadiansPerDegree;
// SC and AC, Y-X'-Z'' [deg], with the arm straight up (Sahara's maximum) and hanging (where the
// planes' own tangents meet on average; not the relaxed posture).
const Vector3 kUprightSc_deg{-54, -21, 37};
const Vector3 kUprightAc_deg{63, -23, 28};
const Vector3 kHangingSc_deg{-21.5, -9.5, -2};
const Vector3 kHangingAc_deg{55, -5, -6};

Quaternion FromDegrees(const Vector3& angles_deg) {
  return QuaternionFromEuler(EulerSequence::kYXZ, angles_deg * kRadiansPerDegree);
}

QuaternionOf<Pair> Paired(const Quaternion& a, const Quaternion& b) {
  return {{a.w, b.w}, {a.x, b.x}, {a.y, b.y}, {a.z, b.z}};
}

Quaternion Single(const QuaternionOf<Pair>& q, std::size_t i) {
  return {q.w[i], q.x[i], q.y[i], q.z[i]};
}

// The posture at one end of the elevations, with the signs of the means.
QuaternionOf<Pair> EndPosture(const Vector3& sc_deg, const Vector3& ac_deg,
                              const QuaternionOf<Pair>& mean) {
  return Paired(AlignedWith(FromDegrees(sc_deg), Single(mean, 0)),
                AlignedWith(FromDegrees(ac_deg), Single(mean, 1)));
}

// Rotation at which the logarithms of the others sum to zero.
Quaternion MeanRotation(const std::vector<Quaternion>& rotations) {
  Quaternion mean = rotations.front();
  constexpr int kMostRounds = 50;
  constexpr double kConverged_rad = 1e-15;
  for (int round = 0; round < kMostRounds; ++round) {
    Vector3 sum{0, 0, 0};
    for (const Quaternion& q : rotations) {
      sum += Log(q * glm::conjugate(mean));
    }
    const Vector3 step = sum / static_cast<double>(rotations.size());
    mean = glm::normalize(Exp(step) * mean);
    if (glm::length(step) < kConverged_rad) {
      break;
    }
  }
  return mean;
}

std::array<Quaternion, kJointCount> RotationsAt(const RhythmTable& table, std::size_t elevation,
                                                std::size_t plane) {
  const ShoulderPose pose = PoseFromAngles(table.position(plane, elevation).angles_rad);
  return {pose.q_TC, pose.q_CS, pose.q_SH};
}

// log(q mean^-1); throws near half a turn, where it has no one value.
Vector3 FromMean(const Quaternion& q, const Quaternion& mean, std::size_t joint) {
  constexpr double kFarthest_rad = 170 * kRadiansPerDegree;
  const Vector3 u = Log(q * glm::conjugate(mean));
  if (glm::length(u) > kFarthest_rad) {
    throw std::invalid_argument(
        std::string(kJointNames[joint]) + " is " +
        std::to_string(DegreesFromRadians(glm::length(u))) +
        " deg from its mean over the table, at most 170 can be interpolated smoothly. Check the "
        "signs and the sequence of the table's angles");
  }
  return u;
}

SplineAxis Axis(const std::vector<double>& knots, std::size_t fewest, const char* name) {
  if (knots.size() < fewest) {
    throw std::invalid_argument("the table has " + std::to_string(knots.size()) + " " + name +
                                ", the smooth interpolation needs at least " +
                                std::to_string(fewest) +
                                ". Add some, or choose the interpolation squad or slerp");
  }
  return SplineAxis(knots);
}

// tau of every position, elevation by elevation in each plane, without leaps of a whole turn.
std::vector<double> TurnsOf(const RhythmTable& table) {
  const std::size_t elevations = table.elevations_rad().size();
  std::vector<double> turns_rad(table.planes_rad().size() * elevations);
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t i = 0; i < elevations; ++i) {
      const Quaternion q_TH = PoseFromAngles(table.position(plane, i).angles_rad).q_TH();
      double turn_rad = 2 * std::atan2(q_TH.y, q_TH.w);
      if (plane > 0 || i > 0) {
        const double neighbour_rad =
            i > 0 ? turns_rad[plane * elevations + i - 1] : turns_rad[(plane - 1) * elevations];
        turn_rad = neighbour_rad + std::remainder(turn_rad - neighbour_rad, 2 * kPi);
      } else {
        turn_rad = std::remainder(turn_rad, 2 * kPi);
      }
      turns_rad[plane * elevations + i] = turn_rad;
    }
  }
  return turns_rad;
}

// The arguments as scalars of type T: numbers, or the variables of jets.
template <typename T>
struct Variables {
  T elevation_rad;
  T plane_rad;
};
template <typename T>
Variables<T> VariablesAt(double elevation_rad, double plane_rad) noexcept {
  Variables<T> variables{T(elevation_rad), T(plane_rad)};
  if constexpr (!std::is_same_v<T, double>) {
    variables.elevation_rad.part[kByElevation] = 1;
    variables.plane_rad.part[kByPlane] = 1;
  }
  return variables;
}

// The surfaces at the point itself, by the quickest way.
template <typename T, typename L, std::size_t K>
GIRDLE_INLINE auto AtPoint(const SurfaceSpline<L, K>& surface,
                           const SurfaceGrid::Place& place) noexcept {
  if constexpr (std::is_same_v<T, double>) {
    return surface.At(place);
  } else {
    return surface.template JetsAt < T::kParts == 3 ? 1 : 2 > (place);
  }
}

template <typename T>
GIRDLE_INLINE QuaternionOf<T> FromMeanBy(const VectorOf<T>& u,
                                         const QuaternionOf<Pair>& mean) noexcept {
  return ExpOf(u) * mean;
}

// 3 s^2 - 2 s^3, from 0 to 1 with no slope at the ends; s - 2 s^2 + s^3, slope 1 at 0 only.
template <typename T>
T Step(const T& s) noexcept {
  return s * s * (T(3.0) - 2.0 * s);
}
template <typename T>
T Start(const T& s) noexcept {
  const T left = T(1.0) - s;
  return s * left * left;
}

}  // namespace

SmoothRhythm::Mean SmoothRhythm::MeanOf(const RhythmTable& table) {
  std::array<std::vector<Quaternion>, kJointCount> rotations;
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t i = 0; i < table.elevations_rad().size(); ++i) {
      const auto joints = RotationsAt(table, i, plane);
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        rotations[joint].push_back(joints[joint]);
      }
    }
  }
  const Quaternion q_SH = MeanRotation(rotations[2]);
  return {Paired(MeanRotation(rotations[0]), MeanRotation(rotations[1])),
          {q_SH.w, q_SH.x, q_SH.y, q_SH.z}};
}

SmoothRhythm::SmoothRhythm(const RhythmTable& table)
    : edges_{table.elevations_rad().front(), table.elevations_rad().back(),
             table.planes_rad().front(), table.planes_rad().back()},
      grid_(Axis(table.elevations_rad(), kFewestElevations, "elevations"),
            Axis(table.planes_rad(), kFewestPlanes, "planes")),
      mean_(MeanOf(table)),
      girdle_(grid_,
              [&](std::size_t i, std::size_t plane) {
                const auto joints = RotationsAt(table, i, plane);
                const Vector3 sc = FromMean(joints[0], Single(mean_.q_TC_CS, 0), 0);
                const Vector3 ac = FromMean(joints[1], Single(mean_.q_TC_CS, 1), 1);
                return VectorOf<Pair>{Pair(sc.x, ac.x), Pair(sc.y, ac.y), Pair(sc.z, ac.z)};
              }),
      turn_(grid_,
            [turns = TurnsOf(table), count = table.elevations_rad().size()](std::size_t i,
                                                                            std::size_t plane) {
              return std::array<double, 1>{turns[plane * count + i]};
            }),
      glenohumeral_(grid_,
                    [&](std::size_t i, std::size_t plane) {
                      const Vector3 gh =
                          FromMean(RotationsAt(table, i, plane)[2],
                                   {mean_.q_SH.w, mean_.q_SH.x, mean_.q_SH.y, mean_.q_SH.z}, 2);
                      return std::array{Pair(gh.x, gh.y), Pair(gh.z, 0)};
                    }),
      hanging_(EndPosture(kHangingSc_deg, kHangingAc_deg, mean_.q_TC_CS)),
      upright_(EndPosture(kUprightSc_deg, kUprightAc_deg, mean_.q_TC_CS)) {
  for (const double plane_rad : table.planes_rad()) {
    hanging_turn_rad_ += turn_.At(grid_.PlaceOf(edges_.lowest_rad, plane_rad))[0] /
                         static_cast<double>(table.planes_rad().size());
  }
}

void SmoothRhythm::CheckWholeRange(const RhythmTable& table) const {
  constexpr double kFarthest_rad = kPi / 2;
  for (const double plane_rad : table.planes_rad()) {
    const auto check = [&](double elevation_rad, const QuaternionOf<Pair>& posture) {
      const QuaternionOf<Pair> q = InTable<double>(elevation_rad, plane_rad).q_TC_CS;
      for (std::size_t joint = 0; joint < 2; ++joint) {
        const double angle_rad = AngleBetween(Single(q, joint), Single(posture, joint));
        if (angle_rad > kFarthest_rad) {
          throw std::invalid_argument(
              std::string(kJointNames[joint]) + " at plane " +
              std::to_string(DegreesFromRadians(plane_rad)) + ", elevation " +
              std::to_string(DegreesFromRadians(elevation_rad)) + " deg is " +
              std::to_string(DegreesFromRadians(angle_rad)) +
              " deg from where the arm hangs or points up, too far to go on from the table. "
              "Choose the range clamp");
        }
      }
    };
    check(edges_.lowest_rad, hanging_);
    check(edges_.highest_rad, upright_);
  }
}

template <typename T>
GirdleOf<T> SmoothRhythm::InTable(const T& elevation_rad, const T& plane_rad) const noexcept {
  return {FromMeanBy<PairOf<T>>(Evaluate(girdle_, grid_, elevation_rad, plane_rad), mean_.q_TC_CS),
          Evaluate(turn_, grid_, elevation_rad, plane_rad)[0]};
}

// Beyond the first or last plane e, x = psi - e, w = dq/dpsi at the edge:
//   g = sign(x) L (1 - exp(-|x|/L))
//   q = Ry(k sin(theta) (x - g)) q(theta, e) exp(w g)              k = 0 below the first plane
//   tau = tau(theta, e) + dtau/dpsi g + sin(min(theta, 90)) (x - g)
template <typename T>
GirdleOf<T> SmoothRhythm::AcrossPlanes(const T& elevation_rad, const T& plane_rad) const noexcept {
  const double psi = ValueOf(plane_rad);
  const bool above = psi > edges_.last_plane_rad;
  if (!above && psi >= edges_.first_plane_rad) {
    return InTable(elevation_rad, plane_rad);
  }
  const double edge_rad = above ? edges_.last_plane_rad : edges_.first_plane_rad;
  const double sign = above ? 1 : -1;
  const GirdleOf<Dual<T>> edge =
      InTable(Dual<T>(elevation_rad, T(0.0)), Dual<T>(T(edge_rad), T(1.0)));
  const T x = plane_rad - T(edge_rad);
  const T g = (sign * kPlaneFading_rad) * (T(1.0) - Exponential((-sign / kPlaneFading_rad) * x));
  const QuaternionOf<PairOf<T>> faded =
      ValueOf(edge.q_TC_CS) * ExpOf(Scaled(Both(g), BodyVelocity(edge.q_TC_CS)));
  const T sine = Sin(elevation_rad);
  const bool past_level = ValueOf(elevation_rad) > kPi / 2;
  const T turn =
      edge.turn_rad.value + edge.turn_rad.slope * g + (past_level ? T(1.0) : sine) * (x - g);
  if (!above) {
    return {faded, turn};
  }
  const PairOf<T> across = PairOf<T>(kAcross) * Both(sine * (x - g));
  return {AboutYOf(across) * faded, turn};
}

// Above the table, x = theta - theta_1, half = (180 - theta_1) / 2, w the mean rate below the top,
// w_e the slope at it, V = log(q_1^-1 Q_180):
//   x <= half:  v = w x + [x < half / 2] (w_e - w) x (1 - x / (half / 2))^2
//   x > half:   s = (x - half) / half,
//               v = half w (1 - 3 s^2 + 2 s^3) + V (3 s^2 - 2 s^3) + half w (s - 2 s^2 + s^3)
//   q = q_1 exp(v);  tau = tau_1 + [x < half / 2] dtau/dtheta x (1 - x / (half / 2))^2
template <typename T>
GirdleOf<T> SmoothRhythm::AboveTable(const T& elevation_rad, const T& plane_rad) const noexcept {
  using P = PairOf<T>;
  const double half_rad = (kPi - edges_.highest_rad) / 2;
  const double span_rad = std::min(kRateSpan_rad, edges_.highest_rad - edges_.lowest_rad);
  const GirdleOf<Dual<T>> top =
      AcrossPlanes(Dual<T>(T(edges_.highest_rad), T(1.0)), Dual<T>(plane_rad, T(0.0)));
  const QuaternionOf<P> q_1 = ValueOf(top.q_TC_CS);
  const QuaternionOf<P> below = AcrossPlanes(T(edges_.highest_rad - span_rad), plane_rad).q_TC_CS;
  const VectorOf<P> rate = Scaled(P(1 / span_rad), LogOf(Inverse(below) * q_1));
  const T x = elevation_rad - T(edges_.highest_rad);
  if (ValueOf(x) > half_rad) {
    const VectorOf<P> whole = LogOf(Inverse(q_1) * upright_);
    const T s = (1 / half_rad) * (x - T(half_rad));
    const VectorOf<P> v =
        Scaled(Both(half_rad * (T(1.0) - Step(s) + Start(s))), rate) + Scaled(Both(Step(s)), whole);
    return {q_1 * ExpOf(v), top.turn_rad.value};
  }
  VectorOf<P> v = Scaled(Both(x), rate);
  T turn = top.turn_rad.value;
  if (ValueOf(x) < half_rad / 2) {
    const T left = T(1.0) - (2 / half_rad) * x;
    const T fading = x * left * left;
    v = v + Scaled(Both(fading), BodyVelocity(top.q_TC_CS) - rate);
    turn = turn + fading * top.turn_rad.slope;
  }
  return {q_1 * ExpOf(v), turn};
}

// Below the table, s = 1 - theta / theta_0, w the slope at theta_0, V = log(q_0^-1 Q_hanging):
//   q = q_0 exp(V (3 s^2 - 2 s^3) - theta_0 w (s - 2 s^2 + s^3)), and tau likewise
template <typename T>
GirdleOf<T> SmoothRhythm::BelowTable(const T& elevation_rad, const T& plane_rad) const noexcept {
  using P = PairOf<T>;
  const GirdleOf<Dual<T>> bottom =
      AcrossPlanes(Dual<T>(T(edges_.lowest_rad), T(1.0)), Dual<T>(plane_rad, T(0.0)));
  const QuaternionOf<P> q_0 = ValueOf(bottom.q_TC_CS);
  const T s = T(1.0) - (1 / edges_.lowest_rad) * elevation_rad;
  const T step = Step(s);
  const T start = edges_.lowest_rad * Start(s);
  const VectorOf<P> whole = LogOf(Inverse(q_0) * hanging_);
  const VectorOf<P> v =
      Scaled(Both(step), whole) - Scaled(Both(start), BodyVelocity(bottom.q_TC_CS));
  const T turn_0 = bottom.turn_rad.value;
  return {q_0 * ExpOf(v),
          turn_0 + step * (T(hanging_turn_rad_) - turn_0) - start * bottom.turn_rad.slope};
}

template <typename T>
GirdleOf<T> SmoothRhythm::Girdle(double elevation_rad, double plane_rad) const noexcept {
  if (elevation_rad >= edges_.lowest_rad && elevation_rad <= edges_.highest_rad &&
      plane_rad >= edges_.first_plane_rad && plane_rad <= edges_.last_plane_rad) [[likely]] {
    const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
    return {FromMeanBy<PairOf<T>>(AtPoint<T>(girdle_, place), mean_.q_TC_CS),
            AtPoint<T>(turn_, place)[0]};
  }
  const auto [theta, psi] = VariablesAt<T>(elevation_rad, plane_rad);
  if (elevation_rad > edges_.highest_rad) {
    return AboveTable(theta, psi);
  }
  return elevation_rad < edges_.lowest_rad ? BelowTable(theta, psi) : AcrossPlanes(theta, psi);
}

template <typename T>
JointsOf<T> SmoothRhythm::Joints(double elevation_rad, double plane_rad) const noexcept {
  const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
  const auto gh = AtPoint<T>(glenohumeral_, place);
  const VectorOf<T> u_SH{Element(gh[0], 0), Element(gh[0], 1), Element(gh[1], 0)};
  return {FromMeanBy<PairOf<T>>(AtPoint<T>(girdle_, place), mean_.q_TC_CS),
          ExpOf(u_SH) * mean_.q_SH};
}

MovingRotation<Pair> SmoothRhythm::MovingGirdle(const SurfaceGrid::Place& place) const noexcept {
  const auto u = girdle_.JetsAt<1>(place);
  const auto part = [&u](JetPart i) {
    return VectorOf<Pair>{u[0].part[i], u[1].part[i], u[2].part[i]};
  };
  return MovingExp(part(kValue), part(kByElevation), part(kByPlane), mean_.q_TC_CS);
}

GirdleRates SmoothRhythm::RatesOfGirdle(double elevation_rad, double plane_rad) const noexcept {
  const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
  const Jet<double, 1> turn = turn_.JetsAt<1>(place)[0];
  return {MovingGirdle(place), turn.part[kValue], turn.part[kByElevation], turn.part[kByPlane]};
}

JointRates SmoothRhythm::RatesOfJoints(double elevation_rad, double plane_rad) const noexcept {
  const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
  const auto gh = glenohumeral_.JetsAt<1>(place);
  const auto part = [&gh](JetPart i) {
    return VectorOf<double>{gh[0].part[i][0], gh[0].part[i][1], gh[1].part[i][0]};
  };
  return {MovingGirdle(place),
          MovingExp(part(kValue), part(kByElevation), part(kByPlane), mean_.q_SH)};
}

template GirdleOf<double> SmoothRhythm::Girdle(double, double) const noexcept;
template GirdleOf<Jet<double, 1>> SmoothRhythm::Girdle(double, double) const noexcept;
template GirdleOf<Jet<double, 2>> SmoothRhythm::Girdle(double, double) const noexcept;
template JointsOf<double> SmoothRhythm::Joints(double, double) const noexcept;
template JointsOf<Jet<double, 1>> SmoothRhythm::Joints(double, double) const noexcept;
template JointsOf<Jet<double, 2>> SmoothRhythm::Joints(double, double) const noexcept;

}  // namespace girdle
