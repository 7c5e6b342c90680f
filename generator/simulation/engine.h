// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// MuJoCo with objects that have owners, and with errors and warnings as exceptions.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "text/input_error.h"

namespace girdle {

struct ModelDeleter {
  void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const noexcept { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, ModelDeleter>;
using DataPointer = std::unique_ptr<mjData, DataDeleter>;

/// An error that MuJoCo reports in its own words, which do not say what the user can change. Who
/// calls MuJoCo says in which model it happened, and what to do.
class EngineError : public InputError {
  using InputError::InputError;
};

/// While this object lives, errors of MuJoCo become exceptions, and its warnings are collected. An
/// error is EngineError, or std::bad_alloc if there is not enough memory. A process may have one
/// such object at a time.
class EngineWatch {
 public:
  EngineWatch();
  EngineWatch(const EngineWatch&) = delete;
  EngineWatch& operator=(const EngineWatch&) = delete;
  ~EngineWatch();

  /// Returns MuJoCo's warnings since the last call, or an empty text.
  static std::string TakeWarnings();

  /// Throws InputError with the warnings since the last call, if there were any. `doing` describes
  /// what was being done.
  static void ExpectNoWarning(const std::string& doing);

  /// Returns what the plugin has reported about a compiled model since the last call, or an empty
  /// text. ExpectNoWarning does not count it as a warning, because such a model steps, and a report
  /// says how it moves.
  static std::string TakeModelFault();

 private:
  void (*previous_error_)(const char*);
  void (*previous_warning_)(const char*);
};

/// Loads the engine plugin as any user of MuJoCo does. Throws InputError if it cannot be loaded or
/// does not support this MuJoCo.
void LoadPlugin(const std::string& path);

/// Loads a model from an MJCF file or a binary MJB file. Throws InputError with MuJoCo's reason,
/// and if the model is too large (xml_model.h) or would crash this process (binary_model.h). Call
/// this only while this process has one thread.
[[nodiscard]] ModelPointer LoadModel(const std::string& path);

/// Files of a model that is not on disk: name and text.
using ModelFiles = std::vector<std::pair<std::string, std::string>>;

/// Loads the first of `files`, an MJCF model that may include the others. Throws InputError with
/// MuJoCo's reason.
[[nodiscard]] ModelPointer LoadModel(const ModelFiles& files);

/// Makes the data of a model. Throws std::bad_alloc if there is not enough memory.
[[nodiscard]] DataPointer MakeData(const mjModel& model);

}  // namespace girdle
