// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Looks for the files that a model (MJCF) names.

#include <filesystem>

#include "input_file.h"
#include "mjcf/files_of_model.h"
#include "reading.h"

namespace girdle::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const InputFile kFile(".xml");
  const std::string& path = kFile.With(TextOf(bytes, size));
  const auto files = ResultOf([&] { return FilesOfModel(path); });
  Expect(files.has_value(), "a file that is no model names no files");
  for (const std::string& found : *files) {
    Expect(std::filesystem::is_regular_file(found), "a file that is found is one");
  }
  return 0;
}

}  // namespace girdle::fuzz
