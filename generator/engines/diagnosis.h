// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Which MuJoCo of this machine works with which plugin, and what to type where none does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engines/engine_search.h"
#include "engines/engine_version.h"

namespace girdle {

/// A library of MuJoCo.
struct EngineDiagnosis {
  FoundFile library;
  std::optional<EngineVersion> version;  ///< nothing if it cannot be opened
  bool works = false;                    ///< with `plugin`
  std::filesystem::path plugin;          ///< empty if there is none for this version
  std::string problem;                   ///< empty if it works
  std::string fix;                       ///< a line for the shell; empty if it works
};

/// A plugin of Girdle.
struct PluginDiagnosis {
  std::filesystem::path file;
  std::optional<EngineVersion> version;  ///< of MuJoCo; nothing if it cannot be opened
  bool has_engine = false;               ///< whether a MuJoCo of this version was found
  std::string problem;                   ///< empty if it has one
  std::string fix;                       ///< a line for the shell; empty if none is known
};

/// Something that pictures need beside MuJoCo. Without it all else works.
struct ToolDiagnosis {
  std::string found;    ///< what or where it is; empty if there is none
  std::string problem;  ///< empty if it was found
  std::string fix;      ///< a line for the shell; empty if it was found or none is known
};

struct Diagnosis {
  std::vector<EngineDiagnosis> engines;
  std::vector<PluginDiagnosis> plugins;
  /// What was named and holds no MuJoCo, a sentence each.
  std::vector<std::string> notes;
  ToolDiagnosis pictures;  ///< OpenGL without a screen
  ToolDiagnosis videos;    ///< ffmpeg
  /// A line for the shell where there is no MuJoCo at all; else empty.
  std::string fix;

  /// At least one MuJoCo works.
  [[nodiscard]] bool passed() const;
};

/// Opens every library and every plugin, and tries those that belong together with `model`, MJCF
/// text that uses the plugin. `checkout` is a folder with Girdle's sources, for the lines that
/// build a plugin, or empty if none is known.
[[nodiscard]] Diagnosis Diagnose(const std::vector<FoundFile>& engines,
                                 const std::vector<std::filesystem::path>& plugins,
                                 const std::string& model, const std::filesystem::path& checkout);

/// The diagnosis for people: a block a MuJoCo, a block a plugin without one, what draws pictures,
/// and a sentence.
[[nodiscard]] std::string DiagnosisAsText(const Diagnosis& diagnosis);

/// The same as JSON, with a line break after it.
[[nodiscard]] std::string DiagnosisAsJson(const Diagnosis& diagnosis);

}  // namespace girdle
