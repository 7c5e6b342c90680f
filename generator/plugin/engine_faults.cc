// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_faults.h"

namespace girdle {

std::string EngineFault(int version, bool is_sparse) {
  constexpr int kWrongWhereSparse = 4000000;
  if (version == kWrongWhereSparse && is_sparse) {
    return "MuJoCo 4.0.0 solves sparse models wrongly, and this one is sparse. Add <option "
           "jacobian=\"dense\"/> to the model, or run another version";
  }
  return "";
}

}  // namespace girdle
