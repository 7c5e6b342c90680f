// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The option that gives a model a skin.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model_names.h"
#include "mjcf/shoulder_model.h"
#include "skin/posed_body.h"

namespace girdle {

/// What stands on the command line; empty where it was not given.
struct SkinArgument {
  std::string skin;
};

void AddSkinArgument(CLI::App& verb, SkinArgument& argument);

/// A skin to write beside a model.
struct MadeSkin {
  SkinElement element;
  std::string bytes;  ///< of the file
};

/// Returns the skin of a model with this anatomy and these sides, named after the model's file;
/// nothing if none was asked for. Throws InputError for a word that is none.
[[nodiscard]] std::optional<MadeSkin> ChosenSkin(const SkinArgument& argument,
                                                 const Anatomy& anatomy,
                                                 const std::vector<Side>& sides,
                                                 const std::string& file_name);

}  // namespace girdle
