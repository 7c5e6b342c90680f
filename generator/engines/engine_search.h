// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Finding libraries of MuJoCo, and plugins for them, on this machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace girdle {

/// A folder that may hold a MuJoCo, or a library of it, and what names it: "MUJOCO_ROOT".
struct Place {
  std::filesystem::path path;
  std::string name;
};

/// A file with all links resolved, and the names of the places that lead to it.
struct FoundFile {
  std::filesystem::path file;
  std::vector<std::string> found_by;
};

/// Returns where this machine may have a MuJoCo, in this order: MUJOCO_ROOT, each python3 and
/// python on PATH (which are asked), VIRTUAL_ENV, CONDA_PREFIX, .venv and build/python, what
/// scripts/setup fetched into build/engine here or for the program in `program_folder`,
/// LD_LIBRARY_PATH, and the folders where releases are unpacked or installed.
[[nodiscard]] std::vector<Place> EnginePlaces(const std::filesystem::path& program_folder);

/// Returns the libraries of MuJoCo in `places`, each once. In a folder they may lie as in a release
/// (lib/), in a wheel (mujoco/), beside each other, or in a folder that holds one of these.
[[nodiscard]] std::vector<FoundFile> FindEngines(const std::vector<Place>& places);

/// Returns the plugins beside the program, in the folder where an installed program has it, in the
/// builds beside the program's, and where `engines` load plugins from by themselves, each once.
/// `installed_folder` is relative to the program's.
[[nodiscard]] std::vector<std::filesystem::path> FindPlugins(
    const std::filesystem::path& program_folder, const std::filesystem::path& installed_folder,
    const std::vector<FoundFile>& engines);

/// Returns the folder of a MuJoCo with headers that holds `engine`, for MUJOCO_ROOT, or an empty
/// path if there are no headers beside it.
[[nodiscard]] std::filesystem::path RootOfEngine(const std::filesystem::path& engine);

/// Returns the Python program whose packages `engine` belongs to, or an empty path.
[[nodiscard]] std::filesystem::path PythonOfEngine(const std::filesystem::path& engine);

}  // namespace girdle
