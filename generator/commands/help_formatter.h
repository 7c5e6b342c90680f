// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The layout of `--help`.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace girdle {

/// Writes the help of the program and of its verbs within a given width.
///
/// Options are listed in their groups: the name on the left, the meaning, wrapped, on the right.
/// Descriptions and footers are wrapped too. Lines that begin with a blank are examples and are not
/// wrapped.
class HelpFormatter : public CLI::Formatter {
 public:
  /// `width` is the most bytes of a line, at least 60.
  explicit HelpFormatter(std::size_t width) : width_(width) { label("Positionals", "Argument"); }

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override;
  std::string make_subcommand(const CLI::App* verb) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_footer(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;

 private:
  std::size_t width_;
};

}  // namespace girdle
