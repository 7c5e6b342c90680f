// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads a motion, and asks it for commands before, within and after its time.

#include <cmath>
#include <sstream>

#include "motions/motion.h"
#include "reading.h"

namespace girdle::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream in(TextOf(bytes, size));
  const auto motion = ResultOf([&] { return ReadMotion(in, kName); });
  if (!motion) {
    return 0;
  }
  Expect(motion->duration_s >= 0 && motion->duration_s <= kLongestMotion_s,
         "a motion lasts up to an hour");
  for (const double share : {-1.0, 0.0, 0.3, 0.5, 1.0, 2.0}) {
    const ArmCommand command = motion->command(share * motion->duration_s);
    Expect(std::isfinite(command.elevation_rad) && std::isfinite(command.plane_rad) &&
               std::isfinite(command.axial_rad) && std::isfinite(command.shrug_rad) &&
               std::isfinite(command.protraction_rad),
           "the commands of a motion are finite");
  }
  return 0;
}

}  // namespace girdle::fuzz
