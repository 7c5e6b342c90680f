// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Pictures as PNG files.
#pragma once

#include <string>

#include "pictures/picture.h"

namespace girdle {

/// Returns the bytes of a PNG file, 8 bits a colour, sRGB, without date or comment: the same
/// picture gives the same bytes. Throws InputError if there is not enough memory.
[[nodiscard]] std::string PngBytes(const Picture& picture);

}  // namespace girdle
