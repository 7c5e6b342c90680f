// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "fits/table_smoothing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace girdle {
namespace {

// Rows that one third difference joins.
constexpr std::size_t kJoinedRows = 4;
constexpr std::size_t kJoinedSteps = kJoinedRows - 1;
// Index in kJointNames.
constexpr std::size_t kGhIndex = 2;

// Returns the matrix [v] of the cross product, [v] u = v x u.
Matrix3 CrossMatrix(const Vector3& v) {
  return {Vector3(0, v.z, -v.y), Vector3(-v.z, 0, v.x), Vector3(v.y, -v.x, 0)};
}

// Returns K of equation (5).
Matrix3 InverseRightJacobian(const Vector3& v) {
  // Below this angle the third and later terms of the series are below rounding:
  // (1 - x/2 cot(x/2)) / x^2 = 1/12 + x^2/720 + x^4/30240 + ...
  constexpr double kSmallAngle = 1e-3;
  constexpr double kSeriesConstant = 1.0 / 12;
  constexpr double kSeriesSquare = 1.0 / 720;
  const double squared_angle = glm::dot(v, v);
  const double angle = std::sqrt(squared_angle);
  const double factor = angle < kSmallAngle ? kSeriesConstant + kSeriesSquare * squared_angle
                                            : (1 - angle / 2 / std::tan(angle / 2)) / squared_angle;
  const Matrix3 cross = CrossMatrix(v);
  return Matrix3(1) + 0.5 * cross + factor * cross * cross;
}

// Symmetric positive definite equations A d = b, with one vector for each row of the table. A joins
// a row only to rows that share a third difference with it. Solve uses Cholesky's A = L L^T within
// that band.
class BandedEquations {
 public:
  explicit BandedEquations(std::size_t rows) : lower_(3 * rows), right_side_(3 * rows) {}

  // Adds to the block of A in this row and column; column <= row.
  void AddToMatrix(std::size_t row, std::size_t column, const Matrix3& block) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < (row == column ? i + 1 : 3); ++j) {
        Entry(3 * row + i, 3 * column + j) += block[j][i];
      }
    }
  }

  void AddToRightSide(std::size_t row, const Vector3& v) {
    for (int i = 0; i < 3; ++i) {
      right_side_[3 * row + i] += v[i];
    }
  }

  // Returns d, which is not finite if A is not positive definite. Overwrites the equations.
  [[nodiscard]] std::vector<Vector3> Solve() {
    const std::size_t size = right_side_.size();
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = FirstColumn(i); j <= i; ++j) {
        double sum = Entry(i, j);
        for (std::size_t k = FirstColumn(i); k < j; ++k) {
          sum -= Entry(i, k) * Entry(j, k);
        }
        Entry(i, j) = i == j ? std::sqrt(sum) : sum / Entry(j, j);
      }
    }
    // L y = b, then L^T d = y, each in place.
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = FirstColumn(i); k < i; ++k) {
        right_side_[i] -= Entry(i, k) * right_side_[k];
      }
      right_side_[i] /= Entry(i, i);
    }
    for (std::size_t i = size; i-- > 0;) {
      right_side_[i] /= Entry(i, i);
      for (std::size_t k = FirstColumn(i); k < i; ++k) {
        right_side_[k] -= Entry(i, k) * right_side_[i];
      }
    }
    std::vector<Vector3> d(size / 3);
    for (std::size_t row = 0; row < d.size(); ++row) {
      d[row] = {right_side_[3 * row], right_side_[3 * row + 1], right_side_[3 * row + 2]};
    }
    return d;
  }

 private:
  // Entries in a line from the first that can be nonzero to the diagonal.
  static constexpr std::size_t kBand = 3 * kJoinedRows;

  [[nodiscard]] static std::size_t FirstColumn(std::size_t line) {
    return line < kBand ? 0 : line - (kBand - 1);
  }
  [[nodiscard]] double& Entry(std::size_t line, std::size_t column) {
    return lower_[line][column + (kBand - 1) - line];
  }

  std::vector<std::array<double, kBand>> lower_;
  std::vector<double> right_side_;
};

// t_i of equation (3) as a weighted sum of w_i, w_i+1, w_i+2, and the weight of its square.
struct ThirdDifference {
  std::array<double, kJoinedSteps> weights;
  double penalty;  ///< lambda p_i
};

ThirdDifference ThirdDifferenceFrom(const double* elevations_rad, double penalty) {
  std::array<double, kJoinedSteps> h{};
  for (std::size_t k = 0; k < kJoinedSteps; ++k) {
    h[k] = elevations_rad[k + 1] - elevations_rad[k];
  }
  const double s = (h[0] + h[1] + h[2]) / kJoinedSteps;
  const double first = 2 * s * s / (h[0] + h[1]);
  const double second = 2 * s * s / (h[1] + h[2]);
  return {{first / h[0], -(first + second) / h[1], second / h[2]}, penalty};
}

// Returns w of equation (2): entry i is the rotation vector from row i to row i + 1.
std::vector<Vector3> WaysBetween(const std::vector<Quaternion>& rows) {
  std::vector<Vector3> ways(rows.size() - 1);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    ways[i] = Log(glm::conjugate(rows[i]) * rows[i + 1]);
  }
  return ways;
}

// Returns the Gauss-Newton step d_i of (1) for rows r near the measured q.
std::vector<Vector3> GaussNewtonStep(const std::vector<Quaternion>& q,
                                     const std::vector<Quaternion>& r,
                                     const std::vector<ThirdDifference>& differences) {
  BandedEquations equations(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Vector3 e = Log(glm::conjugate(q[i]) * r[i]);
    const Matrix3 J = InverseRightJacobian(e);
    equations.AddToMatrix(i, i, glm::transpose(J) * J);
    equations.AddToRightSide(i, -(glm::transpose(J) * e));
  }
  const std::vector<Vector3> w = WaysBetween(r);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const auto& [weights, penalty] = differences[i];
    Vector3 t(0);
    std::array<Matrix3, kJoinedRows> J;
    J.fill(Matrix3(0));
    for (std::size_t k = 0; k < kJoinedSteps; ++k) {
      const Matrix3 K = InverseRightJacobian(w[i + k]);
      t += weights[k] * w[i + k];
      J[k] -= weights[k] * glm::transpose(K);
      J[k + 1] += weights[k] * K;
    }
    for (std::size_t a = 0; a < kJoinedRows; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        equations.AddToMatrix(i + a, i + b, penalty * (glm::transpose(J[a]) * J[b]));
      }
      equations.AddToRightSide(i + a, -penalty * (glm::transpose(J[a]) * t));
    }
  }
  return equations.Solve();
}

// Moves `r` from the measured `q` to the minimum of (1). Returns false if the steps do not settle.
[[nodiscard]] bool Settle(const std::vector<Quaternion>& q,
                          const std::vector<ThirdDifference>& differences,
                          std::vector<Quaternion>& r) {
  // A measured table takes five steps.
  constexpr int kMostSteps = 50;
  // Ten times the rounding at kLargestPenalty.
  constexpr double kSettled_rad = 1e-11;
  r = q;
  for (int step = 0; step < kMostSteps; ++step) {
    const std::vector<Vector3> d = GaussNewtonStep(q, r, differences);
    bool is_settled = true;
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] = glm::normalize(r[i] * Exp(d[i]));
      // Written so that a NaN has not settled.
      is_settled = is_settled && glm::length(d[i]) < kSettled_rad;
    }
    if (is_settled) {
      return true;
    }
  }
  return false;
}

void CheckWithin(const char* name, double value, double upper) {
  // Written so that a NaN fails too.
  if (!(value >= 0 && value <= upper)) {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                ", expected 0 to " + std::to_string(upper));
  }
}

Vector3 EulerAngles(const RhythmTable& table, std::size_t joint, std::size_t plane,
                    std::size_t elevation) {
  const JointAngles& angles_rad = table.position(plane, elevation).angles_rad;
  return {angles_rad[3 * joint], angles_rad[3 * joint + 1], angles_rad[3 * joint + 2]};
}

// Returns the rotations of one joint along the elevations of one plane.
std::vector<Quaternion> Rows(const RhythmTable& table, std::size_t joint, std::size_t plane) {
  std::vector<Quaternion> rows(table.elevations_rad().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = QuaternionFromEuler(kJointSequences[joint], EulerAngles(table, joint, plane, i));
  }
  return rows;
}

JointBend BendOf(const RhythmTable& table, std::size_t joint) {
  const std::vector<double>& x_rad = table.elevations_rad();
  JointBend bend;
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    const std::vector<Vector3> w = WaysBetween(Rows(table, joint, plane));
    for (std::size_t i = 1; i + 1 < x_rad.size(); ++i) {
      const double step_before = x_rad[i] - x_rad[i - 1];
      const double step_after = x_rad[i + 1] - x_rad[i];
      const double mean_step = (step_before + step_after) / 2;
      const auto bend_at = [=](const Vector3& way_before, const Vector3& way_after) {
        return mean_step * (way_after / step_after - way_before / step_before);
      };
      bend.rotation.Add(glm::length(bend_at(w[i - 1], w[i])), plane, i);

      // Returns the difference of each angle by the shorter way around.
      const auto euler_way = [&](std::size_t from) {
        Vector3 way =
            EulerAngles(table, joint, plane, from + 1) - EulerAngles(table, joint, plane, from);
        for (int k = 0; k < 3; ++k) {
          way[k] = std::remainder(way[k], 2 * kPi);
        }
        return way;
      };
      const Vector3 euler = glm::abs(bend_at(euler_way(i - 1), euler_way(i)));
      bend.euler.Add(std::max({euler.x, euler.y, euler.z}), plane, i);
    }
  }
  return bend;
}

}  // namespace

RhythmTable Smoothed(const RhythmTable& table, const SmoothingOptions& options) {
  const std::vector<double>& elevations_rad = table.elevations_rad();
  if (elevations_rad.size() < kFewestSmoothedElevations) {
    throw std::invalid_argument("elevations: " + std::to_string(elevations_rad.size()) +
                                " given, at least " + std::to_string(kFewestSmoothedElevations) +
                                " are needed to smooth");
  }
  CheckWithin("penalty", options.penalty, kLargestPenalty);
  CheckWithin("gh_low_share", options.gh_low_share, 1);
  if (options.penalty == 0) {
    return table;
  }

  std::vector<RhythmPosition> positions;
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t i = 0; i < elevations_rad.size(); ++i) {
      positions.push_back(table.position(plane, i));
    }
  }
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    std::vector<ThirdDifference> differences;
    for (std::size_t i = 0; i + kJoinedSteps < elevations_rad.size(); ++i) {
      const bool is_gh_low = joint == kGhIndex && elevations_rad[i] < options.gh_low_elevation_rad;
      differences.push_back(ThirdDifferenceFrom(
          &elevations_rad[i], options.penalty * (is_gh_low ? options.gh_low_share : 1)));
    }
    for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
      std::vector<Quaternion> r;
      if (!Settle(Rows(table, joint, plane), differences, r)) {
        throw std::invalid_argument(std::string(kJointNames[joint]) + " in plane " +
                                    std::to_string(DegreesFromRadians(table.planes_rad()[plane])) +
                                    " deg turns too far from row to row to be smoothed");
      }
      for (std::size_t i = 0; i < r.size(); ++i) {
        const Vector3 angles_rad = EulerFromQuaternion(kJointSequences[joint], r[i]);
        JointAngles& position_rad = positions[plane * r.size() + i].angles_rad;
        for (int k = 0; k < 3; ++k) {
          position_rad[3 * joint + k] = angles_rad[k];
        }
      }
    }
  }
  return {table.planes_rad(), elevations_rad, std::move(positions)};
}

std::array<JointChange, kJointCount> ChangesBetween(const RhythmTable& before,
                                                    const RhythmTable& after) {
  if (before.planes_rad() != after.planes_rad() ||
      before.elevations_rad() != after.elevations_rad()) {
    throw std::invalid_argument("the tables have different planes or elevations");
  }
  std::array<JointChange, kJointCount> changes;
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    for (std::size_t plane = 0; plane < before.planes_rad().size(); ++plane) {
      const std::vector<Quaternion> q = Rows(before, joint, plane);
      const std::vector<Quaternion> r = Rows(after, joint, plane);
      for (std::size_t i = 0; i < q.size(); ++i) {
        changes[joint].move.Add(AngleBetween(q[i], r[i]), plane, i);
      }
    }
    changes[joint].before = BendOf(before, joint);
    changes[joint].after = BendOf(after, joint);
  }
  return changes;
}

}  // namespace girdle
