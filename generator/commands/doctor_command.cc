// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/doctor_command.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "commands/exit_status.h"
#include "commands/output_file.h"
#include "commands/picture_diagnosis.h"
#include "commands/random_name.h"
#include "commands/simulation_module.h"
#include "mjcf/shoulder_model.h"
#include "mujoco_search/diagnosis.h"
#include "mujoco_search/engine_search.h"
#include "mujoco_search/engine_trial.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/input_error.h"
#include "text/same_bytes.h"

namespace girdle {
namespace {

namespace fs = std::filesystem;

struct DoctorArguments {
  std::vector<std::string> engines;
  std::string plugin;
  bool only = false;
  bool json = false;
  bool install = false;
  bool uninstall = false;
};

// Suffix of a copy that is not in its place yet. Python ignores such a file.
constexpr const char* kPart = ".part";

// Returns the folder of Girdle's sources that the program lies in, where scripts/run builds it.
fs::path Checkout() {
  std::error_code error;
  const fs::path folder = ProgramFolder().parent_path().parent_path();
  return fs::exists(folder / "scripts" / "setup", error) &&
                 fs::exists(folder / "generator" / "plugin", error)
             ? folder
             : fs::path();
}

// Returns the plugin, or an empty path if the program has none.
fs::path Plugin(const DoctorArguments& arguments) {
  fs::path plugin = fs::absolute(ChosenPlugin(arguments.plugin));
  if (std::error_code error; fs::is_regular_file(plugin, error)) {
    return plugin;
  }
  if (!arguments.plugin.empty()) {
    throw InputError("--plugin " + arguments.plugin + ": no such plugin. Name libgirdle_rhythm.so");
  }
  return {};
}

std::string InstallLine(const DoctorArguments& arguments) {
  return ShellWord(ProgramFolder() / "girdle") + " doctor --install" +
         (arguments.plugin.empty() ? "" : " --plugin " + ShellWord(Plugin(arguments)));
}

std::vector<Place> NamedPlaces(const DoctorArguments& arguments) {
  std::vector<Place> places;
  for (const std::string& engine : arguments.engines) {
    if (std::error_code error; !fs::exists(engine, error)) {
      throw InputError("--engine " + engine +
                       ": no such file or folder. Name a library of MuJoCo or the folder of one");
    }
    places.push_back({engine, "--engine " + engine});
    if (FindEngines({places.back()}).empty()) {
      throw InputError(
          "--engine " + engine +
          ": holds no libmujoco.so. Name a library of MuJoCo, the folder of one or the "
          "environment of a Python that has it");
    }
  }
  return places;
}

std::string Model() { return ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm({}), {}); }

Diagnosis Examine(const DoctorArguments& arguments) {
  if (arguments.only && arguments.engines.empty()) {
    throw InputError("--only: without --engine there is nothing to look at. Name one");
  }
  std::vector<Place> places = NamedPlaces(arguments);
  const fs::path plugin = Plugin(arguments);
  const fs::path checkout = Checkout();
  std::vector<std::string> notes;
  if (!arguments.only) {
    if (HasSimulation()) {
      const Trial opened = OpenModule(SimulationFile());
      if (opened.problem.empty()) {
        places.push_back({opened.answer, "this program"});
      } else {
        notes.push_back("this program cannot run MuJoCo: " + opened.problem);
      }
    }
    std::vector<Place> of_machine = EnginePlaces(checkout, notes);
    std::move(of_machine.begin(), of_machine.end(), std::back_inserter(places));
  }
  for (const Place& place : places) {
    if (place.name == "MUJOCO_ROOT" && FindEngines({place}).empty()) {
      notes.push_back(place.name + ": " + place.path.string() + " holds no libmujoco.so");
    }
  }
  const std::vector<FoundEngine> engines = FindEngines(places);
  Diagnosis diagnosis = Diagnose(engines, plugin, Model(), InstallLine(arguments));
  diagnosis.notes = std::move(notes);
  if (engines.empty()) {
    diagnosis.fix = checkout.empty() ? "python3 -m venv .venv && . .venv/bin/activate && pip "
                                       "install mujoco"
                                     : ShellWord(checkout / "scripts" / "setup");
  }
  DiagnosePictures(diagnosis);
  return diagnosis;
}

// Returns the folder of Python's package mujoco for --install and --uninstall.
fs::path ChosenPackage(const DoctorArguments& arguments) {
  if (!arguments.engines.empty()) {
    const std::vector<FoundEngine> engines = FindEngines(NamedPlaces(arguments));
    if (engines.size() != 1) {
      throw InputError("--engine " + arguments.engines.front() + ": " +
                       std::to_string(engines.size()) +
                       " libraries of MuJoCo found there, expected one. Name the environment "
                       "of a Python, such as .venv, or the folder of its package mujoco");
    }
    return engines.front().folder;
  }
  const std::vector<fs::path> pythons = PythonsOnPath();
  if (pythons.empty()) {
    throw InputError("no python3 on PATH. Name the folder of its package mujoco with --engine");
  }
  std::string problem;
  fs::path package = PackageOf(pythons.front(), problem);
  if (package.empty()) {
    throw InputError(pythons.front().string() +
                     (problem.empty()
                          ? std::string(" has no package mujoco. Activate the environment "
                                        "that has it, or name that with --engine. To "
                                        "make one: python3 -m venv .venv && "
                                        ".venv/bin/pip install mujoco")
                          : ", asked for its package mujoco, " + problem +
                                ". Name the package's folder with --engine"));
  }
  return package;
}

// Whether an error means that another user may have the right to do this.
bool NeedsRights(int failure) { return failure == EACCES || failure == EPERM; }

// Removes the parts beside the copy that an interrupted install left.
void RemoveParts(const fs::path& copy) {
  std::error_code error;
  for (fs::directory_iterator entry(copy.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(copy.filename().string() + ".") && name.ends_with(kPart)) {
      unlink(entry->path().c_str());
    }
  }
}

// Returns the single MuJoCo of Python's package.
FoundEngine EngineOf(const fs::path& package) {
  const std::vector<FoundEngine> engines = FindEngines({{package, ""}});
  std::error_code error;
  if (engines.size() != 1 || !fs::exists(package / "__init__.py", error)) {
    throw InputError(package.string() +
                     ": is not Python's package mujoco. Make it with pip install mujoco; in other "
                     "programs load the plugin with mj_loadPluginLibrary");
  }
  return engines.front();
}

// Puts a copy of the plugin into its place in one step, if the copy works there. Throws the
// exceptions of `attempt`; returns the error of the file system. In both cases no part of a copy
// remains.
std::error_code CopyTried(const fs::path& plugin, const fs::path& copy,
                          const std::function<void(const fs::path&)>& attempt) {
  std::error_code error;
  const fs::path part = copy.string() + "." + RandomName() + kPart;
  fs::create_directories(copy.parent_path(), error);
  if (!error) {
    fs::copy_file(plugin, part, error);  // into a new file: it fails if there is one
  }
  if (!error) {
    using enum fs::perms;
    fs::permissions(part, owner_read | owner_write | group_read | others_read, error);
  }
  if (!error) {
    try {
      attempt(part);
    } catch (const InputError&) {
      unlink(part.c_str());
      throw;
    }
    fs::rename(part, copy, error);
  }
  if (error) {
    unlink(part.c_str());
  }
  return error;
}

void Install(const DoctorArguments& arguments) {
  const fs::path package = ChosenPackage(arguments);
  const fs::path plugin = Plugin(arguments);
  const FoundEngine engine = EngineOf(package);
  std::string verdict;
  const auto attempt = [&](const fs::path& file) {
    const Trial trial = TryEngine(engine.file, file, Model());
    if (!trial.problem.empty()) {
      throw InputError(package.string() + ": MuJoCo " +
                       (trial.answer.empty() ? "?" : trial.answer) +
                       " does not work with the plugin, which is not installed: " + trial.problem);
    }
    verdict = "MuJoCo " + trial.answer + " works with it: `import mujoco` loads it from now on\n";
  };
  attempt(plugin);
  const fs::path copy = PluginCopy(package);
  RemoveParts(copy);
  std::error_code ignored;
  const bool is_there = fs::exists(fs::symlink_status(copy, ignored));
  const bool is_same = HaveTheSameBytes(plugin, copy);
  if (!is_same) {
    if (const std::error_code error = CopyTried(plugin, copy, attempt)) {
      throw InputError(
          copy.string() + ": cannot be written: " + error.message() +
          (NeedsRights(error.value())
               ? ". Type: sudo " + InstallLine(arguments) + " --engine " + ShellWord(package) +
                     ", or install MuJoCo into a virtual environment, which is your own"
               : ""));
    }
  }
  Print((is_same    ? "is there already: "
         : is_there ? "replaced "
                    : "wrote ") +
        copy.string() + "\n" + verdict);
}

void Uninstall(const DoctorArguments& arguments) {
  const fs::path copy = PluginCopy(ChosenPackage(arguments));
  RemoveParts(copy);
  const int failure = unlink(copy.c_str()) == 0 ? 0 : errno;
  if (failure != 0 && failure != ENOENT) {
    throw InputError(copy.string() + ": cannot be removed: " + std::strerror(failure) +
                     (NeedsRights(failure) ? ". Type: sudo rm " + ShellWord(copy) : ""));
  }
  Print((failure == 0 ? "removed " : "is not there: ") + copy.string() + "\n");
}

}  // namespace

void AddDoctorCommand(CLI::App& program, int& status) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* verb =
      program.add_subcommand("doctor", "Which MuJoCo of this machine works with the plugin");
  verb->add_option("--engine", arguments->engines,
                   "Look at this library of MuJoCo, in this folder or in this environment of a "
                   "Python as well")
      ->type_name("PATH")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  AddPluginArgument(*verb, arguments->plugin);
  verb->add_flag("--only", arguments->only, "Look at no other MuJoCo than those of --engine");
  verb->add_flag("--json", arguments->json, "The diagnosis as JSON");
  verb->add_flag("--install", arguments->install,
                 "Put the plugin into Python's package mujoco, from which `import mujoco` loads "
                 "it: that of --engine, else that of the first python3 on PATH");
  verb->add_flag("--uninstall", arguments->uninstall, "Remove it from there again");
  verb->footer(
      "\nThe doctor looks where Python, unpacked releases and the system keep MuJoCo, at "
      "MUJOCO_ROOT, and in the checkout that the program lies in. It runs each python3 on PATH, "
      "isolated, to ask where its package is. It loads each MuJoCo with the plugin, steps a "
      "shoulder, and loads OpenGL. Each runs in its own process, with a limit of time and output. "
      "Nothing of the current folder is run. If a MuJoCo does not work, its problem or the line "
      "after `type` says how to repair it. Exit status 1 if no MuJoCo works.\n"
      "\nExamples:\n  girdle doctor\n  girdle doctor --install");
  verb->callback([arguments, &status] {
    const bool changes = arguments->install || arguments->uninstall;
    if (changes && (arguments->only || arguments->json || arguments->engines.size() > 1 ||
                    arguments->install == arguments->uninstall)) {
      throw InputError("--install and --uninstall: each goes with one --engine and --plugin alone");
    }
    if (arguments->install) {
      Install(*arguments);
    } else if (arguments->uninstall) {
      Uninstall(*arguments);
    } else {
      const Diagnosis diagnosis = Examine(*arguments);
      Print(arguments->json ? DiagnosisAsJson(diagnosis) : DiagnosisAsText(diagnosis));
      status = diagnosis.passed() ? kFine : kAboveTolerance;
    }
  });
}

}  // namespace girdle
