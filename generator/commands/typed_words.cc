// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/typed_words.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "text/input_error.h"
#include "text/near_names.h"

namespace girdle {
namespace {

// Names from before version 0.2. Remove them with the version that follows 0.2.
struct Renaming {
  std::string_view old_name;
  std::string_view new_name;
};
constexpr std::array<Renaming, 3> kRenamedVerbs = {
    {{"continuity", "smoothness"}, {"destep", "smooth-table"}, {"thorax", "fit-thorax"}}};
// A verb recognises an old option if it has the new one.
constexpr std::array<Renaming, 9> kRenamedOptions = {{{"--raise", "--elevation"},
                                                      {"--motion", "--in"},
                                                      {"--trace", "--out"},
                                                      {"--controls", "--out-controls"},
                                                      {"--picture", "--out-picture"},
                                                      {"--video", "--out-video"},
                                                      {"--rates", "--derivatives"},
                                                      {"--pose", "--posture"},
                                                      {"--thorax", "--ellipsoids"}}};

// Words behind it are no options.
constexpr std::string_view kEndOfOptions = "--";

std::optional<std::string_view> NewNameOf(std::string_view old_name,
                                          const std::vector<std::string_view>& known,
                                          const auto& renamings) {
  for (const Renaming& renaming : renamings) {
    if (renaming.old_name == old_name && std::ranges::count(known, renaming.new_name) > 0) {
      return renaming.new_name;
    }
  }
  return std::nullopt;
}

std::vector<std::string> OptionsOf(const CLI::App& verb) {
  std::vector<std::string> options;
  for (const CLI::Option* const option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      options.push_back("--" + name);
    }
  }
  return options;
}

bool HasOption(const CLI::App& verb, const std::string& name) {
  return std::ranges::count(OptionsOf(verb), name) > 0;
}

std::vector<std::string_view> ViewsOf(const std::vector<std::string>& words) {
  return {words.begin(), words.end()};
}

void ExpectNoEmptyWord(std::span<const std::string> words) {
  std::string before = "the first word";
  for (const std::string& word : words) {
    if (word.empty() || (word.starts_with("--") && word.find('=') == word.size() - 1)) {
      throw InputError((word.empty() ? before : word.substr(0, word.size() - 1)) +
                       " '': is empty. Give it a value or leave it away");
    }
    before = word;
  }
}

const CLI::App& VerbOf(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* const verb : program.get_subcommands({})) {
    if (verb->get_name() == word) {
      return *verb;
    }
    names.push_back(verb->get_name());
  }
  const std::vector<std::string_view> known = ViewsOf(names);
  if (const std::optional<std::string_view> now = NewNameOf(word, known, kRenamedVerbs)) {
    throw InputError("girdle " + word + " is now called girdle " + std::string(*now));
  }
  std::string list;
  for (const std::string& name : names) {
    list += " " + name;
  }
  throw InputError("'" + word + "' is not a verb. " + DidYouMean(word, known) +
                   "Verbs are:" + list + "\nSee girdle --help");
}

[[noreturn]] void RefuseOption(const CLI::App& program, const CLI::App& verb,
                               const std::string& option) {
  const std::string command = "girdle " + verb.get_name();
  const std::vector<std::string> names = OptionsOf(verb);
  const std::vector<std::string_view> known = ViewsOf(names);
  if (const std::optional<std::string_view> now = NewNameOf(option, known, kRenamedOptions)) {
    throw InputError(option + ": is now called " + std::string(*now) + " in " + command);
  }
  std::string owners;
  for (const CLI::App* const other : program.get_subcommands({})) {
    if (HasOption(*other, option)) {
      owners += (owners.empty() ? "girdle " : ", girdle ") + other->get_name();
    }
  }
  throw InputError(option + ": " + command + " has no such option. " +
                   (owners.empty() ? DidYouMean(option, known) : "It belongs to " + owners + ". ") +
                   "See " + command + " --help");
}

}  // namespace

void ExpectKnownWords(const CLI::App& program, const std::vector<std::string>& words) {
  const std::span<const std::string> checked(words.begin(),
                                             std::ranges::find(words, kEndOfOptions));
  ExpectNoEmptyWord(checked);
  if (words.empty()) {
    return;
  }
  if (words.front().starts_with("--") && !HasOption(program, words.front())) {
    throw InputError(words.front() +
                     ": stands before the verb. Give the verb first, such as girdle solve "
                     "--elevation 90 --plane 40\nSee girdle --help");
  }
  if (words.front().starts_with('-')) {
    return;
  }
  const CLI::App& verb = VerbOf(program, words.front());
  for (const std::string& word : checked) {
    const std::string option = word.substr(0, word.find('='));
    if (option.starts_with("--") && option.size() > 2 && !HasOption(verb, option)) {
      RefuseOption(program, verb, option);
    }
  }
}

}  // namespace girdle
