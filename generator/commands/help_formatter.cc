// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/help_formatter.h"

#include <utility>

#include "text/text_columns.h"

namespace girdle {
namespace {

constexpr std::size_t kIndent = 2;
// Wide enough for `--skin-landmarks FILE`. A longer name has a line of its own.
constexpr std::size_t kMeaningColumn = 26;

}  // namespace

// CLI11 puts blank lines behind some sections and before others.
std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  return CLI::detail::find_and_replace(CLI::Formatter::make_help(app, std::move(name), mode),
                                       "\n\n\n", "\n\n");
}

std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
  std::string text = "\n" + group + ":\n";
  for (const CLI::Option* const option : options) {
    const std::string name = make_option_name(option, is_positional);
    const std::string value = option->get_type_size() == 0 ? "" : " " + option->get_type_name();
    text += LabelledText(is_positional ? option->get_type_name() : name + value,
                         option->get_description() + (option->get_required() ? " (required)" : ""),
                         kIndent, kMeaningColumn, width_);
  }
  return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* verb) const {
  constexpr std::size_t kVerbColumn = 16;
  return LabelledText(verb->get_name(), verb->get_description(), kIndent, kVerbColumn, width_);
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return WrappedText(app->get_description(), width_) + "\n\n";
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
  const std::string footer = app->get_footer();
  return footer.empty() ? "" : WrappedText(footer, width_) + "\n";
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  std::string text = "Usage: " + name;
  if (!app->get_subcommands({}).empty()) {
    text += " VERB";
  }
  for (const CLI::Option* const option : app->get_options()) {
    if (option->get_positional()) {
      text += " " + option->get_type_name();
    } else if (option->get_required()) {
      text += " " + make_option_name(option, false) + " " + option->get_type_name();
    }
  }
  return text + " [OPTIONS]\n";
}

}  // namespace girdle
