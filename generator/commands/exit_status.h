// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How the program ends.
#pragma once

#include <exception>
#include <ostream>

namespace girdle {

/// Exit statuses of the program. They are public: scripts act on them.
inline constexpr int kFine = 0;
inline constexpr int kAboveTolerance = 1;  ///< a residual or a check; its report is printed
inline constexpr int kBadInput = 2;        ///< or bad usage, or an output that cannot be written
inline constexpr int kFaultOfGirdle = 3;   ///< nothing that the user gave is to blame
inline constexpr int kOutOfMemory = 4;     ///< Girdle's or MuJoCo's; more memory may help

/// Writes to `out` what an exception that ends the program means, and returns the exit status.
///
/// InputError is the user's to correct. std::filesystem::filesystem_error is too: it names a path
/// that the system refuses. If memory is used up, neither the input nor Girdle is at fault. Every
/// other exception is a fault of Girdle; its type and message are printed, and a line on what to
/// report. Precondition: `exception` is not null.
[[nodiscard]] int ReportException(const std::exception_ptr& exception, std::ostream& out);

}  // namespace girdle
