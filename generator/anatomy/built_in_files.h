// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The built-in anatomy and postures, as text. The build makes the definitions from the files of
/// data/.
#pragma once

#include <string_view>

namespace girdle::built_in_files {

extern const std::string_view kLandmarks;
extern const std::string_view kSegments;
extern const std::string_view kJointRanges;
extern const std::string_view kThoraxEllipsoids;
extern const std::string_view kLigaments;
extern const std::string_view kPostures;

}  // namespace girdle::built_in_files
