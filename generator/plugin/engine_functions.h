// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The functions of MuJoCo that the plugin calls, taken from the engine that the process already
/// runs.
///
/// The plugin does not link MuJoCo. Linked, it would load a second engine into a process that runs
/// another version or has MuJoCo built in, register itself there and stay unknown where it is
/// wanted.
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

/// Returns the engine of this process: of several loaded ones one whose layout is known, else any;
/// incomplete if there is none.
[[nodiscard]] EngineFunctions FindEngine() noexcept;

}  // namespace girdle
