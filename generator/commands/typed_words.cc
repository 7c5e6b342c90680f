// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/typed_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "text/input_error.h"
#include "text/near_names.h"
#include "text/number_text.h"

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

// Returns an option by its long name, such as --plane, or nullptr.
const CLI::Option* OptionOf(const CLI::App& verb, const std::string& name) {
  return name.starts_with("--") ? verb.get_option_no_throw(name) : nullptr;
}

bool HasOption(const CLI::App& verb, const std::string& name) {
  return OptionOf(verb, name) != nullptr;
}

std::vector<std::string_view> ViewsOf(const std::vector<std::string>& words) {
  return {words.begin(), words.end()};
}

void ExpectNoEmptyWord(std::span<const std::string> words) {
  std::string before = "the first word";
  for (const std::string& word : words) {
    if (word.empty() || (word.starts_with("--") && word.find('=') == word.size() - 1)) {
      throw InputError((word.empty() ? before : word.substr(0, word.size() - 1)) +
                       " '': is empty. Give it a value or omit it");
    }
    before = word;
  }
}

// Returns "girdle solve" for a verb, "girdle" for the program.
std::string CommandOf(const CLI::App& app) {
  return app.get_parent() == nullptr ? "girdle" : "girdle " + app.get_name();
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

// Returns whether CLI11 would take a word for an option rather than for a value.
bool LooksLikeOption(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         (std::isdigit(static_cast<unsigned char>(word[1])) == 0) && word[1] != '.';
}

std::string FormOf(const std::string& name, const CLI::Option& option) {
  return "Write it as " + name + " " + option.get_type_name();
}

// Expects a value behind an option that has one, and none behind another. `next` is the word that
// follows, if any.
void ExpectValue(const std::string& word, const std::string* next, const CLI::Option& option) {
  const std::string name = word.substr(0, word.find('='));
  const bool has_value = name.size() < word.size();
  if (option.get_items_expected_max() == 0) {
    if (has_value) {
      throw InputError(name + ": takes no value. Write " + name + " alone, or omit it");
    }
    return;
  }
  if (has_value) {
    return;
  }
  if (next == nullptr) {
    throw InputError(name + ": has no value. " + FormOf(name, option));
  }
  if (next->starts_with("--")) {
    throw InputError(name + ": has no value, because the option " + *next + " follows. " +
                     FormOf(name, option));
  }
  if (LooksLikeOption(*next)) {
    throw InputError(name + ": has no value, because '" + *next + "' is read as an option. Write " +
                     name + "=" + *next + " if it is the value");
  }
}

// Expects a word that begins with one dash to be -h.
void ExpectShortOption(const CLI::App& app, const std::string& word) {
  if (word == "-h") {
    return;
  }
  const std::vector<std::string> names = OptionsOf(app);
  throw InputError(word + ": options begin with two dashes. " +
                   DidYouMean("-" + word, ViewsOf(names)) + "See " + CommandOf(app) + " --help");
}

// Returns a hint for a word that belongs to no option: it may be a file that --in is to read.
std::string FileHint(const CLI::App& verb, std::span<const std::string> words,
                     const std::string& word) {
  const auto is_given = [&words](std::string_view option) {
    return std::ranges::any_of(
        words, [option](const std::string& other) { return other.starts_with(option); });
  };
  const bool is_hint = HasOption(verb, "--in") && !is_given("--in") && !is_given("--elevation") &&
                       !FiniteNumber(word);
  return is_hint ? "If it is a file, write --in " + word + ". " : "";
}

// Expects each option once, values where options have them, and no word that belongs to none.
void ExpectValues(const CLI::App& verb, std::span<const std::string> words) {
  std::size_t most_alone = 0;
  for (const CLI::Option* const option : verb.get_options()) {
    most_alone +=
        option->get_positional() ? static_cast<std::size_t>(option->get_items_expected_max()) : 0;
  }
  std::set<const CLI::Option*> given;
  std::size_t alone = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string name = word.substr(0, word.find('='));
    const CLI::Option* const option = OptionOf(verb, name);
    if (option != nullptr) {
      ExpectValue(word, i + 1 < words.size() ? &words[i + 1] : nullptr, *option);
      const bool is_first = given.insert(option).second;
      if (!is_first && option->get_multi_option_policy() != CLI::MultiOptionPolicy::TakeAll) {
        throw InputError(name + ": is given twice. Omit one of them");
      }
      i += option->get_items_expected_max() > 0 && name.size() == word.size() ? 1 : 0;
    } else if (LooksLikeOption(word)) {
      ExpectShortOption(verb, word);
    } else if (++alone > most_alone) {
      throw InputError("'" + word + "': belongs to no option, and " + CommandOf(verb) +
                       (most_alone == 0
                            ? " takes no word alone. "
                            : " takes only " + CountText(most_alone, "word") + " alone. ") +
                       FileHint(verb, words, word) + "See " + CommandOf(verb) + " --help");
    }
  }
}

}  // namespace

bool AsksForHelp(const std::vector<std::string>& words) {
  return std::any_of(words.begin(), std::ranges::find(words, kEndOfOptions),
                     [](const std::string& word) { return word == "-h" || word == "--help"; });
}

void ExpectKnownWords(const CLI::App& program, const std::vector<std::string>& words) {
  const std::span<const std::string> checked(words.begin(),
                                             std::ranges::find(words, kEndOfOptions));
  ExpectNoEmptyWord(checked);
  if (words.empty()) {
    return;
  }
  const std::string first = words.front().substr(0, words.front().find('='));
  if (first.starts_with("--") && !HasOption(program, first)) {
    const std::vector<std::string> names = OptionsOf(program);
    const std::string meant = DidYouMean(first, ViewsOf(names));
    throw InputError(first +
                     (meant.empty()
                          ? ": stands before the verb. Give the verb first, such as girdle "
                            "solve --elevation 90 --plane 40. "
                          : ": girdle has no such option. " + meant) +
                     "See girdle --help");
  }
  if (first.starts_with("--")) {
    ExpectValues(program, checked);
    return;
  }
  if (first.starts_with('-')) {
    ExpectShortOption(program, first);
    return;
  }
  const CLI::App& verb = VerbOf(program, words.front());
  for (const std::string& word : checked) {
    const std::string option = word.substr(0, word.find('='));
    if (option.starts_with("--") && option.size() > 2 && !HasOption(verb, option)) {
      RefuseOption(program, verb, option);
    }
  }
  if (!AsksForHelp(words)) {
    ExpectValues(verb, checked.subspan(1));
  }
}

}  // namespace girdle
