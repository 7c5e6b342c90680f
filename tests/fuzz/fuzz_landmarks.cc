// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads one person's landmarks, writes the bones and reads them again.

#include <sstream>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/person_landmarks.h"
#include "reading.h"
#include "returned.h"

namespace girdle::fuzz {
namespace {

std::optional<Anatomy> AnatomyOf(const std::string& text, const Anatomy& adult) {
  std::istringstream in(text);
  return ResultOf([&] { return ReadPersonAnatomy(in, kName, adult); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const Anatomy kAdult = BuiltInAnatomy();
  const std::string text = TextOf(bytes, size);
  if (const auto anatomy = AnatomyOf(text, kAdult)) {
    const std::string written = LandmarksToCsv(*anatomy, {});
    std::istringstream in(written);
    Anatomy again;
    const auto is_read = ResultOf([&] {
      ReadLandmarks(in, kName, again);
      return true;
    });
    Expect(is_read && again.landmarks_m == anatomy->landmarks_m,
           "written landmarks are read as they were");
    static_cast<void>(AnatomyOf(written, kAdult));
  }
  std::istringstream in(text);
  const auto person = ResultOf([&] { return ReadDigitizedPerson(in, kName, kAdult, "mesh"); });
  Expect(!person || (IsPose(person->pose) && IsRotation(person->q_AT)),
         "a person's pose has rotations");
  return 0;
}

}  // namespace girdle::fuzz
