// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/gltf_nodes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace girdle::gltf_nodes_test {
namespace {

// Returns the flaw of a file with these bytes; empty if it has none.
std::string FlawOf(const std::string& bytes) {
  const std::string path = testing::TempDir() + "/girdle_gltf_nodes.gltf";
  std::ofstream(path, std::ios::binary) << bytes;
  std::string flaw = FlawOfGltfNodes(path).value_or("");
  std::filesystem::remove(path);
  return flaw;
}

std::string WithNodes(const std::string& nodes) {
  return R"({"asset": {"version": "2.0"}, "nodes": )" + nodes + "}";
}

TEST(FlawOfGltfNodes, IsNoneForTrees) {
  EXPECT_EQ(FlawOf(WithNodes(R"([{"children": [1, 2]}, {}, {}])")), "");
}

TEST(FlawOfGltfNodes, IsAChildThatIsNoWholeNumber) {
  for (const std::string child : {"1.5", "1e+300", "-1e+300"}) {
    EXPECT_EQ(FlawOf(WithNodes(R"([{"children": [)" + child + "]}, {}]")),
              "the child " + child + " of a node is no whole number");
  }
}

TEST(FlawOfGltfNodes, SaysBrieflyWhatIsNoJson) {
  constexpr std::size_t kLong = 1'000'000;
  EXPECT_EQ(FlawOf("{\"" + std::string(kLong, 'a')),
            "its JSON is wrong, or cut short: no JSON at byte 1000003");
  EXPECT_EQ(FlawOf(WithNodes(std::string(kLong, '9'))),
            "its JSON is wrong, or cut short: a number is too large");
}

}  // namespace
}  // namespace girdle::gltf_nodes_test
