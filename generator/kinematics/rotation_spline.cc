// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation_spline.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace girdle {
namespace {

// Above this cosine (W below 18 deg) the series is used: neighbours in the table are that close.
constexpr double kSeriesCosine = 0.95;

// Terms of the series. Each is at most 0.5 (1 - kSeriesCosine) = 0.025 of the one before, so that
// the first one left out is below 0.025^11 = 2e-18.
constexpr int kSeriesTerms = 11;

// sin(t W) / sin(W) as a power series in cos(W) - 1, which needs neither W nor a sine:
//   sin(t W) / sin(W) = t (1 + b_1 (1 + b_2 (1 + ...))),  b_i = (t^2 / (i (2i+1)) - i / (2i+1))
//   (cos W - 1)
// (D. Eberly, A Fast and Accurate Algorithm for Computing SLERP, J. Graphics Tools 2011;15:161).
struct SeriesFactors {
  std::array<double, kSeriesTerms> square_factor{};
  std::array<double, kSeriesTerms> constant{};
};

constexpr SeriesFactors MakeSeriesFactors() {
  SeriesFactors factors;
  for (int term = 1; term <= kSeriesTerms; ++term) {
    factors.square_factor[term - 1] = 1.0 / (term * (2.0 * term + 1.0));
    factors.constant[term - 1] = term / (2.0 * term + 1.0);
  }
  return factors;
}

constexpr SeriesFactors kSeries = MakeSeriesFactors();

double SineRatio(double t, double cosine_minus_one) noexcept {
  const double t_squared = t * t;
  double sum = 1;
  for (int term = kSeriesTerms - 1; term >= 0; --term) {
    const double b =
        (kSeries.square_factor[term] * t_squared - kSeries.constant[term]) * cosine_minus_one;
    sum = 1 + b * sum;
  }
  return t * sum;
}

}  // namespace

// slerp(a, b, t) = sin((1-t)W)/sin(W) a + sin(tW)/sin(W) b,  cos(W) = a . b (1)
Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept {
  const double cosine = glm::dot(a, b);
  if (cosine > kSeriesCosine) {
    return SineRatio(1 - t, cosine - 1) * a + SineRatio(t, cosine - 1) * b;
  }
  const double W = std::acos(std::fmax(cosine, -1.0));
  const double sine = std::sin(W);
  // Opposite quaternions: stay on the nearer of the two.
  constexpr double kTinySine = 1e-12;
  if (sine < kTinySine) {
    return t < 0.5 ? a : b;
  }
  return (std::sin((1 - t) * W) / sine) * a + (std::sin(t * W) / sine) * b;
}

// s_i = q_i exp(-(log(q_i^-1 q_i+1) + log(q_i^-1 q_i-1)) / 4) (5)
Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                        const Quaternion& q_next) noexcept {
  const Quaternion q_i_inverse = glm::conjugate(q_i);
  return q_i * Exp((Log(q_i_inverse * q_next) + Log(q_i_inverse * q_previous)) / -4.0);
}

// squad(q_i, q_i+1, t) = slerp(slerp(q_i, q_i+1, t), slerp(s_i, s_i+1, t), 2t(1-t)) (4)
Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next, const Quaternion& s_i,
                 const Quaternion& s_next, double t) noexcept {
  return Slerp(Slerp(q_i, q_next, t), Slerp(s_i, s_next, t), 2 * t * (1 - t));
}

}  // namespace girdle
