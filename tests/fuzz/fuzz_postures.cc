// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads a file of postures.

#include <sstream>

#include "anatomy/postures.h"
#include "reading.h"
#include "returned.h"

namespace girdle::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream in(TextOf(bytes, size));
  const auto posture = ResultOf([&] { return ReadPosture(in, kName, "relaxed"); });
  Expect(!posture || (IsRotation(posture->q_TC) && IsRotation(posture->q_CS)),
         "a posture has rotations");
  return 0;
}

}  // namespace girdle::fuzz
