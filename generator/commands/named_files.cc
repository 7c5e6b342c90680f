// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/named_files.h"

#include <cstddef>
#include <filesystem>
#include <system_error>

#include "mjcf/files_of_model.h"
#include "text/input_error.h"

namespace girdle {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStandardStream = "-";

// Returns the place of a file. The file and its folders need not exist.
fs::path PlaceOf(const NamedFile& file, const char* device) {
  std::error_code unclear;
  return file.path == kStandardStream ? fs::path(device) : fs::absolute(file.path, unclear);
}
fs::path PlaceOfWritten(const NamedFile& file) { return PlaceOf(file, "/dev/stdout"); }
fs::path PlaceOfRead(const NamedFile& file) { return PlaceOf(file, "/dev/stdin"); }

// Returns the path as the user typed it, or the words for a standard stream.
std::string TypedText(const NamedFile& file, const char* stream_words) {
  return file.path == kStandardStream ? stream_words : file.option + " " + file.path;
}

// Whether two paths lead to one place. Neither file needs to exist.
bool IsOnePlace(const fs::path& a, const fs::path& b) {
  std::error_code unclear;
  if (fs::exists(a, unclear) && fs::exists(b, unclear)) {
    return fs::equivalent(a, b, unclear);
  }
  const fs::path place_a = fs::weakly_canonical(a, unclear);
  const fs::path place_b = fs::weakly_canonical(b, unclear);
  return !unclear && place_a == place_b;
}

// Throws if the written file is the read one.
void ExpectNotRead(const NamedFile& written, const NamedFile& read) {
  const fs::path source = PlaceOfRead(read);
  std::error_code unclear;
  if (fs::is_regular_file(source, unclear) && IsOnePlace(PlaceOfWritten(written), source)) {
    throw InputError(TypedText(written, "standard output") + ": would replace " +
                     TypedText(read, "standard input") + ", the same file, which is read. Give " +
                     written.option + " another place");
  }
}

// Throws if two written files are the same file.
void ExpectTwo(const NamedFile& first, const NamedFile& second) {
  const fs::path place = PlaceOfWritten(first);
  std::error_code unclear;
  const bool is_device = fs::exists(place, unclear) && !fs::is_regular_file(place, unclear);
  if (!is_device && IsOnePlace(place, PlaceOfWritten(second))) {
    throw InputError(first.option + " and " + second.option + " both want " +
                     (second.path == kStandardStream ? first : second).path +
                     ". Give each a file of its own");
  }
}

}  // namespace

std::vector<NamedFile> ModelFiles(const std::string& model) {
  std::vector<NamedFile> files = {{"the model", model}};
  for (const std::string& file : FilesOfModel(model)) {
    files.push_back({"the model's file", file});
  }
  return files;
}

void ExpectFilesApart(const std::vector<NamedFile>& written, const std::vector<NamedFile>& read) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i].path.empty()) {
      continue;
    }
    for (const NamedFile& source : read) {
      if (!source.path.empty()) {
        ExpectNotRead(written[i], source);
      }
    }
    for (std::size_t j = i + 1; j < written.size(); ++j) {
      if (!written[j].path.empty()) {
        ExpectTwo(written[i], written[j]);
      }
    }
  }
}

}  // namespace girdle
