// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/shoulder_simulation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "anatomy/posed_bones.h"
#include "kinematics/worst_case.h"
#include "rhythm_tables/rhythm_config.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Longer steps are too few for the motions that are measured; with shorter ones a motion of some
// seconds never ends.
constexpr double kLongestTimestep_s = 0.01;
constexpr double kShortestTimestep_s = 1e-6;

// Whether any instance of the plugin is in the model.
bool HasInstance(const mjModel& model) {
  int slot = -1;
  return mjp_getPlugin(kPluginName, &slot) != nullptr &&
         std::find(model.plugin, model.plugin + model.nplugin, slot) !=
             model.plugin + model.nplugin;
}

// Finds the elements of one side by their names.
class ElementFinder {
 public:
  ElementFinder(const mjModel& model, const std::string& model_name, Side side)
      : model_(model), model_name_(model_name), side_(side) {}

  // Id, or -1.
  [[nodiscard]] int Look(mjtObj type, std::string_view stem) const {
    return mj_name2id(&model_, type, SidedName(stem, side_).c_str());
  }

  [[nodiscard]] int Find(mjtObj type, const char* kind, std::string_view stem,
                         bool sided = true) const {
    const std::string name = sided ? SidedName(stem, side_) : std::string(stem);
    const int id = mj_name2id(&model_, type, name.c_str());
    if (id < 0) {
      throw InputError(model_name_ + ": has no " + kind + " \"" + name +
                       "\". Restore it, or make the model anew with girdle generate");
    }
    return id;
  }

  [[nodiscard]] ShoulderElements FindAll() const {
    ShoulderElements elements;
    elements.side = side_;
    elements.assembly =
        Look(mjOBJ_JOINT, kScapulothoracicNames[0]) < 0 ? Assembly::kTree : Assembly::kLoop;
    elements.lead =
        Look(mjOBJ_ACTUATOR, kTranslationNames[0]) < 0 ? Lead::kClavicle : Lead::kScapula;
    const auto coordinates = DrivenCoordinates(elements.assembly);
    const bool has_plugin = HasInstance(model_);
    if (!has_plugin && Look(mjOBJ_ACTUATOR, kCoordinateNames[2]) < 0) {
      throw InputError(
          model_name_ + ": has no instance of the plugin " + kPluginName +
          ". Make a model that has one with girdle generate; for an arm that is not Girdle's "
          "there is girdle verify --mapping");
    }
    if (has_plugin) {
      FindCommands(elements);
    }
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const bool follows = !has_plugin && elements.lead == Lead::kScapula && k < 2;
      elements.joint_controls[k] = follows ? -1 : Control(coordinates[k]);
      elements.qpos[k] = model_.jnt_qposadr[Find(mjOBJ_JOINT, "joint", coordinates[k])];
    }
    if (elements.assembly == Assembly::kLoop) {
      FindLoop(elements);
    }
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const bool sided = static_cast<Segment>(i) != Segment::kThorax;
      elements.bodies[i] = Find(mjOBJ_BODY, "body", kSegmentNames[i], sided);
    }
    for (std::size_t i = 0; i < kSiteCount; ++i) {
      const bool sided = i >= kLandmarkCount || kLandmarks[i].sided;
      elements.sites[i] = Find(mjOBJ_SITE, "site", SiteStem(i), sided);
    }
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      elements.tendons[i] = Find(mjOBJ_TENDON, "tendon", kLigamentNames[i]);
    }
    elements.gliding = Look(mjOBJ_GEOM, kGlidingName);
    if (has_plugin) {
      FindSensor(elements);
    }
    return elements;
  }

 private:
  [[nodiscard]] int Control(std::string_view stem) const {
    return model_.actuator_ctrladr[Find(mjOBJ_ACTUATOR, "actuator", stem)];
  }

  void FindCommands(ShoulderElements& elements) const {
    for (std::size_t i = 0; i < kCommandCount; ++i) {
      elements.command_controls[i] = Control(kCommandNames[i]);
    }
    elements.instance =
        model_.actuator_plugin[Find(mjOBJ_ACTUATOR, "actuator", kCommandNames.front())];
    if (elements.instance < 0) {
      throw InputError(model_name_ + ": actuator \"" + SidedName(kCommandNames.front(), side_) +
                       "\" is not one of the plugin " + kPluginName +
                       ". Make the model anew with girdle generate");
    }
    CheckSide(elements.instance);
    const auto find_optional = [this](std::string_view stem) {
      const int id = Look(mjOBJ_ACTUATOR, stem);
      return id < 0 ? -1 : model_.actuator_ctrladr[id];
    };
    std::transform(kOffsetNames.begin(), kOffsetNames.end(), elements.offset_controls.begin(),
                   find_optional);
    std::transform(kRateNames.begin(), kRateNames.end(), elements.rate_controls.begin(),
                   find_optional);
  }

  // An instance of the other side would aim at the mirror image and report one.
  void CheckSide(int instance) const {
    const char* const text = mj_getPluginConfig(&model_, instance, kSideKey);
    const std::string configured(text == nullptr || *text == '\0' ? kSideNames.front()
                                                                  : std::string_view(text));
    const std::string own(kSideNames[static_cast<std::size_t>(side_)]);
    if (configured != own) {
      throw InputError(model_name_ + ": the plugin's instance \"" +
                       (model_.names + model_.name_pluginadr[instance]) + "\" moves a " +
                       configured + " shoulder, and its elements end in " +
                       std::string(kSideSuffixes[static_cast<std::size_t>(side_)]) +
                       ". Set <config key=\"" + kSideKey + "\" value=\"" + own +
                       "\"/>, or make the model anew with girdle generate");
    }
  }

  void FindLoop(ShoulderElements& elements) const {
    for (std::size_t i = 0; i < kTranslationNames.size(); ++i) {
      elements.place_qpos[i] = model_.jnt_qposadr[Find(mjOBJ_JOINT, "joint", kTranslationNames[i])];
      elements.place_controls[i] =
          elements.lead == Lead::kScapula ? Control(kTranslationNames[i]) : -1;
    }
    elements.connect = Find(mjOBJ_EQUALITY, "equality", kConnectName);
  }

  void FindSensor(ShoulderElements& elements) const {
    const int sensor = Find(mjOBJ_SENSOR, "sensor", kRhythmName);
    if (model_.sensor_type[sensor] != mjSENS_PLUGIN ||
        model_.sensor_plugin[sensor] != elements.instance) {
      const std::string name = SidedName(kRhythmName, side_);
      throw InputError(model_name_ + ": sensor \"" + name + "\" is not one of the plugin " +
                       kPluginName + ". Make it <plugin name=\"" + name + "\" instance=\"" + name +
                       "\"/>, or make the model anew with girdle generate");
    }
    elements.sensor = model_.sensor_adr[sensor];
  }

  const mjModel& model_;
  const std::string& model_name_;
  Side side_;
};

// Of the hinges of a shoulder that are driven.
JointRanges RangesOf(const mjModel& model, const ShoulderElements& elements) {
  JointRanges ranges = ShoulderRhythm::Unbounded();
  const auto coordinates = DrivenCoordinates(elements.assembly);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int joint =
        mj_name2id(&model, mjOBJ_JOINT, SidedName(coordinates[k], elements.side).c_str());
    if (model.jnt_limited[joint] != 0) {
      ranges[k] = {model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1]};
    }
  }
  return ranges;
}

// Of the servos; none for what follows.
JointAngles StiffnessOf(const mjModel& model, const ShoulderElements& elements) {
  if (elements.has_plugin()) {
    const char* text = mj_getPluginConfig(&model, elements.instance, kStiffnessKey);
    RhythmConfigText config;
    config.stiffness = text == nullptr ? "" : text;
    return ParseRhythmConfig(config).stiffness_N_m_per_rad;
  }
  JointAngles stiffness_N_m_per_rad{};
  const auto coordinates = DrivenCoordinates(elements.assembly);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int servo =
        mj_name2id(&model, mjOBJ_ACTUATOR, SidedName(coordinates[k], elements.side).c_str());
    stiffness_N_m_per_rad[k] = servo < 0 ? 0 : model.actuator_gainprm[mjNGAIN * servo];
  }
  return stiffness_N_m_per_rad;
}

Vector3 OnSide(Side side, const mjtNum* p) {
  const Vector3 position{p[0], p[1], p[2]};
  return side == Side::kRight ? position : Mirrored(position);
}

}  // namespace

std::string_view SiteStem(std::size_t site) {
  return site < kLandmarkCount ? kLandmarks[site].name : kJointSites[site - kLandmarkCount].child;
}

std::vector<ShoulderElements> FindShoulders(const mjModel& model, const std::string& model_name) {
  std::vector<ShoulderElements> shoulders;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const ElementFinder finder(model, model_name, side);
    if (finder.Look(mjOBJ_BODY, kSegmentNames[1]) >= 0 ||
        finder.Look(mjOBJ_JOINT, kCoordinateNames.front()) >= 0 ||
        finder.Look(mjOBJ_ACTUATOR, kCommandNames.front()) >= 0) {
      shoulders.push_back(finder.FindAll());
    }
  }
  if (shoulders.empty()) {
    // Says what of a right one is missing.
    shoulders.push_back(ElementFinder(model, model_name, Side::kRight).FindAll());
  }
  return shoulders;
}

ShoulderState MirroredToRight(const ShoulderState& left) noexcept {
  // World: y to -y. A body's own frame is mirrored in z besides (rotation.h), so that with both
  // mirrors turned into half turns about y and z, R_right = Ry(pi) R_left Rz(pi).
  const Quaternion about_y{0, 0, 1, 0};
  const Quaternion about_z{0, 0, 0, 1};
  ShoulderState right = left;
  for (Quaternion& q_WB : right.q_WB) {
    q_WB = about_y * q_WB * about_z;
  }
  for (Vector3& p_m : right.site_m) {
    p_m.y = -p_m.y;
  }
  return right;
}

ShoulderSimulation::ShoulderSimulation(ModelPointer model, std::string name)
    : name_(std::move(name)),
      model_(std::move(model)),
      data_(MakeData(*model_)),
      shoulders_(FindShoulders(*model_, name_)),
      ranges_(RangesOf(*model_, shoulders_.front())),
      stiffness_N_m_per_rad_(StiffnessOf(*model_, shoulders_.front())) {
  if (!(timestep_s() >= kShortestTimestep_s && timestep_s() <= kLongestTimestep_s)) {
    throw InputError(name_ + ": the time step is " + NumberText(timestep_s()) + " s, expected " +
                     NumberText(kShortestTimestep_s) + " to " + NumberText(kLongestTimestep_s) +
                     ". Set <option timestep=\"0.002\"/>");
  }
}

void ShoulderSimulation::Watch(Side side) {
  for (std::size_t i = 0; i < shoulders_.size(); ++i) {
    if (shoulders_[i].side == side) {
      watched_ = i;
      return;
    }
  }
  throw InputError(name_ + ": has no " + std::string(kSideNames[static_cast<std::size_t>(side)]) +
                   " shoulder. Make one that has with girdle generate --side");
}

void ShoulderSimulation::SetCommand(const ArmCommand& command, const CommandRate& rate) {
  if (!has_plugin()) {
    target_ = rhythm_->SolvePose(command, &used_);
  }
  for (const ShoulderElements& elements : shoulders_) {
    if (has_plugin()) {
      SetPluginCommand(elements, command, rate);
    } else {
      SetServos(elements);
    }
  }
}

void ShoulderSimulation::SetPluginCommand(const ShoulderElements& elements,
                                          const ArmCommand& command, const CommandRate& rate) {
  data_->ctrl[elements.command_controls[0]] = command.elevation_rad;
  data_->ctrl[elements.command_controls[1]] = command.plane_rad;
  data_->ctrl[elements.command_controls[2]] = command.axial_rad;
  const std::array<double, kOffsetCount> offsets_rad = {command.shrug_rad, command.protraction_rad};
  for (std::size_t i = 0; i < kOffsetCount; ++i) {
    if (elements.offset_controls[i] >= 0) {
      data_->ctrl[elements.offset_controls[i]] = offsets_rad[i];
    } else if (offsets_rad[i] != 0) {
      throw InputError(name_ + ": " + std::string(kOffsetNames[i]) +
                       " is commanded, and the model has no actuator \"" +
                       SidedName(kOffsetNames[i], elements.side) +
                       "\". Make one that has with girdle generate --offsets");
    }
  }
  for (std::size_t i = 0; i < kRateCount; ++i) {
    if (elements.rate_controls[i] >= 0) {
      data_->ctrl[elements.rate_controls[i]] = rate[i];
    }
  }
}

JointAngles ShoulderSimulation::TargetsOf(const ShoulderElements& elements) const {
  if (!elements.has_plugin()) {
    return DrivenAngles(elements.assembly, target_);
  }
  JointAngles target_rad{};
  std::copy_n(data_->sensordata + elements.sensor + sensor_layout::kTarget, kCoordinateCount,
              target_rad.begin());
  return target_rad;
}

// Where the clavicle, turned as SC is told to, has the AC joint: in the thorax, mirrored to the
// right.
Vector3 ShoulderSimulation::PlaceFor(const ShoulderElements& elements,
                                     const JointAngles& target_rad) const {
  const Quaternion q_TC =
      QuaternionFromEuler(kJointSequences[0], {target_rad[0], target_rad[1], target_rad[2]});
  const int clavicle = elements.bodies[static_cast<std::size_t>(Segment::kClavicle)];
  const int site = elements.sites[static_cast<std::size_t>(Landmark::kPAC)];
  return OnSide(elements.side, model_->body_pos + 3 * clavicle) +
         q_TC * OnSide(elements.side, model_->site_pos + 3 * site);
}

void ShoulderSimulation::SetServos(const ShoulderElements& elements) {
  const JointAngles target_rad = TargetsOf(elements);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    if (elements.joint_controls[k] >= 0) {
      data_->ctrl[elements.joint_controls[k]] = target_rad[k];
    }
  }
  if (elements.lead == Lead::kScapula) {
    const Vector3 place_m = PlaceFor(elements, target_rad);
    for (int i = 0; i < 3; ++i) {
      data_->ctrl[elements.place_controls[static_cast<std::size_t>(i)]] = place_m[i];
    }
  }
}

std::vector<std::string> ShoulderSimulation::TargetNames() const {
  std::vector<std::string> names;
  for (const ShoulderElements& elements : shoulders_) {
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
  for (const ShoulderElements& elements : shoulders_) {
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

JointAngles ShoulderSimulation::Positions() const {
  JointAngles position_rad{};
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    position_rad[k] = data_->qpos[elements().qpos[k]];
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
    const mjtNum* sensor = data_->sensordata + elements().sensor;
    state.distance_rad = sensor[sensor_layout::kDistance];
    state.clamped = sensor[sensor_layout::kCommanded] != command.elevation_rad ||
                    sensor[sensor_layout::kCommanded + 1] != command.plane_rad ||
                    sensor[sensor_layout::kCommanded + 2] != command.axial_rad;
  } else {
    state.distance_rad =
        rhythm_->rhythm().DistanceOutside(command.elevation_rad, command.plane_rad);
    state.clamped = used_ != command;
  }
  state.connect_force_N = ConnectForce();
  AddLigaments(state);
  if (elements().has_thorax_contact()) {
    AddThoraxContact(state);
  }
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const mjtNum* q = data_->xquat + 4 * elements().bodies[i];
    state.q_WB[i] = {q[0], q[1], q[2], q[3]};
  }
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    const mjtNum* p = data_->site_xpos + 3 * elements().sites[i];
    state.site_m[i] = {p[0], p[1], p[2]};
  }
  return state;
}

double ShoulderSimulation::FastestJoint(mjtJoint type) const {
  double fastest = 0;
  for (int joint = 0; joint < model_->njnt; ++joint) {
    if (model_->jnt_type[joint] == type) {
      fastest = WorseOf(fastest, std::abs(data_->qvel[model_->jnt_dofadr[joint]]));
    }
  }
  return fastest;
}

// Length of the sum of the constraint's three forces.
double ShoulderSimulation::ConnectForce() const {
  double squared = 0;
  for (int row = 0; elements().connect >= 0 && row < data_->nefc; ++row) {
    if (data_->efc_type[row] == mjCNSTR_EQUALITY && data_->efc_id[row] == elements().connect) {
      squared += data_->efc_force[row] * data_->efc_force[row];
    }
  }
  return std::sqrt(squared);
}

void ShoulderSimulation::AddLigaments(ShoulderState& state) const {
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    const int tendon = elements().tendons[i];
    state.ligament_m[i] = data_->ten_length[tendon];
    const double beyond_slack_m = state.ligament_m[i] - model_->tendon_lengthspring[2 * tendon + 1];
    // A length that is not a number is beyond.
    state.ligament_force_N[i] =
        model_->tendon_stiffness[tendon] * (beyond_slack_m <= 0 ? 0 : beyond_slack_m);
  }
}

bool ShoulderSimulation::IsOnThorax(const mjContact& contact) const {
  return contact.efc_address >= 0 &&
         (contact.geom[0] == elements().gliding || contact.geom[1] == elements().gliding);
}

// With which the thorax pushes each degree of freedom: by its contacts, and in a loop by way of the
// AC joint. A joint that lies at its limit is held by something else.
std::vector<double> ShoulderSimulation::PushingTorques() const {
  std::vector<mjtNum> forces(static_cast<std::size_t>(data_->nefc), 0);
  for (int row = 0; row < data_->nefc; ++row) {
    if (data_->efc_type[row] == mjCNSTR_EQUALITY && data_->efc_id[row] == elements().connect) {
      forces[static_cast<std::size_t>(row)] = data_->efc_force[row];
    }
  }
  for (int i = 0; i < data_->ncon; ++i) {
    if (IsOnThorax(data_->contact[i])) {
      const int row = data_->contact[i].efc_address;
      forces[static_cast<std::size_t>(row)] = data_->efc_force[row];
    }
  }
  std::vector<mjtNum> torques(static_cast<std::size_t>(model_->nv), 0);
  if (data_->nefc > 0) {
    mj_mulJacTVec(model_.get(), data_.get(), torques.data(), forces.data());
  }
  return torques;
}

void ShoulderSimulation::AddThoraxContact(ShoulderState& state) const {
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    if (IsOnThorax(contact)) {
      state.contact_force_N = WorseOf(state.contact_force_N, data_->efc_force[contact.efc_address]);
      // The sphere that stands for the landmark touches sooner than its centre.
      const int sphere = contact.geom[contact.geom[0] == elements().gliding ? 1 : 0];
      const double depth_m = -contact.dist - model_->geom_size[3 * sphere];
      state.contact_depth_m = depth_m <= state.contact_depth_m ? state.contact_depth_m : depth_m;
    }
  }
  const std::vector<double> torques = PushingTorques();
  const auto coordinates = DrivenCoordinates(elements().assembly);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    if (stiffness_N_m_per_rad_[k] > 0) {
      const int joint =
          mj_name2id(model_.get(), mjOBJ_JOINT, SidedName(coordinates[k], elements().side).c_str());
      state.pushed_rad[k] =
          torques[static_cast<std::size_t>(model_->jnt_dofadr[joint])] / stiffness_N_m_per_rad_[k];
    }
  }
}

void ShoulderSimulation::Start(const ArmCommand& command) {
  mj_resetData(model_.get(), data_.get());
  SetCommand(command, {});
  mj_forward(model_.get(), data_.get());
  for (const ShoulderElements& elements : shoulders_) {
    PutAtAngles(elements, TargetsOf(elements));
  }
  EngineWatch::ExpectNoWarning(name_ + ": at " + NumberText(data_->time) + " s");
}

void ShoulderSimulation::PutAtAngles(const ShoulderElements& elements,
                                     const JointAngles& angles_rad) {
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    data_->qpos[elements.qpos[k]] = angles_rad[k];
  }
  if (elements.assembly == Assembly::kLoop) {
    const Vector3 place_m = PlaceFor(elements, angles_rad);
    for (int i = 0; i < 3; ++i) {
      data_->qpos[elements.place_qpos[static_cast<std::size_t>(i)]] = place_m[i];
    }
  }
}

void ShoulderSimulation::DerivePositions() {
  mju_zero(data_->qvel, static_cast<int>(model_->nv));
  mj_fwdPosition(model_.get(), data_.get());
  EngineWatch::ExpectNoWarning(name_);
}

void ShoulderSimulation::PutAtKeyframe(int key) {
  mj_resetDataKeyframe(model_.get(), data_.get(), key);
  DerivePositions();
}

void ShoulderSimulation::PutAt(const ShoulderElements& elements, const ShoulderPose& pose) {
  PutAtAngles(elements, DrivenAngles(elements.assembly, pose));
  DerivePositions();
}

ShoulderPose ShoulderSimulation::PoseOf(const ShoulderElements& elements) const {
  std::array<Quaternion, kSegmentCount> q_WB{};
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const mjtNum* const q = data_->xquat + 4 * elements.bodies[i];
    q_WB[i] = {q[0], q[1], q[2], q[3]};
  }
  return PoseOfBones(elements.side, q_WB);
}

ShoulderState ShoulderSimulation::Step(const ArmCommand& command, const CommandRate& rate) {
  SetCommand(command, rate);
  const double time_s = data_->time;
  const JointAngles position_rad = Positions();
  const double fastest_rad_per_s = FastestJoint(mjJNT_HINGE);
  const double fastest_m_per_s = FastestJoint(mjJNT_SLIDE);
  // What mj_step derives belongs to the positions before it moves them.
  mj_step(model_.get(), data_.get());
  EngineWatch::ExpectNoWarning(name_ + ": at " + NumberText(time_s) + " s");
  ShoulderState state = Derived(time_s, command, position_rad);
  state.fastest_rad_per_s = fastest_rad_per_s;
  state.fastest_m_per_s = fastest_m_per_s;
  return state;
}

ShoulderState ShoulderSimulation::Observe(const ArmCommand& command) {
  SetCommand(command, {});
  mj_forward(model_.get(), data_.get());
  EngineWatch::ExpectNoWarning(name_ + ": at " + NumberText(data_->time) + " s");
  return Derived(data_->time, command, Positions());
}

ShoulderState ShoulderSimulation::ObserveAtTargets(const ArmCommand& command) {
  Start(command);
  return Observe(command);
}

}  // namespace girdle
