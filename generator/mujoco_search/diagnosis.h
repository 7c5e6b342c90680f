// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Which MuJoCo of this machine works with the plugin, and what to type where one does not.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mujoco_search/engine_search.h"

namespace girdle {

/// A library of MuJoCo.
struct EngineDiagnosis {
  FoundEngine library;
  std::string version;  ///< empty if it cannot be opened
  bool works = false;   ///< with the plugin, or with `copy`
  /// The plugin in the library's own folder, which `import mujoco` loads; empty if there is none.
  std::filesystem::path copy;
  std::string problem;  ///< empty if all is well
  std::string fix;      ///< a line for the shell; empty if none is needed or known
  std::string caution;  ///< what to heed where it works; empty if there is nothing
};

/// The plugin that engines are tried with.
struct PluginDiagnosis {
  std::filesystem::path file;  ///< empty if there is none
  std::string version;         ///< of Girdle; empty if it does not tell
  std::string problem;         ///< empty if all is well
};

/// Something that pictures need beside MuJoCo. Without it all else works.
struct ToolDiagnosis {
  std::string found;    ///< what or where it is; empty if there is none
  std::string problem;  ///< empty if it was found
  std::string fix;      ///< a line for the shell; empty if it was found or none is known
};

struct Diagnosis {
  std::vector<EngineDiagnosis> engines;
  PluginDiagnosis plugin;
  /// What was named and holds no MuJoCo, and what did not answer, a sentence each.
  std::vector<std::string> notes;
  ToolDiagnosis pictures;  ///< OpenGL without a screen
  ToolDiagnosis videos;    ///< ffmpeg
  std::string fix;         ///< a line for the shell where there is no MuJoCo at all; else empty
  std::string install;     ///< a line for the shell that puts the plugin into Python's mujoco

  /// At least one MuJoCo works.
  [[nodiscard]] bool passed() const;
};

/// Opens `plugin`, which is empty if there is none, and tries every engine with it and `model`,
/// MJCF text that uses it. `install` is the line that puts the plugin into Python's mujoco.
[[nodiscard]] Diagnosis Diagnose(const std::vector<FoundEngine>& engines,
                                 const std::filesystem::path& plugin, const std::string& model,
                                 const std::string& install);

/// The diagnosis for people: a block a MuJoCo, how to load the plugin, what draws pictures, and a
/// sentence.
[[nodiscard]] std::string DiagnosisAsText(const Diagnosis& diagnosis);

/// The diagnosis as JSON, with a line break after it.
[[nodiscard]] std::string DiagnosisAsJson(const Diagnosis& diagnosis);

/// Returns where Python's package mujoco in the folder `package` has its copy of the plugin, which
/// `import mujoco` loads by itself, or would have it.
[[nodiscard]] std::filesystem::path PluginCopy(const std::filesystem::path& package);

/// Returns `path` as a word of a shell's command line.
[[nodiscard]] std::string ShellWord(const std::filesystem::path& path);

}  // namespace girdle
