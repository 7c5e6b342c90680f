// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The interface between the program and the library that runs MuJoCo. The program loads the
/// library when a verb needs it, so that the other verbs work without MuJoCo.
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
  /// The zero that axial turns of a file count from; nothing for the model's own.
  std::optional<AxialFrom> axial_from = std::nullopt;
  /// Shoulder of the trace; nothing for the model's first shoulder.
  std::optional<Side> side = std::nullopt;
};

/// Largest opening of the joint of a loop during a simulation.
struct LoopGap {
  std::string name;  ///< name of the equality constraint that closes the joint
  double gap_m = 0;
};

struct SimulationSummary {
  /// Counts of the simulated states, which are the rows of the trace. A state is clamped if its
  /// command lay outside the range of the rhythm or of the controls. Gaps and bridged rows are
  /// those of the motion's file.
  CommandTally tally;
  Range range = Range::kWhole;  ///< range of the rhythm
  /// The zero that axial turns of the file of the motion count from; nothing if it has none.
  std::optional<AxialFrom> axial_from = std::nullopt;
  double duration_s = 0;       ///< simulated time
  double worst_error_deg = 0;  ///< largest difference of a joint from its target
  double last_error_deg = 0;   ///< largest difference of a joint from its target in the last row
  long frames = 0;             ///< frames of the video
  /// The largest gap of each loop of the model. Empty for trees.
  std::vector<LoopGap> loop_gaps;
};

/// Receivers of the output of a simulation.
struct SimulationSinks {
  /// Called before anything is written, with the approximate bytes of trace and controls. May
  /// throw.
  std::function<void(std::uintmax_t trace, std::uintmax_t controls)> sizes;
  TextSink trace;
  TextSink controls;  ///< null for none
  TextSink note;  ///< lines about the motion, without line ends; they come before the simulation
};

/// A pose given by the name of a keyframe of the model.
struct AtKeyframe {
  /// Empty for `hanging` or, if the model has no such keyframe, for the model's initial pose.
  std::string name;
};

/// A picture of a model in a pose, without a simulation.
struct RenderRequest {
  /// A keyframe of the model, or a command whose pose the rhythm gives.
  std::variant<AtKeyframe, ArmCommand> pose;
  /// The shoulder that `pose` and `girdle` apply to, while the other one rests; nothing for all.
  std::optional<Side> side;
  GirdleMotion girdle = GirdleMotion::kMeasured;
  View view;
};

struct RenderResult {
  std::string png;  ///< bytes of a PNG file
  /// The command used instead, if the command lay outside the rhythm's range.
  std::optional<ArmCommand> used_instead;
};

/// A model that Girdle did not generate, and the directions its arm is moved to [deg].
struct MappedModel {
  std::string model;
  std::string mapping;  ///< file in the format of simulation/model_mapping.h
  std::vector<double> elevations_deg;
  std::vector<double> planes_deg;
};

struct VerifyResult {
  std::string report;
  bool passed = false;
};

/// The functions of the library. All throw InputError.
///
/// `rhythm` has the parts of the rhythm that the user chose. They take precedence over the model's.
/// A model with position servos does not store its rhythm: the chosen parts apply, and defaults for
/// the rest. A model with the plugin stores its rhythm: `verify` compares the model with the chosen
/// rhythm instead, and `simulate` refuses a choice that differs from the model's.
struct SimulationModule {
  /// Loads a model from texts that are not written to disk yet, with the plugin. The model is the
  /// first of `files` (name, text); the others are files that it includes. Returns a line on what
  /// MuJoCo found in it.
  std::string (*check_model)(const std::vector<std::pair<std::string, std::string>>& files,
                             const std::string& plugin);
  SimulationSummary (*simulate)(const std::string& model, const std::string& plugin,
                                const MotionRequest& request, const RhythmChoice& rhythm,
                                const SimulationSinks& sinks, const PictureRequest& pictures,
                                const ProgressSink& progress);
  RenderResult (*render)(const std::string& model, const std::string& plugin,
                         const RenderRequest& request, const RhythmChoice& rhythm);
  /// Returns the means by which pictures are drawn here: `EGL device, llvmpipe (LLVM 15.0.6, 256
  /// bits)`.
  std::string (*describe_renderer)();
  /// Returns the path of the ffmpeg that makes videos; empty if there is none.
  std::string (*find_ffmpeg)();
  /// Compares the model's bones with `anatomy`. If `anatomy` is empty, compares with the anatomy
  /// that the model carries, or with the built-in one if the model carries none. The skin is
  /// measured on a girdle that moves as `girdle` says.
  VerifyResult (*verify)(const std::string& model, const std::string& plugin,
                         const RhythmChoice& rhythm, const std::optional<Anatomy>& anatomy,
                         GirdleMotion girdle, const ReportChoice& form,
                         const ProgressSink& progress);
  /// Compares the girdle of any model with the measured rhythm, by default that of `girdle solve`.
  VerifyResult (*verify_mapped)(const MappedModel& mapped, const std::string& plugin,
                                const RhythmChoice& rhythm, const ReportChoice& form,
                                const ProgressSink& progress);
};

/// Name of the function that returns the SimulationModule, of type SimulationModuleFunction.
inline constexpr const char* kSimulationModuleSymbol = "girdle_simulation_module";
using SimulationModuleFunction = const SimulationModule* (*)();

}  // namespace girdle
