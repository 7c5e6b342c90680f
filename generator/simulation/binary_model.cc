// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/binary_model.h"

#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "child_programs/child_process.h"
#include "names/model_names.h"
#include "simulation/engine.h"
#include "simulation/xml_model.h"
#include "text/input_error.h"

namespace girdle {
namespace {

constexpr const char* kFix = ". Give its XML or make it anew with girdle generate";

template <typename T>
void Read(std::ifstream& in, T& value) {
  in.read(reinterpret_cast<char*>(&value), sizeof(value));  // NOLINT(*-reinterpret-cast)
}

// Reads the numbers of elements of an MJB. Throws InputError if the file is of another MuJoCo or is
// not complete. This check is needed because MuJoCo allocates memory for these sizes before it
// checks how much of the file follows.
mjModel ReadSizes(const std::string& path, std::ifstream& in) {
  // An MJB begins with this number. Then come the size of mjtNum, the number of sizes, the version
  // of MuJoCo, the number of arrays, and the sizes.
  constexpr std::int32_t kFirst = 54321;
  std::array<std::int32_t, 5> header{};
  Read(in, header);
  if (!in || header[0] != kFirst) {
    throw InputError(path + ": is no binary model (MJB) of MuJoCo" + kFix);
  }
  if (header[3] != mj_version()) {
    throw InputError(path + ": was saved by another version of MuJoCo than " + mj_versionString() +
                     ", which runs here" + kFix);
  }
  mjModel sizes{};
#define X(name) Read(in, sizes.name);
  MJMODEL_SIZES
#undef X
  std::error_code ignored;
  if (!in || static_cast<std::uintmax_t>(mj_sizeModel(&sizes)) !=
                 std::filesystem::file_size(path, ignored)) {
    throw InputError(path + ": is cut short or damaged" + kFix);
  }
  if (static_cast<double>(sizes.narena) > kMostArena) {
    throw InputError(path + ": reserves " + std::to_string(sizes.narena) +
                     " bytes for its contacts and constraints, which is too much memory. Save it "
                     "again with <size memory=\"" +
                     kMostArenaText + "\"> or less");
  }
  return sizes;
}

// Reads the array of mjModel with this name. There is no gap between the arrays. They begin at the
// size of a model without any array.
std::string ReadArray(std::ifstream& in, const mjModel& sizes, std::string_view wanted) {
  const mjModel none{};
  auto begin = static_cast<std::size_t>(mj_sizeModel(&none));
  const auto end = static_cast<std::size_t>(mj_sizeModel(&sizes));
  std::string bytes;
  MJMODEL_POINTERS_PREAMBLE((&sizes))
#define X(type, name, nr, nc)                                                             \
  {                                                                                       \
    const std::size_t size =                                                              \
        sizeof(type) * static_cast<std::size_t>(sizes.nr) * static_cast<std::size_t>(nc); \
    if (wanted == #name && begin <= end && size <= end - begin) {                         \
      bytes.resize(size);                                                                 \
      in.seekg(static_cast<std::streamoff>(begin));                                       \
    }                                                                                     \
    begin += size;                                                                        \
  }
  MJMODEL_POINTERS
#undef X
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

// Throws InputError unless all plugin instances of an MJB are of girdle.rhythm. The file names a
// plugin by the slot number that it had in the process that saved it.
void ExpectOwnPlugin(const std::string& path, std::ifstream& in, const mjModel& sizes) {
  int own_slot = -1;
  const mjpPlugin* const plugin = mjp_getPlugin(kPluginName, &own_slot);
  const std::string bytes = ReadArray(in, sizes, "plugin");
  std::vector<int> slots(bytes.size() / sizeof(int));
  if (!slots.empty()) {
    std::memcpy(slots.data(), bytes.data(), bytes.size());
  }
  const auto other = std::find_if(slots.begin(), slots.end(),
                                  [&](int slot) { return plugin == nullptr || slot != own_slot; });
  // A zero ends each attribute of each instance.
  const std::string attributes = ReadArray(in, sizes, "plugin_attr");
  if (other != slots.end() ||
      (plugin != nullptr && std::count(attributes.begin(), attributes.end(), '\0') !=
                                plugin->nattribute * sizes.nplugin)) {
    throw InputError(path + ": was saved in a process with other plugins than " + kPluginName +
                     ": an MJB names its plugins by slot number, and " +
                     std::to_string(other == slots.end() ? own_slot : *other) +
                     " is another one here. Give its XML: Python's MuJoCo, for one, always loads "
                     "other plugins");
  }
}

// Throws InputError if a copy of this process does not survive some steps of an MJB.
void ExpectSurvived(const std::string& path) {
  constexpr int kLimit_s = 60;
  constexpr int kSteps = 10;
  const std::string whole_path = std::filesystem::absolute(path);  // the child is elsewhere
  const ChildResult tried = RunInChild(
      [&whole_path](const auto& /*write*/) {
        try {
          if (const ModelPointer model{mj_loadModel(whole_path.c_str(), nullptr)}) {
            const DataPointer data(mj_makeData(model.get()));
            for (int step = 0; data != nullptr && step < kSteps; ++step) {
              mj_step(model.get(), data.get());
            }
          }
        } catch (const InputError&) {
          return;  // the caller loads the file next and reports the error
        }
      },
      {.time_s = kLimit_s});
  if (tried.is_late) {
    throw InputError(path + ": cannot be told from a damaged one: a process that stepped it " +
                     std::to_string(kSteps) + " times " + tried.failure + kFix);
  }
  if (!tried.failure.empty()) {
    throw InputError(path + ": is damaged: a process that stepped it " + tried.failure + kFix);
  }
}

}  // namespace

void ExpectLoadable(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  ExpectOwnPlugin(path, in, ReadSizes(path, in));
  ExpectSurvived(path);
}

}  // namespace girdle
