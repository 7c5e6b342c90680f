// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_functions.h"

#include <dlfcn.h>
#include <link.h>

#include <cstddef>
#include <cstring>

#include "plugin/engine_layout.h"

namespace girdle {
namespace {

// Engines are the libraries whose file name begins with this: libmujoco.so, libmujoco.so.4.0.1.
constexpr const char* kEngineFileName = "libmujoco.so";

template <typename Function>
void Take(void* library, const char* name, Function& function) noexcept {
  function = reinterpret_cast<Function>(dlsym(library, name));
}

EngineFunctions FunctionsOf(void* library) noexcept {
  EngineFunctions engine;
  Take(library, "mj_version", engine.version);
  Take(library, "mj_versionString", engine.version_string);
  Take(library, "mju_warning", engine.warning);
  Take(library, "mj_id2name", engine.id_to_name);
  Take(library, "mj_isSparse", engine.is_sparse);
  Take(library, "mj_getPluginConfig", engine.get_plugin_config);
  Take(library, "mjp_defaultPlugin", engine.default_plugin);
  Take(library, "mjp_getPlugin", engine.get_plugin);
  Take(library, "mjp_registerPlugin", engine.register_plugin);
  return engine;
}

bool IsKnown(const EngineFunctions& engine) noexcept {
  return engine.complete() && FindEngineLayout(engine.version()) != nullptr;
}

// Examines one loaded library. Returns 1, which ends the walk, for an engine with a known layout.
int VisitLibrary(dl_phdr_info* info, std::size_t /*size*/, void* found) noexcept {
  const char* slash = std::strrchr(info->dlpi_name, '/');
  const char* file_name = slash == nullptr ? info->dlpi_name : slash + 1;
  if (std::strncmp(file_name, kEngineFileName, std::strlen(kEngineFileName)) != 0) {
    return 0;
  }
  void* library = dlopen(info->dlpi_name, RTLD_LAZY | RTLD_NOLOAD);
  if (library == nullptr) {
    return 0;
  }
  const EngineFunctions engine = FunctionsOf(library);
  dlclose(library);  // closes this handle only; the process keeps its engine
  if (!engine.complete()) {
    return 0;
  }
  *static_cast<EngineFunctions*>(found) = engine;
  return IsKnown(engine) ? 1 : 0;
}

}  // namespace

EngineFunctions FindEngine() noexcept {
  // A program with MuJoCo built in has its functions in the global scope.
  EngineFunctions found = FunctionsOf(RTLD_DEFAULT);
  if (!IsKnown(found)) {
    dl_iterate_phdr(VisitLibrary, &found);
  }
  return found;
}

}  // namespace girdle
