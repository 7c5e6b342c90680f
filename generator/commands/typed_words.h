// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Unknown words of the command line, and suggestions of known ones.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace girdle {

/// Throws InputError at the first word of the command line that is surely wrong:
///
/// - an empty word, or an option with an empty value, which an unset shell variable gives;
/// - a first word that is no verb of the program;
/// - an option that the verb does not have. The message names the new name of a renamed option, the
///   verbs that have the option, or the option whose name is similar.
///
/// `words` are the words after the program's name. Values of options are not checked.
void ExpectKnownWords(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace girdle
