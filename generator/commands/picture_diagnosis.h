// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What draws pictures on this machine, and what makes videos of them.
#pragma once

#include "mujoco_search/diagnosis.h"

namespace girdle {

/// Sets what `diagnosis` says of pictures and videos. OpenGL's libraries are opened in a process of
/// their own, which may crash.
void DiagnosePictures(Diagnosis& diagnosis);

}  // namespace girdle
