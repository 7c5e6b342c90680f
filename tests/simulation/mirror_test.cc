// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A left shoulder moves as the mirror image of the right one; two on one thorax as each alone.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "names/model_names.h"
#include "simulation/model_variants.h"
#include "simulation/plugin_fixture.h"

namespace girdle::mirror_test {
namespace {

constexpr int kSteps = 600;
// What the rounding of some thousand operations a step leaves over the motion; a constraint's
// solver ends when it gains no more than its own tolerance.
constexpr double kSame = 1e-9;

class Moving : public EngineTest, public testing::WithParamInterface<Variant> {
 protected:
  // The elbow is pushed about, so that no joint is where its servo wants it.
  static void Push(const mjModel& model, mjData& data, const ShoulderNames& names, double time_s) {
    const int humerus = IdOf(model, mjOBJ_BODY, names.Of("humerus"));
    const Vector3 force_N{20 * std::sin(13 * time_s), 15 * std::cos(9 * time_s), -10};
    const Vector3 torque_N_m{0.5, 1.5 * std::sin(8 * time_s), -1};
    // A force's mirror image is that of an arrow; a torque's turns the other way besides.
    const double side = names.side == Side::kRight ? 1 : -1;
    const std::array<double, 6> wrench = {force_N.x,    side * force_N.y,
                                          force_N.z,    side * torque_N_m.x,
                                          torque_N_m.y, side * torque_N_m.z};
    std::copy(wrench.begin(), wrench.end(), data.xfrc_applied + 6 * humerus);
  }

  static void Step(const mjModel& model, mjData& data, const ShoulderNames& names, int step) {
    const double time_s = step * model.opt.timestep;
    Command(model, data, GetParam(), names, LivelyCommand(time_s));
    Push(model, data, names, time_s);
  }

  static Matrix3 RotationAt(const mjtNum* xmat) {
    // MuJoCo's are row by row, GLM's column by column.
    return glm::transpose(
        Matrix3(xmat[0], xmat[1], xmat[2], xmat[3], xmat[4], xmat[5], xmat[6], xmat[7], xmat[8]));
  }

  static double Apart(const Matrix3& a, const Matrix3& b) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) largest = std::max(largest, glm::distance(a[i], b[i]));
    return largest;
  }
};

INSTANTIATE_TEST_SUITE_P(Variants, Moving, testing::ValuesIn(AllVariants()), NameOf);

TEST_P(Moving, TheLeftIsTheMirrorImageOfTheRight) {
  const Matrix3 world{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  const Matrix3 bone{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  const ModelPointer right = GetParam().Load(Sides::kRight);
  const ModelPointer left = GetParam().Load(Sides::kLeft);
  const DataPointer right_data = MakeData(*right);
  const DataPointer left_data = MakeData(*left);
  ASSERT_EQ(right->nsite, left->nsite);
  double fastest = 0;
  for (int step = 0; step < kSteps; ++step) {
    Step(*right, *right_data, {Side::kRight}, step);
    Step(*left, *left_data, {Side::kLeft}, step);
    mj_step(right.get(), right_data.get());
    mj_step(left.get(), left_data.get());
    for (const std::string_view stem : JointStems(GetParam().assembly)) {
      ASSERT_NEAR(PositionOf(*left, *left_data, SidedName(stem, Side::kLeft)),
                  PositionOf(*right, *right_data, SidedName(stem, Side::kRight)), kSame)
          << stem << " at step " << step;
    }
    for (const std::string_view segment : kSegmentNames) {
      const bool has_side = segment != "thorax";
      const std::string name(segment);
      const int r = IdOf(*right, mjOBJ_BODY, has_side ? name + "_r" : name);
      const int l = IdOf(*left, mjOBJ_BODY, has_side ? name + "_l" : name);
      const Vector3 right_m = VectorAt(right_data->xpos + 3 * r);
      ASSERT_LT(glm::distance(VectorAt(left_data->xpos + 3 * l), world * right_m), kSame)
          << name << " at step " << step;
      ASSERT_LT(Apart(RotationAt(left_data->xmat + 9 * l),
                      world * RotationAt(right_data->xmat + 9 * r) * bone),
                kSame)
          << name << " at step " << step;
    }
    for (int site = 0; site < right->nsite; ++site) {
      std::string name = right->names + right->name_siteadr[site];
      const Vector3 right_m = VectorAt(right_data->site_xpos + 3 * site);
      if (name.ends_with("_r")) name.back() = 'l';
      const int l = IdOf(*left, mjOBJ_SITE, name);
      ASSERT_LT(glm::distance(VectorAt(left_data->site_xpos + 3 * l), world * right_m), kSame)
          << name << " at step " << step;
    }
    for (int i = 0; i < right->nv; ++i) fastest = std::max(fastest, std::abs(right_data->qvel[i]));
  }
  EXPECT_GT(fastest, 3) << "nothing moves";
}

TEST_P(Moving, BothMoveAsEachAlone) {
  const ModelPointer both = GetParam().Load(Sides::kBoth);
  const DataPointer both_data = MakeData(*both);
  const std::array<ModelPointer, 2> alone = {GetParam().Load(Sides::kRight),
                                             GetParam().Load(Sides::kLeft)};
  const std::array<DataPointer, 2> alone_data = {MakeData(*alone[0]), MakeData(*alone[1])};
  // Each side its own motion: the left begins later in it.
  constexpr int kLater = 150;
  for (int step = 0; step < kSteps; ++step) {
    for (const std::size_t i : {0U, 1U}) {
      const ShoulderNames names{static_cast<Side>(i)};
      const int own = step + (i == 0 ? 0 : kLater);
      Step(*both, *both_data, names, own);
      Step(*alone[i], *alone_data[i], names, own);
      mj_step(alone[i].get(), alone_data[i].get());
    }
    mj_step(both.get(), both_data.get());
    for (const std::size_t i : {0U, 1U}) {
      for (const std::string_view stem : JointStems(GetParam().assembly)) {
        const std::string name = SidedName(stem, static_cast<Side>(i));
        ASSERT_NEAR(PositionOf(*both, *both_data, name),
                    PositionOf(*alone[i], *alone_data[i], name), kSame)
            << name << " at step " << step;
      }
    }
  }
}

}  // namespace
}  // namespace girdle::mirror_test
