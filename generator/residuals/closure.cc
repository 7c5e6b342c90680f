// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Closure: compares the direction of the simulated arm with the direction of the command.
//
//     (theta, psi) = direction of the middle of EM and EL from GH, in the thorax
//     reached - commanded           against the command, as far as an arm goes; with closure
//                                   `exact`, the plane as an arc, sin(theta) (psi - psi_command)
//     against the table's own       against the direction of the splines' q_TH
//
// Besides all motions and the table, the arm is measured on a grid to the ends of its reach, where
// servos and constraints hold it. With closure `exact`, the splines' arm points in the direction of
// the command. Both comparisons are then equal, and the second follows from the first. With closure
// `table`, the splines' arm misses the command. The size of the miss is a property of the table and
// is only stated.

#include <cmath>
#include <optional>

#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"

namespace girdle {
namespace {

constexpr const char* kClosure = "closure";

// Below this elevation the plane of the arm is ill determined: the table's own arm misses it by up
// to 42 deg.
constexpr double kLowestPlaneElevation_rad = 30 * kRadiansPerDegree;
// Within this angle of hanging or straight up, the plane has no meaning: a millionth of a radian
// moves the elbow by less than a thousandth of a millimeter.
constexpr double kPlaneless_rad = 1e-6;

ArmAngles ArmFromLandmarks(const ShoulderState& state) {
  return ArmAnglesFromRotation(glm::conjugate(state.rotation(Segment::kThorax)) *
                               FromLandmarks(state, Segment::kHumerus));
}

class ClosureGroup : public ResidualGroup {
 public:
  explicit ClosureGroup(const MeasuredShoulder& shoulder)
      : rhythm_(shoulder.rhythm.rhythm()),
        is_exact_(rhythm_.options().closure == Closure::kExact) {}

  void TakePose(const ShownPose& pose) override {
    if (pose.kind != PoseKind::kAtTargets && pose.kind != PoseKind::kGridCommand) {
      return;
    }
    const ArmAngles reached = ArmFromLandmarks(pose.state);
    const ArmAngles own = ArmAnglesFromRotation(pose.wanted.q_TH());
    const ArmCommand used = rhythm_.Solve(pose.command).used;
    const auto add = [&pose](Extreme& extreme, double difference_rad) {
      extreme.Add(DegreesFromRadians(difference_rad), pose.name, pose.command);
    };
    add(own_elevation_deg_, reached.elevation_rad - own.elevation_rad);
    add(elevation_deg_, reached.elevation_rad - used.elevation_rad);
    if (used.elevation_rad < kPlaneless_rad || used.elevation_rad > kPi - kPlaneless_rad) {
      return;
    }
    add(own_plane_deg_, AngleDifference_rad(reached.plane_rad, own.plane_rad));
    const bool is_low = used.elevation_rad < kLowestPlaneElevation_rad && !is_exact_;
    // Near hanging a small turn of the arm changes its plane by much. The arc that the arm is off
    // does not grow with it.
    const double share = is_exact_ ? std::sin(used.elevation_rad) : 1.0;
    add(is_low ? low_plane_deg_ : plane_deg_,
        share * AngleDifference_rad(reached.plane_rad, used.plane_rad));
  }

  void AddLines(std::vector<Residual>& lines) override {
    const auto add = [&](const Extreme& extreme, const char* item, bool is_checked) -> Residual& {
      lines.push_back(extreme.Worst(kClosure, item, "deg",
                                    is_checked ? std::optional(kExact_deg) : std::nullopt));
      return lines.back();
    };
    add(own_elevation_deg_, "elevation against the table's own", !is_exact_).follows = is_exact_;
    add(own_plane_deg_, "plane against the table's own", !is_exact_).follows = is_exact_;
    add(elevation_deg_, "elevation reached - commanded", is_exact_);
    add(plane_deg_, is_exact_ ? "plane reached - commanded" : "plane, from elevation 30",
        is_exact_);
    if (!is_exact_) {
      add(low_plane_deg_, "plane, below elevation 30", false);
    }
  }

 private:
  const ShoulderRhythm& rhythm_;
  bool is_exact_;
  Extreme own_elevation_deg_;
  Extreme own_plane_deg_;
  Extreme elevation_deg_;
  Extreme plane_deg_;
  Extreme low_plane_deg_;
};

}  // namespace

ResidualGroupPointer MakeClosureGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<ClosureGroup>(shoulder);
}

}  // namespace girdle
