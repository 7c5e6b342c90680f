// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads the mapping of a foreign model.

#include <sstream>

#include "reading.h"
#include "returned.h"
#include "simulation/model_mapping.h"

namespace girdle::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream in(TextOf(bytes, size));
  const auto mapping = ResultOf([&] { return ReadModelMapping(in, kName); });
  if (mapping) {
    Expect(!mapping->drives.empty(), "a mapping sets the arm");
    for (const auto& bone : mapping->bones) {
      Expect(!bone || IsRotation(bone->q_BF), "a mapped bone has a rotation");
    }
  }
  return 0;
}

}  // namespace girdle::fuzz
