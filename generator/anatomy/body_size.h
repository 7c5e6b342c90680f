// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One anatomy scaled to other sizes, for people of whom only a few measures are known.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "anatomy/anatomy.h"

namespace girdle {

/// The known measures of a person. An unknown measure is empty.
struct BodySize {
  std::optional<double> clavicle_length_m = std::nullopt;  ///< SC to PAC
  std::optional<double> scapula_length_m = std::nullopt;   ///< TS to PAC
  std::optional<double> humerus_length_m = std::nullopt;  ///< GH to the midpoint of the epicondyles
  std::optional<double> body_mass_kg = std::nullopt;
  std::optional<double> stature_m = std::nullopt;
};

/// One measure: its name, its limits and an example.
struct BodyMeasure {
  std::string_view name;
  std::optional<double> BodySize::*value;
  double smallest;
  double largest;
  std::string_view unit;     ///< m or kg
  std::string_view example;  ///< that of an adult
  std::string_view meaning;
};

/// The measures. Limits are from a child to the tallest and heaviest people known.
inline constexpr std::array<BodyMeasure, 5> kBodyMeasures = {{
    {"clavicle-length", &BodySize::clavicle_length_m, 0.05, 0.25, "m", "0.157", "SC to PAC"},
    {"scapula-length", &BodySize::scapula_length_m, 0.04, 0.25, "m", "0.129", "TS to PAC"},
    {"humerus-length", &BodySize::humerus_length_m, 0.1, 0.5, "m", "0.287",
     "GH to the middle of the epicondyles"},
    {"body-mass", &BodySize::body_mass_kg, 5, 650, "kg", "71", "Every segment has its share of it"},
    {"stature", &BodySize::stature_m, 0.5, 2.8, "m", "1.71",
     "Height of the person; every length grows with it, except those that are given; with "
     "--anatomy it sets only the height above the floor"},
}};

/// Throws std::invalid_argument at the first measure beyond its limits. The message says what to
/// type instead.
void CheckBodySize(const BodySize& size);

/// Returns `anatomy`, scaled to a person of another size. `anatomy` belongs to a person of
/// kAdultStature_m.
///
/// Stature scales every length, also the thorax and its ellipsoids: every segment keeps its share
/// of the stature, as in the proportions of Drillis and Contini (1966). A given length scales its
/// own bone with all its landmarks, and overrides stature for that bone. A bone keeps its shape.
/// Its mass grows with the third power of its length (constant density), and its moments of inertia
/// grow as mass times length squared. If body mass is given, the masses are those of WithBodyMass.
/// Joint ranges do not change. Throws like CheckBodySize.
[[nodiscard]] Anatomy ScaledAnatomy(const Anatomy& anatomy, const BodySize& size);

/// Returns `anatomy` with the masses of a body of `body_mass_kg` and moments of inertia in
/// proportion. The humerus with its soft tissue is 2.8 % of the body mass (Dempster 1955, in
/// Winter, Biomechanics and Motor Control of Human Movement). The other segments have the ratios to
/// the humerus that they have in `adult`.
[[nodiscard]] Anatomy WithBodyMass(Anatomy anatomy, const Anatomy& adult, double body_mass_kg);

/// Returns the height [m] of a standing person's jugular notch above the floor.
[[nodiscard]] double JugularNotchHeight_m(double stature_m) noexcept;

/// The length of each segment divided by its length in another anatomy, in the order of Segment.
using SegmentScales = std::array<double, kSegmentCount>;

/// Returns the sizes of the segments of `anatomy` relative to `adult`. The lengths compared are
/// SC-PAC for the clavicle, TS-PAC for the scapula, GH-elbow for the humerus, and the closed path
/// IJ, C7, T8, PX for the thorax.
[[nodiscard]] SegmentScales ScalesOf(const Anatomy& anatomy, const Anatomy& adult) noexcept;

/// Gives `anatomy` the masses, centres of mass, ellipsoids and ligaments of `adult`, each scaled
/// with its segment. A ligament's lengths are scaled with the mean of its two bones.
void GrowTissues(const Anatomy& adult, const SegmentScales& scales, Anatomy& anatomy) noexcept;

}  // namespace girdle
