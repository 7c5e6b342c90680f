// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mujoco_search/engine_trial.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "child_programs/child_process.h"
#include "names/model_names.h"
#include "plugin/version_symbol.h"

namespace girdle {
namespace {

// A generous limit: a trial takes milliseconds.
constexpr int kLimit_s = 30;
constexpr int kSteps = 10;
// Makes mj_getState write the time alone (mjSTATE_TIME).
constexpr int kTimeOnly = 1;

// The lines that a child writes begin with one of these words.
constexpr std::string_view kAnswer = "answer ";
constexpr std::string_view kProblem = "problem ";
constexpr std::string_view kDone = "done";  // all of the work
constexpr std::size_t kLongestLine = 1000;  // bytes; MuJoCo's messages are no longer

using Write = std::function<void(std::string_view)>;

// Returns a text without line breaks and other characters that control a terminal.
std::string OneLine(std::string text) {
  text.resize(std::min(text.size(), kLongestLine));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

void WriteLine(const Write& write, std::string_view word, const std::string& text) {
  write(std::string(word) + OneLine(text) + "\n");
}

// A library of this process, opened by its file.
class Library {
 public:
  explicit Library(const std::filesystem::path& file)
      : handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) {
      throw std::runtime_error("cannot be opened: " + std::string(dlerror()));
    }
  }

  template <typename Symbol>
  [[nodiscard]] Symbol* Get(const char* name) const {
    auto* symbol = reinterpret_cast<Symbol*>(dlsym(handle_, name));
    if (symbol == nullptr) {
      throw std::runtime_error("has no " + std::string(name));
    }
    return symbol;
  }

 private:
  void* handle_;
};

// Set in children only: MuJoCo gives its handlers no context.
Write on_warning;  // NOLINT(readability-identifier-naming)

void OnWarning(const char* message) { WriteLine(on_warning, kProblem, message); }

// A handler of errors must not return.
void OnError(const char* message) { throw std::runtime_error(message); }

using MessageHandler = void (*)(const char*);

void StepModel(const Library& engine, const std::string& text) {
  std::array<char, 1024> error{};
  auto* spec = engine.Get<void*(const char*, const void*, char*, int)>("mj_parseXMLString")(
      text.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  if (spec == nullptr) {
    throw std::runtime_error("cannot read a model: " + std::string(error.data()));
  }
  void* model = engine.Get<void*(void*, const void*)>("mj_compile")(spec, nullptr);
  if (model == nullptr) {
    throw std::runtime_error("cannot load a model: " +
                             std::string(engine.Get<const char*(void*)>("mjs_getError")(spec)));
  }
  void* data = engine.Get<void*(const void*)>("mj_makeData")(model);
  if (data == nullptr) {
    throw std::runtime_error("cannot make the state of a model");
  }
  auto* step = engine.Get<void(const void*, void*)>("mj_step");
  for (int i = 0; i < kSteps; ++i) {
    step(model, data);
  }
  double time_s = 0;
  engine.Get<void(const void*, const void*, double*, int)>("mj_getState")(model, data, &time_s,
                                                                          kTimeOnly);
  if (!(time_s > 0)) {
    throw std::runtime_error("does not step a model");
  }
}

// Runs `work` in a child and reads its lines.
Trial TrialOf(const std::function<void(const Write&)>& work) {
  const ChildResult child = RunInChild(
      [&](const Write& write) {
        try {
          work(write);
          WriteLine(write, kDone, "");
        } catch (const std::exception& error) {
          WriteLine(write, kProblem, error.what());
        }
      },
      {.time_s = kLimit_s});
  Trial trial;
  bool is_done = false;
  std::istringstream lines(child.output);
  for (std::string line; std::getline(lines, line);) {
    is_done = is_done || line == kDone;
    for (const auto& [word, text] :
         {std::pair(kAnswer, &trial.answer), {kProblem, &trial.problem}}) {
      if (line.starts_with(word) && text->empty()) {
        *text = OneLine(line.substr(word.size()));
      }
    }
  }
  if (!child.failure.empty()) {
    trial.problem += (trial.problem.empty() ? "" : "; ") + child.failure;
  } else if (trial.problem.empty() && !is_done) {
    trial.problem = "ended the process that tried it";
  }
  return trial;
}

int FindMujoco(dl_phdr_info* info, std::size_t /*size*/, void* path) {
  const std::filesystem::path file = info->dlpi_name;
  if (!file.filename().string().starts_with("libmujoco.so")) {
    return 0;
  }
  *static_cast<std::string*>(path) = file.string();
  return 1;
}

}  // namespace

Trial TryEngine(const std::filesystem::path& engine, const std::filesystem::path& plugin,
                const std::string& model) {
  return TrialOf([&](const Write& write) {
    const Library library(engine);
    WriteLine(write, kAnswer, library.Get<const char*()>("mj_versionString")());
    if (plugin.empty()) {
      throw std::runtime_error("there is no plugin to try it with");
    }
    on_warning = write;
    *library.Get<MessageHandler>("mju_user_warning") = OnWarning;
    *library.Get<MessageHandler>("mju_user_error") = OnError;
    library.Get<void(const char*)>("mj_loadPluginLibrary")(plugin.c_str());
    if (library.Get<const void*(const char*, int*)>("mjp_getPlugin")(kPluginName, nullptr) ==
        nullptr) {
      throw std::runtime_error("registers no plugin " + std::string(kPluginName));
    }
    StepModel(library, model);
  });
}

Trial OpenPlugin(const std::filesystem::path& plugin) {
  return TrialOf([&](const Write& write) {
    WriteLine(write, kAnswer, Library(plugin).Get<const char*()>(kPluginVersionSymbol)());
  });
}

Trial OpenModule(const std::filesystem::path& module) {
  return TrialOf([&](const Write& write) {
    const Library library(module);
    std::string path;
    dl_iterate_phdr(FindMujoco, &path);
    if (!std::filesystem::path(path).is_absolute()) {
      throw std::runtime_error("loads no libmujoco.so by a whole path");
    }
    WriteLine(write, kAnswer, path);
  });
}

}  // namespace girdle
