// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/picture_diagnosis.h"

#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "child_programs/child_process.h"
#include "commands/simulation_module.h"
#include "pictures/gl_context.h"

namespace girdle {
namespace {

// The first context of a process is slow, because OpenGL compiles its programs.
constexpr int kLimit_s = 30;

// Keys of the child's JSON output. A string is empty if the machine has no such part.
constexpr const char* kRenderer = "renderer";
constexpr const char* kProblem = "problem";
constexpr const char* kFfmpeg = "ffmpeg";

std::string Look() {
  nlohmann::ordered_json seen = {{kRenderer, ""}, {kProblem, ""}, {kFfmpeg, ""}};
  try {
    const SimulationModule& module = LoadSimulation();
    seen[kFfmpeg] = module.find_ffmpeg();
    seen[kRenderer] = module.describe_renderer();
  } catch (const std::exception& error) {
    seen[kProblem] = error.what();
  }
  return seen.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void DiagnosePictures(Diagnosis& diagnosis) {
  if (!HasSimulation()) {
    diagnosis.pictures.problem = "this program was built without MuJoCo, which draws them";
    diagnosis.videos.problem = diagnosis.pictures.problem;
    return;
  }
  const ChildResult child =
      RunInChild([](const std::function<void(std::string_view)>& write) { write(Look()); },
                 {.time_s = kLimit_s});
  const nlohmann::json seen = nlohmann::json::parse(child.output, nullptr, false);
  if (!child.failure.empty() || !seen.is_object()) {
    diagnosis.pictures.problem = "the process that tried " + child.failure;
    diagnosis.pictures.fix = std::string(kGlVariable) + "=osmesa girdle doctor";
    diagnosis.videos.problem = diagnosis.pictures.problem;
    return;
  }
  diagnosis.pictures.found = seen.value(kRenderer, "");
  diagnosis.pictures.problem = seen.value(kProblem, "");
  if (!diagnosis.pictures.problem.empty()) {
    const char* const chosen = std::getenv(kGlVariable);
    diagnosis.pictures.fix = chosen != nullptr && *chosen != '\0'
                                 ? "unset " + std::string(kGlVariable)
                                 : "apt-get install libegl1 libgl1-mesa-dri";
  }
  diagnosis.videos.found = seen.value(kFfmpeg, "");
  if (diagnosis.videos.found.empty()) {
    diagnosis.videos.problem = "no ffmpeg in PATH";
    diagnosis.videos.fix = "apt-get install ffmpeg";
  }
}

}  // namespace girdle
