// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Joint constraint: checks whether the bones meet in their joints.
//
//     gap = |p_parent - p_child|,  the two sites of SC, AC and GH
//
// SC and GH of every model and AC of a tree are joints of rigid bodies. Their gaps show a body, a
// hinge or a site in the wrong place. AC of a loop is an equality constraint of MuJoCo, which gives
// way.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>

#include "kinematics/lengths.h"
#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"

namespace girdle {
namespace {

constexpr const char* kJointConstraint = "joint constraint";

// Limits for a loop's AC, at rest and during motions. At rest only faults of a servo pull the two
// sites apart: the emitted models leave less than 1e-6. During motions at 1 Hz with the models' own
// time step, the constraint of joint_dynamics.h gives way by 0.01; in other swings of the arm, by
// up to 0.1. MuJoCo softens the constraint for longer steps, to 0.2 at the longest of
// longest_timestep.h.
constexpr double kLoopAtRest_mm = 0.05;
constexpr double kLoopMoving_mm = 0.1;
constexpr double kLoopMovingInLongSteps_mm = 1;
constexpr double kOwnStep_s = 0.002;
// The limit grows from 0.1 at 2 ms to 1 at 5 ms.
constexpr double kSoftening = 2.5;

constexpr std::size_t kAc = 1;

// The parent's site of each joint.
constexpr std::array<Landmark, kJointCount> kParentSites = {Landmark::kSC, Landmark::kPAC,
                                                            Landmark::kGH};

double Gap_mm(const ShoulderState& state, std::size_t joint) {
  return kMillimetersPerMeter *
         glm::distance(state.landmark_m(kParentSites[joint]), state.child_site_m(joint));
}

class JointConstraintGroup : public ResidualGroup {
 public:
  explicit JointConstraintGroup(const MeasuredShoulder& shoulder) : shoulder_(shoulder) {}

  void TakeStep(const SteppedState& step) override {
    AddRigid(step.state, step.motion);
    switch (step.phase) {
      case StepPhase::kMoving:
        moving_.Add(step.state, step.motion);
        break;
      case StepPhase::kSettled:
        at_rest_.Add(step.state, step.motion);
        break;
      case StepPhase::kCycling:
        cycling_.Add(step.state, step.motion);
        break;
      case StepPhase::kSettling:
        break;
    }
  }

  void TakePose(const ShownPose& pose) override {
    if (pose.kind == PoseKind::kAtTargets) {
      AddRigid(pose.state, pose.name);
    } else if (pose.kind == PoseKind::kGridHeld) {
      posed_.Add(pose.state, pose.name);
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      if (shoulder_.is_loop() && joint == kAc) {
        AddLoopLines(lines);
      } else {
        lines.push_back(rigid_mm_[joint].Worst(kJointConstraint, std::string(kJointNames[joint]),
                                               "mm", kExact_mm));
      }
    }
  }

 private:
  // Gap and force of a loop's AC joint.
  struct Connect {
    void Add(const ShoulderState& state, std::string_view motion) {
      gap_mm.Add(Gap_mm(state, kAc), motion, state.command);
      force_N.Add(state.connect_force_N, motion, state.command);
    }

    Extreme gap_mm;
    Extreme force_N;
  };

  void AddRigid(const ShoulderState& state, std::string_view motion) {
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      rigid_mm_[joint].Add(Gap_mm(state, joint), motion, state.command);
    }
  }

  void AddLoopLines(std::vector<Residual>& lines) const {
    const auto add_gap = [&lines](const Connect& connect, const char* item, double tolerance_mm) {
      lines.push_back(connect.gap_mm.Worst(kJointConstraint, item, "mm", tolerance_mm));
    };
    const auto add_force = [&lines](const Connect& connect, const char* item) {
      lines.push_back(connect.force_N.Worst(kJointConstraint, item, "N", std::nullopt));
    };
    add_gap(at_rest_, "AC at rest", kLoopAtRest_mm);
    add_gap(posed_, "AC at the worst pose", kLoopAtRest_mm);
    const double longer = std::max(shoulder_.simulation.timestep_s() / kOwnStep_s, 1.0);
    const double moving_mm =
        std::min(kLoopMoving_mm * std::pow(longer, kSoftening), kLoopMovingInLongSteps_mm);
    add_gap(moving_, "AC moving", moving_mm);
    add_gap(cycling_, "AC at 1 Hz", moving_mm);
    add_force(at_rest_, "AC force at rest");
    add_force(posed_, "AC force at the worst pose");
    add_force(cycling_, "AC force at 1 Hz");
  }

  MeasuredShoulder shoulder_;
  JointExtremes rigid_mm_;
  Connect at_rest_;
  Connect posed_;
  Connect moving_;
  Connect cycling_;
};

}  // namespace

ResidualGroupPointer MakeJointConstraintGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<JointConstraintGroup>(shoulder);
}

}  // namespace girdle
