// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/skin_argument.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "anatomy/built_in_anatomy.h"
#include "commands/option_group.h"
#include "commands/word_argument.h"
#include "rhythm_tables/built_in_tables.h"
#include "skin/fitted_body.h"
#include "skin/implicit_body.h"
#include "skin/makehuman_body.h"
#include "skin/person_body.h"
#include "skin/skin_landmarks.h"
#include "skin/skn_file.h"
#include "skin/weight_blend.h"
#include "text/input_error.h"
#include "text/near_names.h"
#include "text/small_letters.h"

namespace girdle {
namespace {

constexpr const char* kImplicitWord = "implicit";
constexpr std::array<std::string_view, 3> kMeshSuffixes = {".glb", ".gltf", ".obj"};

// Weights of heat alone make the border of the scapula too sharp. Weights of the artist alone
// hardly move skin with clavicle and scapula.
constexpr double kArtistShare = 0.3;
constexpr int kSmoothingSteps = 3;

enum class Source { kImplicit, kFolder, kMesh };

bool HasMeshSuffix(const std::string& path) {
  const std::string suffix = InSmallLetters(std::filesystem::path(path).extension().string());
  return std::find(kMeshSuffixes.begin(), kMeshSuffixes.end(), suffix) != kMeshSuffixes.end();
}

Source SourceOf(const std::string& skin) {
  if (skin == kImplicitWord) return Source::kImplicit;
  std::error_code ignored;
  if (std::filesystem::is_directory(skin, ignored)) return Source::kFolder;
  if (HasMeshSuffix(skin)) return Source::kMesh;
  throw InputError("--skin '" + skin +
                   "': neither the word implicit, nor a folder, nor a mesh (.glb, .gltf, .obj). " +
                   DidYouMean(skin, std::array{std::string_view(kImplicitWord)}) +
                   "scripts/fetch_body fetches a body into the folder build/body");
}

// Refuses options that do not apply to this kind of skin.
void ExpectFitting(Source source, const SkinArguments& arguments, const AnatomyArguments& anatomy) {
  if (!arguments.landmarks.empty() && source != Source::kMesh) {
    throw InputError("--skin-landmarks " + arguments.landmarks + ": --skin " + arguments.skin +
                     " has bones already. Omit it, or give a mesh with --skin");
  }
  if (arguments.landmarks.empty() && source == Source::kMesh) {
    throw InputError("--skin " + arguments.skin +
                     ": where the bones are in a mesh cannot be seen. Add --skin-landmarks FILE, "
                     "landmarks of the right shoulder in the mesh's coordinates, in the format of "
                     "data/example_lab_landmarks.csv");
  }
  if (!arguments.head.empty() && source != Source::kFolder) {
    throw InputError("--head " + arguments.head + ": only for the body of a folder. Omit it");
  }
  if (source != Source::kImplicit && IsAnatomyChosen(anatomy)) {
    throw InputError(
        "--skin " + arguments.skin +
        ": bones fitted to that body are its own. Leave out --anatomy, --ellipsoids and "
        "all measures of a body, or choose --skin implicit, which is made about the "
        "bones");
  }
}

// Returns the result of `make`. A fault of the surface is a std::invalid_argument. If the surface
// came from the user's `source`, it becomes an InputError; otherwise it is a fault of Girdle.
template <typename Make>
auto OrBlame(const std::string& source, const Make& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    if (source.empty()) {
      throw;
    }
    throw InputError(source + ": " + error.what());
  }
}

ChosenBody MadeBody(Source source, const SkinArguments& arguments, const AnatomyArguments& anatomy,
                    const std::vector<Side>& sides) {
  if (source == Source::kImplicit) {
    return ChosenBody{ImplicitBody(ChosenAnatomy(anatomy), sides)};
  }
  ChosenBody chosen;
  chosen.has_own_bones = true;
  if (source == Source::kFolder) {
    Head head = Head::kKept;
    ChooseWord("--head", arguments.head, head);
    FittedBody fitted = FitBones(ReadMakeHumanMan(arguments.skin), BuiltInMakeHumanFit(),
                                 BuiltInAnatomy(), RelaxedStanding(), BuiltInRhythm(), head);
    chosen.body = std::move(fitted.body);
    chosen.artist = std::move(fitted.artist);
  } else {
    chosen.body = ReadPersonBody(arguments.skin, arguments.landmarks, BuiltInAnatomy(), sides);
    SayHowGhWasFound(arguments.landmarks, chosen.body.anatomy);
  }
  FitTissues(chosen.body.anatomy);
  return chosen;
}

}  // namespace

void AddSkinArguments(CLI::App& verb, SkinArguments& arguments) {
  const OptionGroup group(verb, "The skin");
  verb.add_option("--skin", arguments.skin,
                  "With a skin: implicit (a body made of solids about the bones), a FOLDER (a "
                  "man by MakeHuman, which scripts/fetch_body fetches into build/body) or a MESH "
                  "(.glb, .gltf, .obj: closed, in meters); bones are fitted to the latter two")
      ->type_name("WORD|FOLDER|MESH");
  verb.add_option("--skin-landmarks", arguments.landmarks,
                  "Landmarks of the person whose mesh it is: a CSV in the mesh's coordinates, with "
                  "'lab' as "
                  "the segment of every row, as in data/example_lab_landmarks.csv")
      ->type_name("FILE");
  verb.add_option("--head", arguments.head, "Head of a folder's body: keep (default) or cut")
      ->type_name("WORD");
}

std::optional<ChosenBody> BodyFor(const SkinArguments& arguments, const AnatomyArguments& anatomy,
                                  const std::vector<Side>& sides) {
  if (arguments.skin.empty()) {
    if (!arguments.landmarks.empty() || !arguments.head.empty()) {
      throw InputError(arguments.landmarks.empty()
                           ? "--head " + arguments.head + ": add --skin FOLDER"
                           : "--skin-landmarks " + arguments.landmarks + ": add --skin MESH");
    }
    return std::nullopt;
  }
  const Source source = SourceOf(arguments.skin);
  ExpectFitting(source, arguments, anatomy);
  const bool is_built_in = source == Source::kImplicit && !IsAnatomyChosen(anatomy);
  const std::string given = is_built_in ? "" : "--skin " + arguments.skin;
  return OrBlame(given, [&] {
    ChosenBody chosen = MadeBody(source, arguments, anatomy, sides);
    chosen.source = given;
    return chosen;
  });
}

BoundSkin BoundTo(const ChosenBody& chosen, const std::vector<Side>& sides) {
  return OrBlame(chosen.source, [&] {
    const PosedBody& body = chosen.body;
    const std::vector<SkinBone> bones = SkinBonesOf(sides);
    SkinWeights weights = BoneHeat(body.surface, BoneShapesOf(body, bones));
    if (!chosen.artist.empty()) {
      const SkinWeights artist =
          SharesOf(bones, SkinBonesOf({Side::kRight, Side::kLeft}), chosen.artist);
      weights = Smoothed(body.surface, Mixed(weights, artist, kArtistShare), kSmoothingSteps);
    }
    return Bind(body, bones, weights);
  });
}

MadeSkin SkinOf(const ChosenBody& chosen, const std::vector<Side>& sides,
                const std::string& file_name) {
  // No braced list here: if the second part throws, GCC 12 destroys the first one twice.
  MadeSkin made;
  made.element.file = file_name;
  made.bytes = SknBytes(BoundTo(chosen, sides));
  return OrBlame(chosen.source, [&] {
    for (const Side side : sides) {
      made.element.landmarks.push_back(FindSkinLandmarks(chosen.body, side));
    }
    return std::move(made);
  });
}

}  // namespace girdle
