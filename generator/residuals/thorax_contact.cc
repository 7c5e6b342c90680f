// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Thorax contact: forces of the thorax on TS and AI at rest, at every position of the table.
//
//     stiffness  (force / depth - k) / k,  k = k_0 w_0 / w,  of the deepest contact, if it is deep
//                enough to measure; if no contact is, the value is NaN and does not pass
//     armature   of the joints / that of joint_dynamics.h - 1
//     depth      of MuJoCo's contact - that of TS or AI in the anatomy's ellipsoid
//     pushed     torque of the contact / stiffness of the joint's servo
//
// k_0 is 20 N/mm, and w_0 is the inverse weight of the built-in scapula (joint_dynamics.h). w is
// the inverse weight that MuJoCo computes from the model's masses, which the lines on bones check,
// and from the armature of the joints. Force, depth, and the displacement of the joints from their
// targets are only stated.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>

#include "anatomy/ellipsoid.h"
#include "kinematics/assembly.h"
#include "kinematics/lengths.h"
#include "names/joint_dynamics.h"
#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr const char* kThoraxContact = "thorax contact";

// MuJoCo iterates to the nearest point of an ellipsoid until its error is 0.001 mm.
constexpr double kContactSurface_mm = 0.01;
// The contact's stiffness may be off by this share, because the inverse weight of the scapula at TS
// and AI changes with the pose. In people of 0.9 to 2.1 m and 20 to 150 kg it was off by up to 10
// %.
constexpr double kContactStiffness_percent = 20;
// Rounding of a number that MuJoCo reads from text.
constexpr double kArmature_percent = 1e-6;
constexpr double kContactPercent = 100;
// Below this depth, force over depth is inaccurate. At this depth, MuJoCo's error of the depth is a
// thousandth.
constexpr double kDeepContact_m = 0.001;

class ThoraxContactGroup : public ResidualGroup {
 public:
  explicit ThoraxContactGroup(const MeasuredShoulder& shoulder)
      : shoulder_(shoulder), stiffness_N_per_m_(NewtonsPerMeterOf(shoulder)) {}

  void TakePose(const ShownPose& pose) override {
    if (pose.kind != PoseKind::kTableOnThorax) {
      return;
    }
    const ShoulderState& state = pose.state;
    const auto add = [&pose](Extreme& extreme, double value) {
      extreme.Add(value, pose.name, pose.command);
    };
    const double depth_m = state.contact_depth_m;
    const double depth_mm = kMillimetersPerMeter * depth_m;
    add(force_N_, state.contact_force_N);
    add(depth_mm_, depth_mm);
    // A depth that is NaN counts as deep.
    if (!(depth_m <= kDeepContact_m)) {
      add(stiffness_off_percent_,
          kContactPercent * (state.contact_force_N / depth_m / stiffness_N_per_m_ - 1));
    }
    add(surface_off_mm_, depth_mm - DepthInEllipsoid_mm(state));
    // A model's armature does not depend on the pose: the first pose is enough.
    if (armature_off_percent_.empty()) {
      AddArmature(pose.command);
    }
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      add(pushed_deg_[k / 3], DegreesFromRadians(state.pushed_rad[k]));
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    lines.push_back(force_N_.Worst(kThoraxContact, "force on TS or AI", "N", std::nullopt));
    lines.push_back(stiffness_off_percent_.Worst(kThoraxContact, "stiffness against the bones'",
                                                 "%", kContactStiffness_percent));
    if (stiffness_off_percent_.empty()) {
      lines.back().where = "not measured: no contact is deeper than " +
                           NumberText(kMillimetersPerMeter * kDeepContact_m) + " mm";
    }
    lines.push_back(armature_off_percent_.Worst(kThoraxContact, "armature against the built-in's",
                                                "%", kArmature_percent));
    lines.push_back(surface_off_mm_.Worst(kThoraxContact, "depth against the anatomy's", "mm",
                                          kContactSurface_mm));
    lines.push_back(
        depth_mm_.Worst(kThoraxContact, "TS or AI in the ellipsoid", "mm", std::nullopt));
    const auto driven = DrivenJoints(shoulder_.rhythm.assembly());
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      lines.push_back(pushed_deg_[joint].Worst(
          kThoraxContact, std::string(driven[joint]) + " pushed off its target", "deg",
          std::nullopt));
    }
  }

 private:
  void AddArmature(const ArmCommand& command) {
    const mjModel& model = shoulder_.simulation.model();
    const auto& bodies = shoulder_.simulation.elements().bodies;
    // The hinges of SC belong to the body of the clavicle, and so on. Joints of the thorax do not
    // belong to the shoulder.
    const auto first = std::next(bodies.begin());
    for (int dof = 0; dof < model.nv; ++dof) {
      const auto body = std::find(first, bodies.end(), model.dof_bodyid[dof]);
      if (body == bodies.end()) {
        continue;
      }
      const auto joint = static_cast<std::size_t>(body - first);
      const double built_in = model.jnt_type[model.dof_jntid[dof]] == mjJNT_SLIDE
                                  ? kLeadingTranslation.armature_kg
                                  : kJointDynamics.at(joint).armature_kg_m2;
      armature_off_percent_.Add(kContactPercent * (model.dof_armature[dof] / built_in - 1),
                                kSegmentNames.at(joint + 1), command);
    }
  }

  // Returns the stiffness k. It is not in proportion to mass, because the armature of the servos
  // counts too: the shorter the bones, the more.
  [[nodiscard]] static double NewtonsPerMeterOf(const MeasuredShoulder& shoulder) {
    const int scapula =
        shoulder.simulation.elements().bodies[static_cast<std::size_t>(Segment::kScapula)];
    // MuJoCo has two inverse weights for a body: the first for forces, the second for torques.
    const double inverse_weight_per_kg = shoulder.simulation.model().body_invweight0[2 * scapula];
    return kThoraxContactStiffness_N_per_m *
           (shoulder.is_loop() ? kLoopInverseWeight_per_kg : kTreeInverseWeight_per_kg) /
           inverse_weight_per_kg;
  }

  // Returns the depth of the deeper of TS and AI; 0 if both are outside.
  [[nodiscard]] double DepthInEllipsoid_mm(const ShoulderState& state) const {
    double deepest_m = 0;
    for (const Landmark landmark : kGlidingLandmarks) {
      const double depth_m = -DistanceFromEllipsoid(shoulder_.anatomy.gliding,
                                                    InThorax_m(state, state.landmark_m(landmark)));
      // A depth that is NaN becomes the result.
      deepest_m = depth_m <= deepest_m ? deepest_m : depth_m;
    }
    return kMillimetersPerMeter * deepest_m;
  }

  MeasuredShoulder shoulder_;
  double stiffness_N_per_m_;
  Extreme force_N_;
  Extreme depth_mm_;
  Extreme stiffness_off_percent_;
  Extreme armature_off_percent_;
  Extreme surface_off_mm_;
  JointExtremes pushed_deg_;
};

}  // namespace

ResidualGroupPointer MakeThoraxContactGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<ThoraxContactGroup>(shoulder);
}

}  // namespace girdle
