// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// MuJoCo with owned objects and with errors and warnings that cannot be overlooked.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace girdle {

struct ModelDeleter {
  void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const noexcept { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, ModelDeleter>;
using DataPointer = std::unique_ptr<mjData, DataDeleter>;

/// Makes MuJoCo's errors InputErrors, or std::bad_alloc where it gets no memory, and collects its
/// warnings, for the life of the object. One at a time in a process.
class EngineWatch {
 public:
  EngineWatch();
  EngineWatch(const EngineWatch&) = delete;
  EngineWatch& operator=(const EngineWatch&) = delete;
  ~EngineWatch();

  /// Throws InputError with the warnings since the last call, if there were any. `doing` says what
  /// was going on.
  static void ExpectNoWarning(const std::string& doing);

  /// Returns what the plugin has said of a compiled model since the last call, or nothing. That is
  /// no warning to ExpectNoWarning: such a model steps, and a report says how it moves.
  static std::string TakeModelFault();

 private:
  void (*previous_error_)(const char*);
  void (*previous_warning_)(const char*);
};

/// Loads the engine plugin as any user of MuJoCo does. Throws InputError if it cannot be loaded or
/// does not serve this MuJoCo.
void LoadPlugin(const std::string& path);

/// Loads a model from an MJCF file or a binary MJB file. Throws InputError with MuJoCo's reason.
[[nodiscard]] ModelPointer LoadModel(const std::string& path);

/// Files of a model that is not written yet: name and text.
using ModelFiles = std::vector<std::pair<std::string, std::string>>;

/// Loads the first of `files`, an MJCF model that may include the others. Throws InputError with
/// MuJoCo's reason.
[[nodiscard]] ModelPointer LoadModel(const ModelFiles& files);

/// Throws std::bad_alloc if there is not enough memory.
[[nodiscard]] DataPointer MakeData(const mjModel& model);

}  // namespace girdle
