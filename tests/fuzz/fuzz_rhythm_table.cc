// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads a table of the rhythm, writes it and reads it again. Makes a rhythm of it in every way.

#include <sstream>

#include "anatomy/built_in_anatomy.h"
#include "reading.h"
#include "returned.h"
#include "rhythm_tables/rhythm_choice.h"
#include "rhythm_tables/rhythm_table_csv.h"

namespace girdle::fuzz {
namespace {

void ExpectRhythms(const RhythmTable& table) {
  static const JointRanges kRanges = BuiltInAnatomy().ranges;
  for (const Interpolation interpolation :
       {Interpolation::kSmooth, Interpolation::kSquad, Interpolation::kSlerp}) {
    for (const Closure closure : {Closure::kExact, Closure::kTable}) {
      const RhythmChoice choice{interpolation, closure, std::nullopt, ReadTable{table, kName}};
      const auto rhythm = ResultOf([&] { return MakeRhythm(Resolve(choice), kRanges); });
      if (!rhythm) {
        continue;
      }
      for (const ArmCommand& command :
           {ArmCommand{}, ArmCommand{1, 0.5, 0.1, 0.1, -0.1}, ArmCommand{3, -2}}) {
        Expect(IsPose(rhythm->SolvePose(command)), "a rhythm's pose has rotations");
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream in(TextOf(bytes, size));
  const auto table = ResultOf([&] { return ReadRhythmTable(in, kName); });
  if (!table) {
    return 0;
  }
  const std::string line = RhythmTableToLine(*table);
  const auto again = ResultOf([&] { return RhythmTableFromLine(line, kName); });
  Expect(again && RhythmTableToLine(*again) == line, "a written table is read as it was");
  ExpectRhythms(*table);
  return 0;
}

}  // namespace girdle::fuzz
