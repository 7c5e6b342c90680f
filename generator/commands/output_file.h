// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Output files that are either complete or not there at all.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace girdle {

/// A file under construction.
///
/// A regular file is written under a temporary name in its folder; Commit moves it to its place.
/// Without Commit, no part of it remains and an earlier file stays, even if the program is killed
/// (on file systems that support files without a name). `-` is standard output. Standard output and
/// devices are written directly. All failures throw InputError with the reason.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void Write(std::string_view text);
  /// Returns the open file's descriptor, for another program that writes the file in place of
  /// Write.
  [[nodiscard]] int Descriptor() const noexcept;
  /// Passes on the bytes written so far, for example to a reader at the other end of a pipe.
  void Flush();
  /// Flushes and puts the file in its place.
  void Commit();

 private:
  [[nodiscard]] bool OpenUnnamed(const std::string& folder);
  void OpenNamed();
  /// Gives an unnamed file the temporary name.
  void Name();
  [[noreturn]] void Fail() const;

  std::string path_;
  std::string temporary_path_;  ///< empty when the place itself is written
  bool is_named_ = true;        ///< false while the file is on the disk without a name
  std::FILE* file_ = nullptr;
};

/// Throws InputError if the disk of the file that an option names has less free room than `bytes`.
/// Standard output and files that are not regular are not checked.
void ExpectRoom(const std::string& option, const std::string& path, std::uintmax_t bytes);

/// Writes several files (name, text) into a folder, all of them or none. Makes the folder if
/// needed.
void WriteFiles(const std::filesystem::path& folder,
                const std::vector<std::pair<std::string, std::string>>& files);

/// Writes to standard output; throws InputError if it cannot be written.
void Print(std::string_view text);

/// Writes a line about the work to standard error, so that standard output holds results only.
void PrintNote(std::string_view line);

/// Notes on standard error that a file was written, and its content: `wrote map.csv: 91 rows`.
/// Nothing is noted for standard output (`-`) and for an empty path.
void NoteWritten(const std::string& path, const std::string& content = "");

}  // namespace girdle
