// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "fits/gliding_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/NonLinearOptimization>
#include <vector>

#include "anatomy/ellipsoid.h"
#include "anatomy/posed_bones.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/worst_case.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// The weight w of the header is made from these two lengths.
constexpr double kScatter_m = 0.004;
constexpr double kRibcageDeviation_m = 0.07;
constexpr double kRibcageWeight = kScatter_m / kRibcageDeviation_m;

constexpr int kNumbers = 6;  // three of the centre, three radii
constexpr double kLargest_m = 1;

using Numbers = Eigen::Matrix<double, kNumbers, 1>;
using Slopes = Eigen::Matrix<double, 1, kNumbers>;

// Returns the ellipsoid of the solver's variables: centre [m] and logarithms of the radii.
// Logarithms keep the radii positive.
Ellipsoid EllipsoidFrom(const Eigen::VectorXd& x) {
  return {{x[0], x[1], x[2]}, {std::exp(x[3]), std::exp(x[4]), std::exp(x[5])}};
}
Eigen::VectorXd VariablesOf(const Ellipsoid& ellipsoid) {
  Eigen::VectorXd x(kNumbers);
  for (int i = 0; i < 3; ++i) {
    x[i] = ellipsoid.center_m[i];
    x[i + 3] = std::log(ellipsoid.radii_m[i]);
  }
  return x;
}

// Returns the derivatives of the distance d = n . (p - x) by centre and radii, for a point p with
// the nearest surface point x. dd/dc_i = -n_i, because the surface moves with its centre. dd/dr_i =
// -n_i (x_i - c_i) / r_i, because a longer radius stretches the surface in proportion. The shift of
// x along the surface has no effect.
Slopes SlopesOf(const SurfacePoint& nearest, const Ellipsoid& ellipsoid) {
  const Vector3 by_radii =
      -nearest.normal * (nearest.position_m - ellipsoid.center_m) / ellipsoid.radii_m;
  Slopes slopes;
  slopes << -nearest.normal.x, -nearest.normal.y, -nearest.normal.z, by_radii.x, by_radii.y,
      by_radii.z;
  return slopes;
}

// The residuals whose squares the solver minimizes, in the solver's interface.
class GlidingResiduals {
 public:
  GlidingResiduals(std::span<const Vector3> points_m, const Ellipsoid& ribcage)
      : points_m_(points_m), ribcage_(ribcage) {}

  [[nodiscard]] static int inputs() { return kNumbers; }
  [[nodiscard]] int values() const { return static_cast<int>(points_m_.size()) + kNumbers; }

  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const {
    const Ellipsoid ellipsoid = EllipsoidFrom(x);
    Eigen::Index row = 0;
    for (const Vector3& point_m : points_m_) {
      residuals[row++] = DistanceFromEllipsoid(ellipsoid, point_m);
    }
    for (int i = 0; i < 3; ++i) {
      residuals[row + i] = kRibcageWeight * (ellipsoid.center_m[i] - ribcage_.center_m[i]);
      residuals[row + 3 + i] = kRibcageWeight * (ellipsoid.radii_m[i] - ribcage_.radii_m[i]);
    }
    return 0;
  }

  // Computes the derivatives by the solver's variables.
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) const {
    const Ellipsoid ellipsoid = EllipsoidFrom(x);
    jacobian = SlopesByNumbers(ellipsoid);
    for (int i = 0; i < 3; ++i) {
      jacobian.col(i + 3) *= ellipsoid.radii_m[i];  // dr = r d(log r)
    }
    return 0;
  }

  // Returns the derivatives by centre and radii.
  [[nodiscard]] Eigen::MatrixXd SlopesByNumbers(const Ellipsoid& ellipsoid) const {
    Eigen::MatrixXd slopes(values(), kNumbers);
    Eigen::Index row = 0;
    for (const Vector3& point_m : points_m_) {
      slopes.row(row++) = SlopesOf(NearestOnEllipsoid(ellipsoid, point_m), ellipsoid);
    }
    slopes.bottomRows<kNumbers>().setZero();
    slopes.bottomRows<kNumbers>().diagonal().setConstant(kRibcageWeight);
    return slopes;
  }

 private:
  std::span<const Vector3> points_m_;
  Ellipsoid ribcage_;
};

bool IsOfBodySize(const Ellipsoid& ellipsoid) {
  for (int i = 0; i < 3; ++i) {
    // Written so that a NaN fails too.
    if (!(std::abs(ellipsoid.center_m[i]) <= kLargest_m) || !(ellipsoid.radii_m[i] <= kLargest_m)) {
      return false;
    }
  }
  return true;
}

// Returns the square roots of the diagonal of s^2 (J^T J)^-1. J includes the rows of the pull
// toward the rib cage, and s is the scatter of the points.
Ellipsoid DeviationOf(const GlidingResiduals& residuals, std::span<const Vector3> points_m,
                      const Ellipsoid& ellipsoid) {
  double square_sum = 0;
  for (const Vector3& point_m : points_m) {
    const double distance_m = DistanceFromEllipsoid(ellipsoid, point_m);
    square_sum += distance_m * distance_m;
  }
  const double variance = square_sum / static_cast<double>(points_m.size());
  const Eigen::MatrixXd slopes = residuals.SlopesByNumbers(ellipsoid);
  const Eigen::Matrix<double, kNumbers, kNumbers> normal = slopes.transpose() * slopes;
  const Numbers variances =
      variance *
      normal.ldlt().solve(Eigen::Matrix<double, kNumbers, kNumbers>::Identity()).diagonal();
  return {{std::sqrt(variances[0]), std::sqrt(variances[1]), std::sqrt(variances[2])},
          {std::sqrt(variances[3]), std::sqrt(variances[4]), std::sqrt(variances[5])}};
}

// Calls `visit(position, plane, elevation)` for every position with a measured SC and AC.
template <typename Visit>
void ForEachMeasured(const RhythmTable& table, const Visit& visit) {
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
      const RhythmPosition& position = table.position(plane, elevation);
      if (position.measured) {
        visit(position, plane, elevation);
      }
    }
  }
}

}  // namespace

EllipsoidFit FitEllipsoid(std::span<const Vector3> points_m, const Ellipsoid& ribcage) {
  if (points_m.size() < kNumbers) {
    throw std::invalid_argument("an ellipsoid needs " + std::to_string(kNumbers) +
                                " points or more, there are " + std::to_string(points_m.size()));
  }
  GlidingResiduals residuals(points_m, ribcage);
  Eigen::LevenbergMarquardt<GlidingResiduals> solver(residuals);
  // The solver goes on until rounding stops it, which takes about ten steps.
  solver.parameters.ftol = solver.parameters.xtol = 1e-14;
  Eigen::VectorXd x = VariablesOf(ribcage);
  static_cast<void>(solver.minimize(x));
  const Ellipsoid ellipsoid = EllipsoidFrom(x);
  if (!IsOfBodySize(ellipsoid)) {
    throw std::invalid_argument(
        "no ellipsoid of a thorax's size fits where TS and AI go. Check the landmarks TS, AI and "
        "PAC and the table's signs");
  }
  return {ellipsoid, DeviationOf(residuals, points_m, ellipsoid)};
}

EllipsoidFit FitGlidingEllipsoid(const Anatomy& anatomy, const RhythmTable& table) {
  constexpr std::size_t kFewest = kNumbers / kGlidingLandmarks.size();
  if (const std::size_t count = MeasuredPositionCount(table); count < kFewest) {
    throw std::invalid_argument("the table has " + std::to_string(count) +
                                " positions with measured SC and AC, an ellipsoid needs " +
                                std::to_string(kFewest) + ". Take a table with more");
  }
  std::vector<Vector3> points_m;
  ForEachMeasured(table, [&](const RhythmPosition& position, std::size_t, std::size_t) {
    const ShoulderPose pose = PoseFromAngles(position.angles_rad);
    for (const Landmark landmark : kGlidingLandmarks) {
      points_m.push_back(LandmarkInThorax_m(anatomy, pose, landmark));
    }
  });
  return FitEllipsoid(points_m, anatomy.ribcage);
}

std::array<GlidingDistance, kGlidingLandmarks.size()> MeasureGliding(const Ellipsoid& ellipsoid,
                                                                     const Anatomy& anatomy,
                                                                     const RhythmTable& table) {
  std::array<GlidingDistance, kGlidingLandmarks.size()> distances{};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    GlidingDistance& distance = distances[i];
    distance.landmark = kGlidingLandmarks[i];
    WorstCase<ArmCommand> worst;
    ForEachMeasured(
        table, [&](const RhythmPosition& position, std::size_t plane, std::size_t elevation) {
          const double distance_m = DistanceFromEllipsoid(
              ellipsoid,
              LandmarkInThorax_m(anatomy, PoseFromAngles(position.angles_rad), distance.landmark));
          worst.Add(distance_m, table.elevations_rad()[elevation], table.planes_rad()[plane]);
        });
    distance.rms_m = worst.rms();
    distance.worst_m = worst.value();
    distance.elevation_rad = worst.place().elevation_rad;
    distance.plane_rad = worst.place().plane_rad;
  }
  return distances;
}

std::size_t MeasuredPositionCount(const RhythmTable& table) noexcept {
  std::size_t count = 0;
  ForEachMeasured(table,
                  [&count](const RhythmPosition&, std::size_t, std::size_t) noexcept { ++count; });
  return count;
}

}  // namespace girdle
