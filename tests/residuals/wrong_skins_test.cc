// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Every checked line of the residual report on a skin has a model here that is wrong in one thing
// and makes the line fail. The lines that must fail are said exactly, as in wrong_models_test.cc.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/lengths.h"
#include "residuals/residual_groups.h"
#include "residuals/skin_residuals.h"
#include "residuals/skinned_model.h"
#include "simulation/engine_fixture.h"

namespace girdle::wrong_skins_test {
namespace {

using Lines = std::set<std::string>;

// --- What is made wrong --------------------------------------------------------------------------

// Something in the skin before the model gets it.
using SkinFault = std::function<void(LandmarkedSkin&)>;
// Something in the compiled model.
using ModelFault = std::function<void(mjModel&)>;

struct WrongSkin {
  std::string name;
  Lines fails;
  SkinFault skin = nullptr;
  ModelFault model = nullptr;
  Interpolation interpolation = Interpolation::kSmooth;
};

// Ten micrometers: ten times what single precision leaves.
constexpr double kShift_m = 1e-5;

int IdOf(const mjModel& model, mjtObj type, const std::string& name) {
  const int id = mj_name2id(&model, type, name.c_str());
  if (id < 0) {
    throw std::logic_error("the model has no " + name);
  }
  return id;
}

BoundBone& BoneOf(BoundSkin& skin, const std::string& body) {
  const auto found = std::find_if(skin.bones.begin(), skin.bones.end(),
                                  [&](const BoundBone& bone) { return bone.body == body; });
  if (found == skin.bones.end()) {
    throw std::logic_error("the skin does not hang on " + body);
  }
  return *found;
}

// How much of each vertex a bone moves.
std::vector<double> SharesOf(const BoundBone& bone, const BoundSkin& skin) {
  std::vector<double> shares(skin.surface.vertices_m.size());
  for (const VertexWeight& share : bone.weights) {
    shares[static_cast<std::size_t>(share.vertex)] = share.weight;
  }
  return shares;
}

// Vertices hang on one bone alone.
void HangOn(const std::string& body, const std::vector<int>& vertices, BoundSkin& skin) {
  for (BoundBone& bone : skin.bones) {
    std::erase_if(bone.weights, [&](const VertexWeight& share) {
      return std::find(vertices.begin(), vertices.end(), share.vertex) != vertices.end();
    });
  }
  for (const int vertex : vertices) {
    BoneOf(skin, body).weights.push_back({vertex, 1});
  }
}

SkinFault AcromionHangsOn(const std::string& body) {
  return [=](LandmarkedSkin& landmarked) {
    constexpr std::size_t kAcromion = 1;
    static_assert(kSkinLandmarkNames[kAcromion] == kSkinAcromionName);
    HangOn(body, landmarked.right[kAcromion], landmarked.skin);
  };
}

// Some of what clavicle and scapula have in each vertex is given to the thorax: the skin over the
// girdle stays behind, and the arm that rises pushes it together.
SkinFault GirdleHangsOnTheThorax(double given) {
  return [=](LandmarkedSkin& landmarked) {
    BoundSkin& skin = landmarked.skin;
    std::vector<double> shares = SharesOf(BoneOf(skin, "thorax"), skin);
    for (const char* const body : {"clavicle_r", "scapula_r"}) {
      for (VertexWeight& share : BoneOf(skin, body).weights) {
        shares[static_cast<std::size_t>(share.vertex)] += given * share.weight;
        share.weight *= 1 - given;
      }
    }
    std::vector<VertexWeight>& thorax = BoneOf(skin, "thorax").weights;
    thorax.clear();
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (shares[i] > 0) {
        thorax.push_back({static_cast<int>(i), shares[i]});
      }
    }
  };
}

SkinFault BoundElsewhere(const std::string& body) {
  return
      [=](LandmarkedSkin& landmarked) { BoneOf(landmarked.skin, body).bind.p_TB_m.x += kShift_m; };
}

// Skin within 3 cm of a landmark of the right shoulder keeps a share of its distance.
SkinFault DrawnTo(Landmark landmark, double kept = 0.1) {
  return [=](LandmarkedSkin& landmarked) {
    constexpr double kAround_m = 0.03;
    const Vector3 center_m = OnSideInThorax_m(
        BuiltInAnatomy(), BindPose(landmarked.skin, Side::kRight).value(), Side::kRight, landmark);
    for (Vector3& vertex_m : landmarked.skin.surface.vertices_m) {
      if (glm::distance(vertex_m, center_m) < kAround_m) {
        vertex_m = center_m + kept * (vertex_m - center_m);
      }
    }
  };
}

ModelFault Inflated(double by_m) {
  return [=](mjModel& model) {
    model.skin_inflate[IdOf(model, mjOBJ_SKIN, std::string(kSkinName))] = static_cast<float>(by_m);
  };
}

ModelFault BodyMoved(const std::string& body) {
  return [=](mjModel& model) { model.body_pos[3 * IdOf(model, mjOBJ_BODY, body)] += kShift_m; };
}

ModelFault NotANumberAt(int vertex) {
  return [=](mjModel& model) {
    model.skin_vert[3 * static_cast<std::ptrdiff_t>(vertex)] =
        std::numeric_limits<float>::quiet_NaN();
  };
}

// --- The models ----------------------------------------------------------------------------------

const Lines kOffBlend = {"MuJoCo - linear blend, at rest", "MuJoCo - linear blend, moving"};
const Lines kPosed = {"MuJoCo - commanded pose"};
const Lines kBound = {"bones - where they were bound"};
const Lines kRises = {"acromion's skin rises, plane 0", "acromion's skin rises, plane 40",
                      "acromion's skin rises, plane 90"};
const Lines kArea = {"area below half, plane 0"};
const Lines kJumps = {"jump of AC skin over elevation knots, MuJoCo",
                      "jump of AC skin over elevation knots, linear blend",
                      "jump of AC skin over plane knots, MuJoCo",
                      "jump of AC skin over plane knots, linear blend"};
const Lines kDepth = {"depth of landmarks, bind pose"};

Lines operator+(Lines a, const Lines& b) {
  a.insert(b.begin(), b.end());
  return a;
}

std::vector<WrongSkin> WrongSkins() {
  return {
      {"Inflated", kOffBlend + kPosed, nullptr, Inflated(kShift_m)},
      {"ScapulaMoved", kPosed, nullptr, BodyMoved("scapula_r")},
      {"ClavicleBoundElsewhere", kBound, BoundElsewhere("clavicle_r")},
      {"AcromionHangsOnTheThorax", kRises, AcromionHangsOn("thorax")},
      {"SkinOfTheGirdleStaysBehind", kArea, GirdleHangsOnTheThorax(0.4)},
      {"TurnsByJerks", kJumps, nullptr, nullptr, Interpolation::kSlerp},
      {"ElbowHardlyCovered", kDepth, DrawnTo(Landmark::kEL)},
  };
}

// --- Held against the report ---------------------------------------------------------------------

class WrongSkinTest : public EngineTest, public testing::WithParamInterface<WrongSkin> {
 protected:
  // The lines on the right shoulder, which has moved for a while.
  static std::vector<Residual> Measure(const WrongSkin& wrong) {
    LandmarkedSkin landmarked = ImplicitSkin();
    if (wrong.skin) {
      wrong.skin(landmarked);
    }
    ModelPointer model = LoadModel(SkinnedModelOf(landmarked));
    if (wrong.model) {
      wrong.model(*model);
    }
    ShoulderSimulation simulation(
        LoadedShoulders(std::move(model), "shoulder.xml"),
        AssembledRhythm(BuiltInRhythm({wrong.interpolation, Closure::kExact}), Assembly::kTree));
    SkinMeter meter(simulation, simulation.rhythm(), BuiltInAnatomy(), GirdleMotion::kMeasured);
    constexpr int kSteps = 50;
    const ArmCommand asked{RadiansFromDegrees(90), RadiansFromDegrees(40)};
    simulation.Start({RadiansFromDegrees(30), 0});
    for (int i = 0; i < kSteps; ++i) {
      simulation.Step(asked);
    }
    meter.CompareMoving("raising", asked);
    return meter.Measure();
  }

  static Lines Failed(const std::vector<Residual>& lines) {
    Lines failed;
    for (const Residual& line : lines) {
      if (!line.passed()) {
        failed.insert(line.item);
      }
    }
    return failed;
  }
};

TEST_P(WrongSkinTest, FailsInTheseLinesAlone) {
  const WrongSkin& wrong = GetParam();
  const std::vector<Residual> lines = Measure(wrong);
  std::string values;
  for (const Residual& line : lines) {
    if (line.tolerance) {
      values += line.item + " " + std::to_string(line.value) + " " + line.where + "\n";
    }
  }
  EXPECT_EQ(Failed(lines), wrong.fails) << values;
}

INSTANTIATE_TEST_SUITE_P(Faults, WrongSkinTest, testing::ValuesIn(WrongSkins()),
                         [](const testing::TestParamInfo<WrongSkin>& row) {
                           return row.param.name;
                         });

TEST_F(WrongSkinTest, MakesEveryCheckedLineFail) {
  const std::vector<Residual> sound = Measure({"Sound", {}});
  EXPECT_EQ(Failed(sound), Lines{});
  Lines checked;
  for (const Residual& line : sound) {
    if (line.tolerance) {
      checked.insert(line.item);
    }
  }
  Lines failed;
  for (const WrongSkin& wrong : WrongSkins()) {
    failed.insert(wrong.fails.begin(), wrong.fails.end());
  }
  EXPECT_EQ(failed, checked);
}

// The skin about an elbow that hangs on the humerus alone is as far from it in every pose, and
// nowhere is a landmark as shallow. With the skin as it is, no pose of the grid is shallower.
TEST_F(WrongSkinTest, StatesTheLeastDepthOverAllPoses) {
  WrongSkin wrong{"ElbowOnTheHumerus", {}};
  wrong.skin = [](LandmarkedSkin& landmarked) {
    constexpr double kAround_m = 0.06;
    const Vector3 elbow_m =
        OnSideInThorax_m(BuiltInAnatomy(), BindPose(landmarked.skin, Side::kRight).value(),
                         Side::kRight, Landmark::kEL);
    const std::vector<Vector3>& vertices_m = landmarked.skin.surface.vertices_m;
    std::vector<int> about_elbow;
    for (std::size_t i = 0; i < vertices_m.size(); ++i) {
      if (glm::distance(vertices_m[i], elbow_m) < kAround_m) {
        about_elbow.push_back(static_cast<int>(i));
      }
    }
    HangOn("humerus_r", about_elbow, landmarked.skin);
    // So near that no other landmark is nearer to the skin, in whatever pose.
    DrawnTo(Landmark::kEL, 0.001)(landmarked);
  };
  const auto line = [](const std::vector<Residual>& lines, const std::string& item) {
    const auto found = std::find_if(lines.begin(), lines.end(),
                                    [&](const Residual& each) { return each.item == item; });
    return found == lines.end() ? Residual{} : *found;
  };
  const std::vector<Residual> rigid = Measure(wrong);
  const Residual bound = line(rigid, "depth of landmarks, bind pose");
  const Residual posed = line(rigid, "depth of landmarks, all poses");
  EXPECT_GT(bound.value, 0);
  EXPECT_LT(bound.value, 3);
  EXPECT_NEAR(posed.value, bound.value, 1e-6);
  EXPECT_TRUE(posed.where.starts_with("EL, elevation ")) << posed.where;

  const double least_mm = line(Measure({"Sound", {}}), "depth of landmarks, all poses").value;
  const SkinOnBones on_bones(ImplicitSkin().skin, BuiltInAnatomy());
  const ShoulderRhythm rhythm = BuiltInRhythm();
  double shallowest_mm = std::numeric_limits<double>::infinity();
  for (const double elevation_deg : {30, 60, 75, 90, 120, 150}) {
    // Some of the planes that are looked at: fifteen even steps over the reach.
    for (const int step : {7, 9, 11, 14}) {
      const double plane_deg = -95 + 230.0 * step / 15;
      const LandmarkDepths depths_m = LandmarkDepths_m(
          on_bones,
          rhythm.SolvePose({RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)}),
          Side::kRight);
      shallowest_mm =
          std::min(shallowest_mm,
                   kMillimetersPerMeter * *std::min_element(depths_m.begin(), depths_m.end()));
    }
  }
  EXPECT_GT(least_mm, 0);
  // The skin of a model is in single precision.
  EXPECT_LE(least_mm, shallowest_mm + 1e-3);
}

// A skin that was looked at only where it rests says nothing of one that moves.
TEST_F(WrongSkinTest, MovingIsNotPassedByASkinThatRests) {
  ShoulderSimulation simulation(LoadedShoulders(LoadModel(SkinnedModel()), "shoulder.xml"),
                                AssembledRhythm(BuiltInRhythm(), Assembly::kTree));
  const Anatomy anatomy = BuiltInAnatomy();
  const MeasuredShoulder shoulder{simulation, simulation.rhythm(), anatomy};
  const ResidualGroupPointer group = MakeSkinGroup(simulation, shoulder, GirdleMotion::kMeasured);
  simulation.Start({});
  const ShoulderState state = simulation.Step({});
  const auto moving = [&group] {
    std::vector<Residual> lines;
    group->AddLines(lines);
    const auto found = std::find_if(lines.begin(), lines.end(), [](const Residual& line) {
      return line.item == "MuJoCo - linear blend, moving";
    });
    return found == lines.end() ? Residual{} : *found;
  };
  constexpr int kSecond = 1000;
  group->TakeStep({"raising", StepPhase::kMoving, 0, state});
  for (const StepPhase phase : {StepPhase::kSettling, StepPhase::kSettled, StepPhase::kCycling}) {
    for (int number = 0; number < kSecond; ++number) {
      group->TakeStep({"raising", phase, number, state});
    }
  }
  EXPECT_TRUE(std::isnan(moving().value)) << moving().where;
  EXPECT_FALSE(moving().passed());
  for (int number = 0; number < kSecond; ++number) {
    group->TakeStep({"raising", StepPhase::kMoving, number, state});
  }
  EXPECT_TRUE(moving().passed()) << moving().value;
  EXPECT_TRUE(moving().where.starts_with("raising, ")) << moving().where;
}

// Of a vertex that is nowhere only its bones are known, and how the skin elsewhere moves.
TEST_F(WrongSkinTest, DoesNotPassOverAVertexThatIsNoNumber) {
  WrongSkin wrong{"Nowhere", {}};
  const std::vector<int>& acromion = ImplicitSkin().right[1];
  wrong.model = NotANumberAt(acromion.front());
  const std::vector<Residual> lines = Measure(wrong);
  EXPECT_EQ(Failed(lines), kOffBlend + kPosed + kRises + kArea + kJumps + kDepth);
  const auto posed = std::find_if(lines.begin(), lines.end(), [](const Residual& line) {
    return line.item == "depth of landmarks, all poses";
  });
  ASSERT_NE(posed, lines.end());
  EXPECT_TRUE(std::isnan(posed->value)) << posed->value;
}

}  // namespace
}  // namespace girdle::wrong_skins_test
