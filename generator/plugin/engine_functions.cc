// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_functions.h"

#include <dlfcn.h>
#include <link.h>

#include <array>
#include <cstddef>
#include <cstring>

namespace girdle {
namespace {

// Libraries whose file name begins so are engines: libmujoco.so, libmujoco.so.4.0.1.
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
  Take(library, "mj_getPluginConfig", engine.get_plugin_config);
  Take(library, "mjp_defaultPlugin", engine.default_plugin);
  Take(library, "mjp_registerPlugin", engine.register_plugin);
  return engine;
}

struct Search {
  int wanted;
  EngineFunctions found;
};

// Looks at one loaded library; returns 1, which ends the walk, at an engine of the wanted version.
int VisitLibrary(dl_phdr_info* info, std::size_t /*size*/, void* search_pointer) noexcept {
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
  dlclose(library);  // gives back this handle only: the process keeps its engine
  if (!engine.complete()) {
    return 0;
  }
  auto* search = static_cast<Search*>(search_pointer);
  search->found = engine;
  return engine.version() == search->wanted ? 1 : 0;
}

}  // namespace

EngineFunctions FindEngine(int wanted) noexcept {
  // A program with MuJoCo built in has its functions in the global scope.
  const EngineFunctions built_in = FunctionsOf(RTLD_DEFAULT);
  if (built_in.complete() && built_in.version() == wanted) {
    return built_in;
  }
  Search search{wanted, built_in};
  dl_iterate_phdr(VisitLibrary, &search);
  return search.found;
}

const char* PluginPath() noexcept {
  static const char kAnyAddress = 0;
  Dl_info info;
  return dladdr(&kAnyAddress, &info) != 0 ? info.dli_fname : "this library";
}

}  // namespace girdle
