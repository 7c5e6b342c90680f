// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Skin: passes the visits on to a SkinMeter (skin_residuals.h).

#include <iterator>

#include "residuals/residual_groups.h"
#include "residuals/skin_residuals.h"

namespace girdle {
namespace {

// Number of steps between two measurements during a motion. Fewer measurements are enough, because
// MuJoCo's skin depends on the pose alone. At a motion's first step nothing has moved yet.
constexpr int kSkinSteps = 50;

class SkinGroup : public ResidualGroup {
 public:
  SkinGroup(ShoulderSimulation& simulation, const MeasuredShoulder& shoulder, GirdleMotion girdle)
      : meter_(simulation, shoulder.rhythm, shoulder.anatomy, girdle) {}

  void TakeStep(const SteppedState& step) override {
    if (step.phase == StepPhase::kMoving && step.number > 0 && step.number % kSkinSteps == 0) {
      meter_.CompareMoving(step.motion, step.state.command);
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    std::vector<Residual> own = meter_.Measure();
    std::move(own.begin(), own.end(), std::back_inserter(lines));
  }

 private:
  SkinMeter meter_;
};

}  // namespace

ResidualGroupPointer MakeSkinGroup(ShoulderSimulation& simulation, const MeasuredShoulder& shoulder,
                                   GirdleMotion girdle) {
  return std::make_unique<SkinGroup>(simulation, shoulder, girdle);
}

}  // namespace girdle
