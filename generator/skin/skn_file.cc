// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/skn_file.h"

#include <bit>
#include <cstdint>
#include <stdexcept>

namespace girdle {
namespace {

constexpr std::size_t kNameBytes = 40;

void Append(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<char>((word >> shift) & 0xffU));
  }
}
void AppendInteger(std::string& bytes, std::size_t number) {
  Append(bytes, static_cast<std::uint32_t>(number));
}
void AppendFloat(std::string& bytes, double number) {
  Append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(number)));
}
void AppendVector(std::string& bytes, const Vector3& vector) {
  AppendFloat(bytes, vector.x);
  AppendFloat(bytes, vector.y);
  AppendFloat(bytes, vector.z);
}

}  // namespace

std::string SknBytes(const BoundSkin& skin) {
  std::string bytes;
  AppendInteger(bytes, skin.surface.vertices_m.size());
  AppendInteger(bytes, 0);  // coordinates of a texture
  AppendInteger(bytes, skin.surface.triangles.size());
  AppendInteger(bytes, skin.bones.size());
  for (const Vector3& vertex : skin.surface.vertices_m) {
    AppendVector(bytes, vertex);
  }
  for (const Triangle& triangle : skin.surface.triangles) {
    for (const int corner : triangle) {
      Append(bytes, static_cast<std::uint32_t>(corner));
    }
  }
  for (const BoundBone& bone : skin.bones) {
    if (bone.body.size() >= kNameBytes) {
      throw std::invalid_argument("an .skn file has no room for the name " + bone.body);
    }
    bytes += bone.body;
    bytes.append(kNameBytes - bone.body.size(), '\0');
    AppendVector(bytes, bone.bind.p_TB_m);
    AppendFloat(bytes, bone.bind.q_TB.w);
    AppendVector(bytes, {bone.bind.q_TB.x, bone.bind.q_TB.y, bone.bind.q_TB.z});
    AppendInteger(bytes, bone.weights.size());
    for (const VertexWeight& share : bone.weights) {
      Append(bytes, static_cast<std::uint32_t>(share.vertex));
    }
    for (const VertexWeight& share : bone.weights) {
      AppendFloat(bytes, share.weight);
    }
  }
  return bytes;
}

}  // namespace girdle
