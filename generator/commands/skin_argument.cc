// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/skin_argument.h"

#include "skin/bone_heat.h"
#include "skin/bound_skin.h"
#include "skin/implicit_body.h"
#include "skin/skin_landmarks.h"
#include "skin/skn_file.h"
#include "tables/input_error.h"

namespace girdle {
namespace {

constexpr const char* kImplicit = "implicit";

}  // namespace

void AddSkinArgument(CLI::App& verb, SkinArgument& argument) {
  verb.add_option("--skin", argument.skin, "With a skin: implicit (a body made of solids)")
      ->type_name("WORD");
}

std::optional<MadeSkin> ChosenSkin(const SkinArgument& argument, const Anatomy& anatomy,
                                   const std::vector<Side>& sides, const std::string& file_name) {
  if (argument.skin.empty()) {
    return std::nullopt;
  }
  if (argument.skin != kImplicit) {
    throw InputError("--skin '" + argument.skin + "': not known. Give implicit");
  }
  const PosedBody body = ImplicitBody(anatomy, sides);
  const std::vector<SkinBone> bones = SkinBonesOf(sides);
  const SkinWeights weights = BoneHeat(body.surface, BoneShapesOf(body, bones));
  MadeSkin made{{file_name, {}}, SknBytes(Bind(body, bones, weights))};
  for (const Side side : sides) {
    made.element.landmarks.push_back(FindSkinLandmarks(body, side));
  }
  return made;
}

}  // namespace girdle
