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
/// - an empty word, or an option with an empty value, which a shell variable without value leaves;
/// - a first word that is no verb and no option of the program;
/// - an option that the verb does not have. The message names the option's new name if it was
///   renamed, the verbs that have it, or the option that it is a slip of;
/// - an option without its value, with a value that it does not take, or given twice;
/// - more words without an option than the verb takes.
///
/// Values are not checked in words that ask for help.
///
/// `words` are those behind the program's name. Values themselves are not checked, nor are
/// words behind `--`.
void ExpectKnownWords(const CLI::App& program, const std::vector<std::string>& words);

/// Returns whether `-h` or `--help` is among the words before `--`.
[[nodiscard]] bool AsksForHelp(const std::vector<std::string>& words);

}  // namespace girdle
