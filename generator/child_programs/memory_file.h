// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A file that is in memory alone, for what a program writes.
#pragma once

#include <string>

#include "child_programs/descriptor.h"

namespace girdle {

class MemoryFile {
 public:
  /// `name` is for whoever looks at the open files of this process. Throws InputError if there is
  /// no room for another file.
  explicit MemoryFile(const char* name);

  [[nodiscard]] int descriptor() const noexcept { return file_.get(); }
  /// Returns all that is in it.
  [[nodiscard]] std::string Content() const;

 private:
  Descriptor file_;
};

}  // namespace girdle
