// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Faults of single versions of MuJoCo that make a shoulder move wrongly without a word.
#pragma once

#include <string>

#include "plugin/engine_views.h"

namespace girdle {

/// Returns what version `version` (as mj_version) does wrongly with this model, with the fix, or
/// nothing. `instance` is that of the plugin, `is_sparse` what mj_isSparse says of the model.
///   4.0.0  factorises sparse matrices wrongly;
///   3.3.0  takes the ranges of an attached model, in radians, for degrees.
[[nodiscard]] std::string EngineFault(int version, const ModelView& model, int instance,
                                      bool is_sparse);

}  // namespace girdle
