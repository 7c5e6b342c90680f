// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/model_skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/model_variants.h"
#include "simulation/plugin_fixture.h"
#include "simulation/shoulder_simulation.h"
#include "skin/bone_heat.h"
#include "skin/bone_shapes.h"
#include "skin/implicit_body.h"
#include "skin/skn_file.h"
#include "text/input_error.h"

namespace girdle::model_skin_test {
namespace {

// MuJoCo blends in single precision, a metre and a half above the floor.
constexpr double kSinglePrecision_m = 1e-6;
// Of a number in a file, at most 2 m.
constexpr double kStored_m = 2e-7;

constexpr const char* kSkinFile = "skin.skn";

// The implicit body of both shoulders.
struct Made {
  BoundSkin skin;
  SkinElement element;
};

const Made& MadeSkin() {
  static const Made kMade = [] {
    const std::vector<Side> sides = {Side::kRight, Side::kLeft};
    const PosedBody body = ImplicitBody(BuiltInAnatomy(), sides);
    const std::vector<SkinBone> bones = SkinBonesOf(sides);
    Made made{Bind(body, bones, BoneHeat(body.surface, BoneShapesOf(body, bones))),
              {kSkinFile, {}}};
    for (const Side side : sides) {
      made.element.landmarks.push_back(FindSkinLandmarks(body, side));
    }
    return made;
  }();
  return kMade;
}

std::string SkinnedXml(const Variant& variant = {"Tree"}) {
  ShoulderModelOptions options = variant.Options(Sides::kBoth);
  options.skin = MadeSkin().element;
  return ShoulderXml(options);
}

ModelPointer LoadSkinned(const std::string& xml, const BoundSkin& skin = MadeSkin().skin) {
  return LoadModel({{"shoulder.xml", xml}, {kSkinFile, SknBytes(skin)}});
}

double LargestDistance_m(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest_m = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest_m = std::max(largest_m, glm::distance(a[i], b[i]));
  }
  return largest_m;
}

BoundBone& BoneNamed(BoundSkin& skin, const std::string& body) {
  return *std::find_if(skin.bones.begin(), skin.bones.end(),
                       [&](const BoundBone& bone) { return bone.body == body; });
}

class ModelSkinTest : public EngineTest {
 protected:
  // How far MuJoCo has the skin of a model from `wanted` on the same bones, the arms raised.
  static double RaisedDistance_m(const ModelPointer& model, const BoundSkin& wanted) {
    const DataPointer data = MakeData(*model);
    ControlOf(*model, *data, "elevation_r") = 1.9;
    PositionOf(*model, *data, "ac_upward_rotation_r") = -0.5;
    PositionOf(*model, *data, "gh_elevation_r") = -1.2;
    PositionOf(*model, *data, "gh_axial_l") = -1.1;
    mj_forward(model.get(), data.get());
    const ModelSkin skin(*model, "shoulder.xml");
    return LargestDistance_m(skin.VerticesInWorld_m(*data),
                             BlendedVertices_m(wanted, skin.BonesInWorld(*data)));
  }

  static std::string Refusal(const std::string& xml, const BoundSkin& skin = MadeSkin().skin) {
    const ModelPointer model = LoadSkinned(xml, skin);
    try {
      static_cast<void>(ModelSkin(*model, "shoulder.xml").Landmarks(Side::kRight));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ModelSkinTest, IsBoundAsItWasMade) {
  const ModelPointer model = LoadSkinned(SkinnedXml());
  const BoundSkin& made = MadeSkin().skin;
  const ModelSkin skin(*model, "shoulder.xml");
  EXPECT_LT(LargestDistance_m(skin.bound().surface.vertices_m, made.surface.vertices_m), kStored_m);
  EXPECT_EQ(skin.bound().surface.triangles, made.surface.triangles);
  ASSERT_EQ(skin.bound().bones.size(), made.bones.size());
  for (std::size_t k = 0; k < made.bones.size(); ++k) {
    const BoundBone& read = skin.bound().bones[k];
    EXPECT_EQ(read.body, made.bones[k].body);
    EXPECT_LT(glm::distance(read.bind.p_TB_m, made.bones[k].bind.p_TB_m), kStored_m);
    EXPECT_LT(AngleBetween(read.bind.q_TB, made.bones[k].bind.q_TB), kStored_m);
    ASSERT_EQ(read.weights.size(), made.bones[k].weights.size());
    for (std::size_t i = 0; i < read.weights.size(); ++i) {
      EXPECT_EQ(read.weights[i].vertex, made.bones[k].weights[i].vertex);
      EXPECT_NEAR(read.weights[i].weight, made.bones[k].weights[i].weight, kStored_m);
    }
  }
}

TEST_F(ModelSkinTest, HasTheLandmarksThatWereFound) {
  const ModelPointer model = LoadSkinned(SkinnedXml());
  const ModelSkin skin(*model, "shoulder.xml");
  EXPECT_EQ(skin.Landmarks(Side::kRight), MadeSkin().element.landmarks[0]);
  EXPECT_EQ(skin.Landmarks(Side::kLeft), MadeSkin().element.landmarks[1]);
}

// Where a skin was bound, and how its thorax stood there, is nobody's business but its own.
TEST_F(ModelSkinTest, IsTheSameWhereverItWasBound) {
  const Quaternion q = Exp({0.4, -1.1, 0.7});
  const Vector3 p_m{0.3, -0.2, 0.9};
  BoundSkin moved = MadeSkin().skin;
  for (Vector3& vertex_m : moved.surface.vertices_m) {
    vertex_m = q * vertex_m + p_m;
  }
  for (BoundBone& bone : moved.bones) {
    bone.bind = {q * bone.bind.q_TB, q * bone.bind.p_TB_m + p_m};
  }
  const ModelPointer model = LoadSkinned(SkinnedXml(), moved);
  EXPECT_LT(LargestDistance_m(ModelSkin(*model, "shoulder.xml").bound().surface.vertices_m,
                              MadeSkin().skin.surface.vertices_m),
            2 * kStored_m);
  EXPECT_LT(RaisedDistance_m(model, MadeSkin().skin), kSinglePrecision_m);
}

class ModelSkinOfVariant : public ModelSkinTest, public testing::WithParamInterface<Variant> {};

TEST_P(ModelSkinOfVariant, MovesWhileItSimulatesAsLinearBlendSkinningDoes) {
  ShoulderSimulation simulation({LoadSkinned(SkinnedXml(GetParam())), "shoulder.xml"},
                                {BuiltInRhythm(), GetParam().assembly});
  const ModelSkin skin(simulation.model(), "shoulder.xml");
  simulation.Start(LivelyCommand(0));
  std::vector<Vector3> before_m = skin.VerticesInWorld_m(simulation.data());
  constexpr int kSteps = 400;
  constexpr int kLooks = 40;
  for (int step = 1; step <= kSteps; ++step) {
    simulation.Step(LivelyCommand(step * simulation.timestep_s()));
    if (step % kLooks == 0) {
      const std::vector<Vector3> now_m = skin.VerticesInWorld_m(simulation.data());
      EXPECT_LT(LargestDistance_m(
                    now_m, BlendedVertices_m(skin.bound(), skin.BonesInWorld(simulation.data()))),
                kSinglePrecision_m);
      EXPECT_GT(LargestDistance_m(now_m, before_m), 0.001) << "at rest nothing is tested";
      before_m = now_m;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, ModelSkinOfVariant, testing::ValuesIn(AllVariants()), NameOf);

// The control of those below.
TEST_F(ModelSkinTest, IsPosedAsTheSkinThatWasMade) {
  EXPECT_LT(RaisedDistance_m(LoadSkinned(SkinnedXml()), MadeSkin().skin), kSinglePrecision_m);
}

TEST_F(ModelSkinTest, FindsAWeightThatIsAnotherBones) {
  BoundSkin disturbed = MadeSkin().skin;
  // A hundredth of a vertex that is mostly the humerus's.
  std::vector<VertexWeight>& humerus = BoneNamed(disturbed, "humerus_r").weights;
  VertexWeight& taken = *std::find_if(humerus.begin(), humerus.end(),
                                      [](const VertexWeight& share) { return share.weight > 0.5; });
  taken.weight -= 0.01;
  std::vector<VertexWeight>& thorax = BoneNamed(disturbed, "thorax").weights;
  const auto given = std::find_if(thorax.begin(), thorax.end(), [&](const VertexWeight& share) {
    return share.vertex == taken.vertex;
  });
  if (given != thorax.end()) {
    given->weight += 0.01;
  } else {
    thorax.push_back({taken.vertex, 0.01});
  }
  EXPECT_GT(RaisedDistance_m(LoadSkinned(SkinnedXml(), disturbed), MadeSkin().skin),
            10 * kSinglePrecision_m);
}

TEST_F(ModelSkinTest, FindsABoneThatWasBoundElsewhere) {
  for (const char* const body : {"thorax", "clavicle_r", "scapula_r", "humerus_r"}) {
    BoundSkin disturbed = MadeSkin().skin;
    BoneNamed(disturbed, body).bind.p_TB_m.y += 1e-4;
    EXPECT_GT(RaisedDistance_m(LoadSkinned(SkinnedXml(), disturbed), MadeSkin().skin),
              10 * kSinglePrecision_m)
        << body;
  }
}

TEST_F(ModelSkinTest, FindsASkinThatMuJoCoInflates) {
  const ModelPointer model =
      LoadSkinned(Replaced(SkinnedXml(), "<skin ", "<skin inflate=\"1e-4\" "));
  EXPECT_GT(RaisedDistance_m(model, MadeSkin().skin), 10 * kSinglePrecision_m);
}

TEST_F(ModelSkinTest, IsNoneOfOursUnderAnotherName) {
  EXPECT_TRUE(HasSkin(*LoadSkinned(SkinnedXml())));
  const std::string other = Replaced(SkinnedXml(), "<skin name=\"skin\"", "<skin name=\"clothes\"");
  EXPECT_FALSE(HasSkin(*LoadSkinned(other)));
  EXPECT_NE(Refusal(other).find("has no skin \"skin\""), std::string::npos);
}

TEST_F(ModelSkinTest, RefusesLandmarksThatAreMissingOrNoVertices) {
  EXPECT_EQ(Refusal(SkinnedXml()), "");
  EXPECT_NE(Refusal(Replaced(SkinnedXml(), "\"skin_deltoid_r\"", "\"deltoid\""))
                .find("no <numeric name=\"skin_deltoid_r\">"),
            std::string::npos);
  const std::string count = std::to_string(MadeSkin().skin.surface.vertices_m.size());
  const std::string last = std::to_string(MadeSkin().skin.surface.vertices_m.size() - 1);
  for (const std::string& number : {count, std::string("-1"), std::string("3.5")}) {
    const std::string was = "name=\"skin_ac_r\" data=\"" +
                            std::to_string(MadeSkin().element.landmarks[0][0].front()) + "\"";
    const std::string message =
        Refusal(Replaced(SkinnedXml(), was, "name=\"skin_ac_r\" data=\"" + number + "\""));
    EXPECT_NE(message.find("<numeric name=\"skin_ac_r\"> holds " + number), std::string::npos)
        << message;
    EXPECT_NE(message.find("0 to " + last), std::string::npos) << message;
  }
}

TEST_F(ModelSkinTest, RefusesASkinWithoutTheThorax) {
  BoundSkin skin = MadeSkin().skin;
  BoneNamed(skin, "thorax").body = "clavicle_r";
  EXPECT_NE(Refusal(SkinnedXml(), skin).find("does not hang on the body \"thorax\""),
            std::string::npos);
}

}  // namespace
}  // namespace girdle::model_skin_test
