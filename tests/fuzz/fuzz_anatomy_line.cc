// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads the anatomy that a model carries as one line, writes it and reads it again.

#include "anatomy/anatomy_line.h"
#include "reading.h"

namespace girdle::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto anatomy = ResultOf([&] { return AnatomyFromLine(TextOf(bytes, size), kName); });
  if (anatomy) {
    const std::string line = AnatomyAsLine(*anatomy);
    const auto again = ResultOf([&] { return AnatomyFromLine(line, kName); });
    Expect(again && AnatomyAsLine(*again) == line && IsSame(*anatomy, *again),
           "a written anatomy is read as it was");
  }
  return 0;
}

}  // namespace girdle::fuzz
