// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/engine.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>
#include <new>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "names/model_fault_mark.h"
#include "names/model_names.h"
#include "simulation/binary_model.h"
#include "simulation/xml_model.h"
#include "text/input_error.h"

namespace girdle {
namespace {

// MuJoCo calls its handlers from any thread and gives them no context.
std::mutex warnings_mutex;          // NOLINT(readability-identifier-naming)
std::vector<std::string> warnings;  // NOLINT(readability-identifier-naming)

// The plugin's last message about faults of a compiled model.
std::string model_fault;  // NOLINT(readability-identifier-naming)

// How a warning begins that concerns models which are saved. Girdle saves none.
constexpr std::string_view kOnSaving = "Attaching a spec with an empty prefix";

void OnWarning(const char* message) {
  if (std::string_view(message).starts_with(kOnSaving)) {
    return;
  }
  const std::lock_guard lock(warnings_mutex);
  if (std::string_view(message).find(kModelFaultMark) != std::string_view::npos) {
    model_fault = message;
    return;
  }
  warnings.emplace_back(message);
}

// If MuJoCo gets no memory, the model is not at fault. If the model's own arena is too small,
// MuJoCo's message is another one, and the model is at fault.
void ThrowIfOutOfMemory(std::string_view message) {
  if (message.find("Could not allocate memory") != std::string_view::npos ||
      message.find("memory allocation failed") != std::string_view::npos) {
    throw std::bad_alloc();
  }
}

[[noreturn]] void OnError(const char* message) {
  ThrowIfOutOfMemory(message);
  throw EngineError(message);
}

// Returns the lines of a text on one line, each once and without those about saving. MuJoCo tries a
// plugin several times, and repeats its message, sometimes cut off.
std::string DistinctLines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const auto begins_with_it = [&line](const std::string& other) {
      return other.starts_with(line);
    };
    if (!line.empty() && !line.starts_with(kOnSaving) &&
        std::ranges::none_of(lines, begins_with_it)) {
      std::erase_if(lines, [&line](const std::string& other) { return line.starts_with(other); });
      lines.push_back(line);
    }
  }
  std::string joined;
  for (const std::string& line : lines) {
    joined += (joined.empty() ? "" : "; ") + line;
  }
  return joined;
}

// Size of the buffer for MuJoCo's reason.
constexpr std::size_t kErrorSize = 1024;

bool IsBinary(const std::string& name) { return std::filesystem::path(name).extension() == ".mjb"; }

std::string WithoutStop(std::string text) {
  while (text.ends_with('.')) {
    text.pop_back();
  }
  return text;
}

void ExpectLoaded(const ModelPointer& model, const std::string& name, const std::string& reason) {
  ThrowIfOutOfMemory(reason);
  const std::string warned = EngineWatch::TakeWarnings();
  if (model == nullptr || !warned.empty()) {
    const bool is_attached = reason.find("Attach conflict") != std::string::npos ||
                             warned.find("Attach conflict") != std::string::npos;
    throw InputError(
        name + ": MuJoCo cannot load it: " + WithoutStop(DistinctLines(reason + "\n" + warned)) +
        ". " +
        (is_attached
             ? "Give your model the <option> of the shoulder that is attached to it, such as "
               "integrator=\"implicitfast\" timestep=\"0.002\""
             : std::string(IsBinary(name) ? "Give its XML" : "Correct the model") +
                   " or make it anew with girdle generate"));
  }
}

// Loads a model from an MJCF file on disk or in `files`.
ModelPointer LoadXml(const std::string& path, const mjVFS* files) {
  std::array<char, kErrorSize> error{};
  ModelPointer model(mj_loadXML(path.c_str(), files, error.data(), kErrorSize));
  ExpectLoaded(model, path, error.data());
  return model;
}

}  // namespace

EngineWatch::EngineWatch()
    : previous_error_(std::exchange(mju_user_error, OnError)),
      previous_warning_(std::exchange(mju_user_warning, OnWarning)) {
  TakeWarnings();
  TakeModelFault();
}

EngineWatch::~EngineWatch() {
  mju_user_error = previous_error_;
  mju_user_warning = previous_warning_;
}

std::string EngineWatch::TakeWarnings() {
  const std::lock_guard lock(warnings_mutex);
  std::string text;
  for (const std::string& warning : std::exchange(warnings, {})) {
    text += (text.empty() ? "" : "; ") + warning;
  }
  return text;
}

void EngineWatch::ExpectNoWarning(const std::string& doing) {
  const std::string text = TakeWarnings();
  if (!text.empty()) {
    throw InputError(doing + ": MuJoCo warns: " + text);
  }
}

std::string EngineWatch::TakeModelFault() {
  const std::lock_guard lock(warnings_mutex);
  return std::exchange(model_fault, {});
}

void LoadPlugin(const std::string& path) {
  constexpr const char* kFix = ". Name libgirdle_rhythm.so with --plugin FILE";
  if (!std::filesystem::is_regular_file(path)) {
    throw InputError(path + ": no such plugin" + kFix);
  }
  try {
    // The path must have a folder: a mere name is searched for among the system's libraries.
    mj_loadPluginLibrary(std::filesystem::absolute(path).c_str());
  } catch (const InputError& error) {
    throw InputError(path + ": MuJoCo cannot load it as a plugin: " + error.what() + kFix);
  }
  EngineWatch::ExpectNoWarning(path);
  if (mjp_getPlugin(kPluginName, nullptr) == nullptr) {
    throw InputError(path + ": holds no plugin " + kPluginName + kFix);
  }
}

ModelPointer LoadModel(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    throw InputError(
        path +
        (std::filesystem::exists(path, ignored) ? ": is not a regular file" : ": no such file") +
        ". Make a model with girdle generate --out FOLDER and name its scene.xml");
  }
  if (path.find('\\') != std::string::npos) {
    throw InputError(path + ": MuJoCo takes a backslash in a path for a slash. Rename it");
  }
  if (IsBinary(path)) {
    ExpectLoadable(path);
    ModelPointer model(mj_loadModel(path.c_str(), nullptr));
    ExpectLoaded(model, path, "");
    return model;
  }
  ExpectLoadableXml(path, [&path] { static_cast<void>(LoadXml(path, nullptr)); });
  return LoadXml(path, nullptr);
}

ModelPointer LoadModel(const ModelFiles& files) {
  mjVFS vfs;
  mj_defaultVFS(&vfs);
  // The VFS is freed even if an error of MuJoCo becomes an exception.
  const std::unique_ptr<mjVFS, decltype(&mj_deleteVFS)> vfs_guard(&vfs, &mj_deleteVFS);
  for (const auto& [name, text] : files) {
    if (mj_addBufferVFS(&vfs, name.c_str(), text.data(), static_cast<int>(text.size())) != 0) {
      throw InputError(name + ": MuJoCo cannot take the file");
    }
  }
  return LoadXml(files.front().first, &vfs);
}

DataPointer MakeData(const mjModel& model) {
  DataPointer data(mj_makeData(&model));
  EngineWatch::ExpectNoWarning("making the simulation's state");
  if (data == nullptr) {
    throw std::bad_alloc();
  }
  return data;
}

}  // namespace girdle
