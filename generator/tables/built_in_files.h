// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Contents of the files in data/, as text. The build makes the definitions from the files.
#pragma once

#include <string_view>

namespace girdle::built_in_files {

extern const std::string_view kLudewig2009;
extern const std::string_view kLudewig2009Destepped;
extern const std::string_view kLandmarks;
extern const std::string_view kSegments;
extern const std::string_view kJointRanges;
extern const std::string_view kThoraxEllipsoids;
extern const std::string_view kLigaments;
extern const std::string_view kPostures;
extern const std::string_view kPublishedRhythms;
extern const std::string_view kMakeHumanFit;

}  // namespace girdle::built_in_files
