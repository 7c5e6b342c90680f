// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engine_verbs/module.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "anatomy/anatomy_line.h"
#include "anatomy/built_in_anatomy.h"
#include "kinematics/worst_case.h"
#include "motions/motion.h"
#include "names/longest_timestep.h"
#include "names/open_loop.h"
#include "names/unfit_joints.h"
#include "pictures/frame_renderer.h"
#include "pictures/gl_context.h"
#include "pictures/png_file.h"
#include "pictures/simulation_pictures.h"
#include "pictures/video_pipe.h"
#include "residuals/residual_report.h"
#include "residuals/residuals.h"
#include "residuals/scapulothoracic_survey.h"
#include "rhythm_tables/rhythm_choice.h"
#include "rhythm_tables/rhythm_config.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "simulation/engine.h"
#include "simulation/loaded_shoulders.h"
#include "simulation/mapped_arm.h"
#include "simulation/mapped_shoulder.h"
#include "simulation/model_mapping.h"
#include "simulation/model_skin.h"
#include "simulation/shoulder_simulation.h"
#include "simulation/trace.h"
#include "text/input_error.h"
#include "text/near_names.h"
#include "text/number_text.h"
#include "text/text_file.h"

namespace girdle {
namespace {

std::string CheckModel(const ModelFiles& files, const std::string& plugin) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  const LoadedShoulders shoulders(LoadModel(files), files.front().first);
  const mjModel& model = shoulders.model();
  return "MuJoCo " + std::string(mj_versionString()) +
         " loads it: " + CountText(static_cast<std::uintmax_t>(model.njnt), "joint") + ", " +
         CountText(static_cast<std::uintmax_t>(model.nactuator), "actuator") + ", " +
         CountText(static_cast<std::uintmax_t>(model.nkey), "keyframe");
}

Motion RequestedMotion(const MotionRequest& request, AxialFrom axial_from) {
  if (const auto* const reaching = std::get_if<ReachingRequest>(&request.motion)) {
    return ReachingMotion("raise", reaching->from, reaching->to, reaching->duration_s);
  }
  const auto& file = std::get<MotionFile>(request.motion);
  MotionReading reading = file.reading;
  reading.angles.axial_from = axial_from;
  std::ifstream in = OpenTextFile(file.path);
  return ReadMotion(in, file.path, reading);
}

double LargestError_deg(const ShoulderState& state) {
  double largest_rad = 0;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    largest_rad = WorseOf(largest_rad, std::abs(state.target_rad[k] - state.position_rad[k]));
  }
  return DegreesFromRadians(largest_rad);
}

ShoulderRhythm RhythmOf(const LoadedShoulders& simulation, const ResolvedRhythm& resolved) {
  return MakeRhythm(resolved, simulation.ranges(),
                    simulation.name() + ": these options do not go together: ");
}

AssembledRhythm AssembledOf(const LoadedShoulders& simulation, ShoulderRhythm rhythm) {
  try {
    const JointRanges& ranges = simulation.ranges();
    return {std::move(rhythm), simulation.elements().assembly, {ranges[3], ranges[4], ranges[5]}};
  } catch (const std::invalid_argument& error) {
    throw InputError(simulation.name() + ": " + error.what());
  }
}

// Refuses a model whose rhythm differs from the user's choice.
void ExpectRhythm(const LoadedShoulders& simulation, const RhythmChoice& said) {
  if (!simulation.has_plugin()) {
    return;  // position servos follow any rhythm
  }
  const RhythmChoice model_says = OwnChoice(simulation);
  const ResolvedRhythm own = Resolve(model_says);
  const ResolvedRhythm wanted = Resolve(Over(said, model_says));
  const auto refuse = [&](const std::string& what) {
    throw InputError(simulation.name() + ": the model uses another " + what +
                     ". Make one that does with girdle generate and the same options");
  };
  // Throws if there is no such rhythm.
  static_cast<void>(RhythmOf(simulation, wanted));
  if (own.options.interpolation != wanted.options.interpolation) {
    refuse("interpolation than " + std::string(Name(wanted.options.interpolation)));
  }
  if (own.options.closure != wanted.options.closure) {
    refuse("closure than " + std::string(Name(wanted.options.closure)));
  }
  if (said.range && own.options.range != wanted.options.range) {
    refuse("range than " + std::string(Name(*wanted.options.range)));
  }
  if (said.table && RhythmTableToLine(own.table) != RhythmTableToLine(wanted.table)) {
    refuse("table than " + TableName(*said.table));
  }
}

// Loads the model and returns it with the rhythm that it follows, watched on the chosen side.
ShoulderSimulation SimulationFor(const std::string& model_path, std::optional<Side> side,
                                 const RhythmChoice& said) {
  LoadedShoulders loaded(LoadModel(model_path), model_path);
  ExpectRhythm(loaded, said);
  if (side) {
    loaded.Watch(*side);
  }
  const RhythmChoice choice = loaded.has_plugin() ? OwnChoice(loaded) : said;
  AssembledRhythm own = AssembledOf(loaded, RhythmOf(loaded, Resolve(choice)));
  return {std::move(loaded), std::move(own)};
}

DampingScheme SchemeOf(const mjOption& option) {
  if (option.integrator == mjINT_RK4) {
    return DampingScheme::kRungeKutta;
  }
  const bool is_explicit = (option.disableflags & mjDSBL_EULERDAMP) != 0;
  return option.integrator == mjINT_EULER && is_explicit ? DampingScheme::kExplicitEuler
                                                         : DampingScheme::kImplicit;
}

// Returns the plugin's message about this time step, for models without the plugin.
std::string StepFault(const mjOption& option, Assembly assembly) {
  return TimestepFault(option.timestep, assembly, SchemeOf(option));
}

// Returns the plugin's message about an open loop, for models without the plugin.
std::string OpenLoopFaultOf(const mjModel& model, const ShoulderElements& elements) {
  const int clavicle = elements.bodies[static_cast<std::size_t>(Segment::kClavicle)];
  const int scapula = elements.bodies[static_cast<std::size_t>(Segment::kScapula)];
  LoopClosing closing = {
      .constraints_are_disabled = (model.opt.disableflags & mjDSBL_CONSTRAINT) != 0,
      .equalities_are_disabled = (model.opt.disableflags & mjDSBL_EQUALITY) != 0,
      .has_connect = false,
      .starts_inactive = true};
  for (int i = 0; i < model.neq; ++i) {
    if (model.eq_type[i] != mjEQ_CONNECT || model.eq_objtype[i] != mjOBJ_SITE) {
      continue;
    }
    const int first = model.site_bodyid[model.eq_obj1id[i]];
    const int second = model.site_bodyid[model.eq_obj2id[i]];
    if (std::minmax(first, second) == std::minmax(clavicle, scapula)) {
      closing.has_connect = true;
      closing.starts_inactive = closing.starts_inactive && model.eq_active0[i] == 0;
    }
  }
  return OpenLoopFault(closing);
}

// Returns the plugin's first message about a model, for models without the plugin.
std::string PositionModelFault(const LoadedShoulders& loaded) {
  const mjModel& model = loaded.model();
  double widest_rad = 0;
  for (const CoordinateRange& range : loaded.ranges()) {
    widest_rad = std::max(widest_rad, range.upper_rad - range.lower_rad);
  }
  std::vector<std::string> faults = {RangesFault(widest_rad),
                                     StepFault(model.opt, loaded.elements().assembly)};
  for (const ShoulderElements& elements : loaded.shoulders()) {
    if (elements.assembly == Assembly::kLoop) {
      faults.push_back(OpenLoopFaultOf(model, elements));
    }
  }
  if ((model.opt.disableflags & mjDSBL_DAMPER) != 0) {
    faults.emplace_back(kDisabledDamperFault);
  }
  const auto first = std::find_if(faults.begin(), faults.end(),
                                  [](const std::string& fault) { return !fault.empty(); });
  return first == faults.end() ? "" : *first;
}

// Refuses to write controls if the model's commands contain more than position servos can follow.
void ExpectControls(const ShoulderSimulation& simulation) {
  if (simulation.has_plugin() && simulation.elements().rate_controls.front() >= 0) {
    throw InputError(simulation.name() +
                     ": feeds forward how fast its commands change (generate --rates), which "
                     "controls of position servos cannot. Write --out-controls from a model made "
                     "without --rates");
  }
}

void AddTo(SimulationSummary& summary, const ShoulderState& state, const ShoulderRhythm& rhythm) {
  summary.tally.Add(rhythm, state.command, state.used, rhythm.Solve(state.command).origin,
                    state.distance_rad);
  summary.duration_s = state.time_s;
  summary.last_error_deg = LargestError_deg(state);
  summary.worst_error_deg = WorseOf(summary.worst_error_deg, summary.last_error_deg);
}

void AddGaps(SimulationSummary& summary, const std::vector<double>& gaps_m) {
  for (std::size_t loop = 0; loop < gaps_m.size(); ++loop) {
    double& worst_m = summary.loop_gaps[loop].gap_m;
    worst_m = WorseOf(worst_m, gaps_m[loop]);
  }
}

SimulationSummary Simulate(const std::string& model_path, const std::string& plugin,
                           const MotionRequest& request, const RhythmChoice& rhythm,
                           const SimulationSinks& sinks, const PictureRequest& pictures,
                           const ProgressSink& progress) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  ShoulderSimulation simulation = SimulationFor(model_path, request.side, rhythm);
  const std::string fault = simulation.has_plugin() ? EngineWatch::TakeModelFault()
                                                    : PositionModelFault(simulation.loaded());
  if (!fault.empty()) {
    throw InputError(model_path + ": " + fault);
  }
  const Motion asked =
      RequestedMotion(request, request.axial_from.value_or(OwnAxialFrom(simulation.loaded())));
  // The rates are those of the commands in the model's own counting of axial turns.
  const Motion motion = {asked.name, asked.duration_s, [&simulation, &asked](double time_s) {
                           return simulation.AsModelCounts(asked.command(time_s));
                         }};
  const double timestep_s = simulation.timestep_s();
  const long steps = std::lround(motion.duration_s / timestep_s);
  const auto command_at = [&](long step) {
    return ReplayableCommand(motion.command(static_cast<double>(step) * timestep_s));
  };
  const std::string trace_header = TraceHeader(simulation.elements().assembly);
  const std::string controls_header = ControlsHeader(simulation.TargetNames());
  const auto rows = static_cast<std::uintmax_t>(steps) + 1;
  sinks.sizes(SizeOfRows(trace_header, rows), SizeOfRows(controls_header, rows));
  SimulationPictures drawn(simulation, pictures);
  simulation.Start(command_at(0));
  sinks.trace(trace_header);
  if (sinks.controls) {
    ExpectControls(simulation);
    sinks.controls(controls_header);
  }
  SimulationSummary summary;
  for (const std::string& name : simulation.LoopNames()) {
    summary.loop_gaps.push_back({name});
  }
  summary.range = *simulation.rhythm().rhythm().options().range;
  summary.axial_from = asked.axial_from;
  summary.tally.gaps = asked.gaps;
  summary.tally.bridged = asked.bridged;
  for (const std::string& note : asked.notes) {
    sinks.note(note);
  }
  std::string row;
  for (long step = 0; step <= steps; ++step) {
    // After the last state there is no further step.
    const double time_s = static_cast<double>(step) * timestep_s;
    const ShoulderState state =
        step < steps ? simulation.Step(command_at(step), RateOf(motion, time_s, timestep_s))
                     : simulation.Observe(command_at(step));
    row.clear();
    AppendTraceRow(row, state);
    sinks.trace(row);
    drawn.Add(state.time_s, step == steps);
    if (sinks.controls) {
      row.clear();
      AppendControlsRow(row, state.time_s, simulation.Targets());
      sinks.controls(row);
    }
    AddTo(summary, state, simulation.rhythm().rhythm());
    AddGaps(summary, simulation.LoopGaps_m());
    progress(static_cast<double>(step) / static_cast<double>(std::max(steps, 1L)));
  }
  summary.frames = drawn.Finish();
  return summary;
}

std::vector<std::string_view> KeyframesOf(const mjModel& model) {
  std::vector<std::string_view> names;
  for (int key = 0; key < model.nkey; ++key) {
    const char* const name = mj_id2name(&model, mjOBJ_KEY, key);
    if (name != nullptr && *name != '\0') {
      names.emplace_back(name);
    }
  }
  return names;
}

std::string KeyframeNames(const mjModel& model) {
  std::string names;
  for (const std::string_view name : KeyframesOf(model)) {
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

// Returns a hint at the keyframe that the user meant. It ends in a blank unless it is empty.
std::string MeantKeyframe(const mjModel& model, const std::string& name) {
  const std::vector<std::string_view> names = KeyframesOf(model);
  // Its name before version 0.2.
  constexpr std::string_view kOldName = "rest";
  const auto has = [&names](std::string_view key) { return std::ranges::count(names, key) > 0; };
  if (name == kOldName && has(kHangingName)) {
    return "The keyframe rest is now called hanging. ";
  }
  if (name == kHangingName && has(kOldName)) {
    return "In this older model it is called rest. ";
  }
  return DidYouMean(name, names);
}

// Returns the number of the chosen keyframe; -1 for the model's initial pose.
int KeyframeOf(const mjModel& model, const std::string& model_name, const std::string& name) {
  const std::string wanted = name.empty() ? std::string(kHangingName) : name;
  const int key = mj_name2id(&model, mjOBJ_KEY, wanted.c_str());
  if (key < 0 && !name.empty()) {
    const std::string names = KeyframeNames(model);
    throw InputError(model_name + ": has no keyframe \"" + name + "\". " +
                     (names.empty() ? "It has none that has a name: omit --keyframe"
                                    : MeantKeyframe(model, name) + "Choose one of: " + names));
  }
  return key;
}

// Puts the arms into the pose of the request.
void Pose(ShoulderSimulation& simulation, const RenderRequest& request,
          std::optional<ArmCommand>& used_instead) {
  const AssembledRhythm& rhythm = simulation.rhythm();
  const ShoulderPose rest = rhythm.SolvePose({});
  const auto* const command = std::get_if<ArmCommand>(&request.pose);
  for (const ShoulderElements& shoulder : simulation.shoulders()) {
    const bool is_meant = !request.side || *request.side == shoulder.side;
    if (command != nullptr) {
      ArmCommand used;
      const ShoulderPose raised = rhythm.SolvePose(*command, &used);
      if (rhythm.rhythm().IsClamped(*command, used)) {
        used_instead = used;
      }
      simulation.PutAt(shoulder, is_meant ? raised : rest);
    }
    if (is_meant && request.girdle == GirdleMotion::kFrozen) {
      const ShoulderPose at = BindPose(simulation.model(), shoulder.side).value_or(rest);
      simulation.PutAt(shoulder, FrozenGirdle(simulation.PoseOf(shoulder), at));
    }
  }
}

RenderResult Render(const std::string& model_path, const std::string& plugin,
                    const RenderRequest& request, const RhythmChoice& said) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  ModelPointer model = LoadModel(model_path);
  const auto* const at = std::get_if<AtKeyframe>(&request.pose);
  const int key = at == nullptr ? -1 : KeyframeOf(*model, model_path, at->name);
  RenderResult result;
  if (at != nullptr && request.girdle == GirdleMotion::kMeasured && !request.side) {
    // At a keyframe, without a side and a frozen girdle, any model can be drawn as it is.
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
  AssembledRhythm rhythm =
      AssembledOf(loaded, RhythmOf(loaded, Resolve(Over(said, OwnChoice(loaded)))));
  ShoulderSimulation simulation(std::move(loaded), std::move(rhythm));
  FrameRenderer renderer(simulation.model(), model_path, request.view);
  if (key >= 0) {
    simulation.PutAtKeyframe(key);
  }
  Pose(simulation, request, result.used_instead);
  result.png = PngBytes(renderer.Draw(simulation.data()));
  return result;
}

std::string DescribeRenderer() { return GlContext().Description(); }

std::string FfmpegPath() { return FindFfmpeg().string(); }

// Returns the kind of the model: sides, assembly, actuation.
std::string KindOf(const ShoulderSimulation& simulation) {
  const ShoulderElements& elements = simulation.elements();
  std::string text;
  for (const ShoulderElements& shoulder : simulation.shoulders()) {
    text += (text.empty() ? "" : " and ") + std::string(Name(shoulder.side));
  }
  text += ", assembly " + std::string(Name(elements.assembly));
  if (elements.assembly == Assembly::kLoop) {
    text += ", the " + std::string(Name(elements.lead)) + " leads";
  }
  const AxialFrom axial_from = OwnAxialFrom(simulation.loaded());
  return text + (simulation.has_plugin() ? ", plugin" : ", position servos") +
         (axial_from == AxialFrom::kRhythm ? "" : ", axial from " + std::string(Name(axial_from)));
}

// Returns the anatomy that a model carries; nothing if it carries none.
std::optional<Anatomy> OwnAnatomy(const LoadedShoulders& loaded) {
  const mjModel& model = loaded.model();
  const int text = mj_name2id(&model, mjOBJ_TEXT, std::string(kAnatomyName).c_str());
  if (text < 0) {
    return std::nullopt;
  }
  const char* const line = model.text_data + model.text_adr[text];
  return AnatomyFromLine(
      std::string(line, strnlen(line, static_cast<std::size_t>(model.text_size[text]))),
      loaded.name() + ": <text name=\"" + std::string(kAnatomyName) + "\">");
}

// Returns a remark on the anatomy that the bones are compared with.
std::string AnatomyRemark(const std::optional<Anatomy>& said, const std::optional<Anatomy>& own) {
  if (said && own && !IsSame(*said, *own)) {
    return "The model was generated with another anatomy than --anatomy, --ellipsoids or the "
           "measures give; without them it is compared with its own.";
  }
  if (!said && !own) {
    return "The model does not carry its anatomy: its bones are compared with the built-in adult. "
           "For another one give the --anatomy and so on that it was generated with.";
  }
  return "";
}

// Returns a remark if the model fails by no more than the rounding of its numbers explains.
std::string RoundingRemark(const ResidualReport& report) {
  // MuJoCo writes six digits: 5e-7 of a quaternion, of meters and of kilograms, and chains of them.
  constexpr std::array<std::pair<std::string_view, double>, 4> kRounding = {
      {{"deg", 1e-3}, {"mm", 1e-2}, {"kg", 1e-4}, {"kg m^2", 1e-5}}};
  const auto is_small = [&](const Residual& residual) {
    const auto* const rounding =
        std::ranges::find(kRounding, residual.unit, [](const auto& row) { return row.first; });
    return residual.passed() || (residual.bound == Bound::kAtMost && rounding != kRounding.end() &&
                                 residual.value < rounding->second);
  };
  return report.passed() || !std::ranges::all_of(report.residuals, is_small)
             ? ""
             : "Every failure is so small that it may come from rounding: MuJoCo saves a model "
               "with six digits. Verify the file that girdle generate wrote, or one that includes "
               "it.";
}

Residual TimestepResidual(const mjOption& option, Assembly assembly) {
  constexpr double kMilliseconds = 1000;
  return {"time step",
          "of the model",
          kMilliseconds * option.timestep,
          "ms",
          kMilliseconds * LongestTimestep_s(assembly, SchemeOf(option)),
          ""};
}

VerifyResult Verify(const std::string& model_path, const std::string& plugin,
                    const RhythmChoice& said, const std::optional<Anatomy>& said_anatomy,
                    GirdleMotion girdle, const ReportChoice& form, const ProgressSink& progress) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  LoadedShoulders loaded(LoadModel(model_path), model_path);
  const ResolvedRhythm resolved = Resolve(Over(said, OwnChoice(loaded)));
  const std::optional<Anatomy> own_anatomy = OwnAnatomy(loaded);
  const Anatomy adult = BuiltInAnatomy();
  const Anatomy anatomy = said_anatomy ? *said_anatomy : own_anatomy.value_or(adult);
  AssembledRhythm meant = AssembledOf(loaded, RhythmOf(loaded, resolved));
  ShoulderSimulation simulation(std::move(loaded), std::move(meant));
  ResidualReport report =
      MeasureResiduals(simulation, simulation.rhythm(), anatomy, progress, girdle);
  report.rhythm = resolved.text();
  report.kind =
      KindOf(simulation) + (girdle == GirdleMotion::kFrozen ? ", skin of a frozen girdle" : "");
  report.remark = AnatomyRemark(said_anatomy, own_anatomy);
  if (!IsSame(anatomy, adult)) {
    const bool are_own = own_anatomy && IsSame(anatomy, *own_anatomy);
    report.kind += are_own ? ", bones of its own" : ", bones as given";
  }
  report.residuals.insert(report.residuals.begin(),
                          TimestepResidual(simulation.model().opt, simulation.elements().assembly));
  if (report.remark.empty()) {
    report.remark = RoundingRemark(report);
  }
  return {ReportIn(form, report), report.passed()};
}

VerifyResult VerifyMapped(const MappedModel& mapped, const std::string& plugin,
                          const RhythmChoice& said, const ReportChoice& form,
                          const ProgressSink& progress) {
  std::ifstream in = OpenTextFile(mapped.mapping);
  const ModelMapping mapping = ReadModelMapping(in, mapped.mapping);
  const ResolvedRhythm resolved = Resolve(said);
  const ShoulderRhythm rhythm = MakeRhythm(resolved, BuiltInAnatomy().ranges);
  const EngineWatch watch;
  LoadPlugin(plugin);
  const ModelPointer model = LoadModel(mapped.model);
  const MappedShoulder shoulder(*model, mapping);
  MappedArm arm(*model, mapping);
  ScapulothoracicSurvey survey = SurveyGirdle(arm, shoulder, rhythm, BuiltInAnatomy().gliding,
                                              {mapped.elevations_deg, mapped.planes_deg}, progress);
  survey.report.model = mapped.model;
  survey.report.kind = std::string(Name(mapping.side)) + ", mapped by " + mapped.mapping +
                       ", moved by its " + (mapping.drives_are_actuators ? "actuators" : "joints");
  survey.report.rhythm = resolved.text();
  return {SurveyIn(form, survey), survey.report.passed()};
}

std::string NameOf(const std::string& model) { return model; }
std::string NameOf(const ModelFiles& files) { return files.front().first; }
std::string NameOf(const MappedModel& mapped) { return mapped.model; }

// A verb whose first argument is a model. Run says in which model MuJoCo met an error.
template <auto Verb>
struct OnModel;
template <typename Result, typename Model, typename... Arguments,
          Result (*Verb)(const Model&, Arguments...)>
struct OnModel<Verb> {
  static Result Run(const Model& model, Arguments... arguments) {
    try {
      return Verb(model, std::forward<Arguments>(arguments)...);
    } catch (const EngineError& error) {
      throw InputError(NameOf(model) + ": MuJoCo cannot go on with it: " + error.what() +
                       ". Correct the model or make it anew with girdle generate");
    }
  }
};

}  // namespace
}  // namespace girdle

// NOLINTNEXTLINE(readability-identifier-naming): a C symbol
extern "C" __attribute__((visibility("default"))) const girdle::SimulationModule*
girdle_simulation_module() {
  static const girdle::SimulationModule kModule = {girdle::OnModel<girdle::CheckModel>::Run,
                                                   girdle::OnModel<girdle::Simulate>::Run,
                                                   girdle::OnModel<girdle::Render>::Run,
                                                   girdle::DescribeRenderer,
                                                   girdle::FfmpegPath,
                                                   girdle::OnModel<girdle::Verify>::Run,
                                                   girdle::OnModel<girdle::VerifyMapped>::Run};
  return &kModule;
}
