// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Shoulders that are put into a pose, as MuJoCo sees their bones.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "simulation/model_skin.h"
#include "simulation/plugin_fixture.h"
#include "simulation/shoulder_simulation.h"

namespace girdle::posed_shoulder_test {
namespace {

// Hinges, quaternions and a chain of bodies, each rounded a few times.
constexpr double kRounding_rad = 1e-12;
// Skins have their quaternions in single precision.
constexpr double kSingle_rad = 1e-6;

double FarthestJoint_rad(const ShoulderPose& a, const ShoulderPose& b) {
  return std::max(
      {AngleBetween(a.q_TC, b.q_TC), AngleBetween(a.q_CS, b.q_CS), AngleBetween(a.q_SH, b.q_SH)});
}

const ShoulderPose kAbducted = BuiltInRhythm().SolvePose({1.9, 0.1});
const ShoulderPose kFlexed = BuiltInRhythm().SolvePose({1.2, 1.5});

struct Variant {
  std::string name;
  ShoulderModelOptions options;
};
std::ostream& operator<<(std::ostream& out, const Variant& variant) { return out << variant.name; }

class PosedShoulderTest : public EngineTest, public testing::WithParamInterface<Variant> {
 protected:
  static ShoulderSimulation Simulation(const ShoulderModelOptions& options) {
    return {LoadedModel(ShoulderXml(options)), "shoulder.xml"};
  }
};

TEST_P(PosedShoulderTest, HasItsBonesInThePose) {
  ShoulderSimulation simulation = Simulation(GetParam().options);
  for (const ShoulderElements& shoulder : simulation.shoulders()) {
    for (const ShoulderPose& pose : {kAbducted, kFlexed, FrozenGirdle(kFlexed, kAbducted)}) {
      simulation.PutAt(shoulder, pose);
      EXPECT_LT(FarthestJoint_rad(simulation.PoseOf(shoulder), pose), kRounding_rad);
    }
  }
}

TEST_P(PosedShoulderTest, HasItsJointsTogether) {
  ShoulderSimulation simulation = Simulation(GetParam().options);
  for (const ShoulderElements& shoulder : simulation.shoulders()) {
    simulation.PutAt(shoulder, kFlexed);
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      const auto site_m = [&](std::string_view stem) {
        const int id =
            mj_name2id(&simulation.model(), mjOBJ_SITE, SidedName(stem, shoulder.side).c_str());
        const mjtNum* const p = simulation.data().site_xpos + 3 * id;
        return Vector3{p[0], p[1], p[2]};
      };
      EXPECT_LT(glm::length(site_m(kJointSites[joint].parent) - site_m(kJointSites[joint].child)),
                1e-12)
          << kJointNames[joint];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, PosedShoulderTest,
    testing::Values(Variant{"right", {}}, Variant{"left", {.sides = Sides::kLeft}},
                    Variant{"both", {.sides = Sides::kBoth}},
                    Variant{"loop", {.assembly = Assembly::kLoop}},
                    Variant{"left_loop", {.sides = Sides::kLeft, .assembly = Assembly::kLoop}}),
    [](const auto& tested) { return tested.param.name; });

class OneOfTwoTest : public EngineTest {};

TEST_F(OneOfTwoTest, IsPosedWithoutMovingTheOther) {
  ShoulderSimulation simulation(LoadedModel(ShoulderXml({.sides = Sides::kBoth})), "both.xml");
  const auto& shoulders = simulation.shoulders();
  simulation.PutAt(shoulders[0], kAbducted);
  simulation.PutAt(shoulders[1], kFlexed);
  EXPECT_LT(FarthestJoint_rad(simulation.PoseOf(shoulders[0]), kAbducted), kRounding_rad);
  EXPECT_LT(FarthestJoint_rad(simulation.PoseOf(shoulders[1]), kFlexed), kRounding_rad);
}

// ---------------------------------------------------------------------------- Where skin is bound

class BindPoseTest : public EngineTest {
 protected:
  // A triangle bound to each of some bones where they are with the shoulder in a pose.
  static std::string SkinnedXml(Sides sides, const ShoulderPose& pose, std::size_t bones) {
    const std::string xml = ShoulderXml({.sides = sides});
    ShoulderSimulation simulation(LoadedModel(xml), "shoulder.xml");
    const ShoulderElements shoulder = simulation.shoulders().back();
    simulation.PutAt(shoulder, pose);
    std::ostringstream skin;
    skin << "<deformable><skin name=\"skin\" vertex=\"0 0 0 1 0 0 0 1 0\" face=\"0 1 2\">";
    for (std::size_t i = 0; i < bones; ++i) {
      const int body = shoulder.bodies[i];
      const mjtNum* const p = simulation.data().xpos + 3 * body;
      const mjtNum* const q = simulation.data().xquat + 4 * body;
      skin << "<bone body=\"" << mj_id2name(&simulation.model(), mjOBJ_BODY, body)
           << "\" bindpos=\"" << p[0] << ' ' << p[1] << ' ' << p[2] << "\" bindquat=\"";
      skin.precision(17);
      skin << q[0] << ' ' << q[1] << ' ' << q[2] << ' ' << q[3]
           << "\" vertid=\"0 1 2\" vertweight=\"1 1 1\"/>";
    }
    skin << "</skin></deformable></mujoco>";
    return Replaced(xml, "</mujoco>", skin.str());
  }
};

TEST_F(BindPoseTest, IsWhereTheBonesWereWhenTheSkinWasMade) {
  for (const Sides sides : {Sides::kRight, Sides::kLeft, Sides::kBoth}) {
    const ModelPointer model = LoadedModel(SkinnedXml(sides, kFlexed, kSegmentCount));
    const std::optional<ShoulderPose> pose =
        BindPose(*model, sides == Sides::kRight ? Side::kRight : Side::kLeft);
    ASSERT_TRUE(pose);
    EXPECT_LT(FarthestJoint_rad(*pose, kFlexed), kSingle_rad);
  }
}

TEST_F(BindPoseTest, IsNoneWhereTheSkinLeavesABoneOut) {
  const ModelPointer model = LoadedModel(SkinnedXml(Sides::kRight, kFlexed, kSegmentCount - 1));
  EXPECT_FALSE(BindPose(*model, Side::kRight));
}

TEST_F(BindPoseTest, IsNoneWithoutSkin) {
  const ModelPointer model = LoadedModel(ShoulderXml());
  EXPECT_FALSE(BindPose(*model, Side::kRight));
}

TEST_F(BindPoseTest, IsThatOfOurSkinWhateverElseAModelWears) {
  // Clothes, which were made on the abducted arm, before the skin of the flexed one.
  const std::string clothes = Replaced(SkinnedXml(Sides::kRight, kAbducted, kSegmentCount),
                                       "<skin name=\"skin\"", "<skin name=\"clothes\"");
  const std::string start = "<deformable>";
  const std::string skinned = SkinnedXml(Sides::kRight, kFlexed, kSegmentCount);
  const std::string skin = skinned.substr(skinned.find(start));
  const ModelPointer model = LoadedModel(Replaced(clothes, "</mujoco>", skin));
  ASSERT_EQ(model->nskin, 2);
  ASSERT_STREQ(mj_id2name(model.get(), mjOBJ_SKIN, 0), "clothes");
  const std::optional<ShoulderPose> pose = BindPose(*model, Side::kRight);
  ASSERT_TRUE(pose);
  EXPECT_LT(FarthestJoint_rad(*pose, kFlexed), kSingle_rad);
  EXPECT_FALSE(BindPose(*LoadedModel(clothes), Side::kRight)) << "clothes are no skin";
}

}  // namespace
}  // namespace girdle::posed_shoulder_test
