// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Emergent AC: compares the AC rotation in a loop, whose servos drive SC and ST, with the measured
// AC.
//
//     angle of (R_WC^T R_WS) against q_CS of the table's positions, and its Euler angles one by one
//
// No servo drives AC: the servos of SC and ST and the constraint of the AC joint determine it. If
// the bones move as measured, it differs from the measured AC by as much as the published tables
// contradict each other.

#include <array>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"

namespace girdle {
namespace {

constexpr const char* kEmergentAc = "emergent AC";

// Contradiction of the published tables, as for ST (scapulothoracic.cc).
constexpr double kMeasuredAcRms_deg = 2.1;
constexpr double kMeasuredAcWorst_deg = 2.6;

// Index of AC's first coordinate.
constexpr std::size_t kFirstAcCoordinate = 3;

class EmergentAcGroup : public ResidualGroup {
 public:
  void TakePose(const ShownPose& pose) override {
    if (pose.kind != PoseKind::kTableHeld) {
      return;
    }
    const Quaternion q_CS = glm::conjugate(pose.state.rotation(Segment::kClavicle)) *
                            pose.state.rotation(Segment::kScapula);
    const JointAngles& measured_rad = pose.position->angles_rad;
    rotation_deg_.Add(DegreesFromRadians(AngleBetween(q_CS, PoseFromAngles(measured_rad).q_CS)),
                      pose.name, pose.command);
    const Vector3 angles_rad = EulerFromQuaternion(kJointSequences[1], q_CS);
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      angles_deg_[axis].Add(DegreesFromRadians(AngleDifference_rad(
                                angles_rad[i], measured_rad[kFirstAcCoordinate + axis])),
                            pose.name, pose.command);
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    lines.push_back(
        rotation_deg_.RootMeanSquare(kEmergentAc, "measured AC, rms", "deg", kMeasuredAcRms_deg));
    lines.push_back(
        rotation_deg_.Worst(kEmergentAc, "measured AC, worst", "deg", kMeasuredAcWorst_deg));
    for (std::size_t i = 0; i < angles_deg_.size(); ++i) {
      lines.push_back(angles_deg_[i].Worst(
          kEmergentAc, std::string(kCoordinateNames[kFirstAcCoordinate + i]), "deg", std::nullopt));
    }
  }

 private:
  Extreme rotation_deg_;
  std::array<Extreme, 3> angles_deg_;
};

}  // namespace

ResidualGroupPointer MakeEmergentAcGroup() { return std::make_unique<EmergentAcGroup>(); }

}  // namespace girdle
