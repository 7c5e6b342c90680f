// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/found_gh.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "anatomy/humeral_head.h"
#include "kinematics/lengths.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// A humeral head has a radius of about 24 mm (Iannotti et al., J Bone Joint Surg Am
// 1992;74:491-500). A child's head has a third of it, and no head has twice as much.
constexpr double kSmallestHead_m = 0.008;
constexpr double kLargestHead_m = 0.048;
// Number of points that determine a sphere.
constexpr std::size_t kSphereParameters = 4;

// Fits a sphere to points of the humeral head. Returns a text on how well it fits.
std::string PutGhIntoHead(MeasuredLandmarks& measured) {
  FittedSphere sphere;
  try {
    sphere = SphereThrough(measured.head_points_m());
  } catch (const std::invalid_argument& error) {
    measured.FailAtHead(error.what());
  }
  if (sphere.radius_m < kSmallestHead_m || sphere.radius_m > kLargestHead_m) {
    measured.FailAtHead("the sphere through them has a radius of " +
                        MillimeterText(sphere.radius_m) + ", expected " +
                        MillimeterText(kSmallestHead_m) + " to " + MillimeterText(kLargestHead_m) +
                        ". Give points of the humeral head, in meters");
  }
  measured.AddGh(sphere.center_m);
  const std::size_t count = measured.head_points_m().size();
  return "the centre of the sphere through " + std::to_string(count) +
         " points of the humeral head, with a radius of " +
         RoundedText(kMillimetersPerMeter * sphere.radius_m, 1) + " mm; the points lie " +
         RoundedText(kMillimetersPerMeter * sphere.residual_m, 2) + " mm off it (root mean square" +
         (count == kSphereParameters ? ", and always 0 for four points" : "") +
         "); an error of 1 mm in the points moves the centre by " +
         RoundedText(sphere.magnification, 1) + " mm";
}

}  // namespace

std::string FindGh(MeasuredLandmarks& measured, const Anatomy& adult) {
  if (measured.Has(Landmark::kGH)) {
    return "";
  }
  if (!measured.head_points_m().empty()) {
    return PutGhIntoHead(measured);
  }
  const auto at = [&](Landmark landmark) { return measured.In_m(Segment::kScapula, landmark); };
  measured.AddGh(EstimatedGh_m(at(Landmark::kPC), at(Landmark::kPAC), at(Landmark::kAA),
                               at(Landmark::kTS), at(Landmark::kAI)));
  const Vector3 of_adult_m =
      EstimatedGh_m(adult.landmark_m(Landmark::kPC), {0, 0, 0}, adult.landmark_m(Landmark::kAA),
                    adult.landmark_m(Landmark::kTS), adult.landmark_m(Landmark::kAI));
  const auto error_text = [](double length_m) {
    return RoundedText(kMillimetersPerMeter * length_m, 1);
  };
  return "estimated from PC, AC, AA, TS and AI (" + std::string(kGhRegression) +
         "), with a root mean square error of " + error_text(kGhRegressionError_m[0]) +
         " mm to the side, " + error_text(kGhRegressionError_m[1]) + " mm up and " +
         error_text(kGhRegressionError_m[2]) +
         " mm forward on bare bones, and more on landmarks felt through skin; it misses GH of the "
         "built-in bones by " +
         MillimeterText(glm::distance(of_adult_m, adult.landmark_m(Landmark::kGH))) +
         ". Points of the humeral head, HH1 HH2 ..., would tell GH";
}

}  // namespace girdle
