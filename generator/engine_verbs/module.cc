// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engine_verbs/module.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <variant>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/worst_case.h"
#include "pictures/frame_renderer.h"
#include "pictures/gl_context.h"
#include "pictures/png_file.h"
#include "pictures/simulation_pictures.h"
#include "pictures/video_pipe.h"
#include "residuals/residual_report.h"
#include "residuals/residuals.h"
#include "residuals/scapulothoracic_survey.h"
#include "rhythm_tables/built_in_tables.h"
#include "rhythm_tables/rhythm_config.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "simulation/engine.h"
#include "simulation/loaded_shoulders.h"
#include "simulation/mapped_arm.h"
#include "simulation/mapped_shoulder.h"
#include "simulation/model_mapping.h"
#include "simulation/model_skin.h"
#include "simulation/motion.h"
#include "simulation/shoulder_simulation.h"
#include "simulation/trace.h"
#include "text/input_error.h"
#include "text/text_file.h"

namespace girdle {
namespace {

std::string CheckModel(const ModelFiles& files, const std::string& plugin) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  const LoadedShoulders shoulders(LoadModel(files), files.front().first);
  const mjModel& model = shoulders.model();
  return "MuJoCo " + std::string(mj_versionString()) + " loads it: " + std::to_string(model.njnt) +
         " joints, " + std::to_string(model.nactuator) + " actuators, " +
         std::to_string(model.nkey) + " keyframes";
}

Motion RequestedMotion(const MotionRequest& request) {
  if (const auto* const reaching = std::get_if<ReachingRequest>(&request.motion)) {
    return ReachingMotion("raise", reaching->from, reaching->to, reaching->duration_s);
  }
  const std::string& path = std::get<MotionFile>(request.motion).path;
  std::ifstream in = OpenTextFile(path);
  return ReadMotion(in, path);
}

double LargestError_deg(const ShoulderState& state) {
  double largest_rad = 0;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    largest_rad = WorseOf(largest_rad, std::abs(state.target_rad[k] - state.position_rad[k]));
  }
  return DegreesFromRadians(largest_rad);
}

std::string ConfigText(const LoadedShoulders& simulation, const char* key) {
  const char* text = mj_getPluginConfig(&simulation.model(), simulation.elements().instance, key);
  return text == nullptr ? "" : text;
}

// What the model says of its rhythm; position servos say nothing and stand for the defaults.
RhythmConfig ConfigOf(const LoadedShoulders& simulation) {
  if (!simulation.has_plugin()) {
    return ParseRhythmConfig({});
  }
  return ParseRhythmConfig({ConfigText(simulation, kInterpolationKey),
                            ConfigText(simulation, kClosureKey), ConfigText(simulation, kRangeKey),
                            ConfigText(simulation, kTableKey),
                            ConfigText(simulation, kStiffnessKey)});
}

// The rhythm that the model says it uses, with what the user says instead.
ShoulderRhythm RhythmOf(const LoadedShoulders& simulation, const RhythmOverride& override) {
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

AssembledRhythm AssembledOf(const LoadedShoulders& simulation, ShoulderRhythm rhythm) {
  try {
    const JointRanges& ranges = simulation.ranges();
    return {std::move(rhythm), simulation.elements().assembly, {ranges[3], ranges[4], ranges[5]}};
  } catch (const std::invalid_argument& error) {
    throw InputError(simulation.name() + ": " + error.what());
  }
}

// Refuses a model that moves otherwise than the user says.
void ExpectRhythm(const LoadedShoulders& simulation, const RhythmOverride& override) {
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

std::string TableName(const LoadedShoulders& simulation, const RhythmOverride& override) {
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
                           const PictureRequest& pictures, const ProgressSink& progress) {
  const Motion motion = RequestedMotion(request);
  const EngineWatch watch;
  LoadPlugin(plugin);
  LoadedShoulders loaded(LoadModel(model_path), model_path);
  ExpectRhythm(loaded, rhythm);
  if (request.side) {
    loaded.Watch(*request.side);
  }
  AssembledRhythm own =
      AssembledOf(loaded, RhythmOf(loaded, loaded.has_plugin() ? RhythmOverride{} : rhythm));
  ShoulderSimulation simulation(std::move(loaded), std::move(own));
  const auto steps = static_cast<long>(std::lround(motion.duration_s / simulation.timestep_s()));
  const auto command_at = [&](long step) {
    return ReplayableCommand(motion.command(static_cast<double>(step) * simulation.timestep_s()));
  };
  SimulationPictures drawn(simulation, pictures);
  simulation.Start(command_at(0));
  trace(TraceHeader(simulation.elements().assembly));
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
    drawn.Add(state.time_s, step == steps);
    if (controls) {
      row.clear();
      AppendControlsRow(row, state.time_s, simulation.Targets());
      controls(row);
    }
    ++summary.rows;
    // The plugin's sensor does not say how much of an offset was left.
    summary.clamped_rows +=
        state.clamped || simulation.rhythm().rhythm().Solve(state.command).clamped ? 1 : 0;
    summary.worst_distance_deg =
        WorseOf(summary.worst_distance_deg, DegreesFromRadians(state.distance_rad));
    summary.duration_s = state.time_s;
    summary.last_error_deg = LargestError_deg(state);
    summary.worst_error_deg = WorseOf(summary.worst_error_deg, summary.last_error_deg);
    progress(static_cast<double>(step) / static_cast<double>(std::max(steps, 1L)));
  }
  summary.frames = drawn.Finish();
  return summary;
}

std::string KeyframeNames(const mjModel& model) {
  std::string names;
  for (int key = 0; key < model.nkey; ++key) {
    const char* const name = mj_id2name(&model, mjOBJ_KEY, key);
    if (name != nullptr && *name != '\0') {
      names += (names.empty() ? "" : ", ") + std::string(name);
    }
  }
  return names;
}

// Number of the keyframe asked for; -1 for where the model starts.
int KeyframeOf(const mjModel& model, const std::string& model_name, const std::string& name) {
  const std::string wanted = name.empty() ? std::string(kRestName) : name;
  const int key = mj_name2id(&model, mjOBJ_KEY, wanted.c_str());
  if (key < 0 && !name.empty()) {
    const std::string names = KeyframeNames(model);
    throw InputError(model_name + ": has no keyframe \"" + name + "\". " +
                     (names.empty() ? "It has none that has a name: leave --keyframe away"
                                    : "Choose one of: " + names));
  }
  return key;
}

// Puts the arms where the request has them.
void Pose(ShoulderSimulation& simulation, const RenderRequest& request, bool& clamped) {
  const AssembledRhythm& rhythm = simulation.rhythm();
  const ShoulderPose rest = rhythm.SolvePose({});
  const auto* const command = std::get_if<ArmCommand>(&request.pose);
  for (const ShoulderElements& shoulder : simulation.shoulders()) {
    const bool is_meant = !request.side || *request.side == shoulder.side;
    if (command != nullptr) {
      ArmCommand used;
      const ShoulderPose raised = rhythm.SolvePose(*command, &used);
      clamped = clamped || used != *command;
      simulation.PutAt(shoulder, is_meant ? raised : rest);
    }
    if (is_meant && request.girdle == GirdleMotion::kFrozen) {
      const ShoulderPose at = BindPose(simulation.model(), shoulder.side).value_or(rest);
      simulation.PutAt(shoulder, FrozenGirdle(simulation.PoseOf(shoulder), at));
    }
  }
}

RenderResult Render(const std::string& model_path, const std::string& plugin,
                    const RenderRequest& request, const RhythmOverride& override) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  ModelPointer model = LoadModel(model_path);
  const auto* const at = std::get_if<AtKeyframe>(&request.pose);
  const int key = at == nullptr ? -1 : KeyframeOf(*model, model_path, at->name);
  RenderResult result;
  if (at != nullptr && request.girdle == GirdleMotion::kMeasured && !request.side) {
    // Any model can be drawn as it is.
    FrameRenderer renderer(*model, model_path, request.view);
    const DataPointer data = MakeData(*model);
    if (key >= 0) {
      mj_resetDataKeyframe(model.get(), data.get(), key);
    }
    mj_fwdPosition(model.get(), data.get());
    result.png = PngBytes(renderer.Draw(*data));
    return result;
  }
  LoadedShoulders loaded(std::move(model), model_path);
  if (request.side) {
    loaded.Watch(*request.side);
  }
  AssembledRhythm rhythm = AssembledOf(loaded, RhythmOf(loaded, override));
  ShoulderSimulation simulation(std::move(loaded), std::move(rhythm));
  FrameRenderer renderer(simulation.model(), model_path, request.view);
  if (key >= 0) {
    simulation.PutAtKeyframe(key);
  }
  Pose(simulation, request, result.clamped);
  result.png = PngBytes(renderer.Draw(simulation.data()));
  return result;
}

std::string DescribeRenderer() { return GlContext().Description(); }

std::string FfmpegPath() { return FindFfmpeg().string(); }

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
  LoadedShoulders loaded(LoadModel(model_path), model_path);
  AssembledRhythm meant = AssembledOf(loaded, RhythmOf(loaded, override));
  ShoulderSimulation simulation(std::move(loaded), std::move(meant));
  const AssembledRhythm& rhythm = simulation.rhythm();
  ResidualReport report = MeasureResiduals(simulation, rhythm, anatomy, progress, girdle);
  report.rhythm = RhythmText(rhythm.rhythm().options(), TableName(simulation.loaded(), override));
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
  static const girdle::SimulationModule kModule = {
      girdle::CheckModel, girdle::Simulate, girdle::Render,      girdle::DescribeRenderer,
      girdle::FfmpegPath, girdle::Verify,   girdle::VerifyMapped};
  return &kModule;
}
