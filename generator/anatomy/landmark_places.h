// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Where each landmark lies beside the others, on either side of the body, and which measured ones
/// bear wrong names.
///
/// A bone keeps its shape in every posture. So the known landmarks of each bone, moved, turned and
/// scaled, are laid over the measured ones. Names are wrong if measured landmarks fit better after
/// two of them have exchanged their names.
#pragma once

#include <array>
#include <optional>

#include "anatomy/anatomy.h"
#include "kinematics/rotation.h"

namespace girdle {

/// A landmark in a frame of a bone that it belongs to.
struct PlacedLandmark {
  Vector3 position_m{0, 0, 0};
  bool has_row = true;  ///< false for an origin that is 0 0 0 because no row gives it
};

/// Landmarks of each segment, in the order of Segment and of Landmark. A landmark in which two
/// bones meet belongs to both: SC PAC GH. Nothing where it is not known.
using PlacedLandmarks =
    std::array<std::array<std::optional<PlacedLandmark>, kLandmarkCount>, kSegmentCount>;

/// Two landmarks that bear each other's names, and the distance that shows it best.
struct ExchangedLandmarks {
  Landmark first;  ///< before the second in the order of Landmark
  Landmark second;
  Landmark seen_from;     ///< a third one
  Landmark misplaced;     ///< first or second
  double distance_m = 0;  ///< from the third one to where `misplaced` is said to be ...
  double other_m = 0;     ///< ... and to where the other one of the two is said to be
  double expected_m = 0;  ///< to `misplaced` in a bone of this size
};

/// How far the landmarks of a person lie from those of the built-in bones in the person's size, as
/// a standard deviation along each axis [m]: some millimetres of measuring and of shape.
inline constexpr double kShapeSpread_m = 0.008;
/// Standard deviation of the logarithm of a bone's size in one person: some tenths.
inline constexpr double kSizeSpread = 0.15;
/// Above this root mean square distance [m, in the size of the built-in bones], landmarks fit no
/// person, and who has exchanged what cannot be told.
inline constexpr double kFarthestFit_m = 0.03;

/// Returns two landmarks that fit those of `adult`, in any size and on either side of the body,
/// better under each other's names; nothing if all fit best as they are, if they are of two sides
/// (StrayIn) or if nothing fits.
/// `in_one_frame` says that all segments stand in one frame; otherwise only landmarks with rows in
/// one segment's frame can have been exchanged. EM and EL lie alike on both sides of the humerus,
/// whose shape does not tell them apart (IsHumerusTurnedAround does).
[[nodiscard]] std::optional<ExchangedLandmarks> ExchangeIn(const PlacedLandmarks& landmarks,
                                                           bool in_one_frame, const Anatomy& adult);

/// A landmark on the other side of the body than most.
struct StrayLandmark {
  Landmark landmark;
  Landmark other;       ///< one on the side of most
  double beyond_m = 0;  ///< from the median plane
  bool is_left = false;
};

/// Returns a landmark of the left side among those of the right, or the other way round, of
/// landmarks that stand all in one frame; nothing if the strays' mirror images do not fit much
/// better either. The median plane is the thorax frame's. EM and EL, which an arm can take across
/// it, are strays if their mirror images make a better humerus.
[[nodiscard]] std::optional<StrayLandmark> StrayIn(const PlacedLandmarks& landmarks,
                                                   const Anatomy& adult);

}  // namespace girdle
