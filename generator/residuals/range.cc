// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Range: states how far the shoulder was from measured data.
//
//     distance = the angle from the arm's direction to the nearest measured one
//
// The plugin's sensor measures the same distance. It has no tolerance: an arm may leave the
// measured directions, but its pose there is a model and not a measurement. A rhythm that clamps
// does not leave them.

#include "residuals/extreme.h"
#include "residuals/residual_groups.h"

namespace girdle {
namespace {

class RangeGroup : public ResidualGroup {
 public:
  explicit RangeGroup(const MeasuredShoulder& shoulder)
      : is_whole_(shoulder.rhythm.rhythm().options().range == Range::kWhole) {}

  void TakePose(const ShownPose& pose) override {
    if (pose.kind == PoseKind::kAtTargets || pose.kind == PoseKind::kGridCommand) {
      distance_deg_.Add(DegreesFromRadians(pose.state.distance_rad), pose.name, pose.command);
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    if (is_whole_) {
      lines.push_back(
          distance_deg_.Worst("range", "farthest from measured data", "deg", std::nullopt));
    }
  }

 private:
  bool is_whole_;
  Extreme distance_deg_;
};

}  // namespace

ResidualGroupPointer MakeRangeGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<RangeGroup>(shoulder);
}

}  // namespace girdle
