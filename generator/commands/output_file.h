// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Output that is complete or not there at all.
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
/// A regular file is written under a temporary name beside its place and put there by Commit;
/// without Commit nothing of it remains and what was there before stays, even if the program is
/// killed (where the file system knows files without a name). `-` is standard output; it and
/// devices are written directly. All failures throw InputError with the reason.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void Write(std::string_view text);
  /// The open file, for a program that writes it in place of Write.
  [[nodiscard]] int Descriptor() const noexcept;
  /// Hands on what was written so far, as to whoever waits at the other end of a pipe.
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

/// Throws InputError if the disk of a file that an option names has less room than it needs.
/// Nothing is known of standard output and of what is not a regular file.
void ExpectRoom(const std::string& option, const std::string& path, std::uintmax_t bytes);

/// Writes several files (name, text) into a folder, which is made if needed: all of them, or none.
void WriteFiles(const std::filesystem::path& folder,
                const std::vector<std::pair<std::string, std::string>>& files);

/// Writes to standard output; throws InputError if it cannot be written.
void Print(std::string_view text);

/// Writes a line about the work that is done to standard error, where it is in nobody's way.
void PrintNote(std::string_view line);

/// Notes that a file was written, and what is in it: `wrote map.csv: 91 rows`. Nothing is noted of
/// standard output (`-`) and of a file that was not asked for (an empty path).
void NoteWritten(const std::string& path, const std::string& content = "");

}  // namespace girdle
