// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/picture.h"

#include <algorithm>
#include <array>

namespace girdle {
namespace {

constexpr std::size_t kColours = 3;
// A renderer that dithers one colour stays within this range.
constexpr int kBlankRange = 2;
constexpr double kNoiseRatio = 0.7;

bool IsBlank(const Picture& picture) noexcept {
  std::array<int, kColours> least;
  std::array<int, kColours> most;
  least.fill(255);
  most.fill(0);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    const int value = picture.rgb[i];
    least[i % kColours] = std::min(least[i % kColours], value);
    most[i % kColours] = std::max(most[i % kColours], value);
  }
  for (std::size_t k = 0; k < kColours; ++k) {
    if (most[k] - least[k] > kBlankRange) {
      return false;
    }
  }
  return true;
}

// Returns the sum of the variances of the colours.
double Variance(const Picture& picture) noexcept {
  std::array<double, kColours> sum{};
  std::array<double, kColours> squares{};
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    const double value = picture.rgb[i];
    sum[i % kColours] += value;
    squares[i % kColours] += value * value;
  }
  const double count = static_cast<double>(picture.rgb.size()) / kColours;
  double variance = 0;
  for (std::size_t k = 0; k < kColours; ++k) {
    variance += squares[k] / count - (sum[k] / count) * (sum[k] / count);
  }
  return variance;
}

// Returns the mean over pixels of the squared difference to the pixel `right` and `down` of them.
double NeighbourDifference(const Picture& picture, std::size_t right, std::size_t down) noexcept {
  const auto width = static_cast<std::size_t>(picture.size.width);
  const auto height = static_cast<std::size_t>(picture.size.height);
  double sum = 0;
  for (std::size_t y = 0; y + down < height; ++y) {
    for (std::size_t i = kColours * y * width; i < kColours * (y * width + width - right); ++i) {
      const double difference = picture.rgb[i] - picture.rgb[i + kColours * (down * width + right)];
      sum += difference * difference;
    }
  }
  return sum / static_cast<double>((width - right) * (height - down));
}

}  // namespace

std::optional<PictureFault> FaultOf(const Picture& picture) noexcept {
  if (IsBlank(picture)) {
    return PictureFault::kBlank;
  }
  const double unrelated = 2 * Variance(picture);
  const double related =
      std::min(NeighbourDifference(picture, 1, 0), NeighbourDifference(picture, 0, 1));
  return related > kNoiseRatio * unrelated ? std::optional(PictureFault::kNoise) : std::nullopt;
}

}  // namespace girdle
