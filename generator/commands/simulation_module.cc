// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/simulation_module.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "text/input_error.h"

namespace girdle {
namespace {

constexpr const char* kSimulationFile = "libgirdle_simulation.so";
constexpr const char* kPluginFile = "libgirdle_rhythm.so";

// Returns a file beside the program (build tree) or in the library folder (installation).
std::filesystem::path PartOfProgram(const char* file) {
  std::error_code error;
  const std::filesystem::path folder = ProgramFolder();
  const std::filesystem::path beside = folder / file;
  return std::filesystem::exists(beside, error)
             ? beside
             : (folder / GIRDLE_MODULE_DIR / file).lexically_normal();
}

}  // namespace

void AddPluginArgument(CLI::App& verb, std::string& plugin) {
  verb.add_option("--plugin", plugin, "The engine plugin, if not the one built with this program")
      ->type_name("FILE");
}

std::string ChosenPlugin(const std::string& plugin) {
  return plugin.empty() ? PartOfProgram(kPluginFile).string() : plugin;
}

std::filesystem::path ProgramFolder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

std::filesystem::path SimulationFile() { return PartOfProgram(kSimulationFile); }

bool HasSimulation() {
  std::error_code error;
  return std::filesystem::exists(SimulationFile(), error);
}

const SimulationModule& LoadSimulation() {
  const std::filesystem::path path = SimulationFile();
  if (!HasSimulation()) {
    throw InputError(path.string() +
                     ": not there. This verb needs MuJoCo: build Girdle with it (scripts/setup "
                     "fetches it)");
  }
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw InputError(
        "cannot run MuJoCo: " + std::string(dlerror()) +
        ". Girdle was built with the MuJoCo in " GIRDLE_ENGINE_DIR
        ". If that has moved, set LD_LIBRARY_PATH to the folder where it is now; if it "
        "is gone, build and install Girdle again");
  }
  const auto module =
      reinterpret_cast<SimulationModuleFunction>(dlsym(library, kSimulationModuleSymbol));
  if (module == nullptr) {
    throw InputError(path.string() + ": not the simulation of this program. Build Girdle again");
  }
  return *module();
}

}  // namespace girdle
