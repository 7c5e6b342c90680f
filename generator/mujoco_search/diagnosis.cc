// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mujoco_search/diagnosis.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <system_error>

#include "mujoco_search/engine_trial.h"
#include "text/json_text.h"
#include "text/same_bytes.h"
#include "text/split.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

EngineDiagnosis DiagnoseEngine(const FoundEngine& library, const std::filesystem::path& plugin,
                               const std::string& model, const std::string& install) {
  const Trial trial = TryEngine(library.file, plugin, model);
  EngineDiagnosis engine;
  engine.library = library;
  engine.version = trial.answer;
  engine.works = trial.problem.empty();
  engine.problem = trial.problem;
  if (engine.works && engine.version == "4.0.0") {
    engine.caution =
        "solves models of 60 degrees of freedom or more wrongly without <option "
        "jacobian=\"dense\"/>";
  }
  const std::filesystem::path python = PythonOf(library.folder);
  if (engine.version.empty() && !python.empty()) {
    engine.fix = ShellWord(python) + " -m pip install --force-reinstall mujoco";
  }
  std::error_code error;
  const std::filesystem::path copy = PluginCopy(library.folder);
  if (!std::filesystem::is_regular_file(copy, error)) {
    return engine;
  }
  engine.copy = copy;
  if (HaveTheSameBytes(plugin, copy)) {
    return engine;
  }
  if (engine.works) {
    engine.problem = "the plugin that `import mujoco` loads differs from this one";
    engine.fix = install + " --engine " + ShellWord(library.folder);
  } else if (TryEngine(library.file, copy, model).problem.empty()) {
    engine.works = true;
    engine.problem =
        "with the plugin that `import mujoco` loads, not with this one: " + trial.problem;
  }
  return engine;
}

void AppendRow(std::ostream& out, std::string_view name, const std::string& value) {
  if (!value.empty()) {
    constexpr std::size_t kNameWidth = 12;
    out << "  " << AlignedLeft(std::string(name), kNameWidth) << value << "\n";
  }
}

void AppendEngine(std::ostream& out, const EngineDiagnosis& engine) {
  out << "MuJoCo " << (engine.version.empty() ? "?" : engine.version) << "  "
      << (engine.works ? "works" : "") << (engine.works && !engine.problem.empty() ? "; " : "")
      << engine.problem << "\n";
  AppendRow(out, "heed", engine.caution);
  AppendRow(out, "library", engine.library.file.string());
  AppendRow(out, "found by", Joined(engine.library.found_by));
  AppendRow(out, "installed", engine.copy.string());
  AppendRow(out, "type", engine.fix);
  out << "\n";
}

void AppendPlugin(std::ostream& out, const Diagnosis& diagnosis) {
  const PluginDiagnosis& plugin = diagnosis.plugin;
  if (plugin.file.empty()) {
    out << "plugin  none: " << plugin.problem << "\n\n";
    return;
  }
  const std::string file = nlohmann::json(plugin.file.string())
                               .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  out << "plugin  " << (plugin.problem.empty() ? "of Girdle " + plugin.version : plugin.problem)
      << "\n";
  AppendRow(out, "library", plugin.file.string());
  if (!plugin.problem.empty()) {
    if (plugin.problem.starts_with("has no ")) {
      out << "  This is not Girdle's plugin. Name libgirdle_rhythm.so, which scripts/run builds, "
             "with "
             "--plugin.\n";
    }
    out << "\n";
    return;
  }
  out << "  \"plugin girdle.rhythm not found\" means that nothing loaded it. Load it before the "
         "model:\n";
  AppendRow(out, "Python", "mujoco.mj_loadPluginLibrary(" + file + ")");
  AppendRow(out, "C", "mj_loadPluginLibrary(" + file + ");");
  out << "  or let every `import mujoco` of a Python load it:\n";
  AppendRow(out, "type", diagnosis.install);
  out << "\n";
}

void AppendTool(std::ostream& out, std::string_view name, const ToolDiagnosis& tool) {
  out << name << "  " << (tool.found.empty() ? "none: " + tool.problem : tool.found) << "\n";
  AppendRow(out, "type", tool.fix);
}

}  // namespace

std::filesystem::path PluginCopy(const std::filesystem::path& package) {
  return package / "plugin" / "libgirdle_rhythm.so";
}

std::string ShellWord(const std::filesystem::path& path) {
  std::string text = path.string();
  if (text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                             "/._-+=:,@%") == std::string::npos) {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

bool Diagnosis::passed() const {
  return std::any_of(engines.begin(), engines.end(),
                     [](const EngineDiagnosis& engine) { return engine.works; });
}

Diagnosis Diagnose(const std::vector<FoundEngine>& engines, const std::filesystem::path& plugin,
                   const std::string& model, const std::string& install) {
  Diagnosis diagnosis;
  diagnosis.install = install;
  if (plugin.empty()) {
    diagnosis.plugin.problem = "this program was built without MuJoCo, and so without a plugin";
  } else {
    const Trial opened = OpenPlugin(plugin);
    diagnosis.plugin = {plugin, opened.answer, opened.problem};
  }
  for (const FoundEngine& library : engines) {
    diagnosis.engines.push_back(DiagnoseEngine(library, plugin, model, install));
  }
  return diagnosis;
}

std::string DiagnosisAsText(const Diagnosis& diagnosis) {
  std::ostringstream out;
  for (const EngineDiagnosis& engine : diagnosis.engines) {
    AppendEngine(out, engine);
  }
  for (const std::string& note : diagnosis.notes) {
    out << note << "\n\n";
  }
  AppendPlugin(out, diagnosis);
  AppendTool(out, "pictures", diagnosis.pictures);
  AppendTool(out, "videos", diagnosis.videos);
  const auto working = std::count_if(diagnosis.engines.begin(), diagnosis.engines.end(),
                                     [](const EngineDiagnosis& engine) { return engine.works; });
  if (diagnosis.engines.empty()) {
    out << "\nno MuJoCo found\n";
  } else {
    out << "\nMuJoCo works with the plugin: " << working << " of " << diagnosis.engines.size()
        << " found\n";
  }
  AppendRow(out, "type", diagnosis.fix);
  return out.str();
}

std::string DiagnosisAsJson(const Diagnosis& diagnosis) {
  using Json = nlohmann::ordered_json;
  const auto version = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  Json engines = Json::array();
  for (const EngineDiagnosis& engine : diagnosis.engines) {
    engines.push_back({{"version", version(engine.version)},
                       {"library", engine.library.file.string()},
                       {"found_by", engine.library.found_by},
                       {"works", engine.works},
                       {"installed", engine.copy.string()},
                       {"problem", engine.problem},
                       {"fix", engine.fix},
                       {"caution", engine.caution}});
  }
  const auto tool = [](const ToolDiagnosis& value) {
    return Json({{"found", value.found}, {"problem", value.problem}, {"fix", value.fix}});
  };
  const Json report = {{"passed", diagnosis.passed()},
                       {"engines", engines},
                       {"plugin",
                        {{"file", diagnosis.plugin.file.string()},
                         {"version", version(diagnosis.plugin.version)},
                         {"problem", diagnosis.plugin.problem}}},
                       {"pictures", tool(diagnosis.pictures)},
                       {"videos", tool(diagnosis.videos)},
                       {"notes", diagnosis.notes},
                       {"fix", diagnosis.fix},
                       {"install", diagnosis.install}};
  return JsonText(report);
}

}  // namespace girdle
