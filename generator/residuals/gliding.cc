// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Gliding: distance of the scapula's medial border from the ellipsoid that it glides on.
//
//     d(TS), d(AI) = signed distance of the landmark, in the thorax, from the ellipsoid, outside +
//
// The ellipsoid was fitted to the places of the two landmarks under the table's SC and AC. Outside
// the measured directions the distance is only stated.

#include <array>
#include <optional>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/ellipsoid.h"
#include "kinematics/lengths.h"
#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"

namespace girdle {
namespace {

constexpr const char* kGliding = "scapulothoracic";

// Tolerance in an adult, from the fit: 4.4 mm rms, 17 mm at most. Other people's tolerance scales
// with the size of their ellipsoid.
constexpr double kGlidingRms_mm = 5;
constexpr double kGlidingWorst_mm = 17;
// Tolerance for a loop. The ellipsoid was fitted to the scapula under SC and AC; under ST the
// scapula is up to 2.5 deg away, which is 6 mm at TS.
constexpr double kLoopGlidingRms_mm = 6.5;

class GlidingGroup : public ResidualGroup {
 public:
  explicit GlidingGroup(const MeasuredShoulder& shoulder)
      : ellipsoid_(shoulder.anatomy.gliding),
        rms_mm_(shoulder.is_loop() ? kLoopGlidingRms_mm : kGlidingRms_mm) {
    // There is no tolerance for an ellipsoid that was not fitted to these bones.
    if (shoulder.anatomy.has_adult_proportions) {
      size_ = ellipsoid_.radii_m.y / BuiltInAnatomy().gliding.radii_m.y;
    }
  }

  void TakePose(const ShownPose& pose) override {
    if (pose.kind != PoseKind::kAtTargets) {
      return;
    }
    for (const Landmark landmark : kGlidingLandmarks) {
      (pose.state.distance_rad > 0 ? modelled_mm_ : measured_mm_)
          .Add(kMillimetersPerMeter *
                   DistanceFromEllipsoid(ellipsoid_,
                                         InThorax_m(pose.state, pose.state.landmark_m(landmark))),
               pose.name, pose.command);
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    const auto tolerance_mm = [this](double adult_mm) {
      return size_ ? std::optional(*size_ * adult_mm) : std::nullopt;
    };
    lines.push_back(measured_mm_.RootMeanSquare(kGliding, "TS, AI to ellipsoid, rms", "mm",
                                                tolerance_mm(rms_mm_)));
    lines.push_back(measured_mm_.Worst(kGliding, "TS, AI to ellipsoid, worst", "mm",
                                       tolerance_mm(kGlidingWorst_mm)));
    if (!modelled_mm_.empty()) {
      lines.push_back(modelled_mm_.Worst(kGliding, "TS, AI to ellipsoid, outside measured data",
                                         "mm", std::nullopt));
    }
  }

 private:
  const Ellipsoid& ellipsoid_;
  double rms_mm_;
  std::optional<double> size_;  ///< of the ellipsoid; 1 for an adult
  Extreme measured_mm_;
  Extreme modelled_mm_;
};

}  // namespace

ResidualGroupPointer MakeGlidingGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<GlidingGroup>(shoulder);
}

}  // namespace girdle
