// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <system_error>

#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

constexpr std::string_view kStandardOutput = "-";
// Read and write for everybody, minus the bits of the umask.
constexpr mode_t kFileMode = 0666;

[[noreturn]] void FailWriting(const std::string& path) {
  throw InputError((path == kStandardOutput ? "standard output" : path) + ": cannot be written: " +
                   std::strerror(errno) + ". Choose a place that can be written");
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (path_ == kStandardOutput) {
    file_ = stdout;
    return;
  }
  std::error_code ignored;
  const bool is_replaced =
      !std::filesystem::exists(path_, ignored) || std::filesystem::is_regular_file(path_, ignored);
  if (!is_replaced) {
    file_ = std::fopen(path_.c_str(), "wb");
    if (file_ == nullptr) {
      Fail();
    }
    return;
  }
  // If the path is a link, the link stays, and its target is replaced or made.
  std::filesystem::path target = std::filesystem::absolute(path_, ignored);
  constexpr int kMostLinks = 40;  // limit of the Linux kernel
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(target, ignored); ++i) {
    target = target.parent_path() / std::filesystem::read_symlink(target, ignored);
  }
  path_ = target.string();
  temporary_path_ = path_ + "." + std::to_string(getpid()) + ".part";
  if (!OpenUnnamed(target.parent_path().string())) {
    OpenNamed();
  }
}

// A file without a name vanishes when the program ends in any way. Not all file systems support
// such files.
bool OutputFile::OpenUnnamed(const std::string& folder) {
  const int descriptor = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kFileMode);
  if (descriptor < 0) {
    return false;
  }
  file_ = fdopen(descriptor, "wb");
  if (file_ == nullptr) {
    close(descriptor);
    return false;
  }
  is_named_ = false;
  return true;
}

void OutputFile::OpenNamed() {
  file_ = std::fopen(temporary_path_.c_str(), "wb");
  if (file_ == nullptr) {
    temporary_path_.clear();
    Fail();
  }
}

void OutputFile::Name() {
  const std::string unnamed = "/proc/self/fd/" + std::to_string(fileno(file_));
  if (linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, temporary_path_.c_str(), AT_SYMLINK_FOLLOW) !=
      0) {
    Fail();
  }
  is_named_ = true;
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) {
    std::fclose(file_);
  }
  if (!temporary_path_.empty() && is_named_) {
    std::remove(temporary_path_.c_str());
  }
}

void OutputFile::Write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
    Fail();
  }
}

int OutputFile::Descriptor() const noexcept { return fileno(file_); }

void OutputFile::Flush() {
  if (std::fflush(file_) != 0) {
    Fail();
  }
}

void OutputFile::Commit() {
  Flush();
  if (file_ == stdout) {
    return;
  }
  if (!temporary_path_.empty()) {
    // The new file has the access rights of the earlier file.
    struct stat earlier {};
    if (stat(path_.c_str(), &earlier) == 0 && fchmod(fileno(file_), earlier.st_mode) != 0) {
      Fail();
    }
  }
  if (!is_named_) {
    Name();
  }
  const int close_status = std::fclose(file_);
  file_ = nullptr;
  if (close_status != 0) {
    Fail();
  }
  if (!temporary_path_.empty()) {
    if (std::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
      Fail();
    }
    temporary_path_.clear();
  }
}

void OutputFile::Fail() const { FailWriting(path_); }

void ExpectRoom(const std::string& option, const std::string& path, std::uintmax_t bytes) {
  if (path.empty() || path == kStandardOutput) {
    return;
  }
  std::error_code unknown;
  const std::filesystem::path place =
      std::filesystem::weakly_canonical(std::filesystem::absolute(path, unknown), unknown);
  if (std::filesystem::exists(place, unknown) &&
      !std::filesystem::is_regular_file(place, unknown)) {
    return;
  }
  const std::filesystem::space_info space = std::filesystem::space(place.parent_path(), unknown);
  if (!unknown && space.available < bytes) {
    constexpr double kBytesPerGigabyte = 1e9;
    constexpr int kDigits = 3;
    const auto gigabytes = [](std::uintmax_t count) {
      return SignificantText(static_cast<double>(count) / kBytesPerGigabyte, kDigits) + " GB";
    };
    throw InputError(option + " " + path + ": takes about " + gigabytes(bytes) + ", and " +
                     gigabytes(space.available) +
                     " are free there. Choose another place or a shorter motion");
  }
}

void WriteFiles(const std::filesystem::path& folder,
                const std::vector<std::pair<std::string, std::string>>& files) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError(folder.string() + ": the folder cannot be made: " + error.message() +
                     ". Choose another one with --out");
  }
  std::vector<std::unique_ptr<OutputFile>> outputs;
  for (const auto& [name, text] : files) {
    outputs.push_back(std::make_unique<OutputFile>((folder / name).string()));
    outputs.back()->Write(text);
  }
  for (const std::unique_ptr<OutputFile>& output : outputs) {
    output->Commit();
  }
}

void Print(std::string_view text) {
  OutputFile standard_output{std::string(kStandardOutput)};
  standard_output.Write(text);
  standard_output.Commit();
}

void PrintNote(std::string_view line) {
  std::cerr << "girdle: ";
  WritePrintable(std::cerr, line);
  std::cerr << "\n";
}

void NoteWritten(const std::string& path, const std::string& content) {
  if (!path.empty() && path != "-") {
    PrintNote("wrote " + path + (content.empty() ? "" : ": " + content));
  }
}

}  // namespace girdle
