// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The scene around a model.
#pragma once

#include <string>

#include "anatomy/anatomy.h"
#include "mjcf/shoulder_model.h"

namespace girdle {

/// Returns a scene as XML: floor, lights and the cameras front, back, above and oblique around the
/// model in `model_file`, which it includes and which has these sides. The cameras see the whole
/// shoulder of a person with `anatomy`, and in a model with a skin its hands.
[[nodiscard]] std::string SceneXml(const std::string& model_file, const Anatomy& anatomy,
                                   Sides sides = Sides::kRight, bool has_skin = false);

}  // namespace girdle
