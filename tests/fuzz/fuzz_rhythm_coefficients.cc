// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads the coefficients of published rhythms, and asks the rhythms for poses.

#include <sstream>

#include "reading.h"
#include "returned.h"
#include "rhythms/published_rhythms.h"

namespace girdle::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream in(TextOf(bytes, size));
  const auto rhythms =
      ResultOf([&] { return PublishedRhythms(ReadRhythmCoefficients(in, kName)); });
  if (rhythms) {
    for (const PublishedRhythm& rhythm : *rhythms) {
      const GirdlePose pose = rhythm.girdle(2, 1);
      Expect(IsRotation(pose.q_TC) && IsRotation(pose.q_TS), "a published rhythm has rotations");
    }
  }
  return 0;
}

}  // namespace girdle::fuzz
