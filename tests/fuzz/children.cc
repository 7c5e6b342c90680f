// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "children.h"

#include <pthread.h>

#include <csignal>

namespace girdle::fuzz {
namespace {

// Runs in each child, first of all.
void ForgetFuzzer() {
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) {
    std::signal(signal, SIG_DFL);
  }
}

}  // namespace

void LetChildrenCrash() { pthread_atfork(nullptr, nullptr, ForgetFuzzer); }

}  // namespace girdle::fuzz
