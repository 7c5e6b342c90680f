// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/generate_command.h"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands/anatomy_arguments.h"
#include "commands/named_files.h"
#include "commands/option_group.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"
#include "commands/skin_argument.h"
#include "commands/word_argument.h"
#include "mjcf/scene.h"
#include "mjcf/shoulder_model.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/input_error.h"
#include "text/json_text.h"

namespace girdle {
namespace {

struct GenerateArguments {
  RhythmArguments rhythm;
  std::string side;
  std::string assembly;
  std::string lead;
  std::string actuation;
  std::string axial_from;
  AnatomyArguments anatomy;
  SkinArguments skin;
  std::string out;
  bool offsets = false;
  bool rates = false;
  bool thorax_contact = false;
  std::string plugin;
  bool json = false;
};

ShoulderModelOptions ModelOptions(const GenerateArguments& arguments,
                                  const ResolvedRhythm& rhythm) {
  ShoulderModelOptions options;
  ChooseWord("--side", arguments.side, options.sides);
  ChooseWord("--assembly", arguments.assembly, options.assembly);
  ChooseWord("--lead", arguments.lead, options.lead);
  ChooseWord("--actuation", arguments.actuation, options.actuation);
  if (!arguments.lead.empty() && options.assembly != Assembly::kLoop) {
    throw InputError("--lead " + arguments.lead +
                     ": in a tree the scapula hangs from the clavicle. Add --assembly loop");
  }
  if (arguments.thorax_contact && options.lead == Lead::kScapula) {
    throw InputError(
        "--thorax-contact: not available with --lead scapula, which drives the scapula's place. "
        "Omit it, or choose --lead clavicle");
  }
  ChooseWord("--axial-from", arguments.axial_from, options.axial_from);
  for (const auto& [option, given] :
       {std::pair("--axial-from", !arguments.axial_from.empty()),
        std::pair("--offsets", arguments.offsets), std::pair("--rates", arguments.rates)}) {
    if (given && options.actuation == Actuation::kPosition) {
      throw InputError(std::string(option) +
                       ": position servos are given joint angles and have no such command. Omit "
                       "it, or choose --actuation plugin");
    }
  }
  if (arguments.rates) {
    ExpectDerivatives("--rates", arguments.rhythm);
    if (options.assembly == Assembly::kLoop) {
      throw InputError(
          "--rates: not available for the assembly loop. Omit it, or choose --assembly tree");
    }
  }
  options.table = rhythm.built_in();
  options.has_offsets = arguments.offsets;
  options.has_rates = arguments.rates;
  options.has_thorax_contact = arguments.thorax_contact;
  return options;
}

std::string ModelXml(const ResolvedRhythm& resolved, const Anatomy& anatomy,
                     const ShoulderModelOptions& options) {
  const ShoulderRhythm rhythm = ChosenRhythm(resolved);
  try {
    return ShoulderModelXml(anatomy, rhythm, options);
  } catch (const std::invalid_argument& error) {
    throw InputError((options.table ? "" : resolved.table_name() + ": ") + error.what());
  }
}

// Returns a line on what MuJoCo found in the model, or on why MuJoCo was not run. Throws InputError
// if MuJoCo does not accept the model.
std::string CheckedByMujoco(const std::vector<std::pair<std::string, std::string>>& files,
                            const std::string& plugin) {
  if (!HasSimulation()) {
    return "not loaded: this program was built without MuJoCo";
  }
  const SimulationModule* simulation = nullptr;
  try {
    simulation = &LoadSimulation();
  } catch (const InputError& error) {
    return std::string("not loaded: ") + error.what();
  }
  return simulation->check_model(files, plugin);
}

// File names of one model. They differ between variants, so that variants can share a folder.
struct FileNames {
  std::string model;
  std::string scene;
  std::string skin;
  std::string landmarks;
};
FileNames NamesFor(const ShoulderModelOptions& options) {
  const std::string side(Name(options.sides));
  const std::string servos = options.actuation == Actuation::kPosition ? "_position" : "";
  const std::string model = "shoulder_" + side + servos;
  // The skin has its model's name, so that only a newer version of this model replaces it.
  return {model + ".xml",
          "scene" + (options.sides == Sides::kRight ? "" : "_" + side) + servos + ".xml",
          model + ".skn", "landmarks_" + side + ".csv"};
}

// Returns the landmarks of a body with its own bones, as a file to verify the model with. The name
// of the skin's file is left out: equal bodies in different places give equal bytes.
std::string LandmarkFile(const Anatomy& anatomy) {
  std::vector<std::string> comments = {
      "# Landmarks of the shoulder fitted to a skin, as girdle generate wrote them beside "
      "its model.",
      "# Units: meters. Each landmark is given in the ISB frame of its own segment."};
  if (!anatomy.gh_origin.empty()) {
    comments.push_back("# Derived: GH is " + anatomy.gh_origin + ".");
  }
  return LandmarksToCsv(anatomy, comments);
}

// Refuses to replace a file that is read by a file in the output folder.
void ExpectApart(const GenerateArguments& arguments, const std::string& name) {
  ExpectFilesApart({{"--out", (std::filesystem::path(arguments.out) / name).string()}},
                   {{"--table", TableFile(arguments.rhythm.table)},
                    {"--anatomy", arguments.anatomy.file},
                    {"--ellipsoids", arguments.anatomy.ellipsoids},
                    {"--skin", arguments.skin.skin},
                    {"--skin-landmarks", arguments.skin.landmarks},
                    {"--plugin", arguments.plugin}});
}

void Generate(const GenerateArguments& arguments) {
  const ResolvedRhythm rhythm = Resolve(ChoiceFrom(arguments.rhythm));
  ShoulderModelOptions options = ModelOptions(arguments, rhythm);
  const FileNames names = NamesFor(options);
  for (const std::string& name : {names.scene, names.model}) {
    ExpectApart(arguments, name);
  }
  const std::vector<Side> sides = SidesOf(options.sides);
  const std::optional<ChosenBody> body = BodyFor(arguments.skin, arguments.anatomy, sides);
  const bool has_own_bones = body && body->has_own_bones;
  if (body) {
    ExpectApart(arguments, names.skin);
  }
  if (has_own_bones) {
    ExpectApart(arguments, names.landmarks);
  }
  const Anatomy anatomy = body ? body->body.anatomy : ChosenAnatomy(arguments.anatomy);
  std::optional<MadeSkin> skin;
  if (body) {
    skin = SkinOf(*body, sides, names.skin);
    options.skin = skin->element;
  }
  std::vector<std::pair<std::string, std::string>> files = {
      {names.scene, SceneXml(names.model, anatomy, options.sides, skin.has_value())},
      {names.model, ModelXml(rhythm, anatomy, options)}};
  if (skin) {
    files.emplace_back(names.skin, skin->bytes);
  }
  if (has_own_bones) {
    files.emplace_back(names.landmarks, LandmarkFile(anatomy));
  }
  // A model that MuJoCo does not accept is not written.
  const std::string checked = CheckedByMujoco(files, ChosenPlugin(arguments.plugin));
  const std::filesystem::path folder(arguments.out);
  WriteFiles(folder, files);
  const std::string model = (folder / names.model).string();
  const std::string scene = (folder / names.scene).string();
  const std::string skin_file = skin ? (folder / names.skin).string() : "";
  const std::string landmarks = (folder / names.landmarks).string();
  if (arguments.json) {
    nlohmann::ordered_json json;
    json["model"] = model;
    json["scene"] = scene;
    if (skin) json["skin"] = skin_file;
    if (has_own_bones) json["landmarks"] = landmarks;
    if (!anatomy.gh_origin.empty()) json["gh"] = anatomy.gh_origin;
    json["checked"] = checked;
    Print(JsonText(json));
  } else {
    Print("model  " + model + "\nscene  " + scene + "\n" +
          (skin ? "skin   " + skin_file + "\n" : "") + "check  " + checked + "\n");
    if (has_own_bones) {
      Print("bones  those of the skin, written to " + landmarks + "\n");
    }
  }
}

}  // namespace

void AddGenerateCommand(CLI::App& program) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* verb = program.add_subcommand("generate", "A shoulder, or two, as a MuJoCo model");
  verb->add_option("--out", arguments->out, "Folder for the model and its scene")
      ->type_name("DIR")
      ->required();
  verb->add_flag("--json", arguments->json, "Say what was written as JSON");
  {
    const OptionGroup group(*verb, "The shoulder");
    verb->add_option("--side", arguments->side, "right (default), left or both")->type_name("WORD");
    verb->add_option("--assembly", arguments->assembly,
                     "tree (default: the scapula hangs from the clavicle) or loop (both hang from "
                     "the thorax, and a constraint closes the AC joint)")
        ->type_name("WORD");
    verb->add_option("--lead", arguments->lead,
                     "Driven bone of a loop: clavicle (default: its angles are driven and the "
                     "scapula's place "
                     "follows) or scapula (its place is driven and the clavicle follows)")
        ->type_name("WORD");
    verb->add_option("--actuation", arguments->actuation,
                     "plugin (default: commands of elevation, plane and axial turn) or position (a "
                     "native position servo for each coordinate, where no plugin runs)")
        ->type_name("WORD");
    AddAxialFromArgument(*verb, arguments->axial_from,
                         "Zero of the command axial (default rhythm)");
    verb->add_flag("--offsets", arguments->offsets,
                   "With commands for shrug and protraction on top of the rhythm");
    verb->add_flag("--rates", arguments->rates,
                   "With commands for how fast elevation, plane and axial change, which the plugin "
                   "feeds forward so that the joints lag less");
    verb->add_flag("--thorax-contact", arguments->thorax_contact,
                   "With a soft force that keeps the scapula's medial border from sinking into the "
                   "thorax");
  }
  AddRhythmArguments(*verb, arguments->rhythm);
  AddAnatomyArguments(*verb, arguments->anatomy);
  AddSkinArguments(*verb, arguments->skin);
  AddPluginArgument(*verb, arguments->plugin);
  verb->footer(
      "\nExamples:\n  girdle generate --out my_model\n  girdle generate --side both --assembly "
      "loop "
      "--out my_model\n  girdle generate --stature 1.85 --body-mass 80 --out my_model\n"
      "  girdle generate --side both --skin implicit --out my_model");
  verb->callback([arguments] { Generate(*arguments); });
}

}  // namespace girdle
