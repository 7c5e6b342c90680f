// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/output_columns.h"

namespace girdle {

std::string ColumnName(std::string_view stem, std::string_view unit) {
  std::string name(stem);
  if (!unit.empty()) {
    name += '_';
    name += unit;
  }
  return name;
}

}  // namespace girdle
