// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The bytes of an input in a file, for readers that take a path.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "reading.h"

namespace girdle::fuzz {

/// A file of this process in the folder of temporary files. It is gone when the process ends, and
/// left behind by a finding.
class InputFile {
 public:
  /// `suffix` begins with a point: `.obj`.
  explicit InputFile(const std::string& suffix)
      : path_(std::filesystem::temp_directory_path() /
              ("girdle_fuzz_" + std::to_string(getpid()) + suffix)) {}
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  /// Replaces the bytes of the file. Returns its path.
  [[nodiscard]] const std::string& With(const std::string& bytes) const {
    std::ofstream out(path_, std::ios::binary);
    out << bytes;
    out.close();
    if (!out) {
      Report(path_ + " cannot be written");
    }
    return path_;
  }

 private:
  std::string path_;
};

}  // namespace girdle::fuzz
