// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/frame_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kinematics/rotation.h"
#include "pictures/pixels.h"
#include "simulation/engine_fixture.h"
#include "text/input_error.h"

namespace girdle::frame_renderer_test {
namespace {

constexpr PictureSize kSmall = {160, 120};

// A camera that looks along x at the origin, from 2 m behind: left is y, up is z.
const std::string kCamera = R"(<camera name="behind" pos="-2 0 0" xyaxes="0 -1 0 0 0 1"/>)";

std::string Model(const std::string& world, const std::string& more = "") {
  return "<mujoco>" + more + "<worldbody>" + kCamera + world + "</worldbody></mujoco>";
}

std::string Ball(const std::string& place, const std::string& colour, double radius_m = 0.1) {
  return "<body pos=\"" + place + "\"><joint/><geom size=\"" + std::to_string(radius_m) +
         "\" rgba=\"" + colour + "\"/></body>";
}
constexpr const char* kRed = "1 0 0 1";
constexpr const char* kGreen = "0 1 0 1";
constexpr const char* kBlue = "0 0 1 1";

// A square skin of half a metre's side about `place`, across x and seen from either side, of one
// bone: a body with a red ball.
std::string SkinnedModel(const std::string& x, const std::string& colour,
                         const std::string& statistic) {
  const std::string vertices =
      x + " -.25 -.25 " + x + " .25 -.25 " + x + " .25 .25 " + x + " -.25 .25";
  return Model("<body name=\"bone\"><joint/><geom size=\".02\" rgba=\"1 0 0 1\"/></body>",
               "<statistic " + statistic +
                   " center=\"0 0 0\"/><deformable><skin name=\"skin\" rgba=\"" + colour +
                   "\" vertex=\"" + vertices +
                   "\" face=\"0 1 2 0 2 3 2 1 0 3 2 0\"><bone body=\"bone\" bindpos=\"0 0 0\" "
                   "bindquat=\"1 0 0 0\" vertid=\"0 1 2 3\" vertweight=\"1 1 1 1\"/></skin>"
                   "</deformable>");
}

class FrameRendererTest : public EngineTest {
 protected:
  struct Drawn {
    ModelPointer model;
    DataPointer data;
  };

  static Drawn Load(const std::string& xml) {
    ModelPointer model = LoadModel({{"model.xml", xml}});
    DataPointer data = MakeData(*model);
    mj_fwdPosition(model.get(), data.get());
    return {std::move(model), std::move(data)};
  }

  static Picture Draw(const std::string& xml, const View& view) {
    const Drawn loaded = Load(xml);
    FrameRenderer renderer(*loaded.model, "model.xml", view);
    return renderer.Draw(*loaded.data);
  }

  static View From(const std::string& camera) { return {camera, kSmall, std::nullopt}; }

  static std::string Refusal(const std::string& xml, const View& view) {
    try {
      static_cast<void>(Draw(xml, view));
    } catch (const InputError& error) {
      return error.what();
    }
    return "(nothing was thrown)";
  }
};

// ------------------------------------------------------------------- What is where in a picture

TEST_F(FrameRendererTest, ShowsWhatACameraOfTheModelSees) {
  const Picture picture = Draw(Model(Ball("0 0 0", kRed)), From("behind"));
  EXPECT_EQ(picture.size, kSmall);
  EXPECT_TRUE(Middle(picture).is_red());
  EXPECT_FALSE(PixelAt(picture, 0, 0).is_red());
}

TEST_F(FrameRendererTest, HasItsFirstRowOnTopAndItsFirstColumnOnTheLeft) {
  const Picture picture =
      Draw(Model(Ball("0 .3 .3", kRed) + Ball("0 -.3 .3", kGreen) + Ball("0 .3 -.3", kBlue)),
           From("behind"));
  EXPECT_LT(RedPatch(picture).middle_x(), 80);
  EXPECT_LT(RedPatch(picture).middle_y(), 60);
  EXPECT_GT(GreenPatch(picture).middle_x(), 80);
  EXPECT_LT(GreenPatch(picture).middle_y(), 60);
  EXPECT_LT(BluePatch(picture).middle_x(), 80);
  EXPECT_GT(BluePatch(picture).middle_y(), 60);
}

// A row whose bytes are no multiple of four would be sheared by one that is read as padded.
TEST_F(FrameRendererTest, HasStraightRowsAtOddSizes) {
  const Picture picture =
      Draw(Model(Ball("0 0 .3", kRed) + Ball("0 0 -.3", kGreen)), {"behind", {161, 119}, {}});
  constexpr double kPixel = 1;
  EXPECT_NEAR(RedPatch(picture).middle_x(), 80, kPixel);
  EXPECT_NEAR(GreenPatch(picture).middle_x(), 80, kPixel);
  EXPECT_NEAR(RedPatch(picture).middle_y() + GreenPatch(picture).middle_y(), 118, kPixel);
}

TEST_F(FrameRendererTest, GivesTheSameBytesForTheSameState) {
  const std::string xml = Model(Ball("0 0 0", kRed) + Ball("0 .2 .2", kBlue));
  EXPECT_EQ(Draw(xml, From("oblique")).rgb, Draw(xml, From("oblique")).rgb);
}

TEST_F(FrameRendererTest, LeavesTheStateAsItIs) {
  const Drawn loaded = Load(Model(Ball("0 0 0", kRed)));
  const std::vector<mjtNum> before(loaded.data->geom_xpos,
                                   loaded.data->geom_xpos + 3 * loaded.model->ngeom);
  const mjtNum angle = loaded.data->qpos[0];
  FrameRenderer renderer(*loaded.model, "model.xml", From("front"));
  static_cast<void>(renderer.Draw(*loaded.data));
  EXPECT_TRUE(std::equal(before.begin(), before.end(), loaded.data->geom_xpos));
  EXPECT_EQ(loaded.data->qpos[0], angle);
}

// --------------------------------------------------------------------------- Cameras by word

// Forward is x, the person's right is -y. The grey one has the middle where the others are.
const std::string kPerson = Model(Ball(".3 0 0", kRed) + Ball("0 -.3 0", kGreen) +
                                  Ball("-.3 0 0", kBlue) + Ball("0 .3 0", ".5 .5 .5 1"));

TEST_F(FrameRendererTest, LooksFromTheFront) {
  const Picture picture = Draw(kPerson, From("front"));
  // The nearer of two that stand behind one another, and the person's right on the left.
  EXPECT_GT(RedPatch(picture).count, 0);
  EXPECT_EQ(BluePatch(picture).count, 0);
  EXPECT_LT(GreenPatch(picture).middle_x(), RedPatch(picture).middle_x());
}

TEST_F(FrameRendererTest, LooksFromTheBack) {
  const Picture picture = Draw(kPerson, From("back"));
  EXPECT_GT(BluePatch(picture).count, 0);
  EXPECT_EQ(RedPatch(picture).count, 0);
  EXPECT_GT(GreenPatch(picture).middle_x(), BluePatch(picture).middle_x());
}

TEST_F(FrameRendererTest, LooksFromAboveWithTheFrontUp) {
  const Picture picture = Draw(kPerson, From("above"));
  EXPECT_LT(RedPatch(picture).middle_y(), GreenPatch(picture).middle_y());
  EXPECT_LT(GreenPatch(picture).middle_y(), BluePatch(picture).middle_y());
  EXPECT_GT(GreenPatch(picture).middle_x(), RedPatch(picture).middle_x());
}

TEST_F(FrameRendererTest, LooksObliquelyFromInFrontOfTheRightArm) {
  const Picture picture = Draw(kPerson, From("oblique"));
  // The front is nearer than the back, so lower in a picture from above; the right arm on the left.
  EXPECT_GT(RedPatch(picture).middle_y(), BluePatch(picture).middle_y());
  EXPECT_LT(GreenPatch(picture).middle_x(), RedPatch(picture).middle_x());
}

TEST_F(FrameRendererTest, LooksObliquelyFromInFrontOfALeftArmThatIsAlone) {
  const auto with_arm = [](const std::string& side) {
    return Model(Ball(".3 0 0", kRed) + Ball("-.3 0 0", kBlue) + "<body name=\"humerus" + side +
                 "\" pos=\"0 .3 0\"><joint/><geom size=\".1\" rgba=\"0 1 0 1\"/></body>");
  };
  const Picture left = Draw(with_arm("_l"), From("oblique"));
  EXPECT_GT(GreenPatch(left).middle_x(), RedPatch(left).middle_x());
  const Picture right = Draw(with_arm("_r"), From("oblique"));
  EXPECT_GT(RedPatch(right).middle_x(), BluePatch(right).middle_x());
  EXPECT_LT(RedPatch(left).middle_x(), BluePatch(left).middle_x());
}

TEST_F(FrameRendererTest, TakesTheModelsOwnCameraOfAWord) {
  // One that is called so and looks the other way.
  const std::string camera = R"(<camera name="front" pos="-2 0 0" xyaxes="0 -1 0 0 0 1"/>)";
  const Picture picture =
      Draw(Model(Ball(".3 0 0", kRed) + Ball("-.3 0 0", kBlue) + camera), From("front"));
  EXPECT_TRUE(Middle(picture).is_blue());
}

class CameraWordTest : public FrameRendererTest,
                       public testing::WithParamInterface<std::string_view> {};

// Of one that swings: everything in view at the start and in every keyframe, and not lost in it.
TEST_P(CameraWordTest, HasAllBodiesInViewInEveryKeyframe) {
  const Drawn loaded = Load(Model(
      R"(<body><joint axis="1 0 0"/><geom type="capsule" fromto="0 0 0 0 0 -.4" size=".03"
           rgba="1 0 0 1"/></body>)",
      R"(<keyframe><key qpos="1.57"/><key qpos="3.14"/></keyframe>)"));
  FrameRenderer renderer(*loaded.model, "model.xml", From(std::string(GetParam())));
  int largest = 0;
  for (int key = 0; key < loaded.model->nkey; ++key) {
    mj_resetDataKeyframe(loaded.model.get(), loaded.data.get(), key);
    mj_fwdPosition(loaded.model.get(), loaded.data.get());
    const Patch arm = RedPatch(renderer.Draw(*loaded.data));
    ASSERT_GT(arm.count, 0) << key;
    EXPECT_GT(arm.left, 0) << key;
    EXPECT_LT(arm.right, kSmall.width - 1) << key;
    EXPECT_GT(arm.top, 0) << key;
    EXPECT_LT(arm.bottom, kSmall.height - 1) << key;
    largest = std::max({largest, arm.right - arm.left, arm.bottom - arm.top});
  }
  EXPECT_GT(largest, kSmall.height / 4);
}

INSTANTIATE_TEST_SUITE_P(All, CameraWordTest, testing::ValuesIn(kCameraWords),
                         [](const auto& tested) { return std::string(tested.param); });

// ------------------------------------------------------------------------------------- Skins

// Two metres from the camera, past where MuJoCo ends a scene of this extent.
TEST_F(FrameRendererTest, ShowsSkinBeyondTheModelsExtent) {
  const std::string xml = SkinnedModel("0", kGreen, "extent=\"0.01\"");
  const Drawn loaded = Load(xml);
  ASSERT_LT(loaded.model->vis.map.zfar * loaded.model->stat.extent, 2);
  EXPECT_GT(GreenPatch(Draw(xml, From("behind"))).count, 500);
}

// Half a metre from the camera, before where MuJoCo begins a scene of this extent.
TEST_F(FrameRendererTest, ShowsSkinThatIsNearForTheModelsExtent) {
  const std::string xml = SkinnedModel("-1.5", kGreen, "extent=\"100\"");
  const Drawn loaded = Load(xml);
  ASSERT_GT(loaded.model->vis.map.znear * loaded.model->stat.extent, 0.5);
  const Patch near = GreenPatch(Draw(xml, From("behind")));
  // As wide as from a camera whose planes are where they should be.
  const Patch expected =
      GreenPatch(Draw(SkinnedModel("-1.5", kGreen, "extent=\"1\""), From("behind")));
  EXPECT_GT(expected.count, 500);
  EXPECT_EQ(near.left, expected.left);
  EXPECT_EQ(near.right, expected.right);
  EXPECT_EQ(near.count, expected.count);
}

TEST_F(FrameRendererTest, AimsAtSkinThatIsFarFromTheBones) {
  const std::string xml = SkinnedModel("3", kGreen, "extent=\"1\"");
  const Patch skin = GreenPatch(Draw(xml, From("front")));
  ASSERT_GT(skin.count, 0);
  EXPECT_GT(skin.left, 0);
  EXPECT_LT(skin.right, kSmall.width - 1);
}

class ShowTest : public FrameRendererTest {
 protected:
  // The ball in front of the skin, seen from behind.
  static Picture Drawn(std::optional<Show> show) {
    return Draw(SkinnedModel("0.05", kGreen, "extent=\"1\""), {"behind", kSmall, show});
  }
  static Picture DrawnBehindSkin(std::optional<Show> show) {
    return Draw(SkinnedModel("-0.05", kGreen, "extent=\"1\""), {"behind", kSmall, show});
  }
};

TEST_F(ShowTest, SkinHidesTheBonesAlsoWhereTheyComeThrough) {
  EXPECT_GT(GreenPatch(Drawn(Show::kSkin)).count, 500);
  EXPECT_EQ(RedPatch(Drawn(Show::kSkin)).count, 0);
}

TEST_F(ShowTest, BonesHidesTheSkin) {
  EXPECT_EQ(GreenPatch(DrawnBehindSkin(Show::kBones)).count, 0);
  EXPECT_GT(RedPatch(DrawnBehindSkin(Show::kBones)).count, 0);
}

TEST_F(ShowTest, BothShowsBonesThroughTheSkin) {
  const Picture both = DrawnBehindSkin(Show::kBoth);
  const Pixel bone = Middle(both);
  const Pixel bare = Middle(DrawnBehindSkin(Show::kBones));
  const Pixel skin = PixelAt(both, 80 + 10, 60);
  EXPECT_GT(bone.red, skin.red);      // shines through
  EXPECT_GT(bone.green, bare.green);  // and is tinged
}

TEST_F(ShowTest, NothingSaidShowsTheSkin) {
  EXPECT_EQ(Drawn(std::nullopt).rgb, Drawn(Show::kSkin).rgb);
}

TEST_F(ShowTest, NothingSaidShowsTheBonesOfAModelWithoutSkin) {
  EXPECT_TRUE(Middle(Draw(Model(Ball("0 0 0", kRed)), From("behind"))).is_red());
}

// ------------------------------------------------------------------- Several renderers at a time

class SeveralRenderersTest : public FrameRendererTest {
 protected:
  const std::string red_xml_ = Model(Ball("0 0 0", kRed));
  const std::string skin_xml_ = SkinnedModel("0", kGreen, "extent=\"1\"");
};

TEST_F(SeveralRenderersTest, DrawInTurnAsEachAlone) {
  const Drawn red = Load(red_xml_);
  const Drawn skin = Load(skin_xml_);
  FrameRenderer of_red(*red.model, "red", From("behind"));
  FrameRenderer of_skin(*skin.model, "skin", {"oblique", {96, 64}, {}});
  const Picture red_alone = Draw(red_xml_, From("behind"));
  const Picture skin_alone = Draw(skin_xml_, {"oblique", {96, 64}, {}});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(of_red.Draw(*red.data).rgb, red_alone.rgb);
    EXPECT_EQ(of_skin.Draw(*skin.data).rgb, skin_alone.rgb);
  }
}

TEST_F(SeveralRenderersTest, DrawOnAfterAnotherHasGone) {
  const Drawn red = Load(red_xml_);
  FrameRenderer renderer(*red.model, "red", From("behind"));
  const Picture before = renderer.Draw(*red.data);
  static_cast<void>(Draw(skin_xml_, From("oblique")));
  EXPECT_EQ(renderer.Draw(*red.data).rgb, before.rgb);
}

TEST_F(SeveralRenderersTest, CanEndInTheOrderInWhichTheyBegan) {
  const Drawn red = Load(red_xml_);
  auto first = std::make_unique<FrameRenderer>(*red.model, "red", From("behind"));
  auto second = std::make_unique<FrameRenderer>(*red.model, "red", From("behind"));
  const Picture before = first->Draw(*red.data);
  first.reset();
  EXPECT_EQ(second->Draw(*red.data).rgb, before.rgb);
}

// -------------------------------------------------------------------------------- What is refused

TEST_F(FrameRendererTest, RefusesACameraThatThereIsNotAndNamesThoseThatThereAre) {
  EXPECT_EQ(Refusal(Model(Ball("0 0 0", kRed)), From("below")),
            "model.xml: has no camera \"below\". Choose one of: behind, front, back, above, "
            "oblique");
}

TEST_F(FrameRendererTest, RefusesSizesThatAreTooSmallOrTooLarge) {
  const std::string xml = Model(Ball("0 0 0", kRed));
  for (const PictureSize& size : {PictureSize{0, 0}, PictureSize{15, 120}, PictureSize{160, -1},
                                  PictureSize{100000, 100000}, PictureSize{160, 4097}}) {
    EXPECT_EQ(Refusal(xml, {"behind", size, {}}), "a picture of " + std::to_string(size.width) +
                                                      "x" + std::to_string(size.height) +
                                                      " pixels: width and height are 16 to 4096");
  }
}

TEST_F(FrameRendererTest, RefusesToShowTheSkinOfAModelWithoutOne) {
  for (const Show show : {Show::kSkin, Show::kBoth}) {
    EXPECT_EQ(Refusal(Model(Ball("0 0 0", kRed)), {"behind", kSmall, show}),
              "model.xml: has no skin to show. Show its bones, or make a model that has a skin");
  }
}

TEST_F(FrameRendererTest, RefusesAViewOfNothing) {
  EXPECT_EQ(Refusal(Model(Ball("-5 0 0", kRed)), From("behind")),
            "model.xml: the picture is blank: camera behind sees nothing. Choose another one: "
            "behind, front, back, above, oblique");
}

}  // namespace
}  // namespace girdle::frame_renderer_test
