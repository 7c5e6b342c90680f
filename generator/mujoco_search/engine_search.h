// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Finding libraries of MuJoCo on this machine.
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

/// A library of MuJoCo, and the names of the places that lead to it.
struct FoundEngine {
  std::filesystem::path file;    ///< with all links resolved
  std::filesystem::path folder;  ///< where the first place has it, perhaps by a link
  std::vector<std::string> found_by;
};

/// Returns each python3 on PATH, or python in a folder that has no python3, the first first. Never
/// one that is relative to the current folder.
[[nodiscard]] std::vector<std::filesystem::path> PythonsOnPath();

/// Runs `python`, isolated from the current folder and from PYTHON... variables, and asks where its
/// package mujoco is, which is not imported. Returns an empty path if it has none; if it does not
/// answer, `problem` says why.
[[nodiscard]] std::filesystem::path PackageOf(const std::filesystem::path& python,
                                              std::string& problem);

/// Returns where this machine may have a MuJoCo, in this order: MUJOCO_ROOT, each python on PATH
/// (which are asked), VIRTUAL_ENV, CONDA_PREFIX, LD_LIBRARY_PATH, PYTHONPATH, what scripts/setup
/// fetched into `checkout` and a .venv there, and the folders where releases are unpacked or
/// installed. In other variables than MUJOCO_ROOT only whole paths count. `checkout` is the folder
/// with Girdle's sources that the program lies in, or empty. Adds a sentence to `notes` for each
/// python that does not answer.
[[nodiscard]] std::vector<Place> EnginePlaces(const std::filesystem::path& checkout,
                                              std::vector<std::string>& notes);

/// Returns the libraries of MuJoCo in `places`, each once. In a folder they may lie as in a release
/// (lib/), in a wheel (mujoco/), in an environment of Python, beside each other, or in a folder
/// that holds one of these.
[[nodiscard]] std::vector<FoundEngine> FindEngines(const std::vector<Place>& places);

/// Returns the Python program whose packages `folder` belongs to, or an empty path.
[[nodiscard]] std::filesystem::path PythonOf(const std::filesystem::path& folder);

}  // namespace girdle
