// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/xml_model.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "child_programs/child_process.h"
#include "mjcf/model_elements.h"
#include "simulation/engine.h"
#include "text/input_error.h"

namespace girdle {
namespace {

// An attribute that MuJoCo allocates memory by.
struct SizeLimit {
  std::string_view element;
  std::string_view attribute;
  int most;
};
// Each product of these with the elements of a large model takes less than 1 GB.
constexpr int kMostPerElement = 10'000;
constexpr int kMostNumbers = 10'000'000;
constexpr int kMostPixels = 8192;  // along an edge, as OpenGL everywhere takes
constexpr auto kSizeLimits = std::to_array<SizeLimit>({
    {"size", "nuser_body", kMostPerElement},
    {"size", "nuser_jnt", kMostPerElement},
    {"size", "nuser_geom", kMostPerElement},
    {"size", "nuser_site", kMostPerElement},
    {"size", "nuser_cam", kMostPerElement},
    {"size", "nuser_tendon", kMostPerElement},
    {"size", "nuser_actuator", kMostPerElement},
    {"size", "nuser_sensor", kMostPerElement},
    {"size", "nkey", kMostPerElement},
    {"size", "nuserdata", kMostNumbers},
    {"size", "njmax", kMostNumbers},
    {"size", "nconmax", kMostNumbers},
    {"size", "nstack", kMostNumbers},
    {"replicate", "count", kMostPerElement},
    {"texture", "width", kMostPixels},
    {"texture", "height", kMostPixels},
    {"hfield", "nrow", kMostPixels},
    {"hfield", "ncol", kMostPixels},
});

[[noreturn]] void FailTooLarge(const tinyxml2::XMLElement& element, const std::string& attribute,
                               const std::filesystem::path& file, const std::string& most) {
  throw InputError(file.string() + ":" + std::to_string(element.GetLineNum()) + ": <" +
                   element.Name() + " " + attribute + "=\"" + element.Attribute(attribute.c_str()) +
                   "\"> takes too much memory. Write at most " + most);
}

// Returns the bytes of a text such as 100M; 0 for any other text, which MuJoCo reports.
double BytesOf(const std::string& text) {
  constexpr double kStep = 1024;
  constexpr std::string_view kSuffixes = "KMGTPE";
  double bytes = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, bytes);
  const std::size_t steps =
      stop == end
          ? 0
          : kSuffixes.find(static_cast<char>(std::toupper(static_cast<unsigned char>(*stop)))) + 1;
  return error == std::errc() && bytes > 0 ? bytes * std::pow(kStep, steps) : 0;
}

void ExpectModestSizes(const tinyxml2::XMLElement& element, const std::filesystem::path& file) {
  for (const SizeLimit& limit : kSizeLimits) {
    if (element.Name() != limit.element) {
      continue;
    }
    const std::string attribute(limit.attribute);
    double value = 0;
    // MuJoCo reports what is no number.
    if (element.QueryDoubleAttribute(attribute.c_str(), &value) == tinyxml2::XML_SUCCESS &&
        value > limit.most) {
      FailTooLarge(element, attribute, file, std::to_string(limit.most));
    }
  }
}

// Returns the bytes that an element reserves for the arena; 0 if it is another element.
double ArenaOf(const tinyxml2::XMLElement& element, const std::filesystem::path& file) {
  constexpr const char* kMemory = "memory";
  const char* const text = element.Attribute(kMemory);
  if (element.Name() != std::string_view("size") || text == nullptr) {
    return 0;
  }
  const double bytes = BytesOf(text);
  if (bytes > kMostArena) {
    FailTooLarge(element, kMemory, file, kMostArenaText);
  }
  return bytes;
}

constexpr int kLongestLoading_s = 60;
constexpr std::size_t kMostMemory = 1'000'000'000;
// Kinds of the child's answer, its first byte. It writes nothing if all is well.
constexpr char kEngineFault = 'e';
constexpr char kModelFault = 'm';
constexpr char kNoMemory = 'n';
constexpr const char* kLowerSizes =
    ". Lower what makes the model large, such as counts of replicate and composite, vertices of "
    "meshes, and sizes of pictures and height fields";

}  // namespace

void ExpectLoadableXml(const std::string& path, const std::function<void()>& load) {
  double arena = 0;
  VisitElements(path, [&](const tinyxml2::XMLElement& element, const std::filesystem::path& file) {
    ExpectModestSizes(element, file);
    arena = std::max(arena, ArenaOf(element, file));
  });
  std::error_code unclear;
  const std::filesystem::path folder = std::filesystem::current_path(unclear);
  const ChildResult tried = RunInChild(
      [&](const auto& write) {
        std::error_code ignored;
        // The files that the model names may be relative to it.
        std::filesystem::current_path(folder, ignored);
        try {
          load();
        } catch (const EngineError& error) {
          write(kEngineFault + std::string(error.what()));
        } catch (const InputError& error) {
          write(kModelFault + std::string(error.what()));
        } catch (const std::bad_alloc&) {
          write(std::string(1, kNoMemory));
        }
      },
      {.time_s = kLongestLoading_s, .memory_bytes = kMostMemory + static_cast<std::size_t>(arena)});
  if (!tried.failure.empty()) {
    throw InputError(path +
                     ": MuJoCo cannot load it: a process that did, with at most 1 GB of "
                     "memory, " +
                     tried.failure + kLowerSizes);
  }
  if (tried.output.empty()) {
    return;
  }
  const std::string fault = tried.output.substr(1);
  switch (tried.output.front()) {
    case kEngineFault:
      throw EngineError(fault);
    case kModelFault:
      throw InputError(fault);
    default:
      throw InputError(path + ": MuJoCo needs more than 1 GB of memory to load it" + kLowerSizes);
  }
}

}  // namespace girdle
