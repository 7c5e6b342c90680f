// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Files that a verb is to read and to write, before it does.
#pragma once

#include <string>
#include <vector>

namespace girdle {

/// A file with the option or word that names it.
struct NamedFile {
  std::string option;  ///< for messages: `--out`
  std::string path;    ///< `-` for a standard stream; empty for none
};

/// Returns a model and the files that it is made of, as files that are read.
[[nodiscard]] std::vector<NamedFile> ModelFiles(const std::string& model);

/// Throws InputError, with both names, if a file that is to be written is one that is to be read,
/// or another one to be written, whatever it is called: through links and other spellings, and
/// where a standard stream leads to a file. Pipes and devices may be read and written.
void ExpectFilesApart(const std::vector<NamedFile>& written, const std::vector<NamedFile>& read);

}  // namespace girdle
