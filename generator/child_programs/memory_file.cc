// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "child_programs/memory_file.h"

#include <sys/mman.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include "text/input_error.h"

namespace girdle {

MemoryFile::MemoryFile(const char* name) : file_(memfd_create(name, MFD_CLOEXEC)) {
  if (file_.get() < 0) {
    throw InputError("cannot make a file in memory: " + std::string(std::strerror(errno)));
  }
}

std::string MemoryFile::Content() const {
  std::string text;
  std::array<char, 4096> buffer{};
  for (off_t at = 0;;) {
    const ssize_t size = pread(file_.get(), buffer.data(), buffer.size(), at);
    if (size <= 0) {
      return text;
    }
    text.append(buffer.data(), static_cast<std::size_t>(size));
    at += size;
  }
}

}  // namespace girdle
