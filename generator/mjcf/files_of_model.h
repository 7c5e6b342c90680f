// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The files that a model on disk is made of.
#pragma once

#include <string>
#include <vector>

namespace girdle {

/// Returns the files that are there of those that an MJCF model names, and that models which it
/// includes or attaches name: further models, meshes, skins, height fields and textures. A name
/// counts in every folder where MuJoCo may look: that of the model, that of the file that has the
/// name, and the compiler's `meshdir`, `texturedir` and `assetdir` in either. A file that is no XML
/// names none.
[[nodiscard]] std::vector<std::string> FilesOfModel(const std::string& model);

}  // namespace girdle
