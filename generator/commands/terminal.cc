// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace girdle {
namespace {

constexpr std::size_t kNarrowest = 60;
constexpr std::size_t kWidest = 200;

std::string_view Variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): one thread yet
  return value == nullptr ? std::string_view() : value;
}

}  // namespace

bool IsTerminal() { return isatty(STDOUT_FILENO) != 0; }

TextStyle StyleOfStandardOutput() {
  TextStyle style;
  if (!IsTerminal()) {
    return style;
  }
  winsize size = {};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.width = std::clamp<std::size_t>(size.ws_col, kNarrowest, kWidest);
  }
  style.has_colour = Variable("NO_COLOR").empty() && Variable("TERM") != "dumb";
  return style;
}

}  // namespace girdle
