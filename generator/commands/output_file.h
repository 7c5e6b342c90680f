// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Output that is complete or not there at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace girdle {

/// A file under construction.
///
/// A regular file is written under a temporary name beside its place and put there by Commit;
/// without Commit nothing of it remains and what was there before stays. `-` is standard output; it
/// and devices are written directly. All failures throw InputError with the reason.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void Write(std::string_view text);
  /// Flushes and puts the file in its place.
  void Commit();

 private:
  [[noreturn]] void Fail() const;

  std::string path_;
  std::string temporary_path_;  ///< empty when written directly
  std::FILE* file_ = nullptr;
};

/// Writes several files (name, text) into a folder, which is made if needed: all of them, or none.
void WriteFiles(const std::filesystem::path& folder,
                const std::vector<std::pair<std::string, std::string>>& files);

/// Writes to standard output; throws InputError if it cannot be written.
void Print(std::string_view text);

}  // namespace girdle
