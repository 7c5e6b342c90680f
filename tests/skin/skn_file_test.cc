// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/skn_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace girdle::skn_file_test {
namespace {

// Two triangles on two bones; every number is another one and has no error as a float.
BoundSkin Skin() {
  return {{{{0.5, 0.25, 0.125}, {-1, 2, 3}, {4, -5, 6}, {7, 8, -9}}, {{0, 1, 2}, {2, 1, 3}}},
          {{"thorax", {{1, 0, 0, 0}, {0.75, 1.5, -2.5}}, {{0, 1}, {2, 0.5}}},
           {"humerus_r", {{0.5, 0.5, -0.5, 0.5}, {10, 11, 12}}, {{1, 1}, {2, 0.5}, {3, 1}}}}};
}

// Reads as MuJoCo's manual describes the format (XMLreference, deformable/skin): integers and
// numbers of 32 bits as this machine has them, which is little-endian wherever MuJoCo runs.
class SknReader {
 public:
  explicit SknReader(const std::string& bytes) : bytes_(bytes) {}

  [[nodiscard]] std::vector<std::int32_t> Integers(std::size_t count) {
    return Next<std::int32_t>(count);
  }
  [[nodiscard]] std::vector<float> Numbers(std::size_t count) { return Next<float>(count); }
  [[nodiscard]] std::string Characters(std::size_t count) {
    const std::vector<char> characters = Next<char>(count);
    return {characters.begin(), characters.end()};
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  template <typename T>
  std::vector<T> Next(std::size_t count) {
    if (count * sizeof(T) > left()) {
      throw std::out_of_range("the file ends at " + std::to_string(bytes_.size()));
    }
    std::vector<T> values(count);
    std::memcpy(values.data(), bytes_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
    return values;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

// The name, and nothing behind it but zeros.
std::string InFortyBytes(std::string name) {
  name.resize(40, '\0');
  return name;
}

TEST(SknBytes, AreThoseOfMujocosManual) {
  const std::string bytes = SknBytes(Skin());
  SknReader reader(bytes);
  using Integers = std::vector<std::int32_t>;
  using Numbers = std::vector<float>;
  EXPECT_EQ(reader.Integers(4), (Integers{4, 0, 2, 2})) << "vertices, texture, faces, bones";
  EXPECT_EQ(reader.Numbers(12), (Numbers{0.5, 0.25, 0.125, -1, 2, 3, 4, -5, 6, 7, 8, -9}));
  EXPECT_EQ(reader.Integers(6), (Integers{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(reader.Characters(40), InFortyBytes("thorax"));
  EXPECT_EQ(reader.Numbers(3), (Numbers{0.75, 1.5, -2.5}));
  EXPECT_EQ(reader.Numbers(4), (Numbers{1, 0, 0, 0})) << "w x y z";
  EXPECT_EQ(reader.Integers(1), (Integers{2}));
  EXPECT_EQ(reader.Integers(2), (Integers{0, 2}));
  EXPECT_EQ(reader.Numbers(2), (Numbers{1, 0.5}));
  EXPECT_EQ(reader.Characters(40), InFortyBytes("humerus_r"));
  EXPECT_EQ(reader.Numbers(3), (Numbers{10, 11, 12}));
  EXPECT_EQ(reader.Numbers(4), (Numbers{0.5, 0.5, -0.5, 0.5})) << "w x y z";
  EXPECT_EQ(reader.Integers(1), (Integers{3}));
  EXPECT_EQ(reader.Integers(3), (Integers{1, 2, 3}));
  EXPECT_EQ(reader.Numbers(3), (Numbers{1, 0.5, 1}));
  EXPECT_EQ(reader.left(), 0U);
}

TEST(SknBytes, AreLittleEndian) {
  // 4 vertices, then after four counts 0.5 = 0x3f000000.
  const std::string bytes = SknBytes(Skin());
  EXPECT_EQ(bytes.substr(0, 4), std::string("\x04\0\0\0", 4));
  EXPECT_EQ(bytes.substr(16, 4), std::string("\0\0\0\x3f", 4));
}

TEST(SknBytes, HaveRoomForANameOfThirtyNine) {
  BoundSkin skin = Skin();
  skin.bones[1].body = std::string(39, 'b');
  EXPECT_NE(SknBytes(skin).find(skin.bones[1].body + '\0'), std::string::npos);
}

// MuJoCo ends a name at its first zero, which is one of the 40.
TEST(SknBytes, HaveNoRoomForANameOfForty) {
  BoundSkin skin = Skin();
  skin.bones[1].body = std::string(40, 'b');
  try {
    static_cast<void>(SknBytes(skin));
    FAIL() << "was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), "an .skn file has no room for the name " + skin.bones[1].body);
  }
}

}  // namespace
}  // namespace girdle::skn_file_test
