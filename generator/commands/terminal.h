// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Properties of the terminal that the program writes to.
#pragma once

#include "text/text_style.h"

namespace girdle {

/// Returns the width and the colours of texts for people on standard output.
///
/// On a terminal lines have the terminal's width, at least 60 and at most 200 columns, and there is
/// colour unless the environment variable NO_COLOR has a value (no-color.org) or TERM is `dumb`. In
/// a file or a pipe, lines have 80 columns and there is no colour.
[[nodiscard]] TextStyle StyleOfStandardOutput();

/// Returns whether standard output is a terminal.
[[nodiscard]] bool IsTerminal();

}  // namespace girdle
