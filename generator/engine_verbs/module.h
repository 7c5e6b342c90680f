// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What the program asks of the library that runs MuJoCo. The program loads it when a verb needs
/// it, so that the other verbs work where there is no MuJoCo.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "anatomy/anatomy.h"
#include "motions/command_tally.h"
#include "motions/motion.h"
#include "names/model_names.h"
#include "pictures/picture_request.h"
#include "pictures/view.h"
#include "residuals/residual_report.h"
#include "rhythm_tables/rhythm_choice.h"
#include "simulation/girdle_motion.h"
#include "text/sinks.h"

namespace girdle {

/// A motion from one command to another, at rest at both ends.
struct ReachingRequest {
  ArmCommand from;
  ArmCommand to;
  double duration_s = 0;
};

/// A motion in a CSV file.
struct MotionFile {
  std::string path;
  MotionReading reading;
};

struct MotionRequest {
  std::variant<ReachingRequest, MotionFile> motion;
  /// What axial turns of a file are counted from; nothing for what the model counts from.
  std::optional<AxialFrom> axial_from = std::nullopt;
  /// Shoulder of the trace; nothing for the model's first.
  std::optional<Side> side = std::nullopt;
};

/// How far the joint of a loop opened.
struct LoopGap {
  std::string name;  ///< of the equality that closes it
  double gap_m = 0;
};

struct SimulationSummary {
  /// The simulated states, which are the rows of the trace. Clamped are those whose command lay
  /// outside the rhythm's or the controls' ranges.
  CommandTally tally;
  Range range = Range::kWhole;  ///< of the rhythm
  /// What axial turns of the file of the motion count from; nothing if there are none.
  std::optional<AxialFrom> axial_from = std::nullopt;
  double duration_s = 0;       ///< simulated
  double worst_error_deg = 0;  ///< largest difference of a joint from its target
  double last_error_deg = 0;   ///< the same in the last row
  long frames = 0;             ///< of the video
  /// The farthest, of each loop of the model; none of trees.
  std::vector<LoopGap> loop_gaps;
};

/// Where a simulation goes.
struct SimulationSinks {
  /// Told before anything is written about how many bytes trace and controls become; may throw.
  std::function<void(std::uintmax_t trace, std::uintmax_t controls)> sizes;
  TextSink trace;
  TextSink controls;  ///< null for none
  TextSink hint;      ///< a line without its end about the motion, before it is simulated
};

/// A pose that the model has a name for.
struct AtKeyframe {
  /// Empty for `hanging` or, if the model has none, for where it starts.
  std::string name;
};

/// A picture of a model that is put into a pose, without simulating.
struct RenderRequest {
  /// Where the model is put, or where the rhythm takes the shoulders.
  std::variant<AtKeyframe, ArmCommand> pose;
  /// The shoulder that the command and `girdle` are for, while another one rests; nothing for all.
  std::optional<Side> side;
  GirdleMotion girdle = GirdleMotion::kMeasured;
  View view;
};

struct RenderResult {
  std::string png;  ///< a PNG file
  /// Where the command lay outside the rhythm's range: the one used in its place.
  std::optional<ArmCommand> used_instead;
};

/// A model that is not ours, and where its arm is moved to [deg].
struct MappedModel {
  std::string model;
  std::string mapping;  ///< file in the format of tables/model_mapping.h
  std::vector<double> elevations_deg;
  std::vector<double> planes_deg;
};

struct VerifyResult {
  std::string report;
  bool passed = false;
};

/// The functions of the library. All throw InputError.
///
/// `rhythm` is what the user says of it, over what the model says. Position servos know none: they
/// follow what is said here, or the defaults. Of a model with the plugin: `verify` holds a model
/// against it instead of against what the model says; `simulate` refuses a model that says
/// otherwise.
struct SimulationModule {
  /// Loads a model that is not written yet, the first of (name, text) with what it includes, with
  /// the plugin, and returns a line that says what MuJoCo found in it.
  std::string (*check_model)(const std::vector<std::pair<std::string, std::string>>& files,
                             const std::string& plugin);
  SimulationSummary (*simulate)(const std::string& model, const std::string& plugin,
                                const MotionRequest& request, const RhythmChoice& rhythm,
                                const SimulationSinks& sinks, const PictureRequest& pictures,
                                const ProgressSink& progress);
  RenderResult (*render)(const std::string& model, const std::string& plugin,
                         const RenderRequest& request, const RhythmChoice& rhythm);
  /// Says what draws pictures here: `EGL device, llvmpipe (LLVM 15.0.6, 256 bits)`.
  std::string (*describe_renderer)();
  /// Returns where the ffmpeg is that makes videos; empty if there is none.
  std::string (*find_ffmpeg)();
  /// Compares the model's bones with `anatomy` or, if that is empty, with the anatomy that the
  /// model carries; a model that carries none is compared with the built-in one. Its skin is
  /// measured on a girdle that moves as `girdle` says.
  VerifyResult (*verify)(const std::string& model, const std::string& plugin,
                         const RhythmChoice& rhythm, const std::optional<Anatomy>& anatomy,
                         GirdleMotion girdle, const ReportChoice& form,
                         const ProgressSink& progress);
  /// Holds the girdle of any model against the measured rhythm, by default that of `girdle solve`.
  VerifyResult (*verify_mapped)(const MappedModel& mapped, const std::string& plugin,
                                const RhythmChoice& rhythm, const ReportChoice& form,
                                const ProgressSink& progress);
};

/// Name of the function that returns the SimulationModule, of type SimulationModuleFunction.
inline constexpr const char* kSimulationModuleSymbol = "girdle_simulation_module";
using SimulationModuleFunction = const SimulationModule* (*)();

}  // namespace girdle
