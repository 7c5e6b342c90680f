// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/body_size.h"

#include <glm/geometric.hpp>
#include <iterator>
#include <stdexcept>
#include <string>

#include "text/number_text.h"

namespace girdle {
namespace {

constexpr double kHumerusShareOfBodyMass = 0.028;

struct Unit {
  std::string_view name;
  double per_unit;  // how many make one of the right unit
};
constexpr Unit kWrongLengths[] = {{"centimeters", 100}, {"millimeters", 1000}};
constexpr Unit kWrongMasses[] = {{"grams", 1000}};

bool IsWithin(const BodyMeasure& measure, double value) {
  return value >= measure.smallest && value <= measure.largest;
}

// Returns a suggestion of what to type instead of a value that is out of bounds.
std::string Advice(const BodyMeasure& measure, double value) {
  const bool is_length = measure.unit == "m";
  const auto advice = [&](const Unit& unit) {
    return std::string(is_length ? "Give meters" : "Give kilograms") + ", not " +
           std::string(unit.name) + ": " + SignificantText(value / unit.per_unit, 6);
  };
  if (is_length) {
    for (const Unit& unit : kWrongLengths) {
      if (IsWithin(measure, value / unit.per_unit)) return advice(unit);
    }
  } else {
    for (const Unit& unit : kWrongMasses) {
      if (IsWithin(measure, value / unit.per_unit)) return advice(unit);
    }
  }
  return "Give one such as " + std::string(measure.example) + " " + std::string(measure.unit);
}

// Returns the length around the trunk in its median plane.
double AroundTheThorax_m(const Anatomy& anatomy) {
  const Landmark around[] = {Landmark::kIJ, Landmark::kC7, Landmark::kT8, Landmark::kPX};
  double length_m = 0;
  for (std::size_t i = 0; i < std::size(around); ++i) {
    length_m += glm::distance(anatomy.landmark_m(around[i]),
                              anatomy.landmark_m(around[(i + 1) % std::size(around)]));
  }
  return length_m;
}

void ScaleEllipsoid(double scale, Ellipsoid& ellipsoid) {
  ellipsoid.center_m *= scale;
  ellipsoid.radii_m *= scale;
}

}  // namespace

void CheckBodySize(const BodySize& size) {
  for (const BodyMeasure& measure : kBodyMeasures) {
    const std::optional<double>& value = size.*measure.value;
    if (value && !IsWithin(measure, *value)) {
      throw std::invalid_argument(std::string(measure.name) + " " + NumberText(*value) +
                                  ": not within " + NumberText(measure.smallest) + " to " +
                                  NumberText(measure.largest) + " " + std::string(measure.unit) +
                                  ". " + Advice(measure, *value));
    }
  }
}

double JugularNotchHeight_m(double stature_m) noexcept { return kJugularNotchShare * stature_m; }

SegmentScales ScalesOf(const Anatomy& anatomy, const Anatomy& adult) noexcept {
  const auto ratio = [&](Landmark landmark) {
    return glm::length(anatomy.landmark_m(landmark)) / glm::length(adult.landmark_m(landmark));
  };
  return {AroundTheThorax_m(anatomy) / AroundTheThorax_m(adult), ratio(Landmark::kPAC),
          ratio(Landmark::kTS), glm::length(anatomy.elbow_m()) / glm::length(adult.elbow_m())};
}

void GrowTissues(const Anatomy& adult, const SegmentScales& scales, Anatomy& anatomy) noexcept {
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const double scale = scales[i];
    // m ~ L^3, I ~ m L^2.
    const double mass_scale = scale * scale * scale;
    anatomy.segments[i].mass_kg = mass_scale * adult.segments[i].mass_kg;
    anatomy.segments[i].center_of_mass_m = scale * adult.segments[i].center_of_mass_m;
    anatomy.segments[i].inertia_kg_m2 =
        mass_scale * scale * scale * adult.segments[i].inertia_kg_m2;
  }
  const double thorax_scale = scales[static_cast<std::size_t>(Segment::kThorax)];
  anatomy.ribcage = adult.ribcage;
  anatomy.gliding = adult.gliding;
  ScaleEllipsoid(thorax_scale, anatomy.ribcage);
  ScaleEllipsoid(thorax_scale, anatomy.gliding);
  const double clavicle_scale = scales[static_cast<std::size_t>(Segment::kClavicle)];
  const double scapula_scale = scales[static_cast<std::size_t>(Segment::kScapula)];
  anatomy.ligaments = adult.ligaments;
  for (Ligament& ligament : anatomy.ligaments) {
    ligament.clavicle_m *= clavicle_scale;
    ligament.scapula_m *= scapula_scale;
    const double scale = (clavicle_scale + scapula_scale) / 2;
    ligament.slack_m *= scale;
    ligament.failure_elongation_m *= scale;
  }
}

Anatomy ScaledAnatomy(const Anatomy& anatomy, const BodySize& size) {
  CheckBodySize(size);
  const double stature_scale = size.stature_m.value_or(kAdultStature_m) / kAdultStature_m;
  const auto own_scale = [&](const std::optional<double>& length_m, double adult_length_m) {
    return length_m ? *length_m / adult_length_m : stature_scale;
  };
  const SegmentScales scales = {
      stature_scale,
      own_scale(size.clavicle_length_m, glm::length(anatomy.landmark_m(Landmark::kPAC))),
      own_scale(size.scapula_length_m, glm::length(anatomy.landmark_m(Landmark::kTS))),
      own_scale(size.humerus_length_m, glm::length(anatomy.elbow_m()))};
  Anatomy scaled = anatomy;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    scaled.landmarks_m[i] *= scales[static_cast<std::size_t>(kLandmarks[i].segment)];
  }
  GrowTissues(anatomy, scales, scaled);
  if (size.stature_m) {
    scaled.jugular_notch_height_m = JugularNotchHeight_m(*size.stature_m);
  }
  // A longer humerus changes nothing here, because the humerus does not touch the thorax.
  if (size.clavicle_length_m || size.scapula_length_m) {
    scaled.has_adult_proportions = false;
  }
  return size.body_mass_kg ? WithBodyMass(scaled, anatomy, *size.body_mass_kg) : scaled;
}

Anatomy WithBodyMass(Anatomy anatomy, const Anatomy& adult, double body_mass_kg) {
  const double adult_mass_kg = adult.segment(Segment::kHumerus).mass_kg / kHumerusShareOfBodyMass;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    SegmentInertia& segment = anatomy.segments[i];
    const double mass_kg = adult.segments[i].mass_kg * (body_mass_kg / adult_mass_kg);
    segment.inertia_kg_m2 *= mass_kg / segment.mass_kg;
    segment.mass_kg = mass_kg;
  }
  return anatomy;
}

}  // namespace girdle
