// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The options that give a model a skin and, with some skins, its bones.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "commands/anatomy_arguments.h"
#include "mjcf/shoulder_model.h"
#include "names/model_names.h"
#include "skin/bone_heat.h"
#include "skin/bound_skin.h"
#include "skin/posed_body.h"

namespace girdle {

/// The options as given on the command line; empty where not given.
struct SkinArguments {
  std::string skin;
  std::string landmarks;
  std::string head;
};

void AddSkinArguments(CLI::App& verb, SkinArguments& arguments);

/// A body to make a skin of.
struct ChosenBody {
  PosedBody body;
  SkinWeights artist = {};     ///< of SkinBonesOf({right, left}); empty if no artist made any
  bool has_own_bones = false;  ///< whether the anatomy comes with the body
  /// The option and value that the body comes from, for messages: `--skin man.glb`. Empty for the
  /// built-in body.
  std::string source = {};
};

/// Returns the body that the options choose, for a model of these sides; nothing if they choose
/// none.
///
/// A body is made of solids about the bones of the anatomy that `anatomy` chooses, or it is read
/// from a MakeHuman folder, or it is a mesh with landmarks. The last two bring their own bones, to
/// which ligaments and the gliding ellipsoid are fitted. Throws InputError for an unknown word, for
/// options that exclude each other, and for faults of the files.
[[nodiscard]] std::optional<ChosenBody> BodyFor(const SkinArguments& arguments,
                                                const AnatomyArguments& anatomy,
                                                const std::vector<Side>& sides);

/// A skin to write beside a model.
struct MadeSkin {
  SkinElement element;
  std::string bytes;  ///< of the file
};

/// Returns the body's surface bound to the bones of a model of these sides. The weights are those
/// of heat; if the body has weights of an artist, these have a share of 30 %. Throws InputError if
/// no skin can be made from the user's files.
[[nodiscard]] BoundSkin BoundTo(const ChosenBody& chosen, const std::vector<Side>& sides);

/// Returns BoundTo as a model's skin, to be written to `file_name` beside the model. Throws as
/// BoundTo.
[[nodiscard]] MadeSkin SkinOf(const ChosenBody& chosen, const std::vector<Side>& sides,
                              const std::string& file_name);

}  // namespace girdle
