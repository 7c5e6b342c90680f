// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Faults of single versions of MuJoCo that make a shoulder move wrongly without a message.
#pragma once

#include <string>

namespace girdle {

/// Returns the fault of MuJoCo's version `version` (the number of mj_version) with this model and
/// the fix, or an empty text. `is_sparse` is the result of mj_isSparse for the model.
///   4.0.0  factorises sparse matrices wrongly.
/// Version 3.3.0 reads the ranges of an attached model, in radians, as degrees: see model_faults.h.
[[nodiscard]] std::string EngineFault(int version, bool is_sparse);

}  // namespace girdle
