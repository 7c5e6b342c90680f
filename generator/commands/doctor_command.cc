// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/doctor_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "commands/output_file.h"
#include "commands/picture_diagnosis.h"
#include "commands/simulation_module.h"
#include "engines/diagnosis.h"
#include "engines/engine_search.h"
#include "engines/engine_trial.h"
#include "mjcf/shoulder_model.h"
#include "tables/built_in.h"
#include "tables/input_error.h"

namespace girdle {
namespace {

namespace fs = std::filesystem;

struct DoctorArguments {
  std::vector<std::string> engines;
  std::vector<std::string> plugins;
  bool only = false;
  bool json = false;
};

// The folder of Girdle's sources that the program lies in, as scripts/run leaves it.
fs::path Checkout(const fs::path& program_folder) {
  std::error_code error;
  const fs::path folder = program_folder.parent_path().parent_path();
  return fs::exists(folder / "scripts" / "setup", error) &&
                 fs::exists(folder / "generator" / "plugin", error)
             ? folder
             : fs::path();
}

// Whether nothing was found by what bears this name.
bool FoundNothing(const std::vector<FoundFile>& engines, const std::string& name) {
  return std::none_of(engines.begin(), engines.end(), [&](const FoundFile& engine) {
    return std::find(engine.found_by.begin(), engine.found_by.end(), name) != engine.found_by.end();
  });
}

Diagnosis Examine(const DoctorArguments& arguments) {
  const fs::path program_folder = ProgramFolder();
  std::vector<Place> places;
  if (arguments.only && arguments.engines.empty()) {
    throw InputError("--only: without --engine there is nothing to look at. Name one");
  }
  for (const std::string& engine : arguments.engines) {
    if (std::error_code error; !fs::exists(engine, error)) {
      throw InputError("--engine " + engine +
                       ": no such file or folder. Name a library of MuJoCo or the folder of one");
    }
    places.push_back({engine, "--engine " + engine});
  }
  std::vector<fs::path> given_plugins;
  for (const std::string& plugin : arguments.plugins) {
    if (std::error_code error; !fs::is_regular_file(plugin, error)) {
      throw InputError("--plugin " + plugin + ": no such plugin. Name libgirdle_rhythm.so");
    }
    given_plugins.push_back(fs::absolute(plugin));
  }

  std::vector<std::string> notes;
  if (!arguments.only) {
    if (HasSimulation()) {
      std::string problem;
      const fs::path engine = EngineOfModule(SimulationFile(), problem);
      if (!engine.empty()) {
        places.push_back({engine, "this program"});
      } else {
        notes.push_back("this program cannot run MuJoCo: " + problem);
      }
    }
    std::vector<Place> of_machine = EnginePlaces(program_folder);
    std::move(of_machine.begin(), of_machine.end(), std::back_inserter(places));
  }
  const std::vector<FoundFile> engines = FindEngines(places);
  for (const Place& place : places) {
    if ((place.name == "MUJOCO_ROOT" || place.name.starts_with("--engine")) &&
        FoundNothing(engines, place.name)) {
      notes.push_back(place.name + ": " + place.path.string() + " holds no libmujoco.so");
    }
  }

  std::vector<fs::path> plugins = given_plugins;
  for (const fs::path& plugin : FindPlugins(program_folder, GIRDLE_MODULE_DIR, engines)) {
    const bool is_given =
        std::any_of(given_plugins.begin(), given_plugins.end(), [&](const fs::path& given) {
          std::error_code error;
          return fs::equivalent(given, plugin, error);
        });
    if (!is_given) {
      plugins.push_back(plugin);
    }
  }
  Diagnosis diagnosis =
      Diagnose(engines, plugins, ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm({}), {}),
               Checkout(program_folder));
  diagnosis.notes = std::move(notes);
  DiagnosePictures(diagnosis);
  return diagnosis;
}

}  // namespace

void AddDoctorCommand(CLI::App& program, int& status) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* verb =
      program.add_subcommand("doctor", "Which MuJoCo of this machine works with which plugin");
  verb->add_option("--engine", arguments->engines,
                   "Look at this library of MuJoCo, or in this folder, as well")
      ->type_name("PATH")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb->add_option("--plugin", arguments->plugins, "Try this plugin as well, before the others")
      ->type_name("FILE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb->add_flag("--only", arguments->only, "Look at no other MuJoCo than those of --engine");
  verb->add_flag("--json", arguments->json, "The diagnosis as JSON");
  verb->footer(
      "Looks where Python, unpacked releases and the system keep MuJoCo, and at MUJOCO_ROOT. Each "
      "is loaded,\nwith the plugin for its version, in a process of its own, and steps a shoulder. "
      "Where one does not work\nthe line after `type` mends it. Says besides what draws pictures "
      "and makes videos. Exit status 1 if no MuJoCo works.\n"
      "Example:\n  girdle doctor");
  verb->callback([arguments, &status] {
    const Diagnosis diagnosis = Examine(*arguments);
    Print(arguments->json ? DiagnosisAsJson(diagnosis) : DiagnosisAsText(diagnosis));
    status = diagnosis.passed() ? 0 : 1;
  });
}

}  // namespace girdle
