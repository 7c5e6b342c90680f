// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engines/engine_search.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <system_error>

#include "engines/child_process.h"

namespace girdle {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEngineFile = "libmujoco.so";
constexpr const char* kPluginFile = "libgirdle_rhythm.so";

// Pythons start in a fraction of a second.
constexpr int kPythonLimit_s = 20;

// Prints the folder of the package, which is not imported: that would load its library. The empty
// entry of the path is the current folder, where a `mujoco` is not Python's own.
constexpr const char* kAskPython =
    "import importlib.util, sys\n"
    "sys.path = [entry for entry in sys.path if entry]\n"
    "spec = importlib.util.find_spec('mujoco')\n"
    "print(list(spec.submodule_search_locations)[0] if spec else '')\n";

std::string Environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

// The parts of a list of folders such as PATH; those that are empty mean the current folder in
// PATH, by mistake as a rule, and are left out.
std::vector<fs::path> FoldersOf(const char* variable) {
  std::vector<fs::path> folders;
  std::istringstream in(Environment(variable));
  for (std::string folder; std::getline(in, folder, ':');) {
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

// What is in a folder, in order of its names; nothing if there is no such folder or it may not be
// read.
std::vector<fs::path> ContentsOf(const fs::path& folder) {
  std::vector<fs::path> contents;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    contents.push_back(entry->path());
  }
  std::sort(contents.begin(), contents.end());
  return contents;
}

// Where the environment in `prefix` has its package mujoco.
void AddEnvironment(const fs::path& prefix, const std::string& name, std::vector<Place>& places) {
  for (const fs::path& lib : ContentsOf(prefix / "lib")) {
    if (lib.filename().string().starts_with("python3")) {
      places.push_back({lib / "site-packages" / "mujoco", name});
    }
  }
}

void AddPythonsOnPath(std::vector<Place>& places) {
  std::set<fs::path> asked;
  for (const fs::path& folder : FoldersOf("PATH")) {
    std::error_code error;
    // /bin and /usr/bin are one folder on many machines.
    if (!asked.insert(fs::weakly_canonical(folder, error)).second) {
      continue;
    }
    for (const char* name : {"python3", "python"}) {
      const fs::path python = folder / name;
      if (access(python.c_str(), X_OK) != 0 || !fs::is_regular_file(python, error)) {
        continue;
      }
      const ChildResult answer = RunInChild(
          [&](const auto&) {
            execl(python.c_str(), python.c_str(), "-c", kAskPython, static_cast<char*>(nullptr));
          },
          kPythonLimit_s);
      const std::string package = answer.output.substr(0, answer.output.find('\n'));
      if (!package.empty()) {
        places.push_back({package, python.string()});
      }
      break;  // in one folder both are the same
    }
  }
}

void AddEach(const fs::path& folder, const std::string& name, std::vector<Place>& places) {
  for (const fs::path& each : ContentsOf(folder)) {
    places.push_back({each, name});
  }
}

// A library of this name with any version after it.
bool IsEngineFile(const fs::path& file) {
  const std::string name = file.filename().string();
  std::error_code error;
  return name.starts_with(kEngineFile) &&
         (name.size() == std::string(kEngineFile).size() ||
          name[std::string(kEngineFile).size()] == '.') &&
         fs::is_regular_file(file, error);
}

void AddFile(const fs::path& file, const std::string& name, std::vector<FoundFile>& found) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error) {
    return;
  }
  auto at = std::find_if(found.begin(), found.end(),
                         [&](const FoundFile& each) { return each.file == real; });
  if (at == found.end()) {
    found.push_back({real, {}});
    at = std::prev(found.end());
  }
  if (std::find(at->found_by.begin(), at->found_by.end(), name) == at->found_by.end()) {
    at->found_by.push_back(name);
  }
}

}  // namespace

std::vector<Place> EnginePlaces(const fs::path& program_folder) {
  std::vector<Place> places;
  if (const std::string root = Environment("MUJOCO_ROOT"); !root.empty()) {
    places.push_back({root, "MUJOCO_ROOT"});
  }
  AddPythonsOnPath(places);
  for (const char* variable : {"VIRTUAL_ENV", "CONDA_PREFIX"}) {
    if (const std::string prefix = Environment(variable); !prefix.empty()) {
      AddEnvironment(prefix, variable, places);
    }
  }
  AddEnvironment(".venv", ".venv", places);
  AddEnvironment("build/python", "build/python", places);
  AddEnvironment(program_folder / ".." / "python", "build/python", places);
  AddEach("build/engine", "build/engine", places);
  AddEach(program_folder / ".." / "engine", "build/engine", places);
  for (const fs::path& folder : FoldersOf("LD_LIBRARY_PATH")) {
    places.push_back({folder, "LD_LIBRARY_PATH"});
  }
  if (const std::string home = Environment("HOME"); !home.empty()) {
    AddEach(fs::path(home) / ".mujoco", "~/.mujoco", places);
  }
  AddEach("/opt", "/opt", places);
  places.push_back({"/usr/local", "/usr/local"});
  places.push_back({"/usr/lib", "/usr/lib"});
  for (const fs::path& folder : ContentsOf("/usr/lib")) {
    if (folder.filename().string().ends_with("-linux-gnu")) {
      places.push_back({folder, "/usr/lib"});
    }
  }
  return places;
}

std::vector<FoundFile> FindEngines(const std::vector<Place>& places) {
  std::vector<FoundFile> found;
  for (const Place& place : places) {
    if (IsEngineFile(place.path)) {
      AddFile(place.path, place.name, found);
    }
    for (const char* inner : {"", "lib", "mujoco", "mujoco/lib"}) {
      for (const fs::path& file : ContentsOf(place.path / inner)) {
        if (IsEngineFile(file)) {
          AddFile(file, place.name, found);
        }
      }
    }
  }
  return found;
}

std::vector<fs::path> FindPlugins(const fs::path& program_folder, const fs::path& installed_folder,
                                  const std::vector<FoundFile>& engines) {
  std::vector<fs::path> candidates = {program_folder / kPluginFile,
                                      program_folder / installed_folder / kPluginFile};
  for (const fs::path& build : ContentsOf(program_folder / "..")) {
    candidates.push_back(build / kPluginFile);
  }
  for (const FoundFile& engine : engines) {
    const fs::path folder = engine.file.parent_path();
    candidates.push_back(folder / "plugin" / kPluginFile);                        // a wheel's
    candidates.push_back(folder / ".." / "bin" / "mujoco_plugin" / kPluginFile);  // a release's
  }
  std::vector<FoundFile> found;
  std::error_code error;
  for (const fs::path& file : candidates) {
    if (fs::is_regular_file(file, error)) {
      AddFile(file, "", found);
    }
  }
  std::vector<fs::path> files;
  files.reserve(found.size());
  for (const FoundFile& each : found) {
    files.push_back(each.file);
  }
  return files;
}

fs::path RootOfEngine(const fs::path& engine) {
  std::error_code error;
  const fs::path folder = engine.parent_path();
  for (const fs::path& root : {folder, folder.parent_path()}) {
    if (fs::exists(root / "include" / "mujoco" / "mujoco.h", error)) {
      return root;
    }
  }
  return {};
}

fs::path PythonOfEngine(const fs::path& engine) {
  // PREFIX/lib/python3.X/site-packages/mujoco/libmujoco.so.X.Y.Z
  const fs::path packages = engine.parent_path().parent_path();
  if (packages.filename() != "site-packages") {
    return {};
  }
  std::error_code error;
  const fs::path python = packages.parent_path().parent_path().parent_path() / "bin" / "python";
  for (const fs::path& each : {python, fs::path(python.string() + "3")}) {
    if (fs::exists(each, error)) {
      return each;
    }
  }
  return {};
}

}  // namespace girdle
