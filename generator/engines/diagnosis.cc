// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engines/diagnosis.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <system_error>

#include "engines/engine_trial.h"
#include "tables/text_columns.h"

namespace girdle {
namespace {

// A word of a shell's command line.
std::string Quoted(const std::filesystem::path& path) {
  std::string text = path.string();
  const bool is_plain = std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+=:,@%").find(c) != std::string_view::npos;
  });
  if (is_plain && !text.empty()) {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::string InstallLine(const std::filesystem::path& engine, const EngineVersion& version) {
  const std::filesystem::path python = PythonOfEngine(engine);
  return (python.empty() ? "python3" : Quoted(python)) + " -m pip install " + PipPackage(version);
}

// Builds a plugin for the MuJoCo in `root`, in a folder that is looked into the next time.
std::string BuildLine(const std::filesystem::path& checkout, const std::filesystem::path& root,
                      const EngineVersion& version) {
  const std::filesystem::path source = checkout.empty() ? "." : checkout;
  const std::string build = Quoted(source / "build" / ("mujoco-" + Text(version)));
  return "cmake -S " + Quoted(source) + " -B " + build +
         " -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DMUJOCO_ROOT=" + Quoted(root) +
         " && cmake --build " + build + " --target girdle_plugin";
}

// What one types to get a plugin for `engine`, or another engine if there cannot be one.
std::string PluginLine(const std::filesystem::path& engine, const EngineVersion& version,
                       const std::filesystem::path& checkout) {
  const std::filesystem::path root = RootOfEngine(engine);
  return root.empty() ? InstallLine(engine, NewestEngine()) : BuildLine(checkout, root, version);
}

// What one types to make a plugin anew that a build left behind.
std::string RebuildLine(const std::filesystem::path& plugin) {
  const std::filesystem::path folder = plugin.parent_path();
  std::error_code error;
  return std::filesystem::exists(folder / "CMakeCache.txt", error)
             ? "cmake --build " + Quoted(folder)
             : "";
}

// Of the 3.x for who has a 3.x: other packages may need it.
EngineVersion GoodVersionFor(const EngineVersion& version) {
  return version.major < NewestEngine().major ? OldestEngine() : NewestEngine();
}

EngineDiagnosis DiagnoseEngine(const FoundFile& library,
                               const std::vector<PluginDiagnosis>& plugins,
                               const std::string& model, const std::filesystem::path& checkout) {
  EngineDiagnosis engine;
  engine.library = library;
  const Trial opened = OpenEngine(library.file);
  engine.version = opened.version;
  if (!engine.version || !opened.problem.empty()) {
    engine.problem = opened.problem.empty() ? "does not say its version" : opened.problem;
    engine.fix = InstallLine(library.file, NewestEngine());
    if (!PythonOfEngine(library.file).empty()) {
      engine.fix += " --force-reinstall --no-deps";
    }
    return engine;
  }
  engine.problem = WhyRefused(*engine.version);
  if (!engine.problem.empty()) {
    engine.fix = InstallLine(library.file, GoodVersionFor(*engine.version));
    return engine;
  }
  // The first that works, else what the last one said.
  for (const PluginDiagnosis& plugin : plugins) {
    if (plugin.version != engine.version) {
      continue;
    }
    const Trial trial = TryPlugin(library.file, plugin.file, model);
    engine.plugin = plugin.file;
    engine.problem = trial.problem;
    if (trial.problem.empty()) {
      engine.works = true;
      return engine;
    }
  }
  if (engine.plugin.empty()) {
    engine.problem = "no plugin for it";
  }
  engine.fix = PluginLine(library.file, *engine.version, checkout);
  return engine;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string joined;
  for (const std::string& word : words) {
    joined += (joined.empty() ? "" : ", ") + word;
  }
  return joined;
}

std::string VersionText(const std::optional<EngineVersion>& version) {
  return version ? Text(*version) : "?";
}

void AppendRow(std::ostream& out, std::string_view name, const std::string& value) {
  if (!value.empty()) {
    constexpr std::size_t kNameWidth = 12;
    out << "  " << AlignedLeft(std::string(name), kNameWidth) << value << "\n";
  }
}

void AppendTool(std::ostream& out, std::string_view name, const ToolDiagnosis& tool) {
  out << name << "  " << (tool.found.empty() ? "none: " + tool.problem : tool.found) << "\n";
  AppendRow(out, "type", tool.fix);
}

}  // namespace

bool Diagnosis::passed() const {
  return std::any_of(engines.begin(), engines.end(),
                     [](const EngineDiagnosis& engine) { return engine.works; });
}

Diagnosis Diagnose(const std::vector<FoundFile>& engines,
                   const std::vector<std::filesystem::path>& plugins, const std::string& model,
                   const std::filesystem::path& checkout) {
  Diagnosis diagnosis;
  for (const std::filesystem::path& file : plugins) {
    const Trial opened = OpenPlugin(file);
    diagnosis.plugins.push_back({file, opened.version, false, opened.problem,
                                 opened.problem.empty() ? "" : RebuildLine(file)});
  }
  for (const FoundFile& library : engines) {
    diagnosis.engines.push_back(DiagnoseEngine(library, diagnosis.plugins, model, checkout));
  }
  for (PluginDiagnosis& plugin : diagnosis.plugins) {
    plugin.has_engine =
        plugin.version && std::any_of(diagnosis.engines.begin(), diagnosis.engines.end(),
                                      [&](const EngineDiagnosis& engine) {
                                        return engine.version == plugin.version;
                                      });
    if (plugin.version && !plugin.has_engine) {
      plugin.problem = "no MuJoCo of this version here";
      plugin.fix = InstallLine({}, *plugin.version);
    }
  }
  if (diagnosis.engines.empty()) {
    diagnosis.fix =
        checkout.empty() ? InstallLine({}, NewestEngine()) : Quoted(checkout / "scripts" / "setup");
  }
  return diagnosis;
}

std::string DiagnosisAsText(const Diagnosis& diagnosis) {
  std::ostringstream out;
  for (const EngineDiagnosis& engine : diagnosis.engines) {
    out << "MuJoCo " << VersionText(engine.version) << "  "
        << (engine.works ? "works" : engine.problem) << "\n";
    AppendRow(out, "library", engine.library.file.string());
    AppendRow(out, "found by", Joined(engine.library.found_by));
    AppendRow(out, "plugin", engine.plugin.string());
    AppendRow(out, "type", engine.fix);
    out << "\n";
  }
  for (const PluginDiagnosis& plugin : diagnosis.plugins) {
    if (!plugin.problem.empty()) {
      out << "plugin for MuJoCo " << VersionText(plugin.version) << "  " << plugin.problem << "\n";
      AppendRow(out, "plugin", plugin.file.string());
      AppendRow(out, "type", plugin.fix);
      out << "\n";
    }
  }
  for (const std::string& note : diagnosis.notes) {
    out << note << "\n\n";
  }
  AppendTool(out, "pictures", diagnosis.pictures);
  AppendTool(out, "videos", diagnosis.videos);
  out << "\n";
  const auto working = std::count_if(diagnosis.engines.begin(), diagnosis.engines.end(),
                                     [](const EngineDiagnosis& engine) { return engine.works; });
  if (diagnosis.engines.empty()) {
    out << "no MuJoCo found\n";
  } else {
    out << "MuJoCo works with a plugin of Girdle: " << working << " of " << diagnosis.engines.size()
        << " found\n";
  }
  AppendRow(out, "type", diagnosis.fix);
  return out.str();
}

std::string DiagnosisAsJson(const Diagnosis& diagnosis) {
  const auto version = [](const std::optional<EngineVersion>& value) {
    return value ? nlohmann::ordered_json(Text(*value)) : nlohmann::ordered_json();
  };
  nlohmann::ordered_json engines = nlohmann::ordered_json::array();
  for (const EngineDiagnosis& engine : diagnosis.engines) {
    engines.push_back({{"version", version(engine.version)},
                       {"library", engine.library.file.string()},
                       {"found_by", engine.library.found_by},
                       {"works", engine.works},
                       {"plugin", engine.plugin.string()},
                       {"problem", engine.problem},
                       {"fix", engine.fix}});
  }
  nlohmann::ordered_json plugins = nlohmann::ordered_json::array();
  for (const PluginDiagnosis& plugin : diagnosis.plugins) {
    plugins.push_back({{"file", plugin.file.string()},
                       {"version", version(plugin.version)},
                       {"has_engine", plugin.has_engine},
                       {"problem", plugin.problem},
                       {"fix", plugin.fix}});
  }
  const auto tool = [](const ToolDiagnosis& value) {
    return nlohmann::ordered_json(
        {{"found", value.found}, {"problem", value.problem}, {"fix", value.fix}});
  };
  const nlohmann::ordered_json report = {{"passed", diagnosis.passed()},
                                         {"engines", engines},
                                         {"plugins", plugins},
                                         {"pictures", tool(diagnosis.pictures)},
                                         {"videos", tool(diagnosis.videos)},
                                         {"notes", diagnosis.notes},
                                         {"fix", diagnosis.fix}};
  return report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace girdle
