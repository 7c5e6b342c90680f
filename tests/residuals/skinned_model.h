// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A model with the skin of the implicit body, both shoulders; position servos follow any rhythm.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "mjcf/shoulder_model.h"
#include "rhythm_tables/built_in_tables.h"
#include "skin/bone_heat.h"
#include "skin/bone_shapes.h"
#include "skin/bound_skin.h"
#include "skin/implicit_body.h"
#include "skin/skin_landmarks.h"
#include "skin/skn_file.h"

namespace girdle {

/// Names and contents of a model's files, the model first.
using ModelFiles = std::vector<std::pair<std::string, std::string>>;

/// The skin as it is bound, and each side's landmarks on it.
struct LandmarkedSkin {
  BoundSkin skin;  ///< in the frame of the thorax [m]
  SkinLandmarkVertices right;
  SkinLandmarkVertices left;
};

[[nodiscard]] inline const LandmarkedSkin& ImplicitSkin() {
  static const LandmarkedSkin kSkin = [] {
    const std::vector<Side> sides = {Side::kRight, Side::kLeft};
    const PosedBody body = ImplicitBody(BuiltInAnatomy(), sides);
    const std::vector<SkinBone> bones = SkinBonesOf(sides);
    return LandmarkedSkin{Bind(body, bones, BoneHeat(body.surface, BoneShapesOf(body, bones))),
                          FindSkinLandmarks(body, Side::kRight),
                          FindSkinLandmarks(body, Side::kLeft)};
  }();
  return kSkin;
}

[[nodiscard]] inline ModelFiles SkinnedModelOf(const LandmarkedSkin& landmarked) {
  constexpr const char* kSkinFile = "skin.skn";
  ShoulderModelOptions options;
  options.sides = Sides::kBoth;
  options.actuation = Actuation::kPosition;
  options.skin = SkinElement{kSkinFile, {landmarked.right, landmarked.left}};
  return {{"shoulder.xml", ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm(), options)},
          {kSkinFile, SknBytes(landmarked.skin)}};
}

[[nodiscard]] inline const ModelFiles& SkinnedModel() {
  static const ModelFiles kFiles = SkinnedModelOf(ImplicitSkin());
  return kFiles;
}

}  // namespace girdle
