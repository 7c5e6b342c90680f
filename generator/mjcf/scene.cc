// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/scene.h"

#include <array>
#include <glm/geometric.hpp>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/lengths.h"
#include "mjcf/xml_element.h"

namespace girdle {
namespace {

// The point that the cameras are aimed at, in the world [m]: the middle of the thorax and of all
// that the arm of the built-in anatomy reaches, hanging, raised and to the side. For another
// person, distances from it scale with the reach of that person's arm.
const Vector3 kCenter_m{-0.05, -0.17, 1.4};
constexpr double kExtent_m = 0.7;
constexpr double kCameraDistance_m = 1.0;
// Both shoulders are wider than one by this factor; hands that are raised are higher than wide.
constexpr double kBothSides = 1.25;
constexpr double kBothSidesWithHands = 1.15;
// Forearms and hands of a skin reach farther than elbows by this factor.
constexpr double kWithHands = 1.5;
// Raised hands are farther above that point than a waist is below it.
constexpr double kRaisedForHands_m = 0.14;

// Returns the length of the bones from the thorax's origin to the elbow.
double Reach_m(const Anatomy& anatomy) {
  return glm::length(anatomy.landmark_m(Landmark::kSC)) +
         glm::length(anatomy.landmark_m(Landmark::kPAC)) +
         glm::length(anatomy.landmark_m(Landmark::kGH)) + glm::length(anatomy.elbow_m());
}

// The part of the world that the cameras show.
struct View {
  Vector3 center_m;
  double scale;  ///< of extent and distance
};

View ViewOf(const Anatomy& anatomy, Sides sides, bool has_skin) {
  const Anatomy adult = BuiltInAnatomy();
  const double size = Reach_m(anatomy) / Reach_m(adult);
  const double scale = has_skin ? size * kWithHands : size;
  const Vector3 notch_m{0, 0, adult.jugular_notch_height_m};
  const Vector3 raised_m{0, 0, anatomy.jugular_notch_height_m - adult.jugular_notch_height_m};
  const Vector3 for_hands_m{0, 0, has_skin ? size * kRaisedForHands_m : 0};
  const Vector3 center_m = kCenter_m + raised_m + for_hands_m + (size - 1) * (kCenter_m - notch_m);
  switch (sides) {
    case Sides::kRight:
      return {center_m, scale};
    case Sides::kLeft:
      return {{center_m.x, -center_m.y, center_m.z}, scale};
    case Sides::kBoth:
      break;
  }
  return {{center_m.x, 0, center_m.z}, scale * (has_skin ? kBothSidesWithHands : kBothSides)};
}

void WriteCamera(XmlElement& world, const View& view, const char* name, const Vector3& direction,
                 const std::array<double, 6>& xyaxes) {
  world.Add("camera")
      .Set("name", name)
      .Set("pos", RoundedPlace_m(view.center_m + view.scale * kCameraDistance_m * direction))
      .Set("xyaxes", xyaxes);
}

}  // namespace

std::string SceneXml(const std::string& model_file, const Anatomy& anatomy, Sides sides,
                     bool has_skin) {
  const View view = ViewOf(anatomy, sides, has_skin);
  XmlFile file("mujoco");
  XmlElement root = file.root();
  root.Set("model", "girdle scene");
  root.Add("include").Set("file", model_file);
  root.Add("statistic")
      .Set("center", RoundedPlace_m(view.center_m))
      .Set("extent", RoundedLength_m(view.scale * kExtent_m));
  XmlElement visual = root.Add("visual");
  visual.Add("headlight")
      .Set("diffuse", std::array{0.4, 0.4, 0.4})
      .Set("ambient", std::array{0.38, 0.38, 0.38})
      .Set("specular", std::array{0.0, 0.0, 0.0});
  // A viewer starts with a view of the arm from its own side and from the front.
  visual.Add("global").Set("azimuth", sides == Sides::kLeft ? 215 : 145).Set("elevation", -15);
  XmlElement asset = root.Add("asset");
  asset.Add("texture")
      .Set("type", "skybox")
      .Set("builtin", "flat")
      .Set("rgb1", std::array{0.93, 0.94, 0.95})
      .Set("rgb2", std::array{0.93, 0.94, 0.95})
      .Set("width", 64)
      .Set("height", 384);
  asset.Add("texture")
      .Set("name", "floor")
      .Set("type", "2d")
      .Set("builtin", "checker")
      .Set("rgb1", std::array{0.84, 0.85, 0.86})
      .Set("rgb2", std::array{0.8, 0.81, 0.82})
      .Set("width", 256)
      .Set("height", 256);
  asset.Add("material")
      .Set("name", "floor")
      .Set("texture", "floor")
      .Set("texuniform", "true")
      .Set("texrepeat", std::array{2.0, 2.0})
      .Set("specular", 0.0);
  XmlElement world = root.Add("worldbody");
  // A light from above and in front. It is directional, so that the ground is equally bright
  // everywhere. Lights cast no shadows: MuJoCo's shadows speckle skin and ground, and a thorax
  // without legs has a shadow that explains nothing.
  world.Add("light")
      .Set("directional", "true")
      .Set("pos", Vector3{1.5, -1.0, 3.0})
      .Set("dir", Vector3{-0.6, 0.3, -0.7})
      .Set("diffuse", std::array{0.45, 0.45, 0.45})
      .Set("castshadow", "false");
  // A light for the back, where the scapula is.
  world.Add("light")
      .Set("directional", "true")
      .Set("pos", Vector3{-1.5, 1.2, 2.6})
      .Set("dir", Vector3{0.6, -0.5, -0.6})
      .Set("diffuse", std::array{0.3, 0.3, 0.3})
      .Set("castshadow", "false");
  // Ground to stand on. It has an end, because an endless plane has a horizon that cuts a picture
  // in half.
  constexpr double kGround_m = 1.5;
  world.Add("geom")
      .Set("name", "floor")
      .Set("type", "plane")
      .Set("size", Vector3{kGround_m, kGround_m, 0.05})
      .Set("material", "floor");
  // A camera looks along its -z; the first three numbers are its x (right), the others its y (up).
  WriteCamera(world, view, "front", {1, 0, 0}, {0, 1, 0, 0, 0, 1});
  WriteCamera(world, view, "back", {-1, 0, 0}, {0, -1, 0, 0, 0, 1});
  WriteCamera(world, view, "above", {0, 0, 1}, {0, -1, 0, 1, 0, 0});
  if (sides == Sides::kLeft) {
    WriteCamera(world, view, "oblique", {0.6, 0.64, 0.48},
                {-0.7295, 0.684, 0, -0.3283, -0.3502, 0.8773});
  } else {
    WriteCamera(world, view, "oblique", {0.6, -0.64, 0.48},
                {0.7295, 0.684, 0, -0.3283, 0.3502, 0.8773});
  }
  return file.Text();
}

}  // namespace girdle
