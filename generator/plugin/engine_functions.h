// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The functions of MuJoCo that the plugin calls. They belong to the engine that the process
/// already runs.
///
/// The plugin does not link MuJoCo. A linked plugin would load a second engine into a process that
/// runs another version or has MuJoCo built in. It would register itself there and be unknown to
/// the first engine.
#pragma once

#include <mujoco/mujoco.h>

namespace girdle {

struct EngineFunctions {
  decltype(&mj_version) version = nullptr;
  decltype(&mj_versionString) version_string = nullptr;
  decltype(&mju_warning) warning = nullptr;
  decltype(&mj_id2name) id_to_name = nullptr;
  decltype(&mj_isSparse) is_sparse = nullptr;
  decltype(&mj_getPluginConfig) get_plugin_config = nullptr;
  decltype(&mjp_defaultPlugin) default_plugin = nullptr;
  decltype(&mjp_getPlugin) get_plugin = nullptr;
  decltype(&mjp_registerPlugin) register_plugin = nullptr;

  [[nodiscard]] bool complete() const noexcept {
    return version != nullptr && version_string != nullptr && warning != nullptr &&
           id_to_name != nullptr && is_sparse != nullptr && get_plugin_config != nullptr &&
           default_plugin != nullptr && get_plugin != nullptr && register_plugin != nullptr;
  }
};

/// Returns the engine of this process. If several are loaded, it prefers one whose layout is known.
/// If there is none, the result is incomplete.
[[nodiscard]] EngineFunctions FindEngine() noexcept;

}  // namespace girdle
