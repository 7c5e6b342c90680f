// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Kinematic consistency: compares MuJoCo's bones at the servos' targets with the splines' pose.
//
//     joints          angle of (R_WA^T R_WB) against q_AB,  AB = TC, CS, SH of the body rotations
//     clavicle        angle between PAC - SC and q_WT q_TC z
//     scapula         angle of the frame of PAC, TS, AI against q_WT q_TS
//     humerus         angle of the frame of GH, EM, EL against q_WT q_TH
//     scapula's place PAC in the thorax, where a loop's slides put it, against the clavicle's end
//     keyframes       q_key - q(pose),  and what the servos hold there - q_key
//
// Landmarks are a second path: if a bone has wrong sizes, they are off although the body rotations
// are not.

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "anatomy/postures.h"
#include "kinematics/isb_frames.h"
#include "kinematics/lengths.h"
#include "names/model_names.h"
#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"

namespace girdle {
namespace {

constexpr const char* kKinematicConsistency = "kinematic consistency";

class KinematicConsistencyGroup : public ResidualGroup {
 public:
  explicit KinematicConsistencyGroup(const MeasuredShoulder& shoulder) : shoulder_(shoulder) {}

  void TakePose(const ShownPose& pose) override {
    if (pose.kind == PoseKind::kKeyframe) {
      AddKeyframe(pose);
    } else if (pose.kind == PoseKind::kAtTargets) {
      AddRotations(pose);
      AddLandmarkFrames(pose);
      if (shoulder_.is_loop()) {
        scapula_place_mm_.Add(
            kMillimetersPerMeter * glm::distance(InThorax_m(pose.state, pose.state.child_site_m(1)),
                                                 PlaceOfScapula_m(pose.wanted)),
            pose.name, pose.command);
      }
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    const auto add = [&lines](const Extreme& extreme, std::string_view item, const char* unit,
                              double tolerance) {
      lines.push_back(extreme.Worst(kKinematicConsistency, std::string(item), unit, tolerance));
    };
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      add(joints_deg_[joint], kJointNames[joint], "deg", kExact_deg);
    }
    add(clavicle_deg_, "clavicle landmarks", "deg", kExact_deg);
    add(scapula_deg_, "scapula landmarks", "deg", kExact_deg);
    add(humerus_deg_, "humerus landmarks", "deg", kExact_deg);
    if (shoulder_.is_loop()) {
      add(scapula_place_mm_, "scapula's place", "mm", kExact_mm);
    }
    if (!keyframes_deg_.empty()) {
      add(keyframes_deg_, "keyframes", "deg", kExact_deg);
    }
    if (!keyframe_places_mm_.empty()) {
      add(keyframe_places_mm_, "keyframes, scapula's place", "mm", kExact_mm);
    }
  }

 private:
  void AddRotations(const ShownPose& pose) {
    const std::array<Quaternion, kJointCount> wanted = {pose.wanted.q_TC, pose.wanted.q_CS,
                                                        pose.wanted.q_SH};
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      const Quaternion q_AB = glm::conjugate(pose.state.q_WB[joint]) * pose.state.q_WB[joint + 1];
      joints_deg_[joint].Add(DegreesFromRadians(AngleBetween(q_AB, wanted[joint])), pose.name,
                             pose.command);
    }
  }

  void AddLandmarkFrames(const ShownPose& pose) {
    const ShoulderState& state = pose.state;
    const Quaternion q_WT = state.rotation(Segment::kThorax);
    const Vector3 axis_W = ClavicleAxis(state.child_site_m(0), state.landmark_m(Landmark::kPAC));
    const Vector3 wanted_axis_W = q_WT * (pose.wanted.q_TC * Vector3{0, 0, 1});
    clavicle_deg_.Add(DegreesFromRadians(std::atan2(glm::length(glm::cross(axis_W, wanted_axis_W)),
                                                    glm::dot(axis_W, wanted_axis_W))),
                      pose.name, pose.command);
    const Quaternion q_WS = FromLandmarks(state, Segment::kScapula);
    scapula_deg_.Add(DegreesFromRadians(AngleBetween(q_WS, q_WT * pose.wanted.q_TS())), pose.name,
                     pose.command);
    const Quaternion q_WH = FromLandmarks(state, Segment::kHumerus);
    humerus_deg_.Add(DegreesFromRadians(AngleBetween(q_WH, q_WT * pose.wanted.q_TH())), pose.name,
                     pose.command);
  }

  // Measures a keyframe. Girdle's keyframe `relaxed` is relaxed standing. Its commands alone do not
  // give that pose; the trims of the servos add the rest.
  void AddKeyframe(const ShownPose& shown) {
    const mjModel& model = shoulder_.simulation.model();
    const ShoulderElements& elements = shoulder_.simulation.elements();
    const mjtNum* const qpos = model.key_qpos + shown.key * model.nq;
    const mjtNum* const controls = model.key_ctrl + shown.key * model.nu;
    const ShoulderPose meant = shown.name == kRelaxedName
                                   ? HangingIn(RelaxedStanding(), shoulder_.rhythm.rhythm())
                                   : shown.wanted;
    const Assembly assembly = shoulder_.rhythm.assembly();
    const JointAngles target_rad = DrivenAngles(assembly, shown.wanted);
    const JointAngles meant_rad = DrivenAngles(assembly, meant);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const double qpos_rad = qpos[elements.qpos[k]];
      keyframes_deg_.Add(DegreesFromRadians(AngleDifference_rad(qpos_rad, meant_rad[k])),
                         shown.name, shown.command);
      if (elements.joint_controls[k] >= 0) {
        const double held_rad =
            controls[elements.joint_controls[k]] + (elements.has_plugin() ? target_rad[k] : 0);
        keyframes_deg_.Add(DegreesFromRadians(AngleDifference_rad(qpos_rad, held_rad)), shown.name,
                           shown.command);
      }
    }
    for (int i = 0; shoulder_.is_loop() && i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      const double place_m = qpos[elements.place_qpos[axis]];
      keyframe_places_mm_.Add(kMillimetersPerMeter * (place_m - PlaceOfScapula_m(meant)[i]),
                              shown.name, shown.command);
      if (elements.place_controls[axis] >= 0) {
        const double held_m = controls[elements.place_controls[axis]] +
                              (elements.has_plugin() ? PlaceOfScapula_m(shown.wanted)[i] : 0);
        keyframe_places_mm_.Add(kMillimetersPerMeter * (place_m - held_m), shown.name,
                                shown.command);
      }
    }
  }

  // Returns PAC in the thorax frame, as the end of the clavicle.
  [[nodiscard]] Vector3 PlaceOfScapula_m(const ShoulderPose& pose) const {
    return LandmarkInThorax_m(shoulder_.anatomy, pose, Landmark::kPAC);
  }

  MeasuredShoulder shoulder_;
  JointExtremes joints_deg_;
  Extreme clavicle_deg_;
  Extreme scapula_deg_;
  Extreme humerus_deg_;
  Extreme scapula_place_mm_;
  Extreme keyframes_deg_;
  Extreme keyframe_places_mm_;
};

}  // namespace

ResidualGroupPointer MakeKinematicConsistencyGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<KinematicConsistencyGroup>(shoulder);
}

}  // namespace girdle
