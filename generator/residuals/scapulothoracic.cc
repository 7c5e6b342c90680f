// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Scapulothoracic: compares the simulated scapula in the thorax with the published one.
//
//     angle of (R_WT^T R_WS) against q_TS of the table's positions
//
// A tree drives SC and AC. The resulting ST differs from the published ST, because the two tables
// contradict each other; this difference is checked. A loop drives ST itself, and its splines pass
// through the published ST. Kinematic consistency checks more finely, at the same positions,
// whether the scapula follows the splines. For loops these lines therefore follow from others and
// are only stated.

#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "residuals/extreme.h"
#include "residuals/residual_groups.h"

namespace girdle {
namespace {

constexpr const char* kScapulothoracic = "scapulothoracic";

// Contradiction of the published tables: 2.03 deg rms over rows 30 to 120, 1.7 to 2.5 in each row.
constexpr double kPublishedStRms_deg = 2.1;
constexpr double kPublishedStWorst_deg = 2.6;

class ScapulothoracicGroup : public ResidualGroup {
 public:
  explicit ScapulothoracicGroup(const MeasuredShoulder& shoulder)
      : is_loop_(shoulder.is_loop()),
        is_published_(
            shoulder.rhythm.rhythm().table().position(0, 0).scapulothoracic_rad.has_value()) {}

  void TakePose(const ShownPose& pose) override {
    if (pose.kind != PoseKind::kAtTargets || pose.position == nullptr ||
        !pose.position->scapulothoracic_rad) {
      return;
    }
    const Quaternion published_q_TS =
        QuaternionFromEuler(EulerSequence::kYXZ, *pose.position->scapulothoracic_rad);
    const Quaternion q_TS = glm::conjugate(pose.state.rotation(Segment::kThorax)) *
                            pose.state.rotation(Segment::kScapula);
    published_deg_.Add(DegreesFromRadians(AngleBetween(q_TS, published_q_TS)), pose.name,
                       pose.command);
  }

  void AddLines(std::vector<Residual>& lines) override {
    if (!is_published_) {
      return;
    }
    const auto tolerance = [this](double of_tree_deg) {
      return is_loop_ ? std::nullopt : std::optional(of_tree_deg);
    };
    lines.push_back(published_deg_.RootMeanSquare(kScapulothoracic, "published ST, rms", "deg",
                                                  tolerance(kPublishedStRms_deg)));
    lines.back().follows = is_loop_;
    lines.push_back(published_deg_.Worst(kScapulothoracic, "published ST, worst", "deg",
                                         tolerance(kPublishedStWorst_deg)));
    lines.back().follows = is_loop_;
  }

 private:
  bool is_loop_;
  bool is_published_;  ///< whether the table has published values of ST
  Extreme published_deg_;
};

}  // namespace

ResidualGroupPointer MakeScapulothoracicGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<ScapulothoracicGroup>(shoulder);
}

}  // namespace girdle
