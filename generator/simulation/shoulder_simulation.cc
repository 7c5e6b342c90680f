// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/shoulder_simulation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "anatomy/posed_bones.h"
#include "kinematics/worst_case.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

Vector3 PositionAt(const mjtNum* p) { return {p[0], p[1], p[2]}; }

}  // namespace

ShoulderSimulation::ShoulderSimulation(LoadedShoulders shoulders, AssembledRhythm rhythm)
    : loaded_(std::move(shoulders)),
      rhythm_(std::move(rhythm)),
      axial_from_(OwnAxialFrom(loaded_)) {}

ShoulderSimulation::ShoulderSimulation(LoadedShoulders shoulders)
    : loaded_(std::move(shoulders)),
      rhythm_(OwnRhythm(loaded_)),
      axial_from_(OwnAxialFrom(loaded_)) {}

double ShoulderSimulation::WithinControl(double value, int control) const {
  if (control < 0 || model().actuator_ctrllimited[control] == 0) {
    return value;
  }
  const mjtNum* const range = model().actuator_ctrlrange + 2 * control;
  return std::clamp(value, range[0], range[1]);
}

// Axial turns are recounted for the command within the controls' ranges, because the plugin solves
// that command.
ArmCommand ShoulderSimulation::AsModelCounts(const ArmCommand& command) const {
  if (command.axial_from == axial_from_) {
    return command;
  }
  ArmCommand read = command;
  if (has_plugin()) {
    read.elevation_rad = WithinControl(command.elevation_rad, elements().command_controls[0]);
    read.plane_rad = WithinControl(command.plane_rad, elements().command_controls[1]);
  }
  ArmCommand counted = command;
  counted.axial_rad = rhythm_.rhythm().AxialCountedFrom(axial_from_, read);
  counted.axial_from = axial_from_;
  return counted;
}

void ShoulderSimulation::SetCommand(const ArmCommand& command, const CommandRate& rate) {
  const ArmCommand counted = AsModelCounts(command);
  if (!has_plugin()) {
    target_ = rhythm_.SolvePose(counted, &used_);
  }
  for (const ShoulderElements& elements : shoulders()) {
    if (has_plugin()) {
      SetPluginCommand(elements, counted, rate);
    } else {
      SetServos(elements);
    }
  }
}

void ShoulderSimulation::SetPluginCommand(const ShoulderElements& elements,
                                          const ArmCommand& command, const CommandRate& rate) {
  data().ctrl[elements.command_controls[0]] = command.elevation_rad;
  data().ctrl[elements.command_controls[1]] = command.plane_rad;
  data().ctrl[elements.command_controls[2]] = command.axial_rad;
  const std::array<double, kOffsetCount> offsets_rad = {command.shrug_rad, command.protraction_rad};
  for (std::size_t i = 0; i < kOffsetCount; ++i) {
    if (elements.offset_controls[i] >= 0) {
      data().ctrl[elements.offset_controls[i]] = offsets_rad[i];
    } else if (offsets_rad[i] != 0) {
      throw InputError(name() + ": " + std::string(kOffsetNames[i]) +
                       " is commanded, and the model has no actuator \"" +
                       SidedName(kOffsetNames[i], elements.side) +
                       "\". Make one that has with girdle generate --offsets");
    }
  }
  for (std::size_t i = 0; i < kRateCount; ++i) {
    if (elements.rate_controls[i] >= 0) {
      data().ctrl[elements.rate_controls[i]] = rate[i];
    }
  }
}

JointAngles ShoulderSimulation::TargetsOf(const ShoulderElements& elements) const {
  if (!elements.has_plugin()) {
    return DrivenAngles(elements.assembly, target_);
  }
  JointAngles target_rad{};
  std::copy_n(data().sensordata + elements.sensor + sensor_layout::kTarget, kCoordinateCount,
              target_rad.begin());
  return target_rad;
}

// Returns the place of the AC joint on the clavicle at SC's targets, in the thorax, mirrored to the
// right.
Vector3 ShoulderSimulation::PlaceFor(const ShoulderElements& elements,
                                     const JointAngles& target_rad) const {
  const Quaternion q_TC =
      QuaternionFromEuler(kJointSequences[0], {target_rad[0], target_rad[1], target_rad[2]});
  const int clavicle = elements.bodies[static_cast<std::size_t>(Segment::kClavicle)];
  const int site = elements.sites[static_cast<std::size_t>(Landmark::kPAC)];
  return OnSide(elements.side, PositionAt(model().body_pos + 3 * clavicle)) +
         q_TC * OnSide(elements.side, PositionAt(model().site_pos + 3 * site));
}

void ShoulderSimulation::SetServos(const ShoulderElements& elements) {
  const JointAngles target_rad = TargetsOf(elements);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    if (elements.joint_controls[k] >= 0) {
      data().ctrl[elements.joint_controls[k]] = target_rad[k];
    }
  }
  if (elements.lead == Lead::kScapula) {
    const Vector3 place_m = PlaceFor(elements, target_rad);
    for (int i = 0; i < 3; ++i) {
      data().ctrl[elements.place_controls[static_cast<std::size_t>(i)]] = place_m[i];
    }
  }
}

std::vector<std::string> ShoulderSimulation::TargetNames() const {
  std::vector<std::string> names;
  for (const ShoulderElements& elements : shoulders()) {
    const auto coordinates = DrivenCoordinates(elements.assembly);
    const bool leads = elements.lead == Lead::kScapula;
    for (std::size_t k = leads ? 2 : 0; k < kCoordinateCount; ++k) {
      names.push_back(SidedName(coordinates[k], elements.side));
    }
    for (std::size_t i = 0; leads && i < kTranslationNames.size(); ++i) {
      names.push_back(SidedName(kTranslationNames[i], elements.side));
    }
  }
  return names;
}

std::vector<double> ShoulderSimulation::Targets() const {
  std::vector<double> targets;
  for (const ShoulderElements& elements : shoulders()) {
    const JointAngles target_rad = TargetsOf(elements);
    if (elements.lead == Lead::kClavicle) {
      targets.insert(targets.end(), target_rad.begin(), target_rad.end());
      continue;
    }
    targets.insert(targets.end(), target_rad.begin() + 2, target_rad.end());
    const Vector3 place_m = PlaceFor(elements, target_rad);
    targets.insert(targets.end(), {place_m.x, place_m.y, place_m.z});
  }
  return targets;
}

std::vector<std::string> ShoulderSimulation::LoopNames() const {
  std::vector<std::string> names;
  for (const ShoulderElements& elements : shoulders()) {
    if (elements.assembly == Assembly::kLoop) {
      names.push_back(SidedName(kConnectName, elements.side));
    }
  }
  return names;
}

std::vector<double> ShoulderSimulation::LoopGaps_m() const {
  constexpr std::size_t kAc = 1;
  std::vector<double> gaps_m;
  for (const ShoulderElements& elements : shoulders()) {
    if (elements.assembly == Assembly::kLoop) {
      const int on_clavicle = elements.sites[static_cast<std::size_t>(Landmark::kPAC)];
      const int on_scapula = elements.sites[kLandmarkCount + kAc];
      gaps_m.push_back(glm::distance(PositionAt(data().site_xpos + 3 * on_clavicle),
                                     PositionAt(data().site_xpos + 3 * on_scapula)));
    }
  }
  return gaps_m;
}

JointAngles ShoulderSimulation::Positions() const {
  JointAngles position_rad{};
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    position_rad[k] = data().qpos[elements().qpos[k]];
  }
  return position_rad;
}

ShoulderState ShoulderSimulation::Derived(double time_s, const ArmCommand& command,
                                          const JointAngles& position_rad) const {
  ShoulderState state;
  state.time_s = time_s;
  state.command = command;
  state.position_rad = position_rad;
  state.fastest_rad_per_s = FastestJoint(mjJNT_HINGE);
  state.fastest_m_per_s = FastestJoint(mjJNT_SLIDE);
  state.target_rad = TargetsOf(elements());
  if (has_plugin()) {
    const mjtNum* sensor = data().sensordata + elements().sensor;
    state.distance_rad = sensor[sensor_layout::kDistance];
    state.used = command;
    state.used.elevation_rad = sensor[sensor_layout::kCommanded];
    state.used.plane_rad = sensor[sensor_layout::kCommanded + 1];
    state.used.axial_rad = sensor[sensor_layout::kCommanded + 2];
    state.used.axial_from = AxialFrom::kRhythm;
    TakeOffsetsUsed(state.used);
    state.used_axial_isb_rad = sensor[sensor_layout::kCommandedIsb];
    state.clamped = rhythm_.rhythm().IsClamped(AsModelCounts(command), state.used);
  } else {
    state.distance_rad = rhythm_.rhythm().DistanceOutside(command.elevation_rad, command.plane_rad);
    state.used = used_;
    state.used_axial_isb_rad = rhythm_.rhythm().AxialOf(AxialFrom::kIsb, target_, used_);
    state.clamped = rhythm_.rhythm().IsClamped(command, used_);
  }
  state.connect_force_N = ConnectForce();
  AddLigaments(state);
  if (elements().has_thorax_contact()) {
    AddThoraxContact(state);
  }
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const mjtNum* q = data().xquat + 4 * elements().bodies[i];
    state.q_WB[i] = {q[0], q[1], q[2], q[3]};
  }
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    const mjtNum* p = data().site_xpos + 3 * elements().sites[i];
    state.site_m[i] = {p[0], p[1], p[2]};
  }
  return state;
}

void ShoulderSimulation::TakeOffsetsUsed(ArmCommand& used) const {
  if (used.shrug_rad == 0 && used.protraction_rad == 0) {
    return;
  }
  ArmCommand read = used;
  read.shrug_rad = WithinControl(used.shrug_rad, elements().offset_controls[0]);
  read.protraction_rad = WithinControl(used.protraction_rad, elements().offset_controls[1]);
  ArmCommand left;
  static_cast<void>(rhythm_.SolvePose(read, &left));
  used.shrug_rad = left.shrug_rad;
  used.protraction_rad = left.protraction_rad;
}

double ShoulderSimulation::FastestJoint(mjtJoint type) const {
  double fastest = 0;
  for (int joint = 0; joint < model().njnt; ++joint) {
    if (model().jnt_type[joint] == type) {
      fastest = WorseOf(fastest, std::abs(data().qvel[model().jnt_dofadr[joint]]));
    }
  }
  return fastest;
}

// Returns the length of the sum of the constraint's three forces.
double ShoulderSimulation::ConnectForce() const {
  double squared = 0;
  for (int row = 0; elements().connect >= 0 && row < data().nefc; ++row) {
    if (data().efc_type[row] == mjCNSTR_EQUALITY && data().efc_id[row] == elements().connect) {
      squared += data().efc_force[row] * data().efc_force[row];
    }
  }
  return std::sqrt(squared);
}

void ShoulderSimulation::AddLigaments(ShoulderState& state) const {
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    const int tendon = elements().tendons[i];
    state.ligament_m[i] = data().ten_length[tendon];
    const double beyond_slack_m = state.ligament_m[i] - model().tendon_lengthspring[2 * tendon + 1];
    // A length that is NaN counts as beyond slack.
    state.ligament_force_N[i] =
        model().tendon_stiffness[tendon] * (beyond_slack_m <= 0 ? 0 : beyond_slack_m);
  }
}

bool ShoulderSimulation::IsOnThorax(const mjContact& contact) const {
  return contact.efc_address >= 0 &&
         (contact.geom[0] == elements().gliding || contact.geom[1] == elements().gliding);
}

// Returns the torque of the thorax on each degree of freedom, through its contacts and, in a loop,
// through the AC joint. Forces of joint limits are not included.
std::vector<double> ShoulderSimulation::PushingTorques() const {
  std::vector<mjtNum> forces(static_cast<std::size_t>(data().nefc), 0);
  for (int row = 0; row < data().nefc; ++row) {
    if (data().efc_type[row] == mjCNSTR_EQUALITY && data().efc_id[row] == elements().connect) {
      forces[static_cast<std::size_t>(row)] = data().efc_force[row];
    }
  }
  for (int i = 0; i < data().ncon; ++i) {
    if (IsOnThorax(data().contact[i])) {
      const int row = data().contact[i].efc_address;
      forces[static_cast<std::size_t>(row)] = data().efc_force[row];
    }
  }
  std::vector<mjtNum> torques(static_cast<std::size_t>(model().nv), 0);
  if (data().nefc > 0) {
    mj_mulJacTVec(&model(), &data(), torques.data(), forces.data());
  }
  return torques;
}

void ShoulderSimulation::AddThoraxContact(ShoulderState& state) const {
  for (int i = 0; i < data().ncon; ++i) {
    const mjContact& contact = data().contact[i];
    if (IsOnThorax(contact)) {
      state.contact_force_N = WorseOf(state.contact_force_N, data().efc_force[contact.efc_address]);
      // The contact's sphere around the landmark touches the ellipsoid before the landmark does.
      const int sphere = contact.geom[contact.geom[0] == elements().gliding ? 1 : 0];
      const double depth_m = -contact.dist - model().geom_size[3 * sphere];
      state.contact_depth_m = depth_m <= state.contact_depth_m ? state.contact_depth_m : depth_m;
    }
  }
  const std::vector<double> torques = PushingTorques();
  const auto coordinates = DrivenCoordinates(elements().assembly);
  const JointAngles& stiffness_N_m_per_rad = loaded_.stiffness();
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    if (stiffness_N_m_per_rad[k] > 0) {
      const int joint =
          mj_name2id(&model(), mjOBJ_JOINT, SidedName(coordinates[k], elements().side).c_str());
      state.pushed_rad[k] =
          torques[static_cast<std::size_t>(model().jnt_dofadr[joint])] / stiffness_N_m_per_rad[k];
    }
  }
}

void ShoulderSimulation::Start(const ArmCommand& command) {
  mj_resetData(&model(), &data());
  SetCommand(command, {});
  mj_forward(&model(), &data());
  for (const ShoulderElements& elements : shoulders()) {
    PutAtAngles(elements, TargetsOf(elements));
  }
  EngineWatch::ExpectNoWarning(name() + ": at " + NumberText(data().time) + " s");
}

void ShoulderSimulation::PutAtAngles(const ShoulderElements& elements,
                                     const JointAngles& angles_rad) {
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    data().qpos[elements.qpos[k]] = angles_rad[k];
  }
  if (elements.assembly == Assembly::kLoop) {
    const Vector3 place_m = PlaceFor(elements, angles_rad);
    for (int i = 0; i < 3; ++i) {
      data().qpos[elements.place_qpos[static_cast<std::size_t>(i)]] = place_m[i];
    }
  }
}

void ShoulderSimulation::DerivePositions() {
  mju_zero(data().qvel, static_cast<int>(model().nv));
  mj_fwdPosition(&model(), &data());
  EngineWatch::ExpectNoWarning(name());
}

void ShoulderSimulation::PutAtKeyframe(int key) {
  mj_resetDataKeyframe(&model(), &data(), key);
  DerivePositions();
}

void ShoulderSimulation::PutAt(const ShoulderElements& elements, const ShoulderPose& pose) {
  PutAtAngles(elements, DrivenAngles(elements.assembly, pose));
  DerivePositions();
}

ShoulderPose ShoulderSimulation::PoseOf(const ShoulderElements& elements) const {
  std::array<Quaternion, kSegmentCount> q_WB{};
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const mjtNum* const q = data().xquat + 4 * elements.bodies[i];
    q_WB[i] = {q[0], q[1], q[2], q[3]};
  }
  return PoseOfBones(elements.side, q_WB);
}

ShoulderState ShoulderSimulation::Step(const ArmCommand& command, const CommandRate& rate) {
  SetCommand(command, rate);
  const double time_s = data().time;
  const JointAngles position_rad = Positions();
  const double fastest_rad_per_s = FastestJoint(mjJNT_HINGE);
  const double fastest_m_per_s = FastestJoint(mjJNT_SLIDE);
  // mj_step derives its quantities before it moves the positions.
  mj_step(&model(), &data());
  EngineWatch::ExpectNoWarning(name() + ": at " + NumberText(time_s) + " s");
  ShoulderState state = Derived(time_s, command, position_rad);
  state.fastest_rad_per_s = fastest_rad_per_s;
  state.fastest_m_per_s = fastest_m_per_s;
  return state;
}

ShoulderState ShoulderSimulation::Observe(const ArmCommand& command) {
  SetCommand(command, {});
  mj_forward(&model(), &data());
  EngineWatch::ExpectNoWarning(name() + ": at " + NumberText(data().time) + " s");
  return Derived(data().time, command, Positions());
}

ShoulderState ShoulderSimulation::ObserveAtTargets(const ArmCommand& command) {
  Start(command);
  return Observe(command);
}

}  // namespace girdle
