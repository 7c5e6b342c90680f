// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/module.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "simulation/engine.h"
#include "simulation/mapped_arm.h"
#include "simulation/mapped_shoulder.h"
#include "simulation/motion.h"
#include "simulation/residual_report.h"
#include "simulation/residuals.h"
#include "simulation/scapulothoracic_survey.h"
#include "simulation/shoulder_simulation.h"
#include "simulation/trace.h"
#include "tables/built_in.h"
#include "tables/input_error.h"
#include "tables/model_mapping.h"
#include "tables/rhythm_config.h"
#include "tables/rhythm_table_csv.h"
#include "tables/text_file.h"

namespace girdle {
namespace {

std::string CheckModel(const ModelFiles& files, const std::string& plugin) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  const ShoulderSimulation simulation(LoadModel(files), files.front().first);
  const mjModel& model = simulation.model();
  return "MuJoCo " + std::string(mj_versionString()) + " loads it: " + std::to_string(model.njnt) +
         " joints, " + std::to_string(model.nactuator) + " actuators, " +
         std::to_string(model.nkey) + " keyframes";
}

Motion RequestedMotion(const MotionRequest& request) {
  if (request.file.empty()) {
    return ReachingMotion("raise", request.from, request.to, request.duration_s);
  }
  std::ifstream in = OpenTextFile(request.file);
  return ReadMotion(in, request.file);
}

double LargestError_deg(const ShoulderState& state) {
  double largest_rad = 0;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    largest_rad = std::max(largest_rad, std::abs(state.target_rad[k] - state.position_rad[k]));
  }
  return DegreesFromRadians(largest_rad);
}

std::string ConfigText(const ShoulderSimulation& simulation, const char* key) {
  const char* text = mj_getPluginConfig(&simulation.model(), simulation.elements().instance, key);
  return text == nullptr ? "" : text;
}

// What the model says of its rhythm; position servos say nothing and stand for the defaults.
RhythmConfig ConfigOf(const ShoulderSimulation& simulation) {
  if (!simulation.has_plugin()) {
    return ParseRhythmConfig({});
  }
  return ParseRhythmConfig({ConfigText(simulation, kInterpolationKey),
                            ConfigText(simulation, kClosureKey), ConfigText(simulation, kRangeKey),
                            ConfigText(simulation, kTableKey),
                            ConfigText(simulation, kStiffnessKey)});
}

// The rhythm that the model says it uses, with what the user says instead.
ShoulderRhythm RhythmOf(const ShoulderSimulation& simulation, const RhythmOverride& override) {
  RhythmConfig config = ConfigOf(simulation);
  if (override.range || override.interpolation || override.closure) {
    config.options.range = override.range;
  }
  config.options.interpolation = override.interpolation.value_or(config.options.interpolation);
  config.options.closure = override.closure.value_or(config.options.closure);
  if (!simulation.has_plugin() && override.table.empty()) {
    config.table = BuiltInRhythmTable(DefaultTable(config.options.interpolation));
  }
  if (const auto built_in = BuiltInTableFromName(override.table)) {
    config.table = BuiltInRhythmTable(*built_in);
  } else if (!override.table.empty()) {
    return ReadShoulderRhythm(override.table, config.options, simulation.ranges());
  }
  try {
    return ShoulderRhythm(config.table, config.options, simulation.ranges());
  } catch (const std::invalid_argument& error) {
    throw InputError(simulation.name() + ": these options do not go together: " + error.what());
  }
}

AssembledRhythm AssembledOf(const ShoulderSimulation& simulation, ShoulderRhythm rhythm) {
  try {
    const JointRanges& ranges = simulation.ranges();
    return {std::move(rhythm), simulation.elements().assembly, {ranges[3], ranges[4], ranges[5]}};
  } catch (const std::invalid_argument& error) {
    throw InputError(simulation.name() + ": " + error.what());
  }
}

// Refuses a model that moves otherwise than the user says.
void ExpectRhythm(const ShoulderSimulation& simulation, const RhythmOverride& override) {
  if (!simulation.has_plugin()) {
    return;  // follows whatever it is given
  }
  const ShoulderRhythm own = RhythmOf(simulation, {});
  const ShoulderRhythm wanted = RhythmOf(simulation, override);
  const auto refuse = [&](const std::string& what) {
    throw InputError(simulation.name() + ": the model uses another " + what +
                     ". Make one that does with girdle generate and the same options");
  };
  if (own.options().interpolation != wanted.options().interpolation) {
    refuse("interpolation than " + std::string(Name(wanted.options().interpolation)));
  }
  if (own.options().closure != wanted.options().closure) {
    refuse("closure than " + std::string(Name(wanted.options().closure)));
  }
  if (override.range && own.options().range != wanted.options().range) {
    refuse("range than " + std::string(Name(*wanted.options().range)));
  }
  if (!override.table.empty() &&
      RhythmTableToLine(own.table()) != RhythmTableToLine(wanted.table())) {
    refuse("table than " + override.table);
  }
}

std::string TableName(const ShoulderSimulation& simulation, const RhythmOverride& override) {
  if (!override.table.empty()) {
    return override.table;
  }
  const std::string text =
      simulation.has_plugin() ? ConfigText(simulation, kTableKey) : std::string();
  if (text.empty()) {
    return std::string(Name(
        DefaultTable(override.interpolation.value_or(ConfigOf(simulation).options.interpolation))));
  }
  return BuiltInTableFromName(text) ? text : "the model's own";
}

SimulationSummary Simulate(const std::string& model_path, const std::string& plugin,
                           const MotionRequest& request, const RhythmOverride& rhythm,
                           const TextSink& trace, const TextSink& controls,
                           const ProgressSink& progress) {
  const Motion motion = RequestedMotion(request);
  const EngineWatch watch;
  LoadPlugin(plugin);
  ShoulderSimulation simulation(LoadModel(model_path), model_path);
  ExpectRhythm(simulation, rhythm);
  if (request.side) {
    simulation.Watch(*request.side);
  }
  const Assembly assembly = simulation.elements().assembly;
  const AssembledRhythm own = AssembledOf(
      simulation, RhythmOf(simulation, simulation.has_plugin() ? RhythmOverride{} : rhythm));
  simulation.Follow(own);
  const auto steps = static_cast<long>(std::lround(motion.duration_s / simulation.timestep_s()));
  const auto command_at = [&](long step) {
    return ReplayableCommand(motion.command(static_cast<double>(step) * simulation.timestep_s()));
  };
  simulation.Start(command_at(0));
  trace(TraceHeader(assembly));
  if (controls) {
    if (simulation.has_plugin() && simulation.elements().rate_controls.front() >= 0) {
      throw InputError(model_path +
                       ": feeds forward how fast its commands change (generate --rates), which "
                       "controls of position servos cannot. Write --controls from a model made "
                       "without --rates");
    }
    controls(ControlsHeader(simulation.TargetNames()));
  }
  SimulationSummary summary;
  std::string row;
  for (long step = 0; step <= steps; ++step) {
    // The last state has no step after it.
    const double time_s = static_cast<double>(step) * simulation.timestep_s();
    const ShoulderState state =
        step < steps
            ? simulation.Step(command_at(step), RateOf(motion, time_s, simulation.timestep_s()))
            : simulation.Observe(command_at(step));
    row.clear();
    AppendTraceRow(row, state);
    trace(row);
    if (controls) {
      row.clear();
      AppendControlsRow(row, state.time_s, simulation.Targets());
      controls(row);
    }
    ++summary.rows;
    // The plugin's sensor does not say how much of an offset was left.
    summary.clamped_rows += state.clamped || own.rhythm().Solve(state.command).clamped ? 1 : 0;
    summary.worst_distance_deg =
        std::max(summary.worst_distance_deg, DegreesFromRadians(state.distance_rad));
    summary.duration_s = state.time_s;
    summary.last_error_deg = LargestError_deg(state);
    summary.worst_error_deg = std::max(summary.worst_error_deg, summary.last_error_deg);
    progress(static_cast<double>(step) / static_cast<double>(std::max(steps, 1L)));
  }
  return summary;
}

// What was verified: sides, assembly, what moves the joints.
std::string KindOf(const ShoulderSimulation& simulation) {
  const ShoulderElements& elements = simulation.elements();
  std::string text;
  for (const ShoulderElements& shoulder : simulation.shoulders()) {
    text += (text.empty() ? "" : " and ") +
            std::string(kSideNames[static_cast<std::size_t>(shoulder.side)]);
  }
  text += ", assembly " + std::string(kAssemblyNames[static_cast<std::size_t>(elements.assembly)]);
  if (elements.assembly == Assembly::kLoop) {
    text += ", the " + std::string(kLeadNames[static_cast<std::size_t>(elements.lead)]) + " leads";
  }
  return text + (simulation.has_plugin() ? ", plugin" : ", position servos");
}

std::string RhythmText(const RhythmOptions& options, const std::string& table) {
  return "interpolation " + std::string(Name(options.interpolation)) + ", closure " +
         std::string(Name(options.closure)) + ", range " + std::string(Name(*options.range)) +
         ", table " + table;
}

VerifyResult Verify(const std::string& model_path, const std::string& plugin,
                    const RhythmOverride& override, const Anatomy& anatomy, GirdleMotion girdle,
                    bool json, const ProgressSink& progress) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  ShoulderSimulation simulation(LoadModel(model_path), model_path);
  const AssembledRhythm rhythm = AssembledOf(simulation, RhythmOf(simulation, override));
  simulation.Follow(rhythm);
  ResidualReport report = MeasureResiduals(simulation, rhythm, anatomy, progress, girdle);
  report.rhythm = RhythmText(rhythm.rhythm().options(), TableName(simulation, override));
  report.kind =
      KindOf(simulation) + (girdle == GirdleMotion::kFrozen ? ", skin of a frozen girdle" : "");
  return {json ? ReportAsJson(report) : ReportAsText(report), report.passed()};
}

// The rhythm of the built-in shoulder with what the user says of it.
ShoulderRhythm ReferenceRhythm(const RhythmOverride& override) {
  RhythmOptions options;
  options.interpolation = override.interpolation.value_or(options.interpolation);
  options.closure = override.closure.value_or(options.closure);
  options.range = override.range;
  const auto built_in = override.table.empty() ? DefaultTable(options.interpolation)
                                               : BuiltInTableFromName(override.table);
  const JointRanges ranges = BuiltInAnatomy().ranges;
  if (!built_in) {
    return ReadShoulderRhythm(override.table, options, ranges);
  }
  try {
    return ShoulderRhythm(BuiltInRhythmTable(*built_in), options, ranges);
  } catch (const std::invalid_argument& error) {
    throw InputError("these options do not go together: " + std::string(error.what()));
  }
}

VerifyResult VerifyMapped(const MappedModel& mapped, const std::string& plugin,
                          const RhythmOverride& override, bool json, const ProgressSink& progress) {
  std::ifstream in = OpenTextFile(mapped.mapping);
  const ModelMapping mapping = ReadModelMapping(in, mapped.mapping);
  const ShoulderRhythm rhythm = ReferenceRhythm(override);
  const EngineWatch watch;
  LoadPlugin(plugin);
  const ModelPointer model = LoadModel(mapped.model);
  const MappedShoulder shoulder(*model, mapping);
  MappedArm arm(*model, mapping);
  ScapulothoracicSurvey survey = SurveyGirdle(arm, shoulder, rhythm, BuiltInAnatomy().gliding,
                                              {mapped.elevations_deg, mapped.planes_deg}, progress);
  survey.report.model = mapped.model;
  survey.report.kind = std::string(kSideNames[static_cast<std::size_t>(mapping.side)]) +
                       ", mapped by " + mapped.mapping + ", moved by its " +
                       (mapping.drives_are_actuators ? "actuators" : "joints");
  survey.report.rhythm = RhythmText(
      rhythm.options(), override.table.empty()
                            ? std::string(Name(DefaultTable(rhythm.options().interpolation)))
                            : override.table);
  return {json ? SurveyAsJson(survey) : SurveyAsText(survey), survey.report.passed()};
}

}  // namespace
}  // namespace girdle

// NOLINTNEXTLINE(readability-identifier-naming): a C symbol
extern "C" __attribute__((visibility("default"))) const girdle::SimulationModule*
girdle_simulation_module() {
  static const girdle::SimulationModule kModule = {girdle::CheckModel, girdle::Simulate,
                                                   girdle::Verify, girdle::VerifyMapped};
  return &kModule;
}
