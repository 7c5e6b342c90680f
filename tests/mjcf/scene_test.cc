// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "mjcf/parsed_xml.h"

namespace girdle::scene_test {
namespace {

const ParsedXml& Scene() {
  static const ParsedXml kScene(SceneXml("shoulder.xml", BuiltInAnatomy()));
  return kScene;
}

struct Camera {
  const char* name;
  Vector3 from;  // unit vector from the middle of the scene to the camera; x front, z up
};

void PrintTo(const Camera& camera, std::ostream* out) { *out << camera.name; }

class SceneCamera : public testing::TestWithParam<Camera> {
 protected:
  static const tinyxml2::XMLElement& Element() { return Scene().Named("camera", GetParam().name); }
  // The camera's x, to the right of its picture, and y, upward.
  static Vector3 X() {
    const auto axes = NumbersOf(Element(), "xyaxes");
    return {axes.at(0), axes.at(1), axes.at(2)};
  }
  static Vector3 Y() {
    const auto axes = NumbersOf(Element(), "xyaxes");
    return {axes.at(3), axes.at(4), axes.at(5)};
  }
};

// Axes are written to four decimals.
constexpr double kPrinted = 2e-4;

TEST_P(SceneCamera, HasUnitAxesAtRightAngles) {
  EXPECT_NEAR(glm::length(X()), 1, kPrinted);
  EXPECT_NEAR(glm::length(Y()), 1, kPrinted);
  EXPECT_NEAR(glm::dot(X(), Y()), 0, kPrinted);
}

TEST_P(SceneCamera, StandsWhereItsNameSays) {
  const Vector3 from_middle =
      VectorIn(Element(), "pos") - VectorIn(Scene().Child("statistic"), "center");
  EXPECT_LT(glm::length(glm::normalize(from_middle) - GetParam().from), kPrinted);
}

// A camera looks along its -z.
TEST_P(SceneCamera, LooksAtTheMiddle) {
  const Vector3 to_middle =
      VectorIn(Scene().Child("statistic"), "center") - VectorIn(Element(), "pos");
  EXPECT_LT(glm::length(glm::cross(X(), Y()) + glm::normalize(to_middle)), 2 * kPrinted);
}

TEST_P(SceneCamera, HasItsPictureUpright) {
  EXPECT_NEAR(X().z, 0, kPrinted) << "the horizon is level";
  EXPECT_GE(Y().z, 0);
}

INSTANTIATE_TEST_SUITE_P(Names, SceneCamera,
                         testing::Values(Camera{"front", {1, 0, 0}}, Camera{"back", {-1, 0, 0}},
                                         Camera{"above", {0, 0, 1}},
                                         Camera{"oblique", {0.6, -0.64, 0.48}}));

TEST(Scene, OfALeftShoulderIsSeenFromTheMirroredPlaces) {
  const ParsedXml left(SceneXml("shoulder.xml", BuiltInAnatomy(), Sides::kLeft));
  const auto mirrored = [](const Vector3& p) { return Vector3{p.x, -p.y, p.z}; };
  EXPECT_EQ(VectorIn(left.Child("statistic"), "center"),
            mirrored(VectorIn(Scene().Child("statistic"), "center")));
  for (const char* name : {"front", "back", "above", "oblique"}) {
    EXPECT_EQ(VectorIn(left.Named("camera", name), "pos"),
              mirrored(VectorIn(Scene().Named("camera", name), "pos")))
        << name;
  }
}

// The horizon's direction turns round as well where a camera stands to the side.
TEST(Scene, OfALeftShoulderHasItsObliquePictureUprightAndOfTheMiddle) {
  const ParsedXml left(SceneXml("shoulder.xml", BuiltInAnatomy(), Sides::kLeft));
  const auto& camera = left.Named("camera", "oblique");
  const auto axes = NumbersOf(camera, "xyaxes");
  const Vector3 x{axes.at(0), axes.at(1), axes.at(2)};
  const Vector3 y{axes.at(3), axes.at(4), axes.at(5)};
  const Vector3 to_middle = VectorIn(left.Child("statistic"), "center") - VectorIn(camera, "pos");
  EXPECT_LT(glm::length(glm::cross(x, y) + glm::normalize(to_middle)), 2 * kPrinted);
  EXPECT_NEAR(x.z, 0, kPrinted);
  EXPECT_GE(y.z, 0);
}

// --- Other people ---------------------------------------------------------------------------

struct Person {
  const char* name;
  BodySize size;
};

void PrintTo(const Person& person, std::ostream* out) { *out << person.name; }

// The bones from the notch to the elbow of an arm held sideways or hanging, in the world.
std::vector<Vector3> Silhouette_m(const Anatomy& anatomy) {
  const Vector3 notch_m{0, 0, anatomy.jugular_notch_height_m};
  const double girdle_m = glm::length(anatomy.landmark_m(Landmark::kSC)) +
                          glm::length(anatomy.landmark_m(Landmark::kPAC));
  const Vector3 shoulder_m = notch_m - Vector3(0, girdle_m, 0);
  const double arm_m = glm::length(anatomy.elbow_m());
  return {notch_m, shoulder_m, shoulder_m - Vector3(0, arm_m, 0),
          shoulder_m - Vector3(0, 0, arm_m)};
}

// Tangent of half of MuJoCo's default vertical field of view, 45 deg.
constexpr double kHalfPicture = 0.41421356;

// Half the picture's height that the bones take up, seen by the camera `front`: 1 is its edge.
double ShareOfPicture(const BodySize& size) {
  const Anatomy anatomy = ScaledAnatomy(BuiltInAnatomy(), size);
  const ParsedXml scene(SceneXml("shoulder.xml", anatomy));
  const Vector3 camera_m = VectorIn(scene.Named("camera", "front"), "pos");
  double largest = 0;
  for (const Vector3& point_m : Silhouette_m(anatomy)) {
    const Vector3 off_m = point_m - camera_m;
    largest = std::max({largest, std::abs(off_m.y / off_m.x) / kHalfPicture,
                        std::abs(off_m.z / off_m.x) / kHalfPicture});
  }
  return largest;
}

TEST(Scene, WithASkinShowsItsHands) {
  constexpr double kHandsBeyondElbows = 1.25;
  const ParsedXml bare(SceneXml("shoulder.xml", BuiltInAnatomy()));
  const ParsedXml dressed(SceneXml("shoulder.xml", BuiltInAnatomy(), Sides::kRight, true));
  for (const char* name : {"front", "back", "above", "oblique"}) {
    const Vector3 center_m = VectorIn(bare.Child("statistic"), "center");
    const auto distance_m = [&](const ParsedXml& scene) {
      return glm::length(VectorIn(scene.Named("camera", name), "pos") - center_m);
    };
    EXPECT_GT(distance_m(dressed), kHandsBeyondElbows * distance_m(bare)) << name;
  }
}

class SceneOf : public testing::TestWithParam<Person> {};

// As much of the picture as the built-in shoulder, give or take another shape.
TEST_P(SceneOf, FillsThePictureWithThePerson) {
  constexpr double kOtherShape = 0.1;
  const double share = ShareOfPicture(GetParam().size);
  EXPECT_LT(share, 1);
  EXPECT_NEAR(share, ShareOfPicture({}), kOtherShape);
}

TEST_P(SceneOf, LooksAtThePerson) {
  const Anatomy anatomy = ScaledAnatomy(BuiltInAnatomy(), GetParam().size);
  const ParsedXml scene(SceneXml("shoulder.xml", anatomy));
  const double center_m = VectorIn(scene.Child("statistic"), "center").z;
  EXPECT_LT(center_m, anatomy.jugular_notch_height_m);
  EXPECT_GT(center_m, anatomy.jugular_notch_height_m - glm::length(anatomy.elbow_m()));
}

INSTANTIATE_TEST_SUITE_P(Sizes, SceneOf,
                         testing::Values(Person{"child", {.stature_m = 1.1}},
                                         Person{"tall", {.stature_m = 2.1}},
                                         Person{"long arm", {.humerus_length_m = 0.38}},
                                         Person{"narrow", {.clavicle_length_m = 0.12}}));

TEST(Scene, IncludesTheModel) {
  EXPECT_EQ(TextOf(Scene().Child("include"), "file"), "shoulder.xml");
}

TEST(Scene, HasAFloorAndALight) {
  EXPECT_EQ(TextOf(Scene().Named("geom", "floor"), "type"), "plane");
  EXPECT_FALSE(Scene().All("light").empty());
}

TEST(Scene, PaintsTheFloorWithATextureThatIsThere) {
  const std::string material = TextOf(Scene().Named("geom", "floor"), "material");
  const std::string texture = TextOf(Scene().Named("material", material), "texture");
  EXPECT_EQ(TextOf(Scene().Named("texture", texture), "type"), "2d");
}

TEST(Scene, HasNoNumberThatIsNotFiniteOrIsMinusZero) {
  EXPECT_EQ(BadNumbers(Scene()), std::vector<std::string>());
}

}  // namespace
}  // namespace girdle::scene_test
