// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads a table of poses of the arm, in every convention and unit.

#include <cmath>
#include <optional>
#include <sstream>

#include "motions/command_columns.h"
#include "reading.h"
#include "text/csv.h"

namespace girdle::fuzz {
namespace {

// Returns how many rows have a command.
std::size_t CommandsIn(const std::string& text, const AngleReading& reading) {
  std::istringstream in(text);
  CsvReader csv(in, kName);
  const CommandColumns columns(csv, reading);
  AngleSpan span;
  std::size_t count = 0;
  while (csv.Next()) {
    const std::optional<ArmCommand> command = columns.Read(csv.row(), {}, span);
    if (!command) {
      continue;
    }
    ++count;
    Expect(command->elevation_rad >= 0 &&
               command->elevation_rad <= RadiansFromDegrees(kHalfCircle_deg),
           "an elevation is within 0 to 180 deg");
    Expect(std::abs(command->plane_rad) <= RadiansFromDegrees(kHalfCircle_deg),
           "a plane is within -180 to 180 deg");
    Expect(std::isfinite(command->axial_rad) && std::isfinite(command->shrug_rad) &&
               std::isfinite(command->protraction_rad),
           "axial turn and offsets are finite");
  }
  span.ExpectKnownUnit(kName);
  return count;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = TextOf(bytes, size);
  for (const AngleConvention convention : {AngleConvention::kGirdle, AngleConvention::kIsb}) {
    for (const std::optional<AngleUnit> unit :
         {std::optional<AngleUnit>(), std::optional(AngleUnit::kDegree),
          std::optional(AngleUnit::kRadian)}) {
      static_cast<void>(
          ResultOf([&] { return CommandsIn(text, {.convention = convention, .unit = unit}); }));
    }
  }
  return 0;
}

}  // namespace girdle::fuzz
