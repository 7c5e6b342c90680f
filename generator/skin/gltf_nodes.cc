// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/gltf_nodes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "skin/json_fault.h"
#include "text/text_file.h"

namespace girdle {
namespace {

// A flaw that FlawOfGltfNodes returns as text.
class GltfFlaw : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] void FailNoGltf() { throw GltfFlaw("it is no glTF of version 2, or is cut short"); }

// Deepest nesting of JSON lists that is accepted, because readers recurse too.
constexpr int kDeepestJson = 100;

nlohmann::json ParseJson(std::istream& in) {
  const auto expect_shallow = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    if (depth > kDeepestJson) throw GltfFlaw("its JSON is nested too deeply");
    return true;
  };
  try {
    return nlohmann::json::parse(in, expect_shallow);
  } catch (const nlohmann::json::exception& error) {
    throw GltfFlaw("its JSON is wrong, or cut short: " + JsonFault(error));
  }
}

// Returns the index of a node. A conversion of a number that is not whole may be undefined.
std::size_t NodeIndex(const nlohmann::json& number) {
  if (number.is_number_float()) {
    throw GltfFlaw("the child " + number.dump() + " of a node is no whole number");
  }
  return number.get<std::size_t>();
}

// Returns the whole number of 32 bits in the next bytes, lowest byte first.
std::uint32_t NextNumber(std::istream& in) {
  std::array<char, 4> bytes{};
  if (!in.read(bytes.data(), bytes.size())) FailNoGltf();
  std::uint32_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

// Returns the first chunk of a binary file, which is JSON. The file has "glTF", its version, its
// length, the length of the chunk, "JSON", and the chunk.
nlohmann::json ParseBinary(std::istream& in) {
  constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
  constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
  constexpr std::uint32_t kVersion = 2;
  if (NextNumber(in) != kMagic || NextNumber(in) != kVersion) FailNoGltf();
  const std::uint32_t length = NextNumber(in);
  const std::uint32_t chunk_length = NextNumber(in);
  if (NextNumber(in) != kJsonChunk) FailNoGltf();
  const std::istream::pos_type chunk = in.tellg();
  in.seekg(0, std::ios::end);
  const std::streamoff size = in.tellg();
  if (size < static_cast<std::streamoff>(length)) {
    throw GltfFlaw("it has only " + std::to_string(size) + " of its " + std::to_string(length) +
                   " bytes, so it is cut short");
  }
  if (chunk_length > length) FailNoGltf();
  in.seekg(chunk);
  // Only the JSON is parsed: the bytes after it would be an error in it.
  std::string text(chunk_length, ' ');
  if (!in.read(text.data(), chunk_length)) FailNoGltf();
  std::istringstream json(std::move(text));
  return ParseJson(json);
}

void ExpectShallowTrees(const nlohmann::json& nodes) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> parents(nodes.size(), kNone);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].contains("children")) continue;
    for (const nlohmann::json& child : nodes[i].at("children")) {
      auto& parent = parents.at(NodeIndex(child));
      if (parent != kNone) {
        throw GltfFlaw("node " + child.dump() + " is the child of two nodes, or twice of one");
      }
      parent = i;
    }
  }
  std::vector<int> depths(nodes.size(), 0);  // 0 if not known
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    // Goes up to a node whose depth is known. A cycle has no such node and ends at the limit.
    int steps = 0;
    std::size_t above = i;
    while (above != kNone && depths[above] == 0 && steps <= kDeepestGltfNode) {
      above = parents[above];
      ++steps;
    }
    depths[i] = steps + (above == kNone ? 0 : depths[above]);
    if (depths[i] > kDeepestGltfNode) {
      throw GltfFlaw("node " + std::to_string(i) + " has more than " +
                     std::to_string(kDeepestGltfNode - 1) + " nodes above it");
    }
  }
}

}  // namespace

std::optional<std::string> FlawOfGltfNodes(const std::string& path) {
  std::ifstream in = OpenTextFile(path);
  try {
    const nlohmann::json gltf = in.peek() == 'g' ? ParseBinary(in) : ParseJson(in);
    if (!gltf.at("asset").at("version").get<std::string>().starts_with("2.")) FailNoGltf();
    if (gltf.contains("nodes")) ExpectShallowTrees(gltf.at("nodes"));
  } catch (const GltfFlaw& flaw) {
    return flaw.what();
  } catch (const nlohmann::json::exception& error) {
    return "it is no glTF of version 2: " + std::string(error.what());
  } catch (const std::out_of_range&) {
    return "a node has a child that is not there";
  }
  return std::nullopt;
}

}  // namespace girdle
