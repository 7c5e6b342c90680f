// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Diagnosis of the means by which this machine draws pictures and makes videos.
#pragma once

#include "mujoco_search/diagnosis.h"

namespace girdle {

/// Sets the fields of `diagnosis` on pictures and videos. The OpenGL libraries are opened in a
/// child process, because they may crash.
void DiagnosePictures(Diagnosis& diagnosis);

}  // namespace girdle
