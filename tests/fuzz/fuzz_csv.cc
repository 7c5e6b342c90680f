// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads a table row by row, and in blocks as threads share it. Both ways find the same.

#include <sstream>
#include <vector>

#include "reading.h"
#include "text/csv.h"

namespace girdle::fuzz {
namespace {

using Fields = std::vector<std::string>;

// Appends the fields of the current row and, of those that are numbers, the number.
void Append(const CsvRows& row, std::size_t columns, std::vector<Fields>& rows) {
  Fields& fields = rows.emplace_back();
  for (std::size_t column = 0; column < columns; ++column) {
    fields.emplace_back(row.Field(column));
    if (const auto number = ResultOf([&] { return row.Number(column); })) {
      fields.push_back(std::to_string(*number));
    }
  }
}

std::vector<Fields> ByRows(const std::string& text) {
  std::istringstream in(text);
  CsvReader csv(in, kName);
  std::vector<Fields> rows = {csv.columns(), csv.comments()};
  while (csv.Next()) {
    Append(csv.row(), csv.columns().size(), rows);
  }
  return rows;
}

std::vector<Fields> ByBlocks(const std::string& text) {
  std::istringstream in(text);
  CsvReader csv(in, kName);
  std::vector<Fields> rows = {csv.columns(), csv.comments()};
  CsvRows row(csv.header());
  for (CsvBlock block; csv.TakeBlock(block);) {
    row.Start(block);
    while (row.Next()) {
      Append(row, csv.columns().size(), rows);
    }
  }
  return rows;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = TextOf(bytes, size);
  Expect(ResultOf([&] { return ByRows(text); }) == ResultOf([&] { return ByBlocks(text); }),
         "a table is the same row by row and in blocks");
  return 0;
}

}  // namespace girdle::fuzz
