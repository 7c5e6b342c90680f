// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A file in memory that receives the output of a program.
#pragma once

#include <string>

#include "child_programs/descriptor.h"

namespace girdle {

class MemoryFile {
 public:
  /// `name` appears in the list of this process's open files. Throws InputError if the system
  /// allows no further file.
  explicit MemoryFile(const char* name);

  [[nodiscard]] int descriptor() const noexcept { return file_.get(); }
  /// Returns the whole content.
  [[nodiscard]] std::string Content() const;

 private:
  Descriptor file_;
};

}  // namespace girdle
