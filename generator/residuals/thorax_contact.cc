// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Thorax contact: how the thorax pushes TS and AI at rest, at every position of the table.
//
//     stiffness  force / depth - k,  the deepest contact, where it is deep enough to tell; where
//                none is, it is NaN and does not pass
//     depth      of MuJoCo's contact - that of TS or AI in the anatomy's ellipsoid
//     pushed     torque of the contact / stiffness of the joint's servo
//
// Force, depth and what they push the joints off their targets by are stated.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "anatomy/built_in_anatomy.h"
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

// MuJoCo looks for the nearest point of an ellipsoid until it knows it to 0.001 mm.
constexpr double kContactSurface_mm = 0.01;
// By what share the contact's stiffness may be off where the pose changes what the scapula weighs
// at TS and AI. Of other masses it is not known.
constexpr double kContactStiffnessShare = 0.2;
// Below this depth force over depth says little. At this depth what MuJoCo does not know of it is a
// thousandth.
constexpr double kDeepContact_m = 0.001;

constexpr double NewtonsPerMillimeter(double stiffness_N_per_m) {
  return stiffness_N_per_m / kMillimetersPerMeter;
}

class ThoraxContactGroup : public ResidualGroup {
 public:
  explicit ThoraxContactGroup(const MeasuredShoulder& shoulder) : shoulder_(shoulder) {}

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
    // A depth that is not a number counts as deep.
    if (!(depth_m <= kDeepContact_m)) {
      add(stiffness_off_N_per_mm_,
          NewtonsPerMillimeter(state.contact_force_N / depth_m - kThoraxContactStiffness_N_per_m));
    }
    add(surface_off_mm_, depth_mm - DepthInEllipsoid_mm(state));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      add(pushed_deg_[k / 3], DegreesFromRadians(state.pushed_rad[k]));
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    lines.push_back(force_N_.Worst(kThoraxContact, "force on TS or AI", "N", std::nullopt));
    constexpr double kWanted_N_per_mm = NewtonsPerMillimeter(kThoraxContactStiffness_N_per_m);
    lines.push_back(stiffness_off_N_per_mm_.Worst(
        kThoraxContact, "stiffness, off " + NumberText(kWanted_N_per_mm) + " N/mm", "N/mm",
        is_adult() ? std::optional(kContactStiffnessShare * kWanted_N_per_mm) : std::nullopt));
    if (stiffness_off_N_per_mm_.empty()) {
      lines.back().where = "not measured: no contact is deeper than " +
                           NumberText(kMillimetersPerMeter * kDeepContact_m) + " mm";
    }
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
  // Of the deeper of TS and AI; 0 where both are outside.
  [[nodiscard]] double DepthInEllipsoid_mm(const ShoulderState& state) const {
    double deepest_m = 0;
    for (const Landmark landmark : kGlidingLandmarks) {
      const double depth_m = -DistanceFromEllipsoid(shoulder_.anatomy.gliding,
                                                    InThorax_m(state, state.landmark_m(landmark)));
      // A depth that is not a number counts as one.
      deepest_m = depth_m <= deepest_m ? deepest_m : depth_m;
    }
    return kMillimetersPerMeter * deepest_m;
  }

  [[nodiscard]] bool is_adult() const {
    return shoulder_.anatomy.segment(Segment::kScapula).mass_kg ==
           BuiltInAnatomy().segment(Segment::kScapula).mass_kg;
  }

  MeasuredShoulder shoulder_;
  Extreme force_N_;
  Extreme depth_mm_;
  Extreme stiffness_off_N_per_mm_;
  Extreme surface_off_mm_;
  JointExtremes pushed_deg_;
};

}  // namespace

ResidualGroupPointer MakeThoraxContactGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<ThoraxContactGroup>(shoulder);
}

}  // namespace girdle
