// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/library_files.h"

#include <dlfcn.h>

#include "plugin/version_symbol.h"

namespace girdle {

std::string FileOf(const void* address) {
  Dl_info info;
  return dladdr(address, &info) != 0 && info.dli_fname != nullptr ? info.dli_fname
                                                                  : "another library";
}

std::string OwnFile() {
  static const char kAnyAddress = 0;
  return FileOf(&kAnyAddress);
}

std::string DescribedPlugin(const std::string& file) {
  void* const library = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (library == nullptr) {
    return file;
  }
  const auto version = reinterpret_cast<const char* (*)()>(dlsym(library, kPluginVersionSymbol));
  std::string text = version == nullptr ? file : file + " (Girdle " + std::string(version()) + ")";
  dlclose(library);
  return text;
}

}  // namespace girdle
