// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// What ligaments and thorax do to a simulated shoulder.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "anatomy/built_in_anatomy.h"
#include "mjcf/shoulder_model.h"
#include "names/model_names.h"
#include "residuals/residuals.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/engine_fixture.h"
#include "simulation/shoulder_simulation.h"

namespace girdle::thorax_test {
namespace {

class ThoraxTest : public EngineTest {
 protected:
  static ModelPointer Load(const ShoulderModelOptions& options,
                           const Anatomy& anatomy = BuiltInAnatomy()) {
    return LoadModel({{"m.xml", ShoulderModelXml(anatomy, BuiltInRhythm(), options)}});
  }

  static int Id(const mjModel& model, mjtObj type, const std::string& name) {
    const int id = mj_name2id(&model, type, name.c_str());
    EXPECT_GE(id, 0) << name;
    return id;
  }

  static ResidualReport Report(ModelPointer model, Assembly assembly) {
    ShoulderSimulation simulation({std::move(model), "m.xml"}, {BuiltInRhythm(), assembly});
    return MeasureResiduals(simulation, simulation.rhythm(), BuiltInAnatomy(), [](double) {});
  }

  static std::string FailedLines(const ResidualReport& report) {
    std::string text;
    for (const Residual& residual : report.residuals) {
      if (!residual.passed()) {
        text += residual.group + " " + residual.item + "\n";
      }
    }
    return text;
  }

  static const Residual& LineOf(const ResidualReport& report, const std::string& item) {
    const auto found =
        std::find_if(report.residuals.begin(), report.residuals.end(),
                     [&item](const Residual& line) { return line.item.rfind(item, 0) == 0; });
    if (found == report.residuals.end()) {
      throw std::logic_error("the test names no line " + item);
    }
    return *found;
  }
};

// --- Ligaments ----------------------------------------------------------------------------------

TEST_F(ThoraxTest, LigamentsPullOnAClavicleThatIsDisplaced) {
  const ModelPointer model = Load({});
  const DataPointer data = MakeData(*model);
  const int joint = Id(*model, mjOBJ_JOINT, "ac_internal_rotation_r");
  const int dof = model->jnt_dofadr[joint];
  for (const auto& [name, turn_rad] : {std::pair("conoid_r", 0.5), std::pair("trapezoid_r", 0.5)}) {
    const int tendon = Id(*model, mjOBJ_TENDON, name);
    const double slack_m = model->tendon_lengthspring[2 * tendon + 1];
    const auto length_m = [&](double q_rad) {
      mj_resetData(model.get(), data.get());
      data->qpos[model->jnt_qposadr[joint]] = q_rad;
      mj_forward(model.get(), data.get());
      return data->ten_length[tendon];
    };
    const double rest_rad = model->qpos0[model->jnt_qposadr[joint]];
    ASSERT_LT(length_m(rest_rad), slack_m);
    EXPECT_EQ(data->qfrc_passive[dof], data->qfrc_gravcomp[dof]) << "slack, it must not act";
    const double turned_rad = rest_rad + turn_rad;
    ASSERT_GT(length_m(turned_rad), slack_m) << "this turn stretches nothing";
    // Torque of both: minus stiffness times elongation times how the length grows.
    double expected_N_m = 0;
    for (const char* const other : {"conoid_r", "trapezoid_r"}) {
      const int id = Id(*model, mjOBJ_TENDON, other);
      constexpr double kStep_rad = 1e-6;
      static_cast<void>(length_m(turned_rad + kStep_rad));
      const double longer_m = data->ten_length[id];
      static_cast<void>(length_m(turned_rad - kStep_rad));
      const double shorter_m = data->ten_length[id];
      static_cast<void>(length_m(turned_rad));
      const double beyond_m =
          std::max(0.0, data->ten_length[id] - model->tendon_lengthspring[2 * id + 1]);
      expected_N_m -=
          model->tendon_stiffness[id] * beyond_m * (longer_m - shorter_m) / (2 * kStep_rad);
    }
    EXPECT_NEAR(data->qfrc_passive[dof] - data->qfrc_gravcomp[dof], expected_N_m,
                1e-6 * std::abs(expected_N_m));
    EXPECT_LT(expected_N_m * turn_rad, 0) << "it must pull back";
  }
}

class EitherAssembly : public ThoraxTest, public testing::WithParamInterface<Assembly> {};

INSTANTIATE_TEST_SUITE_P(Assemblies, EitherAssembly,
                         testing::Values(Assembly::kTree, Assembly::kLoop),
                         [](const testing::TestParamInfo<Assembly>& test) {
                           return std::string(Name(test.param));
                         });

TEST_P(EitherAssembly, HasLigamentsThatTheMeasuredRhythmLeavesSlack) {
  const ResidualReport report = Report(Load({.assembly = GetParam()}), GetParam());
  EXPECT_EQ(FailedLines(report), "");
  for (const std::string name : {"conoid", "trapezoid"}) {
    EXPECT_EQ(LineOf(report, name + ", force").value, 0);
    EXPECT_EQ(LineOf(report, name + ", beyond slack").value, 0);
    EXPECT_GT(LineOf(report, name + ", shortest").value, 15);
    EXPECT_LT(LineOf(report, name + ", shortest").value, LineOf(report, name + ", longest").value);
    EXPECT_LT(LineOf(report, name + ", longest").value, 30);
  }
}

TEST_F(ThoraxTest, ReportFindsALigamentThatIsTooShort) {
  ModelPointer model = Load({});
  model->tendon_lengthspring[2 * Id(*model, mjOBJ_TENDON, "conoid_r") + 1] = 0.02;
  const std::string failed = FailedLines(Report(std::move(model), Assembly::kTree));
  EXPECT_NE(failed.find("ligaments conoid, beyond slack\n"), std::string::npos) << failed;
  EXPECT_EQ(failed.find("ligaments trapezoid"), std::string::npos) << failed;
}

TEST_F(ThoraxTest, ReportFindsALigamentThatHasMoved) {
  ModelPointer model = Load({});
  model->site_pos[3 * Id(*model, mjOBJ_SITE, "trapezoid_scapula_r")] += 1e-6;
  const std::string failed = FailedLines(Report(std::move(model), Assembly::kTree));
  EXPECT_EQ(failed, "ligaments lengths against the bones\n");
}

// --- The thorax ---------------------------------------------------------------------------------

TEST_P(EitherAssembly, PushesTsOutAsHardAsItIsPressedIn) {
  // 20 kN/m, of the bones of the built-in anatomy, to what its constants are rounded to.
  constexpr double kStiffness_N_per_m = 20000;
  constexpr double kRounded = 0.02;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const ModelPointer model =
        Load({.sides = Sides::kBoth, .assembly = GetParam(), .has_thorax_contact = true});
    const DataPointer data = MakeData(*model);
    const int surface = Id(*model, mjOBJ_GEOM, SidedName("gliding", side));
    const int elevation =
        model->actuator_ctrladr[Id(*model, mjOBJ_ACTUATOR, SidedName("elevation", side))];
    for (const double elevation_deg : {60, 90, 100}) {
      mj_resetData(model.get(), data.get());
      data->ctrl[elevation] = RadiansFromDegrees(elevation_deg);
      // Held there until nothing moves: then the force is stiffness times depth.
      for (int step = 0; step < 1500; ++step) {
        mj_step(model.get(), data.get());
      }
      int touching = 0;
      for (int i = 0; i < data->ncon; ++i) {
        const mjContact& contact = data->contact[i];
        if (contact.geom[0] != surface && contact.geom[1] != surface) {
          continue;
        }
        ++touching;
        const double force_N = data->efc_force[contact.efc_address];
        EXPECT_GT(force_N, 0) << "it never pulls";
        EXPECT_NEAR(force_N / (-contact.dist * kStiffness_N_per_m), 1, kRounded)
            << SidedName("at ", side) << elevation_deg;
      }
      EXPECT_GT(touching, 0) << "nothing is pressed in at " << elevation_deg;
    }
  }
}

TEST_P(EitherAssembly, LeavesAScapulaAloneThatIsOffTheThorax) {
  const ModelPointer model = Load({.assembly = GetParam(), .has_thorax_contact = true});
  const ModelPointer plain = Load({.assembly = GetParam()});
  const std::array<const mjModel*, 2> models = {model.get(), plain.get()};
  std::array<std::array<double, 12>, 2> qpos{};
  for (std::size_t i = 0; i < models.size(); ++i) {
    const DataPointer data = MakeData(*models[i]);
    // Across the body TS and AI stand off the ellipsoid.
    mj_resetDataKeyframe(models[i], data.get(), Id(*models[i], mjOBJ_KEY, "across_90"));
    for (int step = 0; step < 200; ++step) {
      mj_step(models[i], data.get());
      EXPECT_EQ(data->ncon, 0);
    }
    std::copy_n(data->qpos, models[i]->nq, qpos[i].begin());
  }
  EXPECT_EQ(qpos[0], qpos[1]);
}

TEST_P(EitherAssembly, PassesTheReportOnTheThorax) {
  const ResidualReport report =
      Report(Load({.assembly = GetParam(), .has_thorax_contact = true}), GetParam());
  EXPECT_EQ(FailedLines(report), "");
  EXPECT_GT(LineOf(report, "force on TS or AI").value, 50);
  EXPECT_GT(LineOf(report, "TS or AI in the ellipsoid").value, 1);
  EXPECT_GT(LineOf(report, "SC pushed off its target").value, 0.1);
}

TEST_F(ThoraxTest, ReportHasNoContactWhereThereIsNone) {
  const ResidualReport report = Report(Load({}), Assembly::kTree);
  EXPECT_TRUE(std::none_of(report.residuals.begin(), report.residuals.end(),
                           [](const Residual& line) { return line.group == "thorax contact"; }));
}

TEST_F(ThoraxTest, ReportFindsAnotherSurfaceThanTheAnatomys) {
  ModelPointer model = Load({.has_thorax_contact = true});
  model->geom_pos[3 * Id(*model, mjOBJ_GEOM, "gliding_r")] -= 0.0001;
  const std::string failed = FailedLines(Report(std::move(model), Assembly::kTree));
  EXPECT_EQ(failed, "thorax contact depth against the anatomy's\n");
}

TEST_F(ThoraxTest, TheThoraxIsNoExcuseForAServoThatIsOff) {
  ModelPointer model = Load({.actuation = Actuation::kPosition, .has_thorax_contact = true});
  const int servo = Id(*model, mjOBJ_ACTUATOR, "ac_tilt_r");
  model->actuator_biasprm[mjNBIAS * servo + 1] *= 0.9;
  const std::string failed = FailedLines(Report(std::move(model), Assembly::kTree));
  EXPECT_NE(failed.find("tracking settled AC\n"), std::string::npos) << failed;
}

TEST_F(ThoraxTest, AModelWithoutALigamentIsRefused) {
  std::string xml = ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm(), {});
  const std::string name = "name=\"conoid_r\"";
  xml.replace(xml.find(name), name.size(), "name=\"conoid\"");
  try {
    const ShoulderSimulation simulation(LoadModel({{"m.xml", xml}}), "m.xml");
    FAIL() << "nothing was thrown";
  } catch (const std::exception& error) {
    EXPECT_STREQ(error.what(),
                 "m.xml: has no tendon \"conoid_r\". Restore it, or make the model anew with "
                 "girdle generate");
  }
}

}  // namespace
}  // namespace girdle::thorax_test
