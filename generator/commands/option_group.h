// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Groups of options in the help of a verb.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace girdle {

/// Puts the options that are added to a verb during its lifetime under a heading of the verb's
/// help. Options that are added outside a group are listed under "Options": the files and the forms
/// of the output.
class OptionGroup {
 public:
  OptionGroup(CLI::App& verb, const std::string& heading)
      : verb_(verb), before_(verb.option_defaults()->get_group()) {
    verb_.option_defaults()->group(heading);
  }
  OptionGroup(const OptionGroup&) = delete;
  OptionGroup& operator=(const OptionGroup&) = delete;
  ~OptionGroup() { verb_.option_defaults()->group(before_); }

 private:
  CLI::App& verb_;
  std::string before_;
};

}  // namespace girdle
