// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/csv_dialect.h"

#include <algorithm>
#include <array>

#include "text/number_text.h"

namespace girdle {
namespace {

constexpr std::string_view kSeparators = ",;\t";
constexpr std::string_view kBlanks = " \t";

// The beginning of a line that names the separator. Capital letters do not matter.
constexpr std::string_view kSeparatorIs = "sep=";

// Returns `line` without quotes around it.
std::string_view WithoutQuotes(std::string_view line) noexcept {
  return line.size() > 1 && line.starts_with('"') && line.ends_with('"')
             ? line.substr(1, line.size() - 2)
             : line;
}

// Splits a line with quotes, as SplitFields does. The fields are views of `unquoted`.
const char* SplitQuotedFields(std::string_view line, char separator,
                              std::vector<std::string_view>& fields, std::string& unquoted) {
  const auto pass_blanks = [&](std::size_t i) {
    while (i < line.size() && line[i] != separator &&
           kBlanks.find(line[i]) != std::string_view::npos) {
      ++i;
    }
    return i;
  };
  fields.clear();
  // The views stay valid: the text never grows beyond the line.
  unquoted.clear();
  unquoted.reserve(line.size());
  std::size_t i = 0;
  while (true) {
    const std::size_t begin = unquoted.size();
    const std::size_t opening = pass_blanks(i);
    if (opening < line.size() && line[opening] == '"') {
      i = opening + 1;
      while (true) {
        const std::size_t quote = line.find('"', i);
        if (quote == std::string_view::npos) {
          return "a quote is not closed on its line";
        }
        unquoted.append(line, i, quote - i);
        i = quote + 1;
        if (i >= line.size() || line[i] != '"') {
          break;
        }
        unquoted += line[i++];
      }
      i = pass_blanks(i);
      if (i < line.size() && line[i] != separator) {
        return "text behind a closing quote. Put the whole field in quotes";
      }
    } else {
      const std::size_t end = std::min(line.find(separator, i), line.size());
      unquoted.append(line, i, end - i);
      i = end;
    }
    fields.push_back(std::string_view(unquoted).substr(begin));
    if (i >= line.size()) {
      return nullptr;
    }
    ++i;
  }
}

}  // namespace

bool NamesSeparator(std::string_view line) noexcept {
  constexpr unsigned char kSmall = 0x20;  // the bit that makes a letter small
  line = WithoutQuotes(line);
  return line.size() == kSeparatorIs.size() + 1 &&
         std::equal(kSeparatorIs.begin(), kSeparatorIs.end(), line.begin(), [](char a, char b) {
           return a == b || (a != '=' && a == static_cast<char>(b | kSmall));
         });
}

std::optional<char> NamedSeparator(std::string_view line) noexcept {
  const char separator = WithoutQuotes(line).back();
  return kSeparators.find(separator) == std::string_view::npos ? std::nullopt
                                                               : std::optional(separator);
}

ShownSeparator SeparatorOf(std::string_view line) {
  char best = ',';
  std::size_t most = 1;
  std::optional<char> rival;
  std::vector<std::string_view> fields;
  std::string unquoted;
  line = WithoutBlanks(line);
  for (const char separator : kSeparators) {
    // A line with a fault is reported when it is read.
    static_cast<void>(SplitFields(line, separator, fields, unquoted));
    // Numbers with decimal commas have more commas than semicolons.
    if (separator != ',' && fields.size() > 1 && AreNumbers(fields)) {
      return {separator, std::nullopt};
    }
    if (fields.size() > most) {
      best = separator;
      most = fields.size();
      rival.reset();
    } else if (fields.size() == most && most > 1) {
      rival = separator;
    }
  }
  return {best, rival};
}

const char* SplitFields(std::string_view line, char separator,
                        std::vector<std::string_view>& fields, std::string& unquoted) {
  fields.clear();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == separator) {
      fields.push_back(line.substr(begin, i - begin));
      begin = i + 1;
    } else if (line[i] == '"') {
      return SplitQuotedFields(line, separator, fields, unquoted);
    }
  }
  fields.push_back(line.substr(begin));
  return nullptr;
}

std::string_view WithoutBlanks(std::string_view text) noexcept {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
    text.remove_suffix(1);
  }
  return text;
}

bool AreNumbers(const std::vector<std::string_view>& fields) noexcept {
  return std::all_of(fields.begin(), fields.end(), [](std::string_view field) {
    const std::string_view text = WithoutBlanks(field);
    return FiniteNumber(text, '.') || FiniteNumber(text, ',');
  });
}

bool HasDecimalMark(std::string_view text, char decimal_mark) noexcept {
  return text.find(decimal_mark) != std::string_view::npos &&
         FiniteNumber(text, decimal_mark).has_value();
}

}  // namespace girdle
