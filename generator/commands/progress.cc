// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/progress.h"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace girdle {

TerminalProgress::TerminalProgress(std::string label, bool wanted)
    : label_(std::move(label)), is_shown_(wanted && isatty(STDERR_FILENO) != 0) {}

TerminalProgress::~TerminalProgress() { Clear(); }

void TerminalProgress::operator()(double done) {
  constexpr double kPercent = 100;
  const int percent = static_cast<int>(kPercent * done);
  if (is_shown_ && percent != shown_percent_) {
    shown_percent_ = percent;
    std::cerr << "\r" << label_ << " " << percent << " %" << std::flush;
  }
}

void TerminalProgress::Clear() {
  if (shown_percent_ >= 0) {
    shown_percent_ = -1;
    // Clears the label, a blank and "100 %".
    std::cerr << "\r" << std::string(label_.size() + 6, ' ') << "\r" << std::flush;
  }
}

}  // namespace girdle
