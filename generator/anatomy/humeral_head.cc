// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/humeral_head.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>

#include "kinematics/isb_frames.h"
#include "kinematics/lengths.h"

namespace girdle {
namespace {

constexpr std::size_t kFewestPoints = 4;
// Gauss-Newton steps from the algebraic sphere. Points measured on a head need about five.
constexpr int kMostSteps = 50;
constexpr double kSmallestStep_m = 1e-13;

Vector3 Mean_m(const std::vector<Vector3>& points_m) {
  Vector3 sum_m{0, 0, 0};
  for (const Vector3& point_m : points_m) sum_m += point_m;
  return sum_m / static_cast<double>(points_m.size());
}

// Returns the centre of the sphere with the least sum of (|p - c|^2 - r^2)^2: the equation |p|^2 =
// 2 c p + (r^2 - |c|^2) is linear in c and in the bracket. p is relative to the mean of the points.
Vector3 AlgebraicCenter_m(const std::vector<Vector3>& points_m) {
  const Vector3 mean_m = Mean_m(points_m);
  const auto rows = static_cast<Eigen::Index>(points_m.size());
  Eigen::MatrixX4d A(rows, 4);
  Eigen::VectorXd b(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vector3 p = points_m[static_cast<std::size_t>(i)] - mean_m;
    A.row(i) << 2 * p.x, 2 * p.y, 2 * p.z, 1;
    b[i] = glm::dot(p, p);
  }
  const Eigen::VectorXd solution = A.colPivHouseholderQr().solve(b);
  return mean_m + Vector3{solution[0], solution[1], solution[2]};
}

// Returns the derivatives of r - |p - c| by c and r: directions from the centre to the points, and
// 1.
Eigen::MatrixX4d Jacobian(const std::vector<Vector3>& points_m, const Vector3& center_m) {
  Eigen::MatrixX4d J(static_cast<Eigen::Index>(points_m.size()), 4);
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const Vector3 u = glm::normalize(points_m[i] - center_m);
    J.row(static_cast<Eigen::Index>(i)) << u.x, u.y, u.z, 1;
  }
  return J;
}

}  // namespace

Vector3 EstimatedGh_m(const Vector3& pc_m, const Vector3& ac_m, const Vector3& aa_m,
                      const Vector3& ts_m, const Vector3& ai_m) noexcept {
  // ISB's z is the regression's x. ISB's x points backward in a left scapula and is -z.
  const Quaternion q_AS = ScapulaFrame(ac_m, ts_m, ai_m);
  const auto in_scapula_mm = [&](const Vector3& point_m) {
    return kMillimetersPerMeter * (glm::conjugate(q_AS) * (point_m - ac_m));
  };
  const auto distance_mm = [](const Vector3& a_m, const Vector3& b_m) {
    return kMillimetersPerMeter * glm::distance(a_m, b_m);
  };
  const Vector3 pc_S_mm = in_scapula_mm(pc_m);
  const double forward = pc_S_mm.x < 0 ? -1 : 1;
  const Vector3 pc_mm{pc_S_mm.z, pc_S_mm.y, -forward * pc_S_mm.x};
  const double ai_x_mm = in_scapula_mm(ai_m).z;
  const Vector3 gh_mm{
      18.9743 + 0.2434 * pc_mm.x + 0.2341 * ai_x_mm + 0.1590 * distance_mm(ai_m, aa_m) +
          0.0558 * pc_mm.y,
      -3.8791 - 0.1002 * distance_mm(ac_m, pc_m) + 0.1732 * pc_mm.y -
          0.3940 * distance_mm(ac_m, aa_m) + 0.1205 * ai_x_mm,
      9.2629 - 0.2403 * pc_mm.y + 1.0255 * pc_mm.z + 0.1720 * distance_mm(ts_m, pc_m)};
  return ac_m + q_AS * (Vector3{-forward * gh_mm.z, gh_mm.y, gh_mm.x} / kMillimetersPerMeter);
}

double DistanceOffPlane_m(const std::vector<Vector3>& points_m) {
  if (points_m.empty()) return 0;
  const Vector3 mean_m = Mean_m(points_m);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3& point_m : points_m) {
    const Vector3 p = point_m - mean_m;
    const Eigen::Vector3d v(p.x, p.y, p.z);
    spread += v * v.transpose();
  }
  const Eigen::Vector3d n =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  double farthest_m = 0;
  for (const Vector3& point_m : points_m) {
    farthest_m =
        std::max(farthest_m, std::abs(glm::dot(point_m - mean_m, Vector3{n[0], n[1], n[2]})));
  }
  return farthest_m;
}

double LargestDistance_m(const std::vector<Vector3>& points_m) noexcept {
  double largest_m = 0;
  for (const Vector3& a_m : points_m) {
    for (const Vector3& b_m : points_m) largest_m = std::max(largest_m, glm::distance(a_m, b_m));
  }
  return largest_m;
}

FittedSphere SphereThrough(const std::vector<Vector3>& points_m) {
  if (points_m.size() < kFewestPoints) {
    throw std::invalid_argument(std::to_string(points_m.size()) +
                                " of them tell no sphere. Give at least four");
  }
  const double off_m = DistanceOffPlane_m(points_m);
  if (off_m <= kNearlyInAPlane * LargestDistance_m(points_m)) {
    throw std::invalid_argument("lie nearly in a plane, " +
                                std::to_string(std::lround(kMillimetersPerMeter * off_m)) +
                                " mm off it, and tell no sphere. Add points off that plane, over "
                                "as much of the humeral head as can be reached");
  }
  FittedSphere sphere;
  sphere.center_m = AlgebraicCenter_m(points_m);
  const auto count = static_cast<double>(points_m.size());
  const auto distances_m = [&] {
    Eigen::VectorXd distances(static_cast<Eigen::Index>(points_m.size()));
    for (std::size_t i = 0; i < points_m.size(); ++i) {
      distances[static_cast<Eigen::Index>(i)] = glm::distance(points_m[i], sphere.center_m);
    }
    return distances;
  };
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::VectorXd d = distances_m();
    const Eigen::Vector4d change =
        Jacobian(points_m, sphere.center_m).colPivHouseholderQr().solve(d);
    // d = u . change + r: the part of d without r moves the centre.
    const Vector3 move_m{change[0], change[1], change[2]};
    sphere.center_m += move_m;
    if (glm::length(move_m) < kSmallestStep_m) break;
  }
  const Eigen::VectorXd d = distances_m();
  sphere.radius_m = d.mean();
  sphere.residual_m = std::sqrt((d.array() - sphere.radius_m).square().sum() / count);
  const Eigen::MatrixX4d J = Jacobian(points_m, sphere.center_m);
  const Eigen::Matrix4d covariance = (J.transpose() * J).inverse();
  sphere.magnification = std::sqrt(covariance.topLeftCorner<3, 3>().trace());
  return sphere;
}

}  // namespace girdle
