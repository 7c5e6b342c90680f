// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mujoco_search/engine_search.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>

#include "child_programs/child_process.h"
#include "child_programs/program_search.h"

namespace girdle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEngineFile = "libmujoco.so";

// Pythons start in a fraction of a second.
constexpr int kPythonLimit_s = 10;

constexpr std::string_view kMarker = "girdle:";
// Prints a marker and the folder of the package. The package is not imported, because an import
// loads its library. An isolated python leaves out the user's own packages, which are added here.
constexpr const char* kAskPython =
    "import importlib.util, site, sys\n"
    "if sys.prefix == sys.base_prefix:\n"
    "    sys.path.insert(0, site.getusersitepackages())\n"
    "spec = importlib.util.find_spec('mujoco')\n"
    "print('\\ngirdle:' + (spec and spec.submodule_search_locations or [''])[0])\n";

std::string Environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

// Returns the content of a folder, sorted by name. Empty if the folder does not exist or is not
// readable.
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

// Whether a file is a library of this name, with any version after it.
bool IsEngineFile(const fs::path& file) {
  const std::string name = file.filename().string();
  std::error_code error;
  return name.starts_with(kEngineFile) &&
         (name.size() == kEngineFile.size() || name[kEngineFile.size()] == '.') &&
         fs::is_regular_file(file, error);
}

void AddEngine(const fs::path& file, const std::string& name, std::vector<FoundEngine>& found) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error || !IsEngineFile(file)) {
    return;
  }
  auto at = std::find_if(found.begin(), found.end(),
                         [&](const FoundEngine& each) { return each.file == real; });
  if (at == found.end()) {
    const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
    at = found.insert(at, {real, folder, {}});
  }
  if (std::find(at->found_by.begin(), at->found_by.end(), name) == at->found_by.end()) {
    at->found_by.push_back(name);
  }
}

}  // namespace

std::vector<fs::path> PythonsOnPath() {
  std::vector<fs::path> pythons;
  std::set<fs::path> seen;
  for (const fs::path& folder : FoldersOf("PATH")) {
    std::error_code error;
    // /bin and /usr/bin are one folder on many machines.
    if (!seen.insert(fs::weakly_canonical(folder, error)).second) {
      continue;
    }
    for (const char* name : {"python3", "python"}) {
      const fs::path python = folder / name;
      if (IsProgram(python)) {
        pythons.push_back(python);
        break;  // in one folder both are usually one program
      }
    }
  }
  return pythons;
}

fs::path PackageOf(const fs::path& python, std::string& problem) {
  const ChildResult answer =
      RunProgramInChild(python, {"-I", "-c", kAskPython}, {.time_s = kPythonLimit_s});
  problem = answer.failure.empty() ? "gave another answer than a whole path" : answer.failure;
  // A script that starts Python may print lines as well.
  std::istringstream lines(answer.output);
  for (std::string line; answer.failure.empty() && std::getline(lines, line);) {
    fs::path package = line.starts_with(kMarker) ? line.substr(kMarker.size()) : ".";
    if (package.empty() || package.is_absolute()) {
      problem.clear();
      return package;
    }
  }
  return {};
}

std::vector<Place> EnginePlaces(const fs::path& checkout, std::vector<std::string>& notes) {
  std::vector<Place> places;
  const auto add = [&](const fs::path& path, const std::string& name) {
    if (!path.empty()) {
      places.push_back({path, name});
    }
  };
  const auto add_each = [&](const fs::path& folder, const std::string& name) {
    for (const fs::path& each : ContentsOf(folder)) {
      add(each, name);
    }
  };
  add(Environment("MUJOCO_ROOT"), "MUJOCO_ROOT");
  for (const fs::path& python : PythonsOnPath()) {
    std::string problem;
    add(PackageOf(python, problem), python.string());
    if (!problem.empty()) {
      notes.push_back(python.string() + ", asked for its package mujoco, " + problem);
    }
  }
  for (const char* variable : {"VIRTUAL_ENV", "CONDA_PREFIX", "LD_LIBRARY_PATH", "PYTHONPATH"}) {
    for (const fs::path& folder : FoldersOf(variable)) {
      add(folder, variable);
    }
  }
  if (!checkout.empty()) {
    add(checkout / ".venv", ".venv");
    add(checkout / "build" / "python", "build/python");
    add_each(checkout / "build" / "engine", "build/engine");
  }
  for (const fs::path& home : FoldersOf("HOME")) {
    add_each(home / ".mujoco", "~/.mujoco");
  }
  add_each("/opt", "/opt");
  add("/usr/local", "/usr/local");
  add("/usr/lib", "/usr/lib");
  for (const fs::path& folder : ContentsOf("/usr/lib")) {
    if (folder.filename().string().ends_with("-linux-gnu")) {
      add(folder, "/usr/lib");
    }
  }
  return places;
}

std::vector<FoundEngine> FindEngines(const std::vector<Place>& places) {
  std::vector<FoundEngine> found;
  for (const Place& place : places) {
    AddEngine(place.path, place.name, found);
    std::vector<fs::path> folders = {place.path, place.path / "lib", place.path / "mujoco",
                                     place.path / "mujoco" / "lib"};
    for (const fs::path& inner : ContentsOf(place.path / "lib")) {
      if (inner.filename().string().starts_with("python3")) {
        folders.push_back(inner / "site-packages" / "mujoco");
      }
    }
    for (const fs::path& folder : folders) {
      for (const fs::path& file : ContentsOf(folder)) {
        AddEngine(file, place.name, found);
      }
    }
  }
  return found;
}

fs::path PythonOf(const fs::path& folder) {
  // PREFIX/lib/python3.X/site-packages/mujoco
  const fs::path packages = folder.parent_path();
  const fs::path python = packages.parent_path().parent_path().parent_path() / "bin" / "python3";
  std::error_code error;
  return packages.filename() == "site-packages" && fs::exists(python, error) ? python : fs::path();
}

}  // namespace girdle
