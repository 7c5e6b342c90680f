// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Every checked line of the residual report has a model here that is wrong in one thing and makes
// the line fail. The lines that must fail are said exactly: a fault is found where it is, and
// elsewhere only where it cannot but show.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/isb_frames.h"
#include "residuals/report_lines.h"
#include "residuals/residual_groups.h"
#include "residuals/residuals.h"
#include "simulation/engine_fixture.h"
#include "simulation/shoulder_simulation.h"

namespace girdle::wrong_models_test {
namespace {

using Lines = std::set<std::string>;

// --- What is made wrong --------------------------------------------------------------------------

// Something in the compiled model of the right shoulder.
using ModelFault = std::function<void(mjModel&)>;
// Something in the XML.
using XmlFault = std::function<std::string(std::string)>;
// Something in the table by which the model moves and against which it is held.
using TableFault = std::function<void(std::vector<RhythmPosition>&)>;

struct WrongModel {
  std::string name;
  ModelKind kind;
  Lines fails;
  ModelFault model = nullptr;
  XmlFault xml = nullptr;
  TableFault table = nullptr;
};

int IdOf(const mjModel& model, mjtObj type, const std::string& name) {
  const int id = mj_name2id(&model, type, name.c_str());
  if (id < 0) {
    throw std::logic_error("the model has no " + name);
  }
  return id;
}

// Ten micrometers along a body's or a site's axis: less than bone pins resolve.
constexpr double kShift_m = 1e-5;
// A few hundredths of a degree.
constexpr double kTurn_rad = 1e-3;

ModelFault SiteMoved(const std::string& name, int axis, double by_m = kShift_m) {
  return [=](mjModel& model) { model.site_pos[3 * IdOf(model, mjOBJ_SITE, name) + axis] += by_m; };
}
ModelFault BodyMoved(const std::string& name, int axis) {
  return
      [=](mjModel& model) { model.body_pos[3 * IdOf(model, mjOBJ_BODY, name) + axis] += kShift_m; };
}
// A hinge's axis in its body, turned about another of the body's axes.
ModelFault AxisTilted(const std::string& joint, int towards) {
  return [=](mjModel& model) {
    mjtNum* const axis = model.jnt_axis + 3 * IdOf(model, mjOBJ_JOINT, joint);
    axis[towards] += kTurn_rad;
    mju_normalize3(axis);
  };
}
ModelFault ReferenceMoved(const std::string& joint, double by) {
  return [=](mjModel& model) {
    model.qpos0[model.jnt_qposadr[IdOf(model, mjOBJ_JOINT, joint)]] += by;
  };
}
// A spring in parallel to the servo, which pulls to where the joint starts.
ModelFault SpringAdded(const std::string& joint, double stiffness_N_m_per_rad) {
  return [=](mjModel& model) {
    const int id = IdOf(model, mjOBJ_JOINT, joint);
    model.jnt_stiffness[id] = stiffness_N_m_per_rad;
  };
}
ModelFault DampingScaled(const std::string& joint, double factor) {
  return [=](mjModel& model) {
    model.dof_damping[model.jnt_dofadr[IdOf(model, mjOBJ_JOINT, joint)]] *= factor;
  };
}
ModelFault LowerLimit(const std::string& joint, double lower) {
  return [=](mjModel& model) { model.jnt_range[2 * IdOf(model, mjOBJ_JOINT, joint)] = lower; };
}
ModelFault SlackShortened(const std::string& ligament, double by_m) {
  return [=](mjModel& model) {
    const int id = IdOf(model, mjOBJ_TENDON, ligament);
    model.tendon_lengthspring[2 * id + 1] -= by_m;
  };
}
// A number of a ligament that MuJoCo holds, one or two of them for each tendon.
ModelFault TendonSet(const std::string& ligament, mjtNum* mjModel::*values, int of_each, int which,
                     double value) {
  return [=](mjModel& model) {
    (model.*values)[of_each * IdOf(model, mjOBJ_TENDON, ligament) + which] = value;
  };
}
// An attribute of a ligament in the XML.
XmlFault LigamentSays(const std::string& ligament, const std::string& attribute,
                      const std::string& value) {
  return [=](std::string xml) {
    const std::size_t tendon = xml.find("<spatial name=\"" + ligament + "\"");
    const std::string begin = " " + attribute + "=\"";
    const std::size_t at = tendon == std::string::npos ? tendon : xml.find(begin, tendon);
    if (at == std::string::npos) {
      throw std::logic_error("the model's " + ligament + " says no " + attribute);
    }
    const std::size_t from = at + begin.size();
    return xml.replace(from, xml.find('"', from) - from, value);
  };
}
ModelFault ConnectSoftened(double time_constant_s, double damping_ratio) {
  return [=](mjModel& model) {
    mjtNum* const solref = model.eq_solref + mjNREF * IdOf(model, mjOBJ_EQUALITY, "AC_r");
    solref[0] = time_constant_s;
    solref[1] = damping_ratio;
  };
}
// A body's principal moments in another order, with or without their axes.
ModelFault MomentsPermuted(const std::string& body, bool with_axes) {
  return [=](mjModel& model) {
    const int id = IdOf(model, mjOBJ_BODY, body);
    mjtNum* const moments_kg_m2 = model.body_inertia + 3 * id;
    std::rotate(moments_kg_m2, moments_kg_m2 + 1, moments_kg_m2 + 3);
    if (with_axes) {
      // The first axis is the bone's second one, and so on.
      std::fill_n(model.body_iquat + 4 * id, 4, 0.5);
      model.body_sameframe[id] = mjSAMEFRAME_NONE;
    }
  };
}
ModelFault ThoraxStiffened(double factor) {
  return [=](mjModel& model) {
    for (int i = 0; i < model.npair; ++i) {
      model.pair_solref[mjNREF * i] *= factor;
    }
  };
}
ModelFault KeyframeMoved(const std::string& key, const std::string& joint, double by) {
  return [=](mjModel& model) {
    model.key_qpos[model.nq * IdOf(model, mjOBJ_KEY, key) +
                   model.jnt_qposadr[IdOf(model, mjOBJ_JOINT, joint)]] += by;
  };
}
// The equality of a loop's AC joint takes a site beside the clavicle's own.
XmlFault ConnectedBeside(double by_m) {
  return [=](std::string xml) {
    const std::string site = "<site name=\"PAC_r\" pos=\"";
    const std::size_t at = xml.find(site);
    const std::size_t connect = xml.find("site1=\"PAC_r\"");
    if (at == std::string::npos || connect == std::string::npos) {
      throw std::logic_error("the model has no connect of PAC_r");
    }
    std::istringstream numbers(xml.substr(at + site.size(), 200));
    Vector3 p_m;
    numbers >> p_m.x >> p_m.y >> p_m.z;
    xml.replace(connect, 13, "site1=\"beside\"");
    std::ostringstream beside;
    beside.precision(17);
    beside << "<site name=\"beside\" pos=\"" << p_m.x + by_m << " " << p_m.y << " " << p_m.z
           << "\"/>";
    return xml.insert(at, beside.str());
  };
}

// Something beside the shoulder that never comes to rest.
XmlFault BodyAdded(const std::string& joint) {
  return [=](std::string xml) {
    const std::string end = "</worldbody>";
    const std::size_t at = xml.find(end);
    if (at == std::string::npos) {
      throw std::logic_error("the model has no " + end);
    }
    return xml.insert(at, "<body pos=\"2 0 1\">" + joint +
                              R"(<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>)");
  };
}

Quaternion TurnAbout(const Vector3& axis, double angle_deg) {
  return glm::angleAxis(RadiansFromDegrees(angle_deg), axis);
}

// How far something is turned at a position of a table, by the position's number [deg].
using AngleOver = std::function<double(std::size_t)>;

AngleOver Everywhere(double angle_deg) {
  return [=](std::size_t) { return angle_deg; };
}
// Half in general, and all of it about elevation 70: so smoothly that nothing jerks.
AngleOver MostlyAtMiddleElevations(double angle_deg) {
  return [=](std::size_t i) {
    constexpr std::size_t kElevations = 22;
    const double rows = (static_cast<double>(i % kElevations) - 11) / 4;
    return angle_deg * (0.5 + 0.5 * std::exp(-rows * rows));
  };
}
// In the frontal plane alone, about elevation 95.
AngleOver InAbduction(double angle_deg) {
  return [=](std::size_t i) {
    constexpr std::size_t kElevations = 22;
    const double rows = (static_cast<double>(i) - 16) / 1.2;
    return i < kElevations ? angle_deg * std::exp(-rows * rows) : 0;
  };
}

// Published ST as far away from where SC and AC put the scapula.
TableFault StTurned(const AngleOver& angle_deg) {
  return [=](std::vector<RhythmPosition>& positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Quaternion q_TS =
          PoseFromAngles(positions[i].angles_rad).q_TS() * TurnAbout({0, 0, 1}, angle_deg(i));
      positions[i].scapulothoracic_rad = EulerFromQuaternion(EulerSequence::kYXZ, q_TS);
    }
  };
}

// SC turned about the thorax's axis to the right, and ST with it: they agree as before.
TableFault GirdleTurned(const AngleOver& angle_deg) {
  return [=](std::vector<RhythmPosition>& positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Quaternion turn = TurnAbout({0, 0, 1}, angle_deg(i));
      RhythmPosition& position = positions[i];
      const Vector3 sc_rad =
          EulerFromQuaternion(kJointSequences[0], turn * PoseFromAngles(position.angles_rad).q_TC);
      for (int k = 0; k < 3; ++k) {
        position.angles_rad[static_cast<std::size_t>(k)] = sc_rad[k];
      }
      if (position.scapulothoracic_rad) {
        position.scapulothoracic_rad = EulerFromQuaternion(
            EulerSequence::kYXZ,
            turn * QuaternionFromEuler(EulerSequence::kYXZ, *position.scapulothoracic_rad));
      }
    }
  };
}

// --- The models ----------------------------------------------------------------------------------

Lines InGroup(const std::string& group, const std::vector<std::string>& items) {
  Lines lines;
  for (const std::string& item : items) {
    lines.insert(group + ": " + item);
  }
  return lines;
}
Lines operator+(Lines a, const Lines& b) {
  a.insert(b.begin(), b.end());
  return a;
}

Lines JointConstraint(const std::vector<std::string>& items) {
  return InGroup("joint constraint", items);
}
Lines Bones(const std::vector<std::string>& items) { return InGroup("bones", items); }
Lines Consistency(const std::vector<std::string>& items) {
  return InGroup("kinematic consistency", items);
}
Lines Settled(const std::vector<std::string>& items) { return InGroup("tracking settled", items); }
Lines Moving(const std::vector<std::string>& items) { return InGroup("tracking moving", items); }
Lines Scapulothoracic(const std::vector<std::string>& items) {
  return InGroup("scapulothoracic", items);
}
Lines EmergentAc(const std::vector<std::string>& items) { return InGroup("emergent AC", items); }
Lines Ligaments(const std::vector<std::string>& items) { return InGroup("ligaments", items); }

const Lines kReached =
    InGroup("closure", {"elevation reached - commanded", "plane reached - commanded"});
const Lines kOwn =
    InGroup("closure", {"elevation against the table's own", "plane against the table's own"});

std::vector<WrongModel> WrongModels() {
  const ModelKind tree = ModelKind::kTree;
  const ModelKind published = ModelKind::kPublished;
  const ModelKind loop = ModelKind::kLoop;
  const ModelKind scapula_leads = ModelKind::kScapulaLeads;
  const ModelKind contact = ModelKind::kContact;
  const ModelKind small = ModelKind::kSmallContact;
  constexpr int kX = 0;
  constexpr int kY = 1;
  return {
      // Bones in other places.
      {"ClavicleMoved", tree, JointConstraint({"SC"}), BodyMoved("clavicle_r", kX)},
      {"ScapulaMoved", tree, JointConstraint({"AC"}) + Ligaments({"lengths against the bones"}),
       BodyMoved("scapula_r", kX)},
      {"HumerusMoved", tree, JointConstraint({"GH"}), BodyMoved("humerus_r", kX)},
      {"LandmarkOfTheThoraxMoved", tree, Bones({"landmarks"}), SiteMoved("C7", kX)},
      {"LandmarkOfTheClavicleMoved", tree,
       JointConstraint({"AC"}) + Bones({"landmarks"}) + Consistency({"clavicle landmarks"}),
       SiteMoved("PAC_r", kX)},
      {"LandmarkOfTheScapulaMoved", tree, Bones({"landmarks"}) + Consistency({"scapula landmarks"}),
       SiteMoved("TS_r", kY)},
      {"LandmarkOfTheHumerusMoved", tree,
       Bones({"landmarks"}) + Consistency({"humerus landmarks"}) + kReached, SiteMoved("EM_r", kX)},
      {"Heavier", tree, Bones({"masses"}),
       [](mjModel& model) { model.body_mass[IdOf(model, mjOBJ_BODY, "humerus_r")] += 1e-6; }},
      {"CentreOfMassMoved", tree, Bones({"centres of mass"}),
       [](mjModel& model) {
         model.body_ipos[3 * IdOf(model, mjOBJ_BODY, "scapula_r")] += kShift_m;
       }},
      {"OtherMoments", tree, Bones({"moments of inertia"}),
       [](mjModel& model) {
         model.body_inertia[3 * IdOf(model, mjOBJ_BODY, "clavicle_r")] += 1e-8;
       }},
      // Sound: the second axis has the moment about the bone's third one, and so on.
      {"AxesOfMomentsPermuted", tree, Lines{}, MomentsPermuted("scapula_r", true)},
      {"MomentsPermutedAlone", tree, Bones({"moments of inertia"}),
       MomentsPermuted("scapula_r", false)},
      {"TurnedMoments", tree, Bones({"moments of inertia"}),
       [](mjModel& model) {
         mjtNum* const q = model.body_iquat + 4 * IdOf(model, mjOBJ_BODY, "humerus_r");
         q[1] += kTurn_rad;
         mju_normalize4(q);
       }},

      // Joints that turn otherwise.
      {"HingeOfScTilted", tree,
       Consistency({"SC", "clavicle landmarks", "scapula landmarks", "humerus landmarks"}) +
           kReached,
       AxisTilted("sc_elevation_r", kY)},
      {"HingeOfAcTilted", tree,
       Consistency({"AC", "scapula landmarks", "humerus landmarks"}) + kReached +
           Ligaments({"lengths against the bones"}),
       AxisTilted("ac_upward_rotation_r", kY)},
      {"HingeOfGhTilted", tree, Consistency({"GH", "humerus landmarks"}) + kReached,
       AxisTilted("gh_elevation_r", kY)},
      {"TurnOfTheHumerusShifted", tree, Consistency({"GH", "humerus landmarks"}),
       ReferenceMoved("gh_axial_r", kTurn_rad)},
      {"HingeOfScTiltedOfThePublishedRhythm", published,
       Consistency({"SC", "clavicle landmarks", "scapula landmarks", "humerus landmarks"}) + kOwn,
       AxisTilted("sc_elevation_r", kY)},
      {"KeyframeMoved", tree, Consistency({"keyframes"}),
       KeyframeMoved("flexion_90", "sc_elevation_r", kTurn_rad)},
      {"KeyframeHeldElsewhere", tree, Consistency({"keyframes"}),
       [](mjModel& model) {
         model.key_ctrl[model.nu * IdOf(model, mjOBJ_KEY, "relaxed") + 3] += kTurn_rad;
       }},
      {"PlaceOfTheScapulaMoved", loop,
       Consistency({"scapula's place"}) + Ligaments({"lengths against the bones"}) + kReached,
       ReferenceMoved("st_anterior_r", kShift_m)},
      {"PlaceOfAKeyframeMoved", loop, Consistency({"keyframes, scapula's place"}),
       KeyframeMoved("abduction_90", "st_anterior_r", kShift_m)},

      // Servos that do not follow.
      {"SpringOnSc", tree, Settled({"SC"}) + kReached, SpringAdded("sc_protraction_r", 3)},
      {"SpringOnAc", tree, Settled({"AC"}) + kReached, SpringAdded("ac_tilt_r", 3)},
      {"SpringOnGh", tree, Settled({"GH"}) + kReached, SpringAdded("gh_flexion_r", 3)},
      {"SpringOnSt", loop, Settled({"ST"}) + kReached, SpringAdded("st_tilt_r", 3)},
      {"SpringOnThePlaceThatLeads", scapula_leads, Settled({"SC"}) + kReached,
       SpringAdded("st_superior_r", 100)},
      {"DragOnSc", tree, Moving({"SC"}), DampingScaled("sc_rotation_r", 10)},
      {"DragOnAc", tree, Moving({"AC"}), DampingScaled("ac_upward_rotation_r", 11)},
      {"DragOnGh", tree, Moving({"GH"}), DampingScaled("gh_elevation_r", 2)},
      {"DragOnSt", loop, Moving({"ST"}), DampingScaled("st_upward_rotation_r", 10)},
      {"APendulumSwings", tree, Settled({"fastest joint"}), nullptr,
       BodyAdded(R"(<joint axis="0 1 0" stiffness="10" ref=".1"/>)")},
      {"AWeightBounces", loop, Settled({"scapula's place, fastest"}), nullptr,
       BodyAdded(R"(<joint type="slide" axis="0 0 1" stiffness="1000"/>)")},

      // Limits in the way.
      {"EndNotReached", tree, kReached, LowerLimit("gh_elevation_r", -2)},

      // A loop that does not close.
      {"ConnectSoft", loop, JointConstraint({"AC at 1 Hz"}), ConnectSoftened(0.008, 0.7)},
      {"ConnectSofter", loop, JointConstraint({"AC moving", "AC at 1 Hz"}),
       ConnectSoftened(0.02, 0.7)},
      {"ConnectedBeside", loop, JointConstraint({"AC at rest", "AC at the worst pose"}) + kReached,
       nullptr, ConnectedBeside(5.5e-5)},

      // Tables that contradict themselves, or take the scapula through the ribs.
      {"StElsewhereThroughout", tree, Scapulothoracic({"published ST, rms"}), nullptr, nullptr,
       StTurned(Everywhere(2.4))},
      {"StElsewhereInTheMiddle", tree, Scapulothoracic({"published ST, worst"}), nullptr, nullptr,
       StTurned(MostlyAtMiddleElevations(2.8))},
      {"StElsewhereThroughoutInALoop", loop, EmergentAc({"measured AC, rms"}), nullptr, nullptr,
       StTurned(Everywhere(2.4))},
      {"StElsewhereInTheMiddleInALoop", loop, EmergentAc({"measured AC, worst"}), nullptr, nullptr,
       StTurned(MostlyAtMiddleElevations(2.8))},
      {"GirdleElsewhereThroughout", tree, Scapulothoracic({"TS, AI to ellipsoid, rms"}), nullptr,
       nullptr, GirdleTurned(Everywhere(-2))},
      {"GirdleElsewhereInAbduction", tree, Scapulothoracic({"TS, AI to ellipsoid, worst"}), nullptr,
       nullptr, GirdleTurned(InAbduction(6))},

      // Ligaments.
      {"LigamentAttachedElsewhere", tree, Ligaments({"lengths against the bones"}),
       SiteMoved("conoid_scapula_r", kY)},
      {"ConoidShort", tree,
       Ligaments({"conoid, beyond slack", "slack against the anatomy's"}) + kReached,
       SlackShortened("conoid_r", 2e-4)},
      {"TrapezoidShort", tree,
       Ligaments({"trapezoid, beyond slack", "slack against the anatomy's"}) + kReached,
       SlackShortened("trapezoid_r", 2e-4)},
      // A ligament that never pulls is never beyond slack.
      {"ConoidNeverTaut", tree, Ligaments({"slack against the anatomy's"}), nullptr,
       LigamentSays("conoid_r", "springlength", "0 1")},
      {"TrapezoidLongerByAHundredthOfAMillimeter", loop, Ligaments({"slack against the anatomy's"}),
       SlackShortened("trapezoid_r", -kShift_m)},
      {"ConoidPushes", tree, Ligaments({"slack against the anatomy's"}),
       TendonSet("conoid_r", &mjModel::tendon_lengthspring, 2, 0, 1e-4)},
      {"ConoidWithoutStiffness", tree, Ligaments({"stiffness against the anatomy's"}), nullptr,
       LigamentSays("conoid_r", "stiffness", "0")},
      {"TrapezoidStiffer", tree, Ligaments({"stiffness against the anatomy's"}),
       [](mjModel& model) {
         model.tendon_stiffness[IdOf(model, mjOBJ_TENDON, "trapezoid_r")] *= 1 + 1e-6;
       }},
      {"ConoidTearsEarly", tree, Ligaments({"range against the anatomy's"}),
       [](mjModel& model) {
         model.tendon_range[2 * IdOf(model, mjOBJ_TENDON, "conoid_r") + 1] -= kShift_m;
       }},
      {"TrapezoidHoldsFromSomeLength", tree, Ligaments({"range against the anatomy's"}),
       TendonSet("trapezoid_r", &mjModel::tendon_range, 2, 0, kShift_m)},
      {"TrapezoidNeverTears", tree, Ligaments({"range against the anatomy's"}),
       [](mjModel& model) {
         model.tendon_limited[IdOf(model, mjOBJ_TENDON, "trapezoid_r")] = false;
       }},

      // The thorax.
      {"ThoraxSoft", contact, Lines{kContactStiffnessLine}, ThoraxStiffened(0.7)},
      {"ThoraxSoftOfASmallPerson", small, Lines{kContactStiffnessLine}, ThoraxStiffened(0.7)},
      {"ThoraxStiffOfASmallPerson", small, Lines{kContactStiffnessLine}, ThoraxStiffened(1.4)},
      {"ArmatureOff", contact, Lines{"thorax contact: armature against the built-in's"},
       [](mjModel& model) {
         model.dof_armature[model.jnt_dofadr[IdOf(model, mjOBJ_JOINT, "ac_tilt_r")]] *= 1 + 1e-6;
       }},
      {"ThoraxElsewhere", contact, Lines{"thorax contact: depth against the anatomy's"},
       [](mjModel& model) { model.geom_size[3 * IdOf(model, mjOBJ_GEOM, "gliding_r")] += 1e-4; }},
  };
}

// --- Held against the report ---------------------------------------------------------------------

RhythmTable WithFault(const RhythmTable& table, const TableFault& fault) {
  std::vector<RhythmPosition> positions;
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
      positions.push_back(table.position(plane, elevation));
    }
  }
  fault(positions);
  return {table.planes_rad(), table.elevations_rad(), std::move(positions)};
}

class WrongModelTest : public EngineTest, public testing::WithParamInterface<WrongModel> {};

TEST_P(WrongModelTest, FailsInTheseLinesAlone) {
  const WrongModel& wrong = GetParam();
  const Anatomy anatomy = AnatomyOf(wrong.kind);
  const ShoulderModelOptions options = ModelOptionsOf(wrong.kind);
  ShoulderRhythm rhythm = BuiltInRhythm(RhythmOptionsOf(wrong.kind));
  if (wrong.table) {
    rhythm =
        ShoulderRhythm(WithFault(rhythm.table(), wrong.table), rhythm.options(), rhythm.ranges());
  }
  std::string xml = ShoulderModelXml(anatomy, rhythm, options);
  if (wrong.xml) {
    xml = wrong.xml(std::move(xml));
  }
  ModelPointer model = LoadModel({{"shoulder.xml", xml}});
  if (wrong.model) {
    wrong.model(*model);
  }
  ShoulderSimulation simulation(std::move(model), "shoulder.xml");
  const ResidualReport report =
      MeasureResiduals(simulation, {rhythm, options.assembly}, anatomy, [](double) {});
  Lines failed;
  std::string values;
  for (const Residual& line : report.residuals) {
    if (!line.passed()) {
      failed.insert(LineName(line));
    }
    if (!line.passed() || wrong.fails.contains(LineName(line))) {
      values += LineName(line) + " " + std::to_string(line.value) + " " + line.where + "\n";
    }
  }
  EXPECT_EQ(failed, wrong.fails) << values;
}

INSTANTIATE_TEST_SUITE_P(Faults, WrongModelTest, testing::ValuesIn(WrongModels()),
                         [](const testing::TestParamInfo<WrongModel>& row) {
                           return row.param.name;
                         });

TEST(WrongModels, MakeEveryCheckedLineFail) {
  Lines failed;
  for (const WrongModel& wrong : WrongModels()) {
    failed.insert(wrong.fails.begin(), wrong.fails.end());
  }
  Lines checked;
  for (const ModelKind kind : kModelKinds) {
    for (const ReportLine& line : LinesOf(kind)) {
      if (line.is_checked()) {
        checked.insert(line.name);
      }
    }
  }
  EXPECT_EQ(failed, checked);
}

}  // namespace
}  // namespace girdle::wrong_models_test
