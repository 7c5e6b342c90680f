// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/scene.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "mjcf/parsed_xml.h"
#include "tables/body_size.h"
#include "tables/built_in.h"

namespace girdle {
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
}  // namespace girdle
