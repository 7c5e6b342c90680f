// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <iostream>
#include <memory>
#include <ranges>
#include <system_error>
#include <thread>

#include "child_programs/descriptor.h"
#include "commands/random_name.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

constexpr std::string_view kStandardOutput = "-";
// Read and write for everybody, minus the bits of the umask.
constexpr mode_t kFileMode = 0666;
// Random names are taken by others only on purpose.
constexpr int kMostTries = 100;

std::string RandomPath(const std::filesystem::path& folder) {
  return folder / (".girdle-" + RandomName() + ".part");
}

[[noreturn]] void FailWriting(const std::string& path) {
  throw InputError((path == kStandardOutput ? "standard output" : path) + ": cannot be written: " +
                   std::strerror(errno) + ". Choose a place that can be written");
}

// A folder that the destructor removes if it was made here, is empty and is not kept.
class MadeFolder {
 public:
  explicit MadeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::path missing = std::filesystem::absolute(folder, error);
    for (; !missing.empty() && !std::filesystem::exists(missing, error);
         missing = missing.parent_path()) {
      made_.push_back(missing);
    }
    std::filesystem::create_directories(folder, error);
    if (error) {
      RemoveMade();
      throw InputError(folder.string() + ": the folder cannot be made: " + error.message() +
                       ". Choose another one with --out");
    }
  }
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;
  ~MadeFolder() { RemoveMade(); }

  void Keep() { made_.clear(); }

 private:
  void RemoveMade() {
    for (const std::filesystem::path& folder : made_) {
      rmdir(folder.c_str());  // fails if something is in it
    }
  }

  std::vector<std::filesystem::path> made_;  // the deepest one first
};

// Holds a folder against other programs of Girdle. The lock ends with the process in any case.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder)
      : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    constexpr std::chrono::milliseconds kPause(10);
    constexpr std::chrono::seconds kLongest(30);
    for (std::chrono::milliseconds waited(0); flock(folder_.get(), LOCK_EX | LOCK_NB) != 0;
         waited += kPause) {
      if (errno != EWOULDBLOCK) {
        return;  // a file system without locks, or a folder that cannot be read
      }
      if (waited >= kLongest) {
        throw InputError(folder.string() +
                         ": another program holds the folder (flock). Wait for its end, or choose "
                         "another folder with --out");
      }
      std::this_thread::sleep_for(kPause);
    }
  }

  // Writes the names in the folder to the disk.
  void Sync() const noexcept { fsync(folder_.get()); }

 private:
  Descriptor folder_;
};

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (path_ == kStandardOutput) {
    file_ = stdout;
    return;
  }
  std::error_code ignored;
  is_replaced_ =
      !std::filesystem::exists(path_, ignored) || std::filesystem::is_regular_file(path_, ignored);
  if (!is_replaced_) {
    const int device = open(path_.c_str(), O_WRONLY | O_TRUNC | O_NOCTTY | O_CLOEXEC);
    if (device < 0 || !Take(device)) {
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
  folder_ = target.parent_path();
  if (!OpenUnnamed()) {
    OpenNamed();
  }
}

// A file without a name vanishes when the program ends in any way. Not all file systems support
// such files.
bool OutputFile::OpenUnnamed() {
  const int descriptor = open(folder_.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kFileMode);
  if (descriptor < 0) {
    return false;
  }
  return Take(descriptor);
}

void OutputFile::OpenNamed() {
  // A name that exists is not opened, whatever is there: nobody can make the program write through
  // a link of theirs.
  int descriptor = -1;
  for (int tries = 0; descriptor < 0 && tries < kMostTries; ++tries) {
    temporary_path_ = RandomPath(folder_);
    descriptor = open(temporary_path_.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC,
                      kFileMode);
    if (descriptor < 0 && errno != EEXIST) {
      break;
    }
  }
  if (descriptor < 0) {
    Fail();
  }
  if (!Take(descriptor)) {
    unlink(temporary_path_.c_str());
    Fail();
  }
  is_named_ = true;
}

// Makes the stream of an open file, which it closes.
bool OutputFile::Take(int descriptor) {
  file_ = fdopen(descriptor, "wb");
  if (file_ == nullptr) {
    close(descriptor);
  }
  return file_ != nullptr;
}

void OutputFile::Name() {
  const std::string unnamed = "/proc/self/fd/" + std::to_string(fileno(file_));
  for (int tries = 0; !is_named_ && tries < kMostTries; ++tries) {
    temporary_path_ = RandomPath(folder_);
    is_named_ = linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, temporary_path_.c_str(),
                       AT_SYMLINK_FOLLOW) == 0;
    if (!is_named_ && errno != EEXIST) {
      break;
    }
  }
  if (!is_named_) {
    Fail();
  }
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
  const SignalsBlocked blocked;
  Prepare();
  Rename();
}

void OutputFile::Prepare() {
  Flush();
  if (file_ == stdout) {
    return;
  }
  if (is_replaced_) {
    // The new file has the access rights of the earlier file.
    struct stat earlier {};
    was_there_ = stat(path_.c_str(), &earlier) == 0;
    if (was_there_ && fchmod(fileno(file_), earlier.st_mode) != 0) {
      Fail();
    }
    // Some file systems do not know fsync.
    if (fsync(fileno(file_)) != 0 && errno != EINVAL && errno != ENOSYS) {
      Fail();
    }
    if (!is_named_) {
      Name();
    }
  }
  const int close_status = std::fclose(file_);
  file_ = nullptr;
  if (close_status != 0) {
    Fail();
  }
}

void OutputFile::Rename() {
  if (!is_replaced_) {
    return;
  }
  if (std::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
    Fail();
  }
  temporary_path_.clear();
}

void OutputFile::Place() {
  // If the file system can exchange the two files, the earlier one is under the temporary name
  // until the destructor.
  is_exchanged_ =
      is_replaced_ && was_there_ &&
      renameat2(AT_FDCWD, temporary_path_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0;
  if (!is_exchanged_) {
    Rename();
  }
  is_placed_ = is_replaced_;
}

void OutputFile::Undo() noexcept {
  if (!std::exchange(is_placed_, false)) {
    return;
  }
  if (is_exchanged_) {
    renameat2(AT_FDCWD, temporary_path_.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE);
  } else if (!was_there_) {
    unlink(path_.c_str());
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

SignalsBlocked::SignalsBlocked() noexcept {
  sigset_t ending;
  sigemptyset(&ending);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    sigaddset(&ending, signal);
  }
  sigprocmask(SIG_BLOCK, &ending, &before_);
}

SignalsBlocked::~SignalsBlocked() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

void WriteFiles(const std::filesystem::path& folder,
                const std::vector<std::pair<std::string, std::string>>& files) {
  MadeFolder made(folder);
  const FolderLock lock(folder);
  const SignalsBlocked blocked;
  std::vector<std::unique_ptr<OutputFile>> outputs;
  for (const auto& [name, text] : files) {
    outputs.push_back(std::make_unique<OutputFile>((folder / name).string()));
    outputs.back()->Write(text);
    outputs.back()->Flush();
  }
  for (const std::unique_ptr<OutputFile>& output : outputs) {
    output->Prepare();
  }
  try {
    // The first file names the others, so that it comes last.
    for (const std::unique_ptr<OutputFile>& output : std::views::reverse(outputs)) {
      output->Place();
    }
  } catch (...) {
    for (const std::unique_ptr<OutputFile>& output : outputs) {
      output->Undo();
    }
    throw;
  }
  lock.Sync();
  made.Keep();
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
