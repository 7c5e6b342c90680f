// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "tables/input_error.h"

namespace girdle {
namespace {

constexpr std::string_view kStandardOutput = "-";

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
  const bool replaceable =
      !std::filesystem::exists(path_, ignored) || std::filesystem::is_regular_file(path_, ignored);
  if (replaceable) {
    // A link stays a link: what it points to is replaced.
    path_ = std::filesystem::weakly_canonical(path_, ignored).string();
    temporary_path_ = path_ + "." + std::to_string(getpid()) + ".part";
  }
  file_ = std::fopen((replaceable ? temporary_path_ : path_).c_str(), "wb");
  if (file_ == nullptr) {
    temporary_path_.clear();
    Fail();
  }
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) {
    std::fclose(file_);
  }
  if (!temporary_path_.empty()) {
    std::remove(temporary_path_.c_str());
  }
}

void OutputFile::Write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
    Fail();
  }
}

void OutputFile::Commit() {
  if (std::fflush(file_) != 0) {
    Fail();
  }
  if (file_ == stdout) {
    return;
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

}  // namespace girdle
