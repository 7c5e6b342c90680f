// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The built-in rhythm tables, as text. The build makes the definitions from the files of data/.
#pragma once

#include <string_view>

namespace girdle::built_in_files {

extern const std::string_view kLudewig2009;
extern const std::string_view kLudewig2009Smoothed;

}  // namespace girdle::built_in_files
