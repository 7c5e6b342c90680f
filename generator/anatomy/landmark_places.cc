// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/landmark_places.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "anatomy/bone_frames.h"
#include "names/side.h"

namespace girdle {
namespace {

// Landmarks of one segment, and its origin.
struct BoneLandmarks {
  Landmark origin;
  std::vector<Landmark> landmarks;
};

const std::array<BoneLandmarks, kSegmentCount>& Bones() {
  using enum Landmark;
  static const std::array<BoneLandmarks, kSegmentCount> kBones = {{
      {kIJ, {kIJ, kPX, kC7, kT8, kSC}},
      {kSC, {kSC, kPAC}},
      {kPAC, {kPAC, kTS, kAI, kAA, kPC, kACJ, kGC, kGH}},
      {kGH, {kGH, kEM, kEL}},
  }};
  return kBones;
}

// A bone of less than this size has all its landmarks in one point.
constexpr double kSmallestSize = 1e-6;

// If mirror images reduce the misfit to less than this share of it, they are the right places.
constexpr double kMuchBetter = 0.5;

// An epicondyle is misplaced if it is this many times as far from GH as a humerus is long.
constexpr double kTooLongHumerus = 1.25;

const std::optional<PlacedLandmark>& At(const PlacedLandmarks& landmarks, std::size_t segment,
                                        Landmark landmark) {
  return landmarks[segment][static_cast<std::size_t>(landmark)];
}

// Returns the place of a known landmark in the frame of a segment that it belongs to.
Vector3 KnownPlace_m(std::size_t segment, Landmark landmark, const Anatomy& adult) {
  return landmark == Bones()[segment].origin ? Vector3{0, 0, 0} : adult.landmark_m(landmark);
}

// The fit of one bone's known landmarks, or of their mirror image, to the measured ones.
struct BoneFit {
  double misfit_m2 = 0;  // sum of squared distances, in the measured size
  double size = 1;       // of the measured bone relative to the known one
  std::size_t count = 0;
};
struct BoneFits {
  BoneFit right;
  BoneFit left;
};

// Over rotations R, sizes s and shifts, sum |b - s R a|^2 is least at s = tr(S)/A. H = sum a b^T =
// U S V^T is about the centroids, and A = sum |a|^2. The least singular value is negative if the
// best turn would be a mirror (Umeyama, IEEE Trans Pattern Anal Mach Intell 1991;13:376-380). The
// mirror image of the known landmarks changes the sign of det H but no singular value.
BoneFits FitsOf(const PlacedLandmarks& landmarks, std::size_t segment, const Anatomy& adult) {
  std::vector<std::pair<Vector3, Vector3>> pairs;  // known and measured
  Vector3 known_mean_m{0, 0, 0};
  Vector3 measured_mean_m{0, 0, 0};
  for (const Landmark landmark : Bones()[segment].landmarks) {
    if (const auto& measured = At(landmarks, segment, landmark)) {
      pairs.emplace_back(KnownPlace_m(segment, landmark, adult), measured->position_m);
      known_mean_m += pairs.back().first;
      measured_mean_m += pairs.back().second;
    }
  }
  if (pairs.size() < 2) return {};
  known_mean_m /= static_cast<double>(pairs.size());
  measured_mean_m /= static_cast<double>(pairs.size());
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  double known_m2 = 0;
  double measured_m2 = 0;
  for (const auto& [known_m, measured_m] : pairs) {
    const Vector3 a = known_m - known_mean_m;
    const Vector3 b = measured_m - measured_mean_m;
    H += Eigen::Vector3d(a.x, a.y, a.z) * Eigen::RowVector3d(b.x, b.y, b.z);
    known_m2 += glm::dot(a, a);
    measured_m2 += glm::dot(b, b);
  }
  const Eigen::Vector3d singular = Eigen::JacobiSVD<Eigen::Matrix3d>(H).singularValues();
  const double sign = H.determinant() < 0 ? -1 : 1;
  const auto fit = [&](double side) {
    const double trace = singular[0] + singular[1] + side * sign * singular[2];
    return BoneFit{std::max(measured_m2 - trace * trace / known_m2, 0.0),
                   std::max(trace / known_m2, kSmallestSize), pairs.size()};
  };
  return {fit(1), fit(-1)};
}

using AllFits = std::array<BoneFits, kSegmentCount>;

AllFits FitsOf(const PlacedLandmarks& landmarks, const Anatomy& adult) {
  AllFits fits;
  for (std::size_t segment = 0; segment < kSegmentCount; ++segment) {
    fits[segment] = FitsOf(landmarks, segment, adult);
  }
  return fits;
}

struct Misfit {
  double cost = 0;   // minus twice the logarithm of the likelihood, without a constant
  double rms_m = 0;  // distance from the known places, in their size
  std::array<double, kSegmentCount> sizes{};
};

Misfit MisfitOf(const AllFits& fits, Side thorax, Side scapula) {
  Misfit misfit;
  const auto fit = [&](std::size_t segment) -> const BoneFit& {
    const Side side = segment == static_cast<std::size_t>(Segment::kThorax) ? thorax : scapula;
    return side == Side::kRight ? fits[segment].right : fits[segment].left;
  };
  double mean_log = 0;
  double bones = 0;
  double misfit_m2 = 0;
  double count = 0;
  for (std::size_t segment = 0; segment < kSegmentCount; ++segment) {
    misfit.sizes[segment] = fit(segment).size;
    if (fit(segment).count == 0) continue;
    mean_log += std::log(fit(segment).size);
    ++bones;
    misfit_m2 += fit(segment).misfit_m2;
    count += static_cast<double>(fit(segment).count);
  }
  mean_log /= bones;
  const double size = std::exp(mean_log);
  misfit_m2 /= size * size;
  misfit.rms_m = std::sqrt(misfit_m2 / count);
  misfit.cost = misfit_m2 / (kShapeSpread_m * kShapeSpread_m);
  for (std::size_t segment = 0; segment < kSegmentCount; ++segment) {
    if (fit(segment).count == 0) continue;
    const double off = (std::log(fit(segment).size) - mean_log) / kSizeSpread;
    misfit.cost += off * off;
  }
  return misfit;
}

Misfit Better(const Misfit& a, const Misfit& b) { return b.cost < a.cost ? b : a; }

// Returns the misfit of a shoulder of one person, right or left.
Misfit MisfitOfOneSide(const AllFits& fits) {
  return Better(MisfitOf(fits, Side::kRight, Side::kRight),
                MisfitOf(fits, Side::kLeft, Side::kLeft));
}

// Returns the least misfit, also over bones of two sides, which are a flaw of another kind.
Misfit MisfitOfAnySides(const AllFits& fits) {
  return Better(MisfitOfOneSide(fits), Better(MisfitOf(fits, Side::kRight, Side::kLeft),
                                              MisfitOf(fits, Side::kLeft, Side::kRight)));
}

bool IsTold(Landmark first, Landmark second) {
  return first != Landmark::kEM || second != Landmark::kEL;
}

bool HasRow(const std::optional<PlacedLandmark>& landmark) { return landmark && landmark->has_row; }

// Exchanges two landmarks of one segment, or of all segments if `only` is kSegmentCount. Returns
// whether both landmarks exist.
bool Exchange(PlacedLandmarks& landmarks, std::size_t only, std::size_t first, std::size_t second) {
  if (only < kSegmentCount) {
    if (!HasRow(landmarks[only][first]) || !HasRow(landmarks[only][second])) return false;
    std::swap(landmarks[only][first], landmarks[only][second]);
    return true;
  }
  std::optional<PlacedLandmark> places[2];
  for (const auto& segment : landmarks) {
    if (segment[first]) places[0] = segment[first];
    if (segment[second]) places[1] = segment[second];
  }
  if (!places[0] || !places[1]) return false;
  for (auto& segment : landmarks) {
    if (segment[first]) segment[first] = places[1];
    if (segment[second]) segment[second] = places[0];
  }
  return true;
}

// Adds the distance that an exchange corrects most, as its evidence.
void SetEvidence(const PlacedLandmarks& given, const PlacedLandmarks& mended,
                 const std::array<double, kSegmentCount>& sizes, const Anatomy& adult,
                 ExchangedLandmarks& exchange) {
  double largest_gain_m = -std::numeric_limits<double>::infinity();
  for (std::size_t segment = 0; segment < kSegmentCount; ++segment) {
    for (const Landmark misplaced : {exchange.first, exchange.second}) {
      if (!At(given, segment, misplaced)) continue;
      const Vector3 said_m = At(given, segment, misplaced)->position_m;
      const Vector3 found_m = At(mended, segment, misplaced)->position_m;
      for (const Landmark third : Bones()[segment].landmarks) {
        if (third == exchange.first || third == exchange.second || !At(given, segment, third)) {
          continue;
        }
        const Vector3 from_m = At(given, segment, third)->position_m;
        const double expected_m =
            sizes[segment] * glm::distance(KnownPlace_m(segment, third, adult),
                                           KnownPlace_m(segment, misplaced, adult));
        const double distance_m = glm::distance(from_m, said_m);
        const double other_m = glm::distance(from_m, found_m);
        const double gain_m = std::abs(distance_m - expected_m) - std::abs(other_m - expected_m);
        if (gain_m > largest_gain_m) {
          largest_gain_m = gain_m;
          exchange.seen_from = third;
          exchange.misplaced = misplaced;
          exchange.distance_m = distance_m;
          exchange.other_m = other_m;
          exchange.expected_m = expected_m;
        }
      }
    }
  }
}

// Landmarks that are all given in one frame, relative to the median plane.
class InOneFrame {
 public:
  explicit InOneFrame(const PlacedLandmarks& landmarks) {
    for (const auto& segment : landmarks) {
      for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        if (!segment[i]) continue;
        p_A_m_[i] = segment[i]->position_m;
        is_known_[i] = true;
      }
    }
    to_the_right_ = BoneRotation(Segment::kThorax, p_A_m_) * Vector3(0, 0, 1);
  }

  [[nodiscard]] bool Knows(Landmark landmark) const {
    return is_known_[static_cast<std::size_t>(landmark)];
  }
  [[nodiscard]] const Vector3& at_m(Landmark landmark) const {
    return p_A_m_[static_cast<std::size_t>(landmark)];
  }
  // Returns the distance of a landmark to the right of the median plane.
  [[nodiscard]] double Right_m(Landmark landmark) const {
    return glm::dot(at_m(landmark) - at_m(Landmark::kIJ), to_the_right_);
  }
  [[nodiscard]] Vector3 Image_m(Landmark landmark) const {
    return at_m(landmark) - 2 * Right_m(landmark) * to_the_right_;
  }

 private:
  LandmarkPositions p_A_m_{};
  std::array<bool, kLandmarkCount> is_known_{};
  Vector3 to_the_right_{0, 0, 0};
};

// Landmarks sorted by their sides of the body.
struct Sorted {
  std::vector<Landmark> most;
  std::vector<Landmark> strays;
  bool is_right = true;  // the side of most landmarks
};

// Whether the mirror image of an epicondyle gives a more likely humerus.
bool IsStrayEpicondyle(const InOneFrame& body, Landmark epicondyle, bool is_right,
                       double length_m) {
  const Landmark shoulder = body.Knows(Landmark::kGH) ? Landmark::kGH : Landmark::kPAC;
  const double beyond_m = is_right ? -body.Right_m(epicondyle) : body.Right_m(epicondyle);
  const double there_m = glm::distance(body.at_m(epicondyle), body.at_m(shoulder));
  const double image_there_m = glm::distance(body.Image_m(epicondyle), body.at_m(shoulder));
  return beyond_m > 0 && there_m > kTooLongHumerus * length_m &&
         std::abs(std::log(image_there_m / length_m)) < std::abs(std::log(there_m / length_m));
}

Sorted SortedBySide(const PlacedLandmarks& landmarks, const InOneFrame& body,
                    const Anatomy& adult) {
  Sorted sorted;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    // Epicondyles are left out here, because an arm can cross the median plane.
    if (!body.Knows(landmark) || !kLandmarks[i].sided ||
        kLandmarks[i].segment == Segment::kHumerus) {
      continue;
    }
    (body.Right_m(landmark) > 0 ? sorted.most : sorted.strays).push_back(landmark);
  }
  sorted.is_right = sorted.most.size() >= sorted.strays.size();
  if (!sorted.is_right) std::swap(sorted.most, sorted.strays);
  const BoneFits scapula = FitsOf(landmarks, static_cast<std::size_t>(Segment::kScapula), adult);
  const double size = sorted.is_right ? scapula.right.size : scapula.left.size;
  for (const Landmark epicondyle : {Landmark::kEM, Landmark::kEL}) {
    if (IsStrayEpicondyle(body, epicondyle, sorted.is_right,
                          size * glm::length(adult.landmark_m(epicondyle)))) {
      sorted.strays.push_back(epicondyle);
    }
  }
  return sorted;
}

// Returns the landmarks with the mirror images of the strays in their places.
PlacedLandmarks WithoutStrays(PlacedLandmarks landmarks, const Anatomy& adult) {
  const InOneFrame body(landmarks);
  for (const Landmark stray : SortedBySide(landmarks, body, adult).strays) {
    for (auto& segment : landmarks) {
      if (auto& landmark = segment[static_cast<std::size_t>(stray)]) {
        landmark->position_m = body.Image_m(stray);
      }
    }
  }
  return landmarks;
}

}  // namespace

std::optional<ExchangedLandmarks> ExchangeIn(const PlacedLandmarks& landmarks, bool in_one_frame,
                                             const Anatomy& adult) {
  Misfit best = MisfitOfAnySides(FitsOf(landmarks, adult));
  if (in_one_frame) {
    best = Better(best, MisfitOfAnySides(FitsOf(WithoutStrays(landmarks, adult), adult)));
  }
  std::optional<ExchangedLandmarks> exchange;
  PlacedLandmarks mended;
  const std::size_t begin = in_one_frame ? kSegmentCount : 0;
  const std::size_t end = in_one_frame ? kSegmentCount + 1 : kSegmentCount;
  for (std::size_t only = begin; only < end; ++only) {
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      for (std::size_t k = i + 1; k < kLandmarkCount; ++k) {
        const auto first = static_cast<Landmark>(i);
        const auto second = static_cast<Landmark>(k);
        PlacedLandmarks tried = landmarks;
        if (!IsTold(first, second) || !Exchange(tried, only, i, k)) continue;
        const Misfit misfit = MisfitOfOneSide(FitsOf(tried, adult));
        if (misfit.cost < best.cost && misfit.rms_m < kFarthestFit_m) {
          best = misfit;
          mended = tried;
          exchange = ExchangedLandmarks{first, second, first, first};
        }
      }
    }
  }
  if (exchange) SetEvidence(landmarks, mended, best.sizes, adult, *exchange);
  return exchange;
}

std::optional<StrayLandmark> StrayIn(const PlacedLandmarks& landmarks, const Anatomy& adult) {
  const InOneFrame body(landmarks);
  const Sorted sorted = SortedBySide(landmarks, body, adult);
  if (sorted.strays.empty()) return std::nullopt;
  const double cost = MisfitOfOneSide(FitsOf(landmarks, adult)).cost;
  const double mended_cost = MisfitOfOneSide(FitsOf(WithoutStrays(landmarks, adult), adult)).cost;
  if (mended_cost > kMuchBetter * cost) return std::nullopt;
  const Landmark stray = sorted.strays.front();
  return StrayLandmark{stray, sorted.most.front(), std::abs(body.Right_m(stray)), sorted.is_right};
}

}  // namespace girdle
