// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Search for libraries of MuJoCo on this machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace girdle {

/// A folder that may hold a MuJoCo, or a library of it, and the name of its source: "MUJOCO_ROOT".
struct Place {
  std::filesystem::path path;
  std::string name;
};

/// A library of MuJoCo, and the names of the places that lead to it.
struct FoundEngine {
  std::filesystem::path file;    ///< with all links resolved
  std::filesystem::path folder;  ///< folder of the first place that has it, possibly through a link
  std::vector<std::string> found_by;
};

/// Returns the python3 of each folder on PATH, or its python if it has no python3, in the order of
/// PATH. Folders that are relative to the current folder are left out.
[[nodiscard]] std::vector<std::filesystem::path> PythonsOnPath();

/// Returns the folder of the package mujoco of `python`, or an empty path if it has none. Runs
/// `python` without the current folder and PYTHON... variables; the package is not imported. If
/// `python` does not answer, `problem` is the reason.
[[nodiscard]] std::filesystem::path PackageOf(const std::filesystem::path& python,
                                              std::string& problem);

/// Returns the places where this machine may have a MuJoCo, in this order: MUJOCO_ROOT, each python
/// on PATH (which is run), VIRTUAL_ENV, CONDA_PREFIX, LD_LIBRARY_PATH, PYTHONPATH, the MuJoCo that
/// scripts/setup fetched into `checkout` and a .venv there, and the folders where releases are
/// unpacked or installed.
///
/// Relative paths count in MUJOCO_ROOT only. `checkout` is the folder with Girdle's sources that
/// the program lies in, or empty. Adds a sentence to `notes` for each python that does not answer.
[[nodiscard]] std::vector<Place> EnginePlaces(const std::filesystem::path& checkout,
                                              std::vector<std::string>& notes);

/// Returns the libraries of MuJoCo in `places`, each once. In a folder, a library may be where a
/// release (lib/), a wheel (mujoco/) or a Python environment has it, directly in the folder, or in
/// a subfolder that holds one of these.
[[nodiscard]] std::vector<FoundEngine> FindEngines(const std::vector<Place>& places);

/// Returns the Python program that uses the packages in `folder`, or an empty path.
[[nodiscard]] std::filesystem::path PythonOf(const std::filesystem::path& folder);

}  // namespace girdle
