// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Tracking: compares the simulated joints with the targets of their servos.
//
//     error = target - (q - pushed),  pushed = torque of the thorax / stiffness of the servo
//
// The displacement by the thorax has its own group (thorax_contact.cc).

#include <cstddef>
#include <string>

#include "kinematics/assembly.h"
#include "residuals/extreme.h"
#include "residuals/residual_groups.h"

namespace girdle {
namespace {

constexpr const char* kTrackingSettled = "tracking settled";
constexpr const char* kTrackingMoving = "tracking moving";

// A servo at rest could be as exact as rounding. A hundredth of a degree is far below what bone
// pins resolve, and below the swing that remains in a shoulder without damping.
constexpr double kSettledTracking_deg = 0.01;
// On the thorax: MuJoCo 3 finds the normal of a contact with an ellipsoid by iterations that end
// differently from step to step. The direction therefore trembles, and the joints tremble by 0.015
// deg.
constexpr double kSettledOnThorax_deg = 0.03;
// The lag of 20 ms (joint_dynamics.h) at the fastest joint speed of the standard motions, about 80
// deg/s, and a margin.
constexpr double kMovingTracking_deg = 3;
// A joint that trembles faster than this at rest, 6e-5 deg/s, has servos or constraints that
// conflict.
constexpr double kSpeedAtRest_rad_per_s = 1e-6;
// The equal speed at the end of a clavicle, a tenth of a meter from the joint.
constexpr double kSpeedAtRest_m_per_s = 1e-7;

class TrackingGroup : public ResidualGroup {
 public:
  explicit TrackingGroup(const MeasuredShoulder& shoulder) : shoulder_(shoulder) {}

  void TakeStep(const SteppedState& step) override {
    const ShoulderState& state = step.state;
    if (step.phase == StepPhase::kMoving) {
      Add(state, step.motion, moving_deg_);
    } else if (step.phase == StepPhase::kSettled) {
      Add(state, step.motion, settled_deg_);
      hinge_speed_rad_per_s_.Add(state.fastest_rad_per_s, step.motion, state.command);
      slide_speed_m_per_s_.Add(state.fastest_m_per_s, step.motion, state.command);
    }
  }

  void TakePose(const ShownPose& pose) override {
    if (pose.kind == PoseKind::kTableOnThorax) {
      Add(pose.state, pose.name, settled_deg_);
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    AddJoints(lines, kTrackingSettled, settled_deg_,
              shoulder_.has_thorax_contact() ? kSettledOnThorax_deg : kSettledTracking_deg);
    lines.push_back(hinge_speed_rad_per_s_.Worst(kTrackingSettled, "fastest joint", "rad/s",
                                                 kSpeedAtRest_rad_per_s));
    if (shoulder_.is_loop()) {
      lines.push_back(slide_speed_m_per_s_.Worst(kTrackingSettled, "scapula's place, fastest",
                                                 "m/s", kSpeedAtRest_m_per_s));
    }
    AddJoints(lines, kTrackingMoving, moving_deg_, kMovingTracking_deg);
  }

 private:
  static void Add(const ShoulderState& state, std::string_view motion, JointExtremes& joints_deg) {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      joints_deg[k / 3].Add(
          DegreesFromRadians(state.target_rad[k] - state.position_rad[k] + state.pushed_rad[k]),
          motion, state.command);
    }
  }

  void AddJoints(std::vector<Residual>& lines, const char* group, const JointExtremes& joints_deg,
                 double tolerance_deg) const {
    const auto driven = DrivenJoints(shoulder_.rhythm.assembly());
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      lines.push_back(
          joints_deg[joint].Worst(group, std::string(driven[joint]), "deg", tolerance_deg));
    }
  }

  MeasuredShoulder shoulder_;
  JointExtremes settled_deg_;
  JointExtremes moving_deg_;
  Extreme hinge_speed_rad_per_s_;
  Extreme slide_speed_m_per_s_;
};

}  // namespace

ResidualGroupPointer MakeTrackingGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<TrackingGroup>(shoulder);
}

}  // namespace girdle
