// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/generate_command.h"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"
#include "mjcf/scene.h"
#include "mjcf/shoulder_model.h"
#include "tables/built_in.h"
#include "tables/input_error.h"

namespace girdle {
namespace {

constexpr const char* kModelFile = "shoulder_right.xml";
constexpr const char* kSceneFile = "scene.xml";

struct GenerateArguments {
  RhythmArguments rhythm;
  std::string out;
  bool offsets = false;
  bool rates = false;
  std::string plugin;
  bool json = false;
};

std::string ModelXml(const GenerateArguments& arguments) {
  if (arguments.rates) {
    ExpectRates(arguments.rhythm);
  }
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  const std::optional<BuiltInTable> table = ChosenBuiltInTable(arguments.rhythm);
  try {
    return ShoulderModelXml(
        BuiltInAnatomy(), rhythm,
        {.table = table, .has_offsets = arguments.offsets, .has_rates = arguments.rates});
  } catch (const std::invalid_argument& error) {
    throw InputError((table ? "" : arguments.rhythm.table + ": ") + error.what());
  }
}

void Generate(const GenerateArguments& arguments) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {kSceneFile, SceneXml(kModelFile)}, {kModelFile, ModelXml(arguments)}};
  // What MuJoCo does not accept is not a model and is not written.
  const std::string checked =
      HasSimulation() ? LoadSimulation().check_model(files, ChosenPlugin(arguments.plugin))
                      : "not loaded: this program was built without MuJoCo";
  const std::filesystem::path folder(arguments.out);
  WriteFiles(folder, files);
  const std::string model = (folder / kModelFile).string();
  const std::string scene = (folder / kSceneFile).string();
  if (arguments.json) {
    nlohmann::ordered_json json;
    json["model"] = model;
    json["scene"] = scene;
    json["checked"] = checked;
    Print(json.dump(2) + "\n");
  } else {
    Print("model  " + model + "\nscene  " + scene + "\ncheck  " + checked + "\n");
  }
}

}  // namespace

void AddGenerateCommand(CLI::App& program) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* verb = program.add_subcommand("generate", "The right shoulder as a MuJoCo model");
  verb->add_option("--out", arguments->out, "Folder for the model and its scene")
      ->type_name("DIR")
      ->required();
  AddRhythmArguments(*verb, arguments->rhythm);
  verb->add_flag("--offsets", arguments->offsets,
                 "With commands for shrug and protraction on top of the rhythm");
  verb->add_flag("--rates", arguments->rates,
                 "With commands for how fast elevation, plane and axial change, which the plugin "
                 "feeds forward so that the joints lag less");
  AddPluginArgument(*verb, arguments->plugin);
  verb->add_flag("--json", arguments->json, "Say what was written as JSON");
  verb->footer("Example:\n  girdle generate --out my_model");
  verb->callback([arguments] { Generate(*arguments); });
}

}  // namespace girdle
