// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Names of temporary files that nobody can foresee.
#pragma once

#include <string>

namespace girdle {

/// Returns 1 to 16 random hexadecimal digits. Throws InputError if the system gives none.
[[nodiscard]] std::string RandomName();

}  // namespace girdle
