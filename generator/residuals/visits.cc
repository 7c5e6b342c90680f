// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/visits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "kinematics/knot_crossings.h"
#include "motions/motion.h"
#include "names/model_names.h"

namespace girdle {
namespace {

// Duration of a standard motion and of the rest after it.
constexpr double kMoving_s = 3;
constexpr double kSettling_s = 4;
// The last share of the rest, which counts as settled.
constexpr double kSettledShare = 0.25;
// Parts of a motion without dynamics. They are at most 3 deg apart, where the motion is fastest.
constexpr int kPosesOfMotion = 128;
// End of the standard motions: people raise their arms to 150 +- 9 deg (Henninger, 20 people).
constexpr double kRaised_rad = 150 * kRadiansPerDegree;
// Step of the grid over all that the arm reaches.
constexpr double kGridStep_rad = 10 * kRadiansPerDegree;
// Steps during which servos and constraints hold a pose.
constexpr int kHoldingSteps = 5;
// Time for the thorax to push the joints: 15 time constants of the servos.
constexpr double kPushing_s = 0.3;
// Duration of the cycles of 1 Hz. The second cycle starts from the state after the first.
constexpr double kCycles_s = 2;

// Returns the motions that every model is taken through.
std::vector<Motion> StandardMotions(const ShoulderRhythm& rhythm) {
  const ArmRectangle& domain = rhythm.domain();
  const double lowest_rad = domain.lowest_elevation_rad;
  const double highest_rad = std::min(domain.highest_elevation_rad, kRaised_rad);
  const auto raise = [&](const char* name, double plane_deg) {
    const double plane_rad = RadiansFromDegrees(plane_deg);
    return ReachingMotion(name, {lowest_rad, plane_rad}, {highest_rad, plane_rad}, kMoving_s);
  };
  const double level_rad = RadiansFromDegrees(90);
  return {raise("abduction", 0), raise("scapular plane", 40), raise("flexion", 90),
          ReachingMotion("protraction at 90", {level_rad, rhythm.LowestPlaneAt(level_rad)},
                         {level_rad, domain.last_plane_rad}, kMoving_s)};
}

// Returns cycles over the table's elevations and planes, there and back once a second.
std::vector<Motion> Cycles(const RhythmTable& table) {
  const auto between = [](double from, double to, double time_s) {
    return from + (to - from) * (1 - std::cos(2 * kPi * time_s)) / 2;
  };
  const double lowest_rad = table.elevations_rad().front();
  const double highest_rad = table.elevations_rad().back();
  std::vector<Motion> cycles;
  for (const double plane_rad : table.planes_rad()) {
    cycles.push_back({"1 Hz", kCycles_s, [=](double time_s) {
                        return ArmCommand{between(lowest_rad, highest_rad, time_s), plane_rad};
                      }});
  }
  for (const double elevation_rad : {RadiansFromDegrees(60), RadiansFromDegrees(100)}) {
    cycles.push_back({"1 Hz", kCycles_s, [=, &table](double time_s) {
                        return ArmCommand{
                            elevation_rad,
                            between(table.planes_rad().front(), table.planes_rad().back(), time_s)};
                      }});
  }
  return cycles;
}

// Returns values from one bound to the other. The last step may be shorter.
std::vector<double> GridValues(double from_rad, double to_rad) {
  constexpr double kRounding = 1e-9;  // rounding must not add a step
  const double steps = std::ceil((to_rad - from_rad) / kGridStep_rad - kRounding);
  std::vector<double> values_rad;
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    values_rad.push_back(std::min(from_rad + i * kGridStep_rad, to_rad));
  }
  return values_rad;
}

class Visitor {
 public:
  Visitor(ShoulderSimulation& simulation, const MeasuredShoulder& shoulder,
          const std::vector<ResidualGroupPointer>& groups)
      : simulation_(simulation), shoulder_(shoulder), groups_(groups) {}

  void VisitMotion(const Motion& motion, const ProgressSink& progress) {
    const double timestep_s = simulation_.timestep_s();
    const auto moving_steps = static_cast<int>(std::lround(motion.duration_s / timestep_s));
    const auto settling_steps = static_cast<int>(std::lround(kSettling_s / timestep_s));
    const int settled_from = moving_steps + static_cast<int>((1 - kSettledShare) * settling_steps);
    StartAtRest(motion.command(0));
    for (int step = 0; step < moving_steps + settling_steps; ++step) {
      const StepPhase phase = step < moving_steps    ? StepPhase::kMoving
                              : step >= settled_from ? StepPhase::kSettled
                                                     : StepPhase::kSettling;
      ShowStep(motion, phase, step);
      progress(static_cast<double>(step) / (moving_steps + settling_steps));
    }
    for (int i = 0; i <= kPosesOfMotion; ++i) {
      const ArmCommand command = motion.command(motion.duration_s * i / kPosesOfMotion);
      Show(motion.name, PoseKind::kAtTargets, command, AtTargets(command));
    }
  }

  void VisitCycle(const Motion& motion) {
    const auto steps = static_cast<int>(std::lround(motion.duration_s / simulation_.timestep_s()));
    StartAtRest(motion.command(0));
    for (int step = 0; step < steps; ++step) {
      ShowStep(motion, StepPhase::kCycling, step);
    }
  }

  void VisitTable() {
    const RhythmTable& table = shoulder_.rhythm.rhythm().table();
    for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
      for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
        const ArmCommand command{table.elevations_rad()[elevation], table.planes_rad()[plane], 0};
        const RhythmPosition* const position = &table.position(plane, elevation);
        const auto show = [&](PoseKind kind, const ShoulderState& state) {
          Show("table", kind, command, state, position);
        };
        show(PoseKind::kAtTargets, AtTargets(command));
        if (shoulder_.is_loop()) {
          show(PoseKind::kTableHeld,
               shoulder_.has_thorax_contact() ? AtTargets(command) : Held(command));
        }
        if (shoulder_.has_thorax_contact()) {
          StartAtRest(command);
          show(PoseKind::kTableOnThorax, OnRight(simulation_.Observe(command)));
        }
      }
    }
  }

  void VisitGrid() {
    const ShoulderRhythm& rhythm = shoulder_.rhythm.rhythm();
    const ArmRectangle& domain = rhythm.domain();
    for (const double elevation_rad :
         GridValues(domain.lowest_elevation_rad, domain.highest_elevation_rad)) {
      for (const double plane_rad : GridValues(domain.first_plane_rad, domain.last_plane_rad)) {
        const ArmCommand command = rhythm.Solve({elevation_rad, plane_rad}).used;
        const ShoulderState held = Held(command);
        Show("grid", PoseKind::kGridHeld, command, held);
        Show("grid", PoseKind::kGridCommand, command,
             shoulder_.has_thorax_contact() ? AtTargets(command) : held);
      }
    }
  }

  void VisitKeyframes() {
    const mjModel& model = simulation_.model();
    const ShoulderElements& elements = simulation_.elements();
    for (int key = 0; key < model.nkey; ++key) {
      const char* const name = model.names + model.name_keyadr[key];
      // A keyframe with one of Girdle's names must be the pose of that name. Another keyframe must
      // be the pose of its commands.
      const auto* named = std::find_if(kKeyframes.begin(), kKeyframes.end(),
                                       [name](const NamedPose& pose) { return pose.name == name; });
      const bool is_ours = named != kKeyframes.end();
      const mjtNum* const controls = model.key_ctrl + key * model.nu;
      ArmCommand command;
      if (is_ours && named->name != kHangingName) {
        command = {RadiansFromDegrees(named->elevation_deg), RadiansFromDegrees(named->plane_deg)};
      } else if (elements.has_plugin()) {
        command = {controls[elements.command_controls[0]], controls[elements.command_controls[1]],
                   controls[elements.command_controls[2]]};
        command.axial_from = OwnAxialFrom(simulation_.loaded());
      } else if (!is_ours) {
        continue;  // targets of position servos do not tell the command
      }
      simulation_.PutAtKeyframe(key);
      Show(name, PoseKind::kKeyframe, command, OnRight(simulation_.Observe(command)), nullptr, key);
    }
  }

 private:
  void ShowStep(const Motion& motion, StepPhase phase, int number) {
    const double timestep_s = simulation_.timestep_s();
    const double time_s = number * timestep_s;
    const ShoulderState state =
        OnRight(simulation_.Step(motion.command(time_s), RateOf(motion, time_s, timestep_s)));
    for (const ResidualGroupPointer& group : groups_) {
      group->TakeStep({motion.name, phase, number, state});
    }
  }

  void Show(std::string_view name, PoseKind kind, const ArmCommand& command,
            const ShoulderState& state, const RhythmPosition* position = nullptr, int key = -1) {
    const ShoulderPose wanted = shoulder_.rhythm.SolvePose(command);
    for (const ResidualGroupPointer& group : groups_) {
      group->TakePose({name, kind, command, state, wanted, position, key});
    }
  }

  [[nodiscard]] ShoulderState OnRight(const ShoulderState& state) const {
    return simulation_.elements().side == Side::kLeft ? MirroredToRight(state) : state;
  }

  ShoulderState AtTargets(const ArmCommand& command) {
    return OnRight(simulation_.ObserveAtTargets(command));
  }

  // Starts at a command's targets, or where the thorax has pushed the joints from there.
  void StartAtRest(const ArmCommand& command) {
    simulation_.Start(command);
    const auto steps = static_cast<int>(std::lround(kPushing_s / simulation_.timestep_s()));
    for (int step = 0; shoulder_.has_thorax_contact() && step < steps; ++step) {
      simulation_.Step(command);
    }
  }

  ShoulderState Held(const ArmCommand& command) {
    StartAtRest(command);
    for (int step = 0; step < kHoldingSteps; ++step) {
      simulation_.Step(command);
    }
    return OnRight(simulation_.Observe(command));
  }

  ShoulderSimulation& simulation_;
  const MeasuredShoulder& shoulder_;
  const std::vector<ResidualGroupPointer>& groups_;
};

}  // namespace

void ShowVisits(ShoulderSimulation& simulation, const MeasuredShoulder& shoulder,
                const std::vector<ResidualGroupPointer>& groups, const ProgressSink& progress) {
  Visitor visitor(simulation, shoulder, groups);
  const std::vector<Motion> motions = StandardMotions(shoulder.rhythm.rhythm());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const double share = 1.0 / static_cast<double>(motions.size());
    visitor.VisitMotion(motions[i], [&progress, i, share](double done) {
      progress(share * (static_cast<double>(i) + done));
    });
  }
  for (const Motion& motion : Cycles(shoulder.rhythm.rhythm().table())) {
    visitor.VisitCycle(motion);
  }
  visitor.VisitTable();
  visitor.VisitGrid();
  visitor.VisitKeyframes();
}

}  // namespace girdle
