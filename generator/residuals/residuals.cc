// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residuals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <string_view>
#include <utility>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/ellipsoid.h"
#include "anatomy/posed_bones.h"
#include "kinematics/isb_frames.h"
#include "kinematics/lengths.h"
#include "residuals/extreme.h"
#include "residuals/skin_residuals.h"
#include "simulation/motion.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Of a loop, whose AC joint a soft constraint holds: at rest, and while the arm goes up and down
// once a second.
constexpr double kLoopAtRest_mm = 0.05;
constexpr double kLoopMoving_mm = 0.1;

// Tolerances. Rounding in double precision leaves 1e-13 of a radian or a meter at most; 1e-6 of a
// degree or a millimeter is far above that and far below anything that can be measured.
constexpr double kExact_deg = 1e-6;
constexpr double kExact_mm = 1e-6;
constexpr double kExactMass = 1e-9;  // kg and kg m^2
// A servo that holds still must be as good as its own rounding; a hundredth of a degree is far
// below what bone pins resolve, and what a shoulder without damping still swings by.
constexpr double kSettledTracking_deg = 0.01;
// On the thorax: MuJoCo 3 finds the normal of an ellipsoid's contact by iterations that do not end
// the same from step to step, so that its direction trembles and the joints by 0.015 deg with it.
constexpr double kSettledOnThorax_deg = 0.03;
// Lag of 20 ms (joint_dynamics.h) at the fastest joint speed of the standard motions, about 80
// deg/s, and some room.
constexpr double kMovingTracking_deg = 3;
// A joint that still trembles at rest is held by servos or constraints that fight.
constexpr double kSpeedAtRest_rad_per_s = 1e-6;
constexpr double kSpeedAtRest_m_per_s = 1e-7;  // the same at the end of a clavicle
// Of the published tables themselves (2.03 deg rms over rows 30 to 120, 1.7 to 2.5 each).
constexpr double kScapulothoracicRms_deg = 2.1;
constexpr double kScapulothoracicWorst_deg = 2.6;
// Of the fitted ellipsoid: the scapula's medial border glides within this of it.
constexpr double kGlidingRms_mm = 5;
constexpr double kGlidingWorst_mm = 17;
// It was fitted to where SC and AC take the scapula; where ST does is up to 2.5 deg, 6 mm at TS,
// away.
constexpr double kLoopGlidingRms_mm = 6.5;

// What is asked of the joints never stretches a ligament; what they lag behind by while they move
// does: 3 deg of AC, 40 mm off the attachments, would be 2 mm. A tenth of a millimetre, 5 N, is
// what slack was rounded to.
constexpr double kStretched_mm = 0.1;

// MuJoCo looks for the nearest point of an ellipsoid until it knows it to 0.001 mm.
constexpr double kContactSurface_mm = 0.01;
// How stiff the contact is (joint_dynamics.h), and by how much it may be off where the pose changes
// what the scapula weighs at TS and AI. Of other masses it is not known.
constexpr double kContactStiffness_N_per_mm = 20;
constexpr double kContactStiffnessShare = 0.2;
// Below this depth force over depth says little.
constexpr double kDeepContact_m = 0.001;

// Duration of a standard motion and of the rest after it.
constexpr double kMoving_s = 3;
constexpr double kSettling_s = 4;
// Of a skin that moves, every so many steps: what MuJoCo makes of it depends on the pose alone.
constexpr int kSkinSteps = 50;
// Share of the rest at its end that counts as settled.
constexpr double kSettledShare = 0.25;
// Below this elevation the plane of the arm is ill determined: the table's own misses it by up to
// 42 deg.
constexpr double kLowestPlaneElevation_rad = 30 * kRadiansPerDegree;
// So near to hanging or straight up the plane has no meaning.
constexpr double kPlaneless_rad = 1e-6;
// Where the standard motions end: people raise their arms to 150 +- 9 deg (Henninger, 20 people).
constexpr double kRaised_rad = 150 * kRadiansPerDegree;
// Of the grid on which closure is looked at, beside the motions.
constexpr double kGridStep_rad = 10 * kRadiansPerDegree;

using JointExtremes = std::array<Extreme, kJointCount>;

// What a ligament does over poses and motions.
struct LigamentExtremes {
  Extreme longest_mm;
  Extreme shorter_mm;  // than an arm's length: its largest value is the shortest ligament
  Extreme beyond_slack_mm;
  Extreme force_N;
};

// Difference of two angles in [-pi, pi].
double AngleDifference(double a_rad, double b_rad) {
  return std::remainder(a_rad - b_rad, 2 * kPi);
}

Vector3 InThorax(const ShoulderState& state, const Vector3& point_m) {
  return glm::conjugate(state.rotation(Segment::kThorax)) *
         (point_m - state.landmark_m(Landmark::kIJ));
}

// Where the simulated humerus points, from landmarks: GH to the middle of the epicondyles.
ArmAngles ArmFromLandmarks(const ShoulderState& state) {
  const Quaternion q_WH = HumerusFrame(state.child_site_m(2), state.landmark_m(Landmark::kEM),
                                       state.landmark_m(Landmark::kEL));
  return ArmAnglesFromRotation(glm::conjugate(state.rotation(Segment::kThorax)) * q_WH);
}

class ResidualMeter {
 public:
  ResidualMeter(ShoulderSimulation& simulation, const AssembledRhythm& rhythm,
                const Anatomy& anatomy, GirdleMotion girdle)
      : simulation_(simulation),
        assembled_(rhythm),
        rhythm_(rhythm.rhythm()),
        is_loop_(rhythm.assembly() == Assembly::kLoop),
        anatomy_(anatomy) {
    if (HasSkin(simulation.model())) {
      skin_.emplace(simulation, rhythm, anatomy, girdle);
    }
  }

  void RunMotion(const Motion& motion, const ProgressSink& progress) {
    const double timestep_s = simulation_.timestep_s();
    const auto moving_steps = static_cast<int>(std::lround(motion.duration_s / timestep_s));
    const auto settling_steps = static_cast<int>(std::lround(kSettling_s / timestep_s));
    const int settled_from = moving_steps + static_cast<int>((1 - kSettledShare) * settling_steps);
    StartAtRest(motion.command(0));
    for (int step = 0; step < moving_steps + settling_steps; ++step) {
      const double time_s = step * timestep_s;
      const ShoulderState state =
          Canonical(simulation_.Step(motion.command(time_s), RateOf(motion, time_s, timestep_s)));
      AddJointGaps(state, motion.name);
      AddLigaments(state, motion.name);
      if (step >= settled_from) {
        speed_at_rest_.Add(state.fastest_rad_per_s, motion.name, state.command);
        if (is_loop_) {
          slide_at_rest_.Add(state.fastest_m_per_s, motion.name, state.command);
        }
      }
      if (step < moving_steps || step >= settled_from) {
        AddConnect(state, motion.name, step < moving_steps ? connect_moving_ : connect_at_rest_);
      }
      AddTracking(state, motion.name, step < moving_steps ? moving_ : settled_,
                  step < moving_steps || step >= settled_from);
      if (skin_ && step % kSkinSteps == 0) {
        skin_->CompareMoving(motion.name, state.command);
      }
      progress(static_cast<double>(step) / (moving_steps + settling_steps));
    }
    // The same poses without dynamics, a degree apart or less.
    constexpr int kPoses = 128;
    for (int i = 0; i <= kPoses; ++i) {
      VisitPose(motion.command(motion.duration_s * i / kPoses), motion.name);
    }
  }

  // Up and down without a rest: only whether the joints hold.
  void RunCycles(const Motion& motion) {
    const double timestep_s = simulation_.timestep_s();
    const auto steps = static_cast<int>(std::lround(motion.duration_s / timestep_s));
    StartAtRest(motion.command(0));
    for (int step = 0; step < steps; ++step) {
      const double time_s = step * timestep_s;
      const ShoulderState state =
          Canonical(simulation_.Step(motion.command(time_s), RateOf(motion, time_s, timestep_s)));
      AddJointGaps(state, motion.name);
      AddLigaments(state, motion.name);
      AddConnect(state, motion.name, connect_cycling_);
    }
  }

  void VisitTable() {
    const RhythmTable& table = rhythm_.table();
    for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
      for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
        const ArmCommand command{table.elevations_rad()[elevation], table.planes_rad()[plane], 0};
        const ShoulderState state = VisitPose(command, "table");
        AddScapulothoracic(state, table.position(plane, elevation), command);
        if (is_loop_) {
          AddEmergent(Posed(command), table.position(plane, elevation), command);
        }
        if (has_thorax_contact()) {
          AddThoraxContact(command);
        }
      }
    }
  }

  // Poses everywhere, to the ends of what the arm reaches, settled for some steps.
  void VisitGrid() {
    const ArmRectangle& domain = rhythm_.domain();
    const auto values_rad = [](double from_rad, double to_rad) {
      constexpr double kRounding = 1e-9;  // makes no further step
      const double steps = std::ceil((to_rad - from_rad) / kGridStep_rad - kRounding);
      std::vector<double> values;
      for (int i = 0; i <= static_cast<int>(steps); ++i) {
        values.push_back(std::min(from_rad + i * kGridStep_rad, to_rad));
      }
      return values;
    };
    for (const double elevation_rad :
         values_rad(domain.lowest_elevation_rad, domain.highest_elevation_rad)) {
      for (const double plane_rad : values_rad(domain.first_plane_rad, domain.last_plane_rad)) {
        const ArmCommand command = rhythm_.Solve({elevation_rad, plane_rad}).used;
        const ShoulderState state = Settled(command);
        AddConnect(state, "grid", connect_posed_);
        AddLigaments(state, "grid");
        AddClosure(has_thorax_contact() ? Posed(command) : state, assembled_.SolvePose(command),
                   "grid");
      }
    }
  }

  void VisitKeyframes() {
    const mjModel& model = simulation_.model();
    const ShoulderElements& elements = simulation_.elements();
    for (int key = 0; key < model.nkey; ++key) {
      const char* name = model.names + model.name_keyadr[key];
      // A keyframe that has a name of ours has to be what the name says, another one what its
      // commands say.
      const auto* named = std::find_if(kKeyframes.begin(), kKeyframes.end(),
                                       [name](const NamedPose& pose) { return pose.name == name; });
      const bool is_ours = named != kKeyframes.end();
      const mjtNum* controls = model.key_ctrl + key * model.nu;
      ArmCommand command;
      if (is_ours && named->name != kRestName) {
        command = {RadiansFromDegrees(named->elevation_deg), RadiansFromDegrees(named->plane_deg)};
      } else if (elements.has_plugin()) {
        command = {controls[elements.command_controls[0]], controls[elements.command_controls[1]],
                   controls[elements.command_controls[2]]};
      } else if (!is_ours) {
        continue;  // position servos do not say what was meant
      }
      AddKeyframe(name, command, controls, model.key_qpos + key * model.nq);
    }
  }

  // The bones themselves: every landmark where the anatomy has it on its bone.
  void VisitBones() {
    const ShoulderState state = Canonical(simulation_.ObserveAtTargets(
        {rhythm_.table().elevations_rad().front(), rhythm_.table().planes_rad().front(), 0}));
    const bool has_both = simulation_.shoulders().size() > 1;
    const std::array<Vector3, kSegmentCount> origins_m = {
        state.landmark_m(Landmark::kIJ), state.child_site_m(0), state.child_site_m(1),
        state.child_site_m(2)};
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const auto segment = static_cast<std::size_t>(kLandmarks[i].segment);
      const Vector3 on_bone_m =
          glm::conjugate(state.q_WB[segment]) * (state.site_m[i] - origins_m[segment]);
      const Vector3& own_m = anatomy_.landmarks_m[i];
      bones_.Add(kMillimetersPerMeter * glm::distance(on_bone_m, has_both && !kLandmarks[i].sided
                                                                     ? InMedianPlane(own_m)
                                                                     : own_m),
                 std::string(kLandmarks[i].name), state.command);
    }
    const mjModel& model = simulation_.model();
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const int body = simulation_.elements().bodies[i];
      const SegmentInertia& inertia = anatomy_.segments[i];
      const std::string name(kSegmentNames[i]);
      masses_.Add(model.body_mass[body] - inertia.mass_kg, name, state.command);
      const mjtNum* p_m = model.body_ipos + 3 * body;
      const Vector3 center_m{p_m[0], p_m[1], p_m[2]};
      const bool is_left = simulation_.elements().side == Side::kLeft;
      centers_.Add(kMillimetersPerMeter *
                       glm::distance(is_left ? Mirrored(center_m) : center_m,
                                     has_both && i == 0 ? InMedianPlane(inertia.center_of_mass_m)
                                                        : inertia.center_of_mass_m),
                   name, state.command);
      const mjtNum* moments_kg_m2 = model.body_inertia + 3 * body;
      inertias_.Add(glm::distance(Vector3(moments_kg_m2[0], moments_kg_m2[1], moments_kg_m2[2]),
                                  inertia.inertia_kg_m2),
                    name, state.command);
    }
  }

  // Moves the simulation once more, for the skin.
  [[nodiscard]] std::vector<Residual> Report() {
    std::vector<Residual> lines;
    const auto add_joints = [&lines](const char* group, const JointExtremes& extremes,
                                     const char* unit, double tolerance) {
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        lines.push_back(
            extremes[joint].Worst(group, std::string(kJointNames[joint]), unit, tolerance));
      }
    };
    AddJointConstraints(lines);
    lines.push_back(bones_.Worst("bones", "landmarks", "mm", kExact_mm));
    lines.push_back(masses_.Worst("bones", "masses", "kg", kExactMass));
    lines.push_back(centers_.Worst("bones", "centres of mass", "mm", kExact_mm));
    lines.push_back(inertias_.Worst("bones", "moments of inertia", "kg m^2", kExactMass));
    add_joints("kinematic consistency", body_rotations_, "deg", kExact_deg);
    lines.push_back(
        clavicle_axis_.Worst("kinematic consistency", "clavicle landmarks", "deg", kExact_deg));
    lines.push_back(
        scapula_frame_.Worst("kinematic consistency", "scapula landmarks", "deg", kExact_deg));
    lines.push_back(
        humerus_frame_.Worst("kinematic consistency", "humerus landmarks", "deg", kExact_deg));
    if (is_loop_) {
      lines.push_back(
          scapula_place_.Worst("kinematic consistency", "scapula's place", "mm", kExact_mm));
    }
    if (!keyframes_.empty()) {
      lines.push_back(keyframes_.Worst("kinematic consistency", "keyframes", "deg", kExact_deg));
    }
    if (!keyframe_places_.empty()) {
      lines.push_back(keyframe_places_.Worst("kinematic consistency", "keyframes, scapula's place",
                                             "mm", kExact_mm));
    }
    const auto driven = DrivenJoints(assembled_.assembly());
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      lines.push_back(settled_[joint].Worst(
          "tracking settled", std::string(driven[joint]), "deg",
          has_thorax_contact() ? kSettledOnThorax_deg : kSettledTracking_deg));
    }
    lines.push_back(
        speed_at_rest_.Worst("tracking settled", "fastest joint", "rad/s", kSpeedAtRest_rad_per_s));
    if (is_loop_) {
      lines.push_back(slide_at_rest_.Worst("tracking settled", "scapula's place, fastest", "m/s",
                                           kSpeedAtRest_m_per_s));
    }
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      lines.push_back(moving_[joint].Worst("tracking moving", std::string(driven[joint]), "deg",
                                           kMovingTracking_deg));
    }
    lines.push_back(closure_elevation_own_.Worst("closure", "elevation against the table's own",
                                                 "deg", kExact_deg));
    lines.push_back(
        closure_plane_own_.Worst("closure", "plane against the table's own", "deg", kExact_deg));
    const bool is_exact = rhythm_.options().closure == Closure::kExact;
    const std::optional<double> tolerance = is_exact ? std::optional(kExact_deg) : std::nullopt;
    lines.push_back(
        closure_elevation_.Worst("closure", "elevation reached - commanded", "deg", tolerance));
    lines.push_back(closure_plane_.Worst(
        "closure", is_exact ? "plane reached - commanded" : "plane, from elevation 30", "deg",
        tolerance));
    if (!is_exact) {
      lines.push_back(
          closure_low_plane_.Worst("closure", "plane, below elevation 30", "deg", std::nullopt));
    }
    if (rhythm_.options().range == Range::kWhole) {
      lines.push_back(distance_.Worst("range", "farthest from measured data", "deg", std::nullopt));
    }
    if (!scapulothoracic_.empty()) {
      // A loop is driven there.
      lines.push_back(
          scapulothoracic_.RootMeanSquare("scapulothoracic", "published ST, rms", "deg",
                                          is_loop_ ? kExact_deg : kScapulothoracicRms_deg));
      lines.push_back(scapulothoracic_.Worst("scapulothoracic", "published ST, worst", "deg",
                                             is_loop_ ? kExact_deg : kScapulothoracicWorst_deg));
    }
    if (is_loop_) {
      lines.push_back(emergent_.RootMeanSquare("emergent AC", "measured AC, rms", "deg",
                                               kScapulothoracicRms_deg));
      lines.push_back(
          emergent_.Worst("emergent AC", "measured AC, worst", "deg", kScapulothoracicWorst_deg));
      for (std::size_t i = 0; i < emergent_angles_.size(); ++i) {
        lines.push_back(emergent_angles_[i].Worst(
            "emergent AC", std::string(kCoordinateNames[3 + i]), "deg", std::nullopt));
      }
    }
    // Of an ellipsoid that was not fitted to these bones nothing is promised.
    const double size = anatomy_.gliding.radii_m.y / BuiltInAnatomy().gliding.radii_m.y;
    const auto tolerance_mm = [&](double adult_mm) {
      return anatomy_.has_adult_proportions ? std::optional(size * adult_mm) : std::nullopt;
    };
    lines.push_back(
        gliding_.RootMeanSquare("scapulothoracic", "TS, AI to ellipsoid, rms", "mm",
                                tolerance_mm(is_loop_ ? kLoopGlidingRms_mm : kGlidingRms_mm)));
    lines.push_back(gliding_.Worst("scapulothoracic", "TS, AI to ellipsoid, worst", "mm",
                                   tolerance_mm(kGlidingWorst_mm)));
    if (!modelled_gliding_.empty()) {
      lines.push_back(modelled_gliding_.Worst("scapulothoracic", "the same outside measured data",
                                              "mm", std::nullopt));
    }
    AddThoraxContactLines(lines);
    AddLigamentLines(lines);
    if (skin_) {
      std::vector<Residual> on_skin = skin_->Measure();
      std::move(on_skin.begin(), on_skin.end(), std::back_inserter(lines));
    }
    return lines;
  }

 private:
  [[nodiscard]] ShoulderState Canonical(const ShoulderState& state) const {
    return simulation_.elements().side == Side::kLeft ? MirroredToRight(state) : state;
  }

  [[nodiscard]] bool has_thorax_contact() const {
    return simulation_.elements().has_thorax_contact();
  }

  // At a command's targets, or where the thorax has pushed the joints from there.
  void StartAtRest(const ArmCommand& command) {
    simulation_.Start(command);
    constexpr double kPushing_s = 0.3;  // 15 time constants of the servos
    const auto steps = static_cast<int>(std::lround(kPushing_s / simulation_.timestep_s()));
    for (int step = 0; has_thorax_contact() && step < steps; ++step) {
      simulation_.Step(command);
    }
  }

  // Where the joints are asked to be: after some steps, unless the thorax pushes them off.
  ShoulderState Posed(const ArmCommand& command) {
    return has_thorax_contact() ? Canonical(simulation_.ObserveAtTargets(command))
                                : Settled(command);
  }

  // At rest on the thorax: how hard it pushes, and that it alone holds the joints off their
  // targets.
  void AddThoraxContact(const ArmCommand& command) {
    StartAtRest(command);
    const ShoulderState state = Canonical(simulation_.Observe(command));
    contact_force_N_.Add(state.contact_force_N, "table", command);
    contact_depth_mm_.Add(kMillimetersPerMeter * state.contact_depth_m, "table", command);
    if (state.contact_depth_m > kDeepContact_m) {
      const double stiffness_N_per_mm =
          state.contact_force_N / (kMillimetersPerMeter * state.contact_depth_m);
      contact_stiffness_.Add(stiffness_N_per_mm - kContactStiffness_N_per_mm, "table", command);
    }
    double deepest_m = 0;
    for (const Landmark landmark : {Landmark::kTS, Landmark::kAI}) {
      deepest_m = std::max(
          deepest_m,
          -DistanceFromEllipsoid(anatomy_.gliding, InThorax(state, state.landmark_m(landmark))));
    }
    contact_surface_mm_.Add(kMillimetersPerMeter * (state.contact_depth_m - deepest_m), "table",
                            command);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      pushed_[k / 3].Add(DegreesFromRadians(state.pushed_rad[k]), "table", command);
    }
    AddTracking(state, "table", settled_, true);
  }

  void AddThoraxContactLines(std::vector<Residual>& lines) const {
    if (!has_thorax_contact()) {
      return;
    }
    const char* const group = "thorax contact";
    lines.push_back(contact_force_N_.Worst(group, "force on TS or AI", "N", std::nullopt));
    if (!contact_stiffness_.empty()) {
      const double scapula_kg = anatomy_.segment(Segment::kScapula).mass_kg;
      const bool is_adult = scapula_kg == BuiltInAnatomy().segment(Segment::kScapula).mass_kg;
      lines.push_back(contact_stiffness_.Worst(
          group, "stiffness, off 20 N/mm", "N/mm",
          is_adult ? std::optional(kContactStiffnessShare * kContactStiffness_N_per_mm)
                   : std::nullopt));
    }
    lines.push_back(
        contact_surface_mm_.Worst(group, "depth against the anatomy's", "mm", kContactSurface_mm));
    lines.push_back(
        contact_depth_mm_.Worst(group, "TS or AI in the ellipsoid", "mm", std::nullopt));
    const auto driven = DrivenJoints(assembled_.assembly());
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      lines.push_back(pushed_[joint].Worst(
          group, std::string(driven[joint]) + " pushed off its target", "deg", std::nullopt));
    }
  }

  // Longer than any ligament.
  static constexpr double kFar_mm = 1000;

  void AddLigaments(const ShoulderState& state, std::string_view motion) {
    const ShoulderElements& elements = simulation_.elements();
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      LigamentExtremes& extremes = ligaments_[i];
      const double length_mm = kMillimetersPerMeter * state.ligament_m[i];
      const double slack_mm = kMillimetersPerMeter *
                              simulation_.model().tendon_lengthspring[2 * elements.tendons[i] + 1];
      extremes.longest_mm.Add(length_mm, motion, state.command);
      extremes.shorter_mm.Add(kFar_mm - length_mm, motion, state.command);
      extremes.beyond_slack_mm.Add(std::max(0.0, length_mm - slack_mm), motion, state.command);
      extremes.force_N.Add(state.ligament_force_N[i], motion, state.command);
    }
  }

  // Against the attachments of the anatomy in the splines' pose.
  void AddLigamentLengths(const ShoulderState& state, const ShoulderPose& pose,
                          std::string_view motion) {
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      const double wanted_m = LigamentLength_m(anatomy_.ligaments[i], anatomy_, pose);
      ligament_lengths_.Add(kMillimetersPerMeter * (state.ligament_m[i] - wanted_m), motion,
                            state.command);
    }
  }

  void AddLigamentLines(std::vector<Residual>& lines) const {
    const char* const group = "ligaments";
    lines.push_back(ligament_lengths_.Worst(group, "lengths against the bones", "mm", kExact_mm));
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      const std::string name(kLigamentNames[i]);
      const LigamentExtremes& extremes = ligaments_[i];
      const Ligament& ligament = anatomy_.ligaments[i];
      const auto millimeters = [](double length_m) {
        return RoundedText(kMillimetersPerMeter * length_m, 1);
      };
      Residual shortest = extremes.shorter_mm.Worst(group, name + ", shortest", "mm", std::nullopt);
      shortest.value = kFar_mm - shortest.value;
      lines.push_back(std::move(shortest));
      lines.push_back(extremes.longest_mm.Worst(group,
                                                name + ", longest (published " +
                                                    millimeters(ligament.published_m) + " +- " +
                                                    millimeters(ligament.published_sd_m) + ")",
                                                "mm", std::nullopt));
      lines.push_back(
          extremes.beyond_slack_mm.Worst(group, name + ", beyond slack", "mm", kStretched_mm));
      lines.push_back(extremes.force_N.Worst(group, name + ", force", "N", std::nullopt));
    }
  }

  // At a command's targets, after some steps.
  ShoulderState Settled(const ArmCommand& command) {
    StartAtRest(command);
    constexpr int kSteps = 5;
    for (int step = 0; step < kSteps; ++step) {
      simulation_.Step(command);
    }
    return Canonical(simulation_.Observe(command));
  }

  void AddKeyframe(const char* name, const ArmCommand& command, const mjtNum* controls,
                   const mjtNum* qpos) {
    const ShoulderElements& elements = simulation_.elements();
    const ShoulderPose target = assembled_.SolvePose(command);
    const ShoulderPose wanted =
        name == kRelaxedName ? HangingIn(RelaxedStanding(), rhythm_) : target;
    const JointAngles target_rad = DrivenAngles(assembled_.assembly(), target);
    const JointAngles wanted_rad = DrivenAngles(assembled_.assembly(), wanted);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const double qpos_rad = qpos[elements.qpos[k]];
      keyframes_.Add(DegreesFromRadians(AngleDifference(qpos_rad, wanted_rad[k])), name, command);
      if (elements.joint_controls[k] >= 0) {
        const double held_rad =
            controls[elements.joint_controls[k]] + (elements.has_plugin() ? target_rad[k] : 0);
        keyframes_.Add(DegreesFromRadians(AngleDifference(qpos_rad, held_rad)), name, command);
      }
    }
    for (int i = 0; is_loop_ && i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      const double place_m = qpos[elements.place_qpos[axis]];
      keyframe_places_.Add(kMillimetersPerMeter * (place_m - PlaceOfScapula(wanted)[i]), name,
                           command);
      if (elements.place_controls[axis] >= 0) {
        const double held_m = controls[elements.place_controls[axis]] +
                              (elements.has_plugin() ? PlaceOfScapula(target)[i] : 0);
        keyframe_places_.Add(kMillimetersPerMeter * (place_m - held_m), name, command);
      }
    }
  }

  // PAC in the thorax frame [m] where the clavicle takes it.
  [[nodiscard]] Vector3 PlaceOfScapula(const ShoulderPose& pose) const {
    return LandmarkInThorax_m(anatomy_, pose, Landmark::kPAC);
  }

  // A tree's joints hold by construction; a loop's AC is held by the simulator.
  void AddJointConstraints(std::vector<Residual>& lines) const {
    const char* const group = "joint constraint";
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      if (!is_loop_ || joint != 1) {
        lines.push_back(
            gaps_[joint].Worst(group, std::string(kJointNames[joint]), "mm", kExact_mm));
        continue;
      }
      lines.push_back(connect_at_rest_.gap_mm.Worst(group, "AC at rest", "mm", kLoopAtRest_mm));
      lines.push_back(
          connect_posed_.gap_mm.Worst(group, "AC at the worst pose", "mm", kLoopAtRest_mm));
      lines.push_back(connect_moving_.gap_mm.Worst(group, "AC moving", "mm", kLoopMoving_mm));
      lines.push_back(connect_cycling_.gap_mm.Worst(group, "AC at 1 Hz", "mm", kLoopMoving_mm));
      lines.push_back(connect_at_rest_.force_N.Worst(group, "AC force at rest", "N", std::nullopt));
      lines.push_back(
          connect_posed_.force_N.Worst(group, "AC force at the worst pose", "N", std::nullopt));
      lines.push_back(connect_cycling_.force_N.Worst(group, "AC force at 1 Hz", "N", std::nullopt));
    }
  }

  // How a loop's AC joint holds.
  struct ConnectExtremes {
    Extreme gap_mm;
    Extreme force_N;
  };

  void AddConnect(const ShoulderState& state, std::string_view motion, ConnectExtremes& extremes) {
    extremes.gap_mm.Add(kMillimetersPerMeter *
                            glm::distance(state.landmark_m(Landmark::kPAC), state.child_site_m(1)),
                        motion, state.command);
    extremes.force_N.Add(state.connect_force_N, motion, state.command);
  }

  // What AC is where SC and ST are driven, against what was measured.
  void AddEmergent(const ShoulderState& state, const RhythmPosition& position,
                   const ArmCommand& command) {
    const Quaternion q_CS =
        glm::conjugate(state.rotation(Segment::kClavicle)) * state.rotation(Segment::kScapula);
    const Quaternion measured_q_CS = PoseFromAngles(position.angles_rad).q_CS;
    emergent_.Add(DegreesFromRadians(AngleBetween(q_CS, measured_q_CS)), "table", command);
    const Vector3 angles_rad = EulerFromQuaternion(kJointSequences[1], q_CS);
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      emergent_angles_[axis].Add(
          DegreesFromRadians(AngleDifference(angles_rad[i], position.angles_rad[3 + axis])),
          "table", command);
    }
  }

  // Joint constraint: distance of the two sites that meet in each joint.
  void AddJointGaps(const ShoulderState& state, std::string_view motion) {
    const std::array<Landmark, kJointCount> parents = {Landmark::kSC, Landmark::kPAC,
                                                       Landmark::kGH};
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      gaps_[joint].Add(kMillimetersPerMeter * glm::distance(state.landmark_m(parents[joint]),
                                                            state.child_site_m(joint)),
                       motion, state.command);
    }
  }

  // Tracking: simulated coordinates against the plugin's targets.
  static void AddTracking(const ShoulderState& state, std::string_view motion,
                          JointExtremes& extremes, bool counts) {
    if (!counts) {
      return;
    }
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      // What constraints push a joint off by is known, and told by itself.
      extremes[k / 3].Add(
          DegreesFromRadians(state.target_rad[k] - state.position_rad[k] + state.pushed_rad[k]),
          motion, state.command);
    }
  }

  ShoulderState VisitPose(const ArmCommand& command, std::string_view motion) {
    const ShoulderState state = Canonical(simulation_.ObserveAtTargets(command));
    const ShoulderPose pose = assembled_.SolvePose(command);
    AddJointGaps(state, motion);
    AddRotations(state, pose, motion);
    if (is_loop_) {
      scapula_place_.Add(
          kMillimetersPerMeter *
              glm::distance(InThorax(state, state.child_site_m(1)), PlaceOfScapula(pose)),
          motion, command);
    }
    AddLandmarkFrames(state, pose, motion);
    AddClosure(state, pose, motion);
    AddGliding(state, motion);
    AddLigaments(state, motion);
    AddLigamentLengths(state, pose, motion);
    return state;
  }

  // Kinematic consistency, first path: MuJoCo's body rotations against the splines' quaternions.
  void AddRotations(const ShoulderState& state, const ShoulderPose& pose, std::string_view motion) {
    const std::array<Quaternion, kJointCount> wanted = {pose.q_TC, pose.q_CS, pose.q_SH};
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      const Quaternion simulated = glm::conjugate(state.q_WB[joint]) * state.q_WB[joint + 1];
      body_rotations_[joint].Add(DegreesFromRadians(AngleBetween(simulated, wanted[joint])), motion,
                                 state.command);
    }
  }

  // Second path: ISB frames rebuilt from the simulated landmarks against the same quaternions.
  void AddLandmarkFrames(const ShoulderState& state, const ShoulderPose& pose,
                         std::string_view motion) {
    const Quaternion q_WT = state.rotation(Segment::kThorax);
    const Vector3 axis_W = ClavicleAxis(state.child_site_m(0), state.landmark_m(Landmark::kPAC));
    const Vector3 wanted_axis_W = q_WT * (pose.q_TC * Vector3{0, 0, 1});
    clavicle_axis_.Add(DegreesFromRadians(std::atan2(glm::length(glm::cross(axis_W, wanted_axis_W)),
                                                     glm::dot(axis_W, wanted_axis_W))),
                       motion, state.command);
    const Quaternion q_WS = ScapulaFrame(state.child_site_m(1), state.landmark_m(Landmark::kTS),
                                         state.landmark_m(Landmark::kAI));
    scapula_frame_.Add(DegreesFromRadians(AngleBetween(q_WS, q_WT * pose.q_TS())), motion,
                       state.command);
    const Quaternion q_WH = HumerusFrame(state.child_site_m(2), state.landmark_m(Landmark::kEM),
                                         state.landmark_m(Landmark::kEL));
    humerus_frame_.Add(DegreesFromRadians(AngleBetween(q_WH, q_WT * pose.q_TH())), motion,
                       state.command);
  }

  // Closure: where the simulated arm points, against where the splines' arm does and against the
  // command.
  void AddClosure(const ShoulderState& state, const ShoulderPose& pose, std::string_view motion) {
    const ArmAngles reached = ArmFromLandmarks(state);
    const ArmAngles own = ArmAnglesFromRotation(pose.q_TH());
    const ArmCommand& command = state.command;
    const ArmCommand used = rhythm_.Solve(command).used;
    distance_.Add(DegreesFromRadians(state.distance_rad), motion, command);
    closure_elevation_own_.Add(DegreesFromRadians(reached.elevation_rad - own.elevation_rad),
                               motion, command);
    closure_elevation_.Add(DegreesFromRadians(reached.elevation_rad - used.elevation_rad), motion,
                           command);
    if (used.elevation_rad < kPlaneless_rad || used.elevation_rad > kPi - kPlaneless_rad) {
      return;
    }
    closure_plane_own_.Add(DegreesFromRadians(AngleDifference(reached.plane_rad, own.plane_rad)),
                           motion, command);
    const bool is_low = used.elevation_rad < kLowestPlaneElevation_rad &&
                        rhythm_.options().closure == Closure::kTable;
    (is_low ? closure_low_plane_ : closure_plane_)
        .Add(DegreesFromRadians(AngleDifference(reached.plane_rad, used.plane_rad)), motion,
             command);
  }

  void AddScapulothoracic(const ShoulderState& state, const RhythmPosition& position,
                          const ArmCommand& command) {
    if (!position.scapulothoracic_rad) {
      return;
    }
    const Quaternion published_q_TS =
        QuaternionFromEuler(EulerSequence::kYXZ, *position.scapulothoracic_rad);
    const Quaternion q_TS =
        glm::conjugate(state.rotation(Segment::kThorax)) * state.rotation(Segment::kScapula);
    scapulothoracic_.Add(DegreesFromRadians(AngleBetween(q_TS, published_q_TS)), "table", command);
  }

  void AddGliding(const ShoulderState& state, std::string_view motion) {
    for (const Landmark landmark : {Landmark::kTS, Landmark::kAI}) {
      (state.distance_rad > 0 ? modelled_gliding_ : gliding_)
          .Add(kMillimetersPerMeter *
                   DistanceFromEllipsoid(anatomy_.gliding,
                                         InThorax(state, state.landmark_m(landmark))),
               motion, state.command);
    }
  }

  ShoulderSimulation& simulation_;
  const AssembledRhythm& assembled_;
  const ShoulderRhythm& rhythm_;
  bool is_loop_;
  const Anatomy& anatomy_;
  std::optional<SkinMeter> skin_;  ///< of a model that has one
  JointExtremes gaps_;
  ConnectExtremes connect_at_rest_;
  ConnectExtremes connect_posed_;
  ConnectExtremes connect_moving_;
  ConnectExtremes connect_cycling_;
  Extreme emergent_;
  std::array<Extreme, 3> emergent_angles_;
  Extreme bones_;
  Extreme masses_;
  Extreme centers_;
  Extreme inertias_;
  JointExtremes body_rotations_;
  Extreme clavicle_axis_;
  Extreme scapula_frame_;
  Extreme humerus_frame_;
  Extreme scapula_place_;
  Extreme keyframes_;
  Extreme keyframe_places_;
  JointExtremes settled_;
  Extreme speed_at_rest_;
  Extreme slide_at_rest_;
  JointExtremes moving_;
  Extreme closure_elevation_own_;
  Extreme closure_plane_own_;
  Extreme closure_elevation_;
  Extreme closure_plane_;
  Extreme closure_low_plane_;
  Extreme distance_;
  Extreme scapulothoracic_;
  Extreme gliding_;
  Extreme modelled_gliding_;
  Extreme contact_force_N_;
  Extreme contact_depth_mm_;
  Extreme contact_stiffness_;
  Extreme contact_surface_mm_;
  JointExtremes pushed_;
  std::array<LigamentExtremes, kLigamentCount> ligaments_;
  Extreme ligament_lengths_;
};

// The motions that every model is run through.
std::vector<Motion> StandardMotions(const ArmRectangle& domain) {
  const double lowest_rad = domain.lowest_elevation_rad;
  const double highest_rad = std::min(domain.highest_elevation_rad, kRaised_rad);
  const auto raise = [&](const char* name, double plane_deg) {
    const double plane_rad = RadiansFromDegrees(plane_deg);
    return ReachingMotion(name, {lowest_rad, plane_rad}, {highest_rad, plane_rad}, kMoving_s);
  };
  const double level_rad = RadiansFromDegrees(90);
  return {raise("abduction", 0), raise("scapular plane", 40), raise("flexion", 90),
          ReachingMotion(
              "protraction at 90",
              {level_rad, std::max(domain.first_plane_rad, LowestPlaneAt(level_rad).plane_rad)},
              {level_rad, domain.last_plane_rad}, kMoving_s)};
}

// Over the table's elevations and planes and back, once a second.
std::vector<Motion> Cycles(const RhythmTable& table) {
  constexpr double kDuration_s = 2;
  const auto between = [](double from, double to, double time_s) {
    return from + (to - from) * (1 - std::cos(2 * kPi * time_s)) / 2;
  };
  const double lowest_rad = table.elevations_rad().front();
  const double highest_rad = table.elevations_rad().back();
  std::vector<Motion> cycles;
  for (const double plane_rad : table.planes_rad()) {
    cycles.push_back({"1 Hz", kDuration_s, [=](double time_s) {
                        return ArmCommand{between(lowest_rad, highest_rad, time_s), plane_rad};
                      }});
  }
  for (const double elevation_rad : {RadiansFromDegrees(60), RadiansFromDegrees(100)}) {
    cycles.push_back({"1 Hz", kDuration_s, [=, &table](double time_s) {
                        return ArmCommand{
                            elevation_rad,
                            between(table.planes_rad().front(), table.planes_rad().back(), time_s)};
                      }});
  }
  return cycles;
}

std::vector<Residual> MeasureShoulder(ShoulderSimulation& simulation, const AssembledRhythm& rhythm,
                                      const Anatomy& anatomy, GirdleMotion girdle,
                                      const ProgressSink& progress) {
  ResidualMeter meter(simulation, rhythm, anatomy, girdle);
  const std::vector<Motion> motions = StandardMotions(rhythm.rhythm().domain());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double share = 1.0 / static_cast<double>(motions.size());
    meter.RunMotion(motions[i], [&progress, i, share](double done) {
      progress(share * (static_cast<double>(i) + done));
    });
  }
  for (const Motion& motion : Cycles(rhythm.rhythm().table())) {
    meter.RunCycles(motion);
  }
  meter.VisitTable();
  meter.VisitGrid();
  meter.VisitKeyframes();
  meter.VisitBones();
  return meter.Report();
}

}  // namespace

bool ResidualReport::passed() const noexcept {
  return std::all_of(residuals.begin(), residuals.end(),
                     [](const Residual& residual) { return residual.passed(); });
}

ResidualReport MeasureResiduals(ShoulderSimulation& simulation, const AssembledRhythm& rhythm,
                                const Anatomy& anatomy, const ProgressSink& progress,
                                GirdleMotion girdle) {
  if (girdle == GirdleMotion::kFrozen && !HasSkin(simulation.model())) {
    throw InputError(simulation.name() +
                     ": has no skin, on which alone a frozen girdle is measured. Make a model that "
                     "has one with girdle generate --skin");
  }
  ResidualReport report{simulation.name(), "", "", mj_versionString(), {}};
  const std::size_t sides = simulation.shoulders().size();
  for (std::size_t i = 0; i < sides; ++i) {
    const Side side = simulation.shoulders()[i].side;
    simulation.Watch(side);
    std::vector<Residual> lines =
        MeasureShoulder(simulation, rhythm, anatomy, girdle, [&progress, i, sides](double done) {
          progress((static_cast<double>(i) + done) / static_cast<double>(sides));
        });
    for (Residual& line : lines) {
      if (sides > 1) {
        line.item += ", " + std::string(kSideNames[static_cast<std::size_t>(side)]);
      }
      report.residuals.push_back(std::move(line));
    }
  }
  return report;
}

}  // namespace girdle
