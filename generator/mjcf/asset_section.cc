// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <array>
#include <string>
#include <utility>

#include "anatomy/triangle_mesh.h"
#include "kinematics/lengths.h"
#include "mjcf/bone_meshes.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr double kLandmarkRadius_m = 0.004;
constexpr double kLigamentRadius_m = 0.002;

TriangleMesh MeshOnSide(Side side, TriangleMesh mesh) {
  if (side == Side::kLeft) {
    for (Vector3& vertex : mesh.vertices_m) {
      vertex = Mirrored(vertex);
    }
    for (std::array<int, 3>& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return mesh;
}

void WriteMesh(XmlElement asset, const std::string& name, const TriangleMesh& mesh) {
  std::string vertices;
  for (const Vector3& vertex : mesh.vertices_m) {
    for (const double coordinate : {vertex.x, vertex.y, vertex.z}) {
      vertices += (vertices.empty() ? "" : " ") + RoundedText(coordinate, kLengthDecimals);
    }
  }
  std::string faces;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      faces += (faces.empty() ? "" : " ") + std::to_string(vertex);
    }
  }
  asset.Add("mesh")
      .Set("name", name)
      .Set("class", kDefaultsName)
      .Set("vertex", vertices)
      .Set("face", faces);
}

// An element has a limit if it has a range of its own.
constexpr const char* kAsRange = "auto";
constexpr std::array kNone = {0.0, 0.0};
// MuJoCo's own defaults.
constexpr std::array kLimitSolref = {0.02, 1.0};
constexpr std::array kLimitSolimp = {0.9, 0.95, 0.001, 0.5, 2.0};

// MuJoCo keeps one set of defaults for actuators of all kinds.
void WriteActuatorDefaults(const ModelPlan& plan, XmlElement girdle) {
  if (!plan.has_plugin()) {
    girdle.Add("position").Set("inheritrange", 0);
  }
  XmlElement general = girdle.Add("general");
  general.Set("gear", std::array{1.0, 0.0, 0.0, 0.0, 0.0, 0.0})
      .Set("dyntype", "none")
      .Set("dynprm", 1)
      .Set("gainprm", std::array{1.0, 0.0, 0.0})
      .Set("biasprm", std::array{0.0, 0.0, 0.0})
      .Set("ctrlrange", kNone)
      .Set("ctrllimited", kAsRange)
      .Set("actrange", kNone)
      .Set("actlimited", kAsRange)
      .Set("forcerange", kNone)
      .Set("forcelimited", kAsRange);
  if (plan.has_plugin()) {
    general.Set("gaintype", "fixed").Set("biastype", "none");
  }
}

}  // namespace

// Writes Girdle's defaults. A model that includes this one has defaults of its own, and they apply
// to all attributes that are given neither here nor at the element itself. Attributes that only
// some of the supported versions of MuJoCo know cannot be given: armature, damping and delay of
// actuators, and damping and stiffness as curves.
void WriteDefaults(const ModelPlan& plan, XmlElement root) {
  constexpr Vector3 kOrigin{0, 0, 0};
  constexpr Quaternion kUnturned{1, 0, 0, 0};
  XmlElement girdle = root.Add("default").Add("default").Set("class", kDefaultsName);
  girdle.Add("mesh").Set("scale", Vector3{1, 1, 1});
  girdle.Add("joint")
      .Set("type", "hinge")
      .Set("pos", kOrigin)
      .Set("stiffness", 0)
      .Set("springdamper", std::array{0.0, 0.0})
      .Set("frictionloss", 0)
      .Set("margin", 0)
      .Set("solreflimit", kLimitSolref)
      .Set("solimplimit", kLimitSolimp)
      .Set("range", kNone)
      .Set("limited", kAsRange)
      .Set("actuatorfrcrange", kNone)
      .Set("actuatorfrclimited", kAsRange);
  // Bones are only drawn: they do not collide and have no mass.
  girdle.Add("geom")
      .Set("pos", kOrigin)
      .Set("quat", kUnturned)
      .Set("contype", 0)
      .Set("conaffinity", 0)
      .Set("group", 1)
      .Set("mass", 0)
      .Set("material", "bone");
  girdle.Add("site")
      .Set("pos", kOrigin)
      .Set("quat", kUnturned)
      .Set("size", kLandmarkRadius_m)
      .Set("group", 3)
      .Set("rgba", std::array{0.85, 0.25, 0.1, 1.0});
  girdle.Add("tendon")
      .Set("limited", kAsRange)
      .Set("solreflimit", kLimitSolref)
      .Set("solimplimit", kLimitSolimp)
      .Set("damping", 0)
      .Set("frictionloss", 0)
      .Set("margin", 0)
      .Set("width", kLigamentRadius_m)
      .Set("group", 2)
      .Set("rgba", std::array{0.93, 0.93, 0.88, 1.0});
  if (plan.is_loop()) {
    girdle.Add("equality").Set("active", "true");
  }
  if (plan.options.has_thorax_contact) {
    girdle.Add("pair").Set("margin", 0).Set("gap", 0);
  }
  WriteActuatorDefaults(plan, girdle);
}

void WriteAssets(const ModelPlan& plan, XmlElement root) {
  XmlElement asset = root.Add("asset");
  asset.Add("material").Set("name", "bone").Set("rgba", std::array{0.89, 0.85, 0.76, 1.0});
  asset.Add("material").Set("name", "rib").Set("rgba", std::array{0.75, 0.77, 0.8, 1.0});
  WriteMesh(asset, "ribcage", RibcageMesh(plan.anatomy));
  for (const Side side : plan.sides) {
    WriteMesh(asset, SidedName("clavicle", side), MeshOnSide(side, ClavicleMesh(plan.anatomy)));
    WriteMesh(asset, SidedName("scapula", side), MeshOnSide(side, ScapulaMesh(plan.anatomy)));
    WriteMesh(asset, SidedName("humerus", side), MeshOnSide(side, HumerusMesh(plan.anatomy)));
  }
}

}  // namespace girdle
