// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Pictures as PNG files.
#pragma once

#include <string>

#include "pictures/picture.h"

namespace girdle {

/// Returns the bytes of a PNG file: 8 bits per colour, sRGB, without date and comment. Equal
/// pictures give equal bytes. Throws InputError if there is not enough memory.
[[nodiscard]] std::string PngBytes(const Picture& picture);

}  // namespace girdle
