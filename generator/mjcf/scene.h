// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The scene around a model.
#pragma once

#include <string>

#include "anatomy/anatomy.h"
#include "mjcf/shoulder_model.h"

namespace girdle {

/// Returns a scene as XML. It has floor, lights and the cameras front, back, above and oblique, and
/// it includes the model in `model_file`. `sides` are the model's sides. The cameras see the whole
/// shoulder of a person with `anatomy`, and also the hands if the model has a skin.
[[nodiscard]] std::string SceneXml(const std::string& model_file, const Anatomy& anatomy,
                                   Sides sides = Sides::kRight, bool has_skin = false);

}  // namespace girdle
