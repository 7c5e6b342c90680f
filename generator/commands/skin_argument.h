// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The options that give a model a skin, and with some skins its bones.
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

/// What stands on the command line; empty where it was not given.
struct SkinArguments {
  std::string skin;
  std::string landmarks;
  std::string head;
};

void AddSkinArguments(CLI::App& verb, SkinArguments& arguments);

/// A body to make a skin of.
struct ChosenBody {
  PosedBody body;
  SkinWeights artist = {};     ///< of SkinBonesOf({right, left}); empty if there was no artist
  bool has_own_bones = false;  ///< whether the body brought its anatomy
  /// What of the command line the body is made of, to stand in messages: `--skin man.glb`. Empty
  /// for the body that is built in.
  std::string source = {};
};

/// Returns the body that was asked for, for a model of these sides: one made of solids about the
/// bones that `anatomy` chooses, a MakeHuman body of a folder or a mesh with landmarks, both of
/// which bring their own bones, with ligaments and gliding ellipsoid to fit; nothing if none was
/// asked for. Throws InputError for a word that is none, options that do not go together, and what
/// is wrong with the files.
[[nodiscard]] std::optional<ChosenBody> BodyFor(const SkinArguments& arguments,
                                                const AnatomyArguments& anatomy,
                                                const std::vector<Side>& sides);

/// A skin to write beside a model.
struct MadeSkin {
  SkinElement element;
  std::string bytes;  ///< of the file
};

/// Returns the body's surface bound to the bones of a model of these sides: by heat, and where
/// there was an artist by 30 % of what the artist chose. Throws InputError if no skin can be made
/// of what the user gave.
[[nodiscard]] BoundSkin BoundTo(const ChosenBody& chosen, const std::vector<Side>& sides);

/// Returns BoundTo as a model's skin, to be written to `file_name` beside the model. Throws as
/// BoundTo.
[[nodiscard]] MadeSkin SkinOf(const ChosenBody& chosen, const std::vector<Side>& sides,
                              const std::string& file_name);

}  // namespace girdle
