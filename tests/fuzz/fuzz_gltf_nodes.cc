// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Checks the nodes of a glTF file.

#include "input_file.h"
#include "reading.h"
#include "skin/gltf_nodes.h"

namespace girdle::fuzz {

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const InputFile kFile(".glb");
  const std::string& path = kFile.With(TextOf(bytes, size));
  const auto flaw = ResultOf([&] { return FlawOfGltfNodes(path); });
  Expect(flaw.has_value(), "a file that can be opened is no InputError");
  Expect(!*flaw || (!(*flaw)->empty() && (*flaw)->size() <= kLongestMessage), "a flaw is short");
  return 0;
}

}  // namespace girdle::fuzz
