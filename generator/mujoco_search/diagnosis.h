// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Diagnosis of each MuJoCo on this machine: whether it works with the plugin, and a fix if not.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mujoco_search/engine_search.h"

namespace girdle {

/// Diagnosis of one library of MuJoCo.
struct EngineDiagnosis {
  FoundEngine library;
  std::string version;  ///< empty if it cannot be opened
  bool works = false;   ///< whether it works with the plugin, or with `copy`
  /// The plugin in the library's own folder, which `import mujoco` loads; empty if there is none.
  std::filesystem::path copy;
  std::string problem;  ///< empty if all is well
  std::string fix;      ///< a line for the shell; empty if none is needed or known
  std::string caution;  ///< advice for a MuJoCo that works; empty if there is none
};

/// Diagnosis of the plugin that engines are tried with.
struct PluginDiagnosis {
  std::filesystem::path file;  ///< empty if there is none
  std::string version;         ///< version of Girdle; empty if the plugin does not answer
  std::string problem;         ///< empty if all is well
};

/// Diagnosis of something else that pictures need. Without it, all but pictures and videos works.
struct ToolDiagnosis {
  std::string found;    ///< its name or path; empty if there is none
  std::string problem;  ///< empty if it was found
  std::string fix;      ///< a line for the shell; empty if it was found or none is known
};

struct Diagnosis {
  std::vector<EngineDiagnosis> engines;
  PluginDiagnosis plugin;
  /// A sentence for each named place without a MuJoCo and for each python that did not answer.
  std::vector<std::string> notes;
  ToolDiagnosis pictures;  ///< OpenGL without a screen
  ToolDiagnosis videos;    ///< ffmpeg
  std::string fix;         ///< a line for the shell if there is no MuJoCo at all; else empty
  std::string install;     ///< a line for the shell that puts the plugin into Python's mujoco

  /// Returns whether at least one MuJoCo works.
  [[nodiscard]] bool passed() const;
};

/// Opens `plugin` (empty if there is none), and tries every engine with it and with `model`, MJCF
/// text that uses it. `install` is the line that puts the plugin into Python's mujoco.
[[nodiscard]] Diagnosis Diagnose(const std::vector<FoundEngine>& engines,
                                 const std::filesystem::path& plugin, const std::string& model,
                                 const std::string& install);

/// Returns the diagnosis for people: a block for each MuJoCo, how to load the plugin, the means of
/// drawing pictures, and a sentence.
[[nodiscard]] std::string DiagnosisAsText(const Diagnosis& diagnosis);

/// Returns the diagnosis as JSON, with a line break at its end.
[[nodiscard]] std::string DiagnosisAsJson(const Diagnosis& diagnosis);

/// Returns the path of the plugin's copy in `package`, the folder of Python's package mujoco,
/// whether or not the copy exists. `import mujoco` loads a copy there by itself.
[[nodiscard]] std::filesystem::path PluginCopy(const std::filesystem::path& package);

/// Returns `path` quoted as one word of a shell's command line.
[[nodiscard]] std::string ShellWord(const std::filesystem::path& path);

}  // namespace girdle
