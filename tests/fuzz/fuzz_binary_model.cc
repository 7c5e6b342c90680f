// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Checks a binary model (MJB). The input says which bytes of a good one are replaced, and where it
// is cut off.

#include "children.h"
#include "input_file.h"
#include "input_values.h"
#include "reading.h"
#include "simulation/binary_model.h"
#include "simulation/engine.h"

namespace girdle::fuzz {
namespace {

constexpr const char* kModel = R"(
<mujoco>
  <worldbody><body name="thorax"><joint name="j"/><geom size="1"/></body></worldbody>
  <actuator><motor joint="j"/></actuator>
  <sensor><jointpos joint="j"/></sensor>
</mujoco>)";

std::string GoodModel() {
  const ModelPointer model = LoadModel(ModelFiles{{"input.xml", kModel}});
  std::string bytes(static_cast<std::size_t>(mj_sizeModel(model.get())), '\0');
  mj_saveModel(model.get(), nullptr, bytes.data(), static_cast<int>(bytes.size()));
  return bytes;
}

std::string DamagedModel(std::string bytes, InputValues values) {
  constexpr std::size_t kMostCut = 16;
  bytes.resize(bytes.size() - values.TakeByte() % kMostCut);
  while (!values.empty()) {
    const std::size_t place = values.TakeBelow(bytes.size());
    bytes[place] = static_cast<char>(values.TakeByte());
  }
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*words*/) {
  LetChildrenCrash();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const EngineWatch kWatch;
  static const std::string kGood = GoodModel();
  static const InputFile kFile(".mjb");
  const std::string text = BytesOf(bytes, size);
  const std::string& path = kFile.With(DamagedModel(kGood, InputValues(text)));
  static_cast<void>(ResultOf([&] {
    ExpectLoadable(path);
    return true;
  }));
  return 0;
}

}  // namespace girdle::fuzz
