// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The files that make up a model on disk.
#pragma once

#include <string>
#include <vector>

namespace girdle {

/// Returns the existing files that an MJCF model names: further models, meshes, skins, height
/// fields and textures. Files that included or attached models name are returned too. A name is
/// looked for in every folder where MuJoCo may look: the folder of the model, the folder of the
/// file that contains the name, and the compiler's `meshdir`, `texturedir` and `assetdir` in both.
/// A file that is not XML names no files.
[[nodiscard]] std::vector<std::string> FilesOfModel(const std::string& model);

}  // namespace girdle
