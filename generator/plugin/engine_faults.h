// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Faults of single versions of MuJoCo that make a shoulder move wrongly without a word.
#pragma once

#include <string>

namespace girdle {

/// Returns what version `version` (as mj_version) does wrongly with this model, with the fix, or
/// nothing. `is_sparse` is what mj_isSparse says of the model.
///   4.0.0  factorises sparse matrices wrongly.
/// Version 3.3.0 takes the ranges of an attached model, in radians, for degrees: see
/// model_faults.h.
[[nodiscard]] std::string EngineFault(int version, bool is_sparse);

}  // namespace girdle
