// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Models from text, without files.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <stdexcept>
#include <string>

#include "simulation/engine.h"

namespace girdle {

/// Returns the compiled model. Throws std::runtime_error with MuJoCo's reason.
inline ModelPointer ModelFromText(const std::string& xml) {
  constexpr const char* kFile = "model.xml";
  mjVFS vfs;
  mj_defaultVFS(&vfs);
  mj_addBufferVFS(&vfs, kFile, xml.data(), static_cast<int>(xml.size()));
  std::array<char, 1024> error{};
  ModelPointer model(mj_loadXML(kFile, &vfs, error.data(), error.size()));
  mj_deleteVFS(&vfs);
  if (model == nullptr) {
    throw std::runtime_error(error.data());
  }
  return model;
}

}  // namespace girdle
