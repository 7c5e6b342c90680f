// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Units of length.
#pragma once

namespace girdle {

/// Lengths are in meters, and in millimeters where people read them.
inline constexpr double kMillimetersPerMeter = 1000;

}  // namespace girdle
