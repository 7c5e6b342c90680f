// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/isb_frames.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <ostream>

#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"

namespace girdle {
namespace {

// A few dozen roundings, of landmarks up to ten times as far off as they are apart.
constexpr double kRounding = 1e-13;

// A rigid placement in any unit of length.
struct Placement {
  Quaternion q_AB;
  Vector3 p_AB;
  double scale;

  [[nodiscard]] Vector3 operator()(const Vector3& p_BL) const {
    return p_AB + scale * (q_AB * p_BL);
  }
};

rc::Gen<Placement> AnyPlacement() {
  return rc::gen::exec([] {
    return Placement{*UnitQuaternion(), *VectorWithin(-1, 1), *NumberWithin(0.5, 2)};
  });
}

void showValue(const Placement& placement, std::ostream& out) {
  out << "turned by ";
  showValue(placement.q_AB, out);
  out << ", moved by ";
  showValue(placement.p_AB, out);
  out << ", scaled by " << placement.scale;
}

// Landmarks in the bone's own frame, as the definitions place them.
struct ScapulaLandmarks {
  Vector3 pac;
  Vector3 ts;
  Vector3 ai;
};

struct HumerusLandmarks {
  Vector3 gh;
  Vector3 em;
  Vector3 el;
};

// Origin PAC, TS on -z, AI below in the y-z plane.
ScapulaLandmarks AnyScapula() {
  const double spine_m = *NumberWithin(0.1, 0.15);
  return {{0, 0, 0},
          {0, 0, -spine_m},
          {0, -*NumberWithin(0.1, 0.15), -spine_m + *NumberWithin(-0.03, 0.03)}};
}

// Origin GH, the epicondyles in the y-z plane with their middle on -y, EL to the right of EM.
HumerusLandmarks AnyHumerus() {
  const double length_m = *NumberWithin(0.25, 0.35);
  const double half_width_m = *NumberWithin(0.02, 0.04);
  const double tilt_m = *NumberWithin(-0.01, 0.01);
  return {{0, 0, 0}, {0, -length_m - tilt_m, -half_width_m}, {0, -length_m + tilt_m, half_width_m}};
}

RC_GTEST_PROP(ScapulaFrame, IsTheRotationThatPlacedTheLandmarks, ()) {
  const ScapulaLandmarks bone = AnyScapula();
  const Placement placed = *AnyPlacement();
  RC_ASSERT(AngleBetween(ScapulaFrame(placed(bone.pac), placed(bone.ts), placed(bone.ai)),
                         placed.q_AB) < kRounding);
}

RC_GTEST_PROP(HumerusFrame, IsTheRotationThatPlacedTheLandmarks, ()) {
  const HumerusLandmarks bone = AnyHumerus();
  const Placement placed = *AnyPlacement();
  RC_ASSERT(AngleBetween(HumerusFrame(placed(bone.gh), placed(bone.em), placed(bone.el)),
                         placed.q_AB) < kRounding);
}

RC_GTEST_PROP(ClavicleAxis, IsTheUnitVectorFromScToPac, ()) {
  const double length_m = *NumberWithin(0.1, 0.2);
  const Placement placed = *AnyPlacement();
  const Vector3 axis = ClavicleAxis(placed({0, 0, 0}), placed({0, 0, length_m}));
  RC_ASSERT(glm::length(axis - placed.q_AB * Vector3(0, 0, 1)) < kRounding);
}

// The humerus's z is parallel to EM-EL only where the epicondyles stand level; its y always points
// to GH.
RC_GTEST_PROP(HumerusFrame, HasItsLongAxisThroughTheMiddleOfTheElbow, ()) {
  const Vector3 gh = *VectorWithin(-1, 1);
  const Vector3 em = *VectorWithin(-1, 1);
  const Vector3 el = *VectorWithin(-1, 1);
  const Vector3 shaft = gh - (em + el) / 2.0;
  RC_PRE(glm::length(glm::cross(shaft, el - em)) > 0.01);
  RC_ASSERT(glm::length(HumerusFrame(gh, em, el) * Vector3(0, 1, 0) - glm::normalize(shaft)) <
            kRounding);
}

RC_GTEST_PROP(ScapulaFrame, HasItsForwardAxisPerpendicularToTheBlade, ()) {
  const Vector3 pac = *VectorWithin(-1, 1);
  const Vector3 ts = *VectorWithin(-1, 1);
  const Vector3 ai = *VectorWithin(-1, 1);
  RC_PRE(glm::length(glm::cross(pac - ts, ai - ts)) > 0.01);
  const Vector3 x = ScapulaFrame(pac, ts, ai) * Vector3(1, 0, 0);
  RC_ASSERT(std::abs(glm::dot(x, pac - ts)) < kRounding);
  RC_ASSERT(std::abs(glm::dot(x, ai - ts)) < kRounding);
}

TEST(ScapulaFrame, OfTheShippedLandmarksIsTheirOwnFrame) {
  const auto landmarks_m = ShippedLandmarks();
  const Vector3 pac{0, 0, 0};  // the scapula's origin
  EXPECT_LT(AngleBetween(ScapulaFrame(pac, landmarks_m.at("TS"), landmarks_m.at("AI")),
                         Quaternion(1, 0, 0, 0)),
            kRounding);
}

TEST(HumerusFrame, OfTheShippedLandmarksIsTheirOwnFrame) {
  const auto landmarks_m = ShippedLandmarks();
  const Vector3 gh{0, 0, 0};  // the humerus's origin
  EXPECT_LT(AngleBetween(HumerusFrame(gh, landmarks_m.at("EM"), landmarks_m.at("EL")),
                         Quaternion(1, 0, 0, 0)),
            kRounding);
}

TEST(ClavicleAxis, OfTheShippedLandmarksIsZ) {
  const Vector3 sc{0, 0, 0};  // the clavicle's origin
  EXPECT_LT(glm::length(ClavicleAxis(sc, ShippedLandmarks().at("PAC")) - Vector3(0, 0, 1)),
            kRounding);
}

TEST(ScapulaFrame, OfLandmarksOnALineIsNotFinite) {
  EXPECT_FALSE(std::isfinite(glm::length(ScapulaFrame({0, 0, 0}, {0, 0, -1}, {0, 0, -2}))));
}

TEST(HumerusFrame, OfLandmarksOnALineIsNotFinite) {
  EXPECT_FALSE(std::isfinite(glm::length(HumerusFrame({0, 0, 0}, {0, -1, 0}, {0, -2, 0}))));
}

}  // namespace
}  // namespace girdle
