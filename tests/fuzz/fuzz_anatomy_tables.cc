// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads the tables of an anatomy. What can be written is written and read again.

#include <sstream>

#include "anatomy/anatomy.h"
#include "reading.h"

namespace girdle::fuzz {
namespace {

using Reader = void (*)(std::istream& in, const std::string& name, Anatomy& anatomy);
using Writer = std::string (*)(const Anatomy& anatomy, const std::vector<std::string>& comments);

std::optional<Anatomy> Read(const std::string& text, Reader reader) {
  return ResultOf([&] {
    std::istringstream in(text);
    Anatomy anatomy;
    reader(in, kName, anatomy);
    return anatomy;
  });
}

void ReadAndWrite(const std::string& text, Reader reader, Writer writer) {
  if (const auto anatomy = Read(text, reader)) {
    const std::string written = writer(*anatomy, {});
    const auto again = Read(written, reader);
    Expect(again && writer(*again, {}) == written, "a written table is read as it was");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = TextOf(bytes, size);
  ReadAndWrite(text, ReadLandmarks, LandmarksToCsv);
  ReadAndWrite(text, ReadThoraxEllipsoids, ThoraxEllipsoidsToCsv);
  for (const Reader reader : {ReadSegments, ReadJointRanges, ReadLigaments}) {
    static_cast<void>(Read(text, reader));
  }
  return 0;
}

}  // namespace girdle::fuzz
