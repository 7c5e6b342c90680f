// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Output files that are either complete or not there at all.
#pragma once

#include <csignal>
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
/// A regular file is written without a name, or under a temporary one, in its folder; Commit moves
/// it to its place once all its bytes are on the disk. Without Commit, no part of it remains and an
/// earlier file stays, even if the program is killed (on file systems that support files without a
/// name). SIGINT and similar signals wait until the file is in its place. `-` is standard output.
/// Standard output and devices are written directly. All failures throw InputError with the
/// reason.
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

  /// The parts of Commit, for files that belong together. Block the signals for all of them
  /// (SignalsBlocked).
  ///
  /// Writes all bytes to the disk and gives the file its temporary name.
  void Prepare();
  /// Puts a prepared file in its place.
  void Place();
  /// Puts back what was there before Place, as far as the file system can exchange two files.
  void Undo() noexcept;

 private:
  [[nodiscard]] bool OpenUnnamed();
  void OpenNamed();
  [[nodiscard]] bool Take(int descriptor);
  /// Gives an unnamed file the temporary name.
  void Name();
  void Rename();
  [[noreturn]] void Fail() const;

  std::string path_;
  std::filesystem::path folder_;
  std::string temporary_path_;  ///< empty if there is no temporary name
  bool is_replaced_ = false;    ///< false if the place itself is written
  bool is_named_ = false;       ///< false while the file is on the disk without a name
  bool was_there_ = false;      ///< whether there is an earlier file
  bool is_placed_ = false;
  bool is_exchanged_ = false;  ///< whether the earlier file has the temporary name now
  std::FILE* file_ = nullptr;
};

/// Blocks the signals that usually end a program, until its destructor. They are delivered then.
class SignalsBlocked {
 public:
  SignalsBlocked() noexcept;
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  ~SignalsBlocked();

 private:
  sigset_t before_;
};

/// Throws InputError if the disk of the file that an option names has less free room than `bytes`.
/// Standard output and files that are not regular are not checked.
void ExpectRoom(const std::string& option, const std::string& path, std::uintmax_t bytes);

/// Writes several files (name, text) into a folder, all of them or none. Makes the folder if
/// needed, and removes it again if nothing can be written. All bytes of all files are on the disk
/// before the first one gets its name. Meanwhile other calls for this folder wait, also those of
/// other processes, so that the files there are of one call.
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
