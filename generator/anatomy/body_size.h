// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One anatomy in other sizes, for people of whom only a tape measure's figures are known.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "anatomy/anatomy.h"

namespace girdle {

/// What is known of a person; nothing where it is not.
struct BodySize {
  std::optional<double> clavicle_length_m = std::nullopt;  ///< SC to PAC
  std::optional<double> scapula_length_m = std::nullopt;   ///< TS to PAC
  std::optional<double> humerus_length_m = std::nullopt;   ///< GH to the middle of the epicondyles
  std::optional<double> body_mass_kg = std::nullopt;
  std::optional<double> stature_m = std::nullopt;
};

/// One of the figures: its name, what it may be, and an example.
struct BodyMeasure {
  std::string_view name;
  std::optional<double> BodySize::*value;
  double smallest;
  double largest;
  std::string_view unit;     ///< m or kg
  std::string_view example;  ///< an adult's
  std::string_view meaning;
};

/// From a child's to those of the tallest and heaviest people known.
inline constexpr std::array<BodyMeasure, 5> kBodyMeasures = {{
    {"clavicle-length", &BodySize::clavicle_length_m, 0.05, 0.25, "m", "0.157", "SC to PAC"},
    {"scapula-length", &BodySize::scapula_length_m, 0.04, 0.25, "m", "0.129", "TS to PAC"},
    {"humerus-length", &BodySize::humerus_length_m, 0.1, 0.5, "m", "0.287",
     "GH to the middle of the epicondyles"},
    {"body-mass", &BodySize::body_mass_kg, 5, 650, "kg", "71", "Every segment has its share of it"},
    {"stature", &BodySize::stature_m, 0.5, 2.8, "m", "1.71",
     "Every length has its share of it, but for those that are given; with --anatomy, the height "
     "above the floor alone"},
}};

/// Throws std::invalid_argument, with what to type instead, at the first figure out of its bounds.
void CheckBodySize(const BodySize& size);

/// Returns `anatomy`, which is that of a person of kAdultStature_m, for a person of another size.
///
/// Stature scales every length, the thorax and its ellipsoids included: all keep their share of it,
/// as in the proportions of Drillis and Contini (1966), where every segment has a fixed one. A
/// length that is given scales its own bone, with all its landmarks, and wins over stature. A bone
/// keeps its shape. Its mass grows with the third power of its length (the same density), its
/// moments of inertia as mass times length squared; with body mass, the masses are as in
/// WithBodyMass. Joint ranges stay. Throws as CheckBodySize.
[[nodiscard]] Anatomy ScaledAnatomy(const Anatomy& anatomy, const BodySize& size);

/// Returns `anatomy` with the masses of a body of `body_mass_kg`, moments of inertia in proportion.
/// The humerus with its soft tissue is 2.8 % of it (Dempster 1955, in Winter, Biomechanics and
/// Motor Control of Human Movement); the other segments are to it as in `adult`.
[[nodiscard]] Anatomy WithBodyMass(Anatomy anatomy, const Anatomy& adult, double body_mass_kg);

/// Height of the jugular notch above the floor of a person standing [m].
[[nodiscard]] double JugularNotchHeight_m(double stature_m) noexcept;

/// How many times as long each segment is as in another anatomy, in the order of Segment.
using SegmentScales = std::array<double, kSegmentCount>;

/// Sizes of the segments of `anatomy`, those of `adult` being 1: the clavicle by SC-PAC, the
/// scapula by TS-PAC, the humerus by GH-elbow, the thorax by the way round IJ, C7, T8 and PX.
[[nodiscard]] SegmentScales ScalesOf(const Anatomy& anatomy, const Anatomy& adult) noexcept;

/// Gives `anatomy` the masses, centres of mass, ellipsoids and ligaments of `adult`, each grown
/// with its segment; a ligament's lengths with the mean of its two bones.
void GrowTissues(const Anatomy& adult, const SegmentScales& scales, Anatomy& anatomy) noexcept;

}  // namespace girdle
