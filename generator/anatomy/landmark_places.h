// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Checks measured landmarks against known bones: which names are exchanged, and which landmarks
/// are on the wrong side of the body.
///
/// A bone keeps its shape in every posture. So the known landmarks of each bone are moved, turned
/// and scaled until they fit the measured ones best. Names are wrong if the measured landmarks fit
/// better after two of them exchange their names.
#pragma once

#include <array>
#include <optional>

#include "anatomy/anatomy.h"
#include "kinematics/rotation.h"

namespace girdle {

/// A landmark in the frame of a bone that it belongs to.
struct PlacedLandmark {
  Vector3 position_m{0, 0, 0};
  bool has_row = true;  ///< false for an origin that is 0 0 0 because no row gives it
};

/// Landmarks of each segment, in the order of Segment and of Landmark. Unknown landmarks are empty.
/// SC, PAC and GH, where two bones meet, belong to both bones.
using PlacedLandmarks =
    std::array<std::array<std::optional<PlacedLandmark>, kLandmarkCount>, kSegmentCount>;

/// Two landmarks with exchanged names, and the distance that shows the exchange best.
struct ExchangedLandmarks {
  Landmark first;  ///< before the second in the order of Landmark
  Landmark second;
  Landmark seen_from;     ///< a third landmark
  Landmark misplaced;     ///< `first` or `second`
  double distance_m = 0;  ///< from the third landmark to the place given for `misplaced`
  double other_m = 0;     ///< from the third landmark to the place given for the other one
  double expected_m = 0;  ///< from the third landmark to `misplaced` in a bone of this size
};

/// Spread of a person's landmarks about those of the built-in bones in the person's size: standard
/// deviation along each axis [m]. It includes some millimetres of measuring error and some of
/// shape.
inline constexpr double kShapeSpread_m = 0.008;
/// Spread of the sizes of the bones of one person: standard deviation of the logarithm. Sizes may
/// differ by some tenths.
inline constexpr double kSizeSpread = 0.15;
/// If the root mean square distance [m, in the size of the built-in bones] is larger than this, the
/// landmarks fit no person, and an exchange of names cannot be found.
inline constexpr double kFarthestFit_m = 0.03;

/// Returns two landmarks that fit `adult` better after they exchange their names. Bones may have
/// any size and be of either side. Returns nothing if all names fit best as they are, if the
/// landmarks are of two sides (StrayIn), or if nothing fits. If `in_one_frame` is true, all
/// segments are in one frame. Otherwise only landmarks with rows in one segment's frame are
/// considered. EM and EL lie symmetrically on the humerus, so its shape cannot show their exchange;
/// IsHumerusTurnedAround can.
[[nodiscard]] std::optional<ExchangedLandmarks> ExchangeIn(const PlacedLandmarks& landmarks,
                                                           bool in_one_frame, const Anatomy& adult);

/// A landmark that is on the other side of the body than most.
struct StrayLandmark {
  Landmark landmark;
  Landmark other;       ///< a landmark on the side of most
  double beyond_m = 0;  ///< distance from the median plane
  bool is_left = false;
};

/// Returns a landmark of the left side among those of the right, or the reverse. Precondition: all
/// landmarks are in one frame. Returns nothing if there is none, or if the mirror images of the
/// strays do not fit much better. The median plane is that of the thorax frame. An arm can take EM
/// and EL across it, so these two are strays only if their mirror images make a better humerus.
[[nodiscard]] std::optional<StrayLandmark> StrayIn(const PlacedLandmarks& landmarks,
                                                   const Anatomy& adult);

}  // namespace girdle
