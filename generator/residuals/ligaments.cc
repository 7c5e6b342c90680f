// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Ligaments: conoid and trapezoid, one-sided springs between clavicle and scapula.
//
//     length against the bones   l - |p_TA - p_TB|,  the anatomy's attachments in the splines' pose
//     beyond slack               max(0, l - l_slack),  l_slack the model's own
//     slack, stiffness, range    of the tendon in MuJoCo minus those that the anatomy has for the
//                                rhythm (ligament_slack.h); springs and ranges begin at no length
//
// Lengths and forces over all visits are only stated.

#include <array>
#include <cstddef>
#include <limits>
#include <string>

#include "anatomy/ligament_slack.h"
#include "anatomy/posed_bones.h"
#include "kinematics/lengths.h"
#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr const char* kLigaments = "ligaments";

// The targets of the joints never stretch a ligament. The lag of the joints during motions does: 3
// deg of AC, with attachments 40 mm away, would be 2 mm. The tolerance is the rounding of slack
// lengths, a tenth of a millimetre, which is 5 N.
constexpr double kStretched_mm = 0.1;

// Stiffness is read from the model with 17 digits: 50 N/mm to within a thousandth of a newton per
// meter.
constexpr double kExact_N_per_mm = 1e-6;

// Extremes of one ligament over poses and motions.
struct LigamentExtremes {
  WorstCase<ReportPlace, Worse::kSmaller> shortest_mm;
  Extreme longest_mm;
  Extreme beyond_slack_mm;
  Extreme force_N;
};

class LigamentsGroup : public ResidualGroup {
 public:
  explicit LigamentsGroup(const MeasuredShoulder& shoulder) : shoulder_(shoulder) {}

  void TakeStep(const SteppedState& step) override { Add(step.state, step.motion); }

  void TakePose(const ShownPose& pose) override {
    if (pose.kind == PoseKind::kAtTargets || pose.kind == PoseKind::kGridHeld) {
      Add(pose.state, pose.name);
    }
    if (pose.kind == PoseKind::kAtTargets) {
      // A tendon's parameters do not depend on the pose: the first pose is enough.
      if (slack_off_mm_.empty()) {
        AddParameters(pose.command);
      }
      for (std::size_t i = 0; i < kLigamentCount; ++i) {
        const double wanted_m =
            LigamentLength_m(shoulder_.anatomy.ligaments[i], shoulder_.anatomy, pose.wanted);
        against_bones_mm_.Add(kMillimetersPerMeter * (pose.state.ligament_m[i] - wanted_m),
                              pose.name, pose.command);
      }
    }
  }

  void AddLines(std::vector<Residual>& lines) override {
    lines.push_back(
        against_bones_mm_.Worst(kLigaments, "lengths against the bones", "mm", kExact_mm));
    lines.push_back(
        slack_off_mm_.Worst(kLigaments, "slack against the anatomy's", "mm", kExact_mm));
    lines.push_back(stiffness_off_N_per_mm_.Worst(kLigaments, "stiffness against the anatomy's",
                                                  "N/mm", kExact_N_per_mm));
    lines.push_back(
        range_off_mm_.Worst(kLigaments, "range against the anatomy's", "mm", kExact_mm));
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      AddLinesOf(lines, std::string(kLigamentNames[i]), shoulder_.anatomy.ligaments[i],
                 ligaments_[i]);
    }
  }

 private:
  void Add(const ShoulderState& state, std::string_view motion) {
    const ShoulderElements& elements = shoulder_.simulation.elements();
    const mjModel& model = shoulder_.simulation.model();
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      LigamentExtremes& extremes = ligaments_[i];
      const double length_mm = kMillimetersPerMeter * state.ligament_m[i];
      const double slack_mm =
          kMillimetersPerMeter * model.tendon_lengthspring[2 * elements.tendons[i] + 1];
      extremes.shortest_mm.Add(length_mm, motion, state.command);
      extremes.longest_mm.Add(length_mm, motion, state.command);
      // A length that is NaN counts as beyond slack.
      extremes.beyond_slack_mm.Add(length_mm <= slack_mm ? 0 : length_mm - slack_mm, motion,
                                   state.command);
      extremes.force_N.Add(state.ligament_force_N[i], motion, state.command);
    }
  }

  void AddParameters(const ArmCommand& command) {
    const Anatomy& anatomy = shoulder_.anatomy;
    const mjModel& model = shoulder_.simulation.model();
    const LigamentLengths slack_m = SlackFor_m(anatomy, shoulder_.rhythm);
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      const Ligament& ligament = anatomy.ligaments[i];
      const std::string_view name = kLigamentNames[i];
      const int tendon = shoulder_.simulation.elements().tendons[i];
      const mjtNum* const spring_m = model.tendon_lengthspring + 2 * tendon;
      slack_off_mm_.Add(kMillimetersPerMeter * spring_m[0], name, command);
      slack_off_mm_.Add(kMillimetersPerMeter * (spring_m[1] - slack_m[i]), name, command);
      stiffness_off_N_per_mm_.Add(
          (model.tendon_stiffness[tendon] - ligament.stiffness_N_per_m) / kMillimetersPerMeter,
          name, command);
      // A tendon without an active range has no largest length.
      const mjtNum* const range_m = model.tendon_range + 2 * tendon;
      const double end_m =
          model.tendon_limited[tendon] ? range_m[1] : std::numeric_limits<double>::infinity();
      range_off_mm_.Add(kMillimetersPerMeter * range_m[0], name, command);
      range_off_mm_.Add(kMillimetersPerMeter * (end_m - TearingLength_m(ligament, slack_m[i])),
                        name, command);
    }
  }

  static void AddLinesOf(std::vector<Residual>& lines, const std::string& name,
                         const Ligament& ligament, const LigamentExtremes& extremes) {
    const auto millimeters = [](double length_m) {
      return RoundedText(kMillimetersPerMeter * length_m, 1);
    };
    const ReportPlace& shortest = extremes.shortest_mm.place();
    lines.push_back({kLigaments, name + ", shortest", extremes.shortest_mm.value(), "mm",
                     std::nullopt, PlaceOf(shortest.motion, shortest.command)});
    lines.push_back(extremes.longest_mm.Worst(kLigaments,
                                              name + ", longest (published " +
                                                  millimeters(ligament.published_m) + " +- " +
                                                  millimeters(ligament.published_sd_m) + ")",
                                              "mm", std::nullopt));
    lines.push_back(
        extremes.beyond_slack_mm.Worst(kLigaments, name + ", beyond slack", "mm", kStretched_mm));
    lines.push_back(extremes.force_N.Worst(kLigaments, name + ", force", "N", std::nullopt));
  }

  MeasuredShoulder shoulder_;
  Extreme against_bones_mm_;
  Extreme slack_off_mm_;
  Extreme stiffness_off_N_per_mm_;
  Extreme range_off_mm_;
  std::array<LigamentExtremes, kLigamentCount> ligaments_;
};

}  // namespace

ResidualGroupPointer MakeLigamentsGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<LigamentsGroup>(shoulder);
}

}  // namespace girdle
