// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Checks of the files that a verb reads and writes, before it does either.
#pragma once

#include <string>
#include <vector>

namespace girdle {

/// A file with the option or word that names it.
struct NamedFile {
  std::string option;  ///< for messages: `--out`
  std::string path;    ///< `-` for a standard stream; empty for none
};

/// Returns the files that a model consists of, the model's own file among them, as files that are
/// read.
[[nodiscard]] std::vector<NamedFile> ModelFiles(const std::string& model);

/// Throws InputError, with both names, if a file to be written is also to be read or is to be
/// written twice. Links, other spellings of a path, and standard streams that are redirected to a
/// file are recognised. Pipes and devices may be both read and written.
void ExpectFilesApart(const std::vector<NamedFile>& written, const std::vector<NamedFile>& read);

}  // namespace girdle
