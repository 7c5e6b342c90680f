// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/engine.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <utility>
#include <vector>

#include "kinematics/model_names.h"
#include "tables/input_error.h"

namespace girdle {
namespace {

// MuJoCo calls its handlers from any thread and gives them no context.
std::mutex warnings_mutex;          // NOLINT(readability-identifier-naming)
std::vector<std::string> warnings;  // NOLINT(readability-identifier-naming)

void OnWarning(const char* message) {
  const std::lock_guard lock(warnings_mutex);
  warnings.emplace_back(message);
}

[[noreturn]] void OnError(const char* message) {
  throw InputError(std::string("MuJoCo: ") + message);
}

std::string TakeWarnings() {
  const std::lock_guard lock(warnings_mutex);
  std::string text;
  for (const std::string& warning : std::exchange(warnings, {})) {
    text += (text.empty() ? "" : "; ") + warning;
  }
  return text;
}

// The lines of a text on one line, each once: MuJoCo's reason repeats what a plugin says at each of
// its tries.
std::string DistinctLines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && std::find(lines.begin(), lines.end(), line) == lines.end()) {
      lines.push_back(line);
    }
  }
  std::string joined;
  for (const std::string& line : lines) {
    joined += (joined.empty() ? "" : "; ") + line;
  }
  return joined;
}

}  // namespace

EngineWatch::EngineWatch()
    : previous_error_(std::exchange(mju_user_error, OnError)),
      previous_warning_(std::exchange(mju_user_warning, OnWarning)) {
  TakeWarnings();
}

EngineWatch::~EngineWatch() {
  mju_user_error = previous_error_;
  mju_user_warning = previous_warning_;
}

void EngineWatch::ExpectNoWarning(const std::string& doing) {
  const std::string text = TakeWarnings();
  if (!text.empty()) {
    throw InputError(doing + ": MuJoCo warns: " + text);
  }
}

void LoadPlugin(const std::string& path) {
  if (!std::filesystem::exists(path)) {
    throw InputError(path + ": no such plugin. Build it, or name it with --plugin FILE");
  }
  mj_loadPluginLibrary(path.c_str());
  EngineWatch::ExpectNoWarning(path);
  if (mjp_getPlugin(kPluginName, nullptr) == nullptr) {
    throw InputError(path + ": holds no plugin " + kPluginName +
                     ". Name libgirdle_rhythm.so with --plugin FILE");
  }
}

ModelPointer LoadModel(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw InputError(path +
                     ": no such file. Make a model with girdle generate --out FOLDER and name its "
                     "scene.xml");
  }
  constexpr std::size_t kErrorSize = 1024;
  std::array<char, kErrorSize> error{};
  ModelPointer model(std::filesystem::path(path).extension() == ".mjb"
                         ? mj_loadModel(path.c_str(), nullptr)
                         : mj_loadXML(path.c_str(), nullptr, error.data(), kErrorSize));
  const std::string warned = TakeWarnings();
  if (model == nullptr || !warned.empty()) {
    throw InputError(path + ": MuJoCo cannot load it: " +
                     DistinctLines(std::string(error.data()) + "\n" + warned) +
                     ". Mend the model or make it anew with girdle generate");
  }
  return model;
}

DataPointer MakeData(const mjModel& model) {
  DataPointer data(mj_makeData(&model));
  EngineWatch::ExpectNoWarning("making the simulation's state");
  if (data == nullptr) {
    throw InputError("MuJoCo cannot make the simulation's state: not enough memory");
  }
  return data;
}

}  // namespace girdle
