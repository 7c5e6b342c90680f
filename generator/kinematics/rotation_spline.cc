// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace girdle {
namespace {

// sin(t W) / sin(W) as a power series in cos(W) - 1, which needs neither W nor a sine:
//   sin(t W) / sin(W) = t (1 + b_1 (1 + b_2 (1 + ...))),
//   b_i = (t^2 / (i (2i+1)) - i / (2i+1)) (cos W - 1)
// (D. Eberly, A Fast and Accurate Algorithm for Computing SLERP, J. Graphics Tools 2011;15:161).
// Every |b_i| is at most (1 - cos W) / 2.
constexpr int kMostTerms = 9;

struct SeriesFactors {
  std::array<double, kMostTerms> square_factor{};
  std::array<double, kMostTerms> constant{};
};

constexpr SeriesFactors MakeSeriesFactors() {
  SeriesFactors factors;
  for (int i = 1; i <= kMostTerms; ++i) {
    factors.square_factor[i - 1] = 1.0 / (i * (2.0 * i + 1.0));
    factors.constant[i - 1] = i / (2.0 * i + 1.0);
  }
  return factors;
}

constexpr SeriesFactors kSeries = MakeSeriesFactors();

// Slerp of N pairs by the series. The N sums run side by side: each alone would wait for its own
// last term.
template <int Terms, std::size_t N>
std::array<Quaternion, N> SeriesSlerp(const std::array<Quaternion, N>& a,
                                      const std::array<Quaternion, N>& b, double t,
                                      const std::array<double, N>& cosine) noexcept {
  const double u = 1 - t;
  std::array<double, N> sum_a;  // NOLINT(*-member-init): filled below
  std::array<double, N> sum_b;  // NOLINT(*-member-init): filled below
  sum_a.fill(1);
  sum_b.fill(1);
  for (int i = Terms - 1; i >= 0; --i) {
    const double factor_a = kSeries.square_factor[i] * u * u - kSeries.constant[i];
    const double factor_b = kSeries.square_factor[i] * t * t - kSeries.constant[i];
    for (std::size_t k = 0; k < N; ++k) {
      sum_a[k] = 1 + factor_a * (cosine[k] - 1) * sum_a[k];
      sum_b[k] = 1 + factor_b * (cosine[k] - 1) * sum_b[k];
    }
  }
  std::array<Quaternion, N> result;
  for (std::size_t k = 0; k < N; ++k) {
    result[k] = u * sum_a[k] * a[k] + t * sum_b[k] * b[k];
  }
  return result;
}

// slerp(a, b, t) = sin((1-t)W)/sin(W) a + sin(tW)/sin(W) b,  cos(W) = a . b                     (1)
Quaternion TrigonometricSlerp(const Quaternion& a, const Quaternion& b, double t,
                              double cosine) noexcept {
  const double W = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double sine = std::sin(W);
  // Opposite quaternions, as far as an arc cosine can tell: stay on the nearer of the two.
  constexpr double kTinySine = 1e-7;
  if (sine < kTinySine) {
    return t < 0.5 ? a : b;
  }
  return (std::sin((1 - t) * W) / sine) * a + (std::sin(t * W) / sine) * b;
}

template <std::size_t N>
std::array<Quaternion, N> SlerpEach(const std::array<Quaternion, N>& a,
                                    const std::array<Quaternion, N>& b, double t) noexcept {
  std::array<double, N> cosine;  // NOLINT(*-member-init): filled below
  for (std::size_t k = 0; k < N; ++k) {
    cosine[k] = glm::dot(a[k], b[k]);
  }
  // Neighbours in the table are close, squad's inner arcs closer still. In each case the first term
  // left out is below 1e-16, half a unit in the last place.
  const double smallest = *std::min_element(cosine.begin(), cosine.end());
  if (smallest > 1 - 1e-5) {
    return SeriesSlerp<2>(a, b, t, cosine);
  }
  if (smallest > 1 - 1e-3) {
    return SeriesSlerp<4>(a, b, t, cosine);
  }
  if (smallest > 1 - 0.02) {
    return SeriesSlerp<7>(a, b, t, cosine);
  }
  if (smallest > 1 - 0.05) {
    return SeriesSlerp<kMostTerms>(a, b, t, cosine);
  }
  if constexpr (N == 1) {
    return {TrigonometricSlerp(a[0], b[0], t, cosine[0])};
  } else {
    // One far pair among near ones: each goes its own way.
    std::array<Quaternion, N> result;
    for (std::size_t k = 0; k < N; ++k) {
      result[k] = SlerpEach<1>({a[k]}, {b[k]}, t)[0];
    }
    return result;
  }
}

}  // namespace

Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept {
  return SlerpEach<1>({a}, {b}, t)[0];
}

JointRotations Slerp(const JointRotations& a, const JointRotations& b, double t) noexcept {
  return SlerpEach(a, b, t);
}

// s_i = q_i exp(-(log(q_i^-1 q_i+1) + log(q_i^-1 q_i-1)) / 4)                                   (5)
Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                        const Quaternion& q_next) noexcept {
  const Quaternion q_i_inverse = glm::conjugate(q_i);
  return q_i * Exp((Log(q_i_inverse * q_next) + Log(q_i_inverse * q_previous)) / -4.0);
}

JointRotations SquadControl(const JointRotations& q_previous, const JointRotations& q_i,
                            const JointRotations& q_next) noexcept {
  return {SquadControl(q_previous[0], q_i[0], q_next[0]),
          SquadControl(q_previous[1], q_i[1], q_next[1]),
          SquadControl(q_previous[2], q_i[2], q_next[2])};
}

// squad(q_i, q_i+1, t) = slerp(slerp(q_i, q_i+1, t), slerp(s_i, s_i+1, t), 2t(1-t))             (4)
Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next, const Quaternion& s_i,
                 const Quaternion& s_next, double t) noexcept {
  return Slerp(Slerp(q_i, q_next, t), Slerp(s_i, s_next, t), 2 * t * (1 - t));
}

JointRotations Squad(const JointRotations& q_i, const JointRotations& q_next,
                     const JointRotations& s_i, const JointRotations& s_next, double t) noexcept {
  return Slerp(Slerp(q_i, q_next, t), Slerp(s_i, s_next, t), 2 * t * (1 - t));
}

}  // namespace girdle
