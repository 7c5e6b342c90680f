// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Gives MuJoCo the skin of a model (SKN), written by Girdle or as bytes of the input, and reads it
// from the model.

#include "input_values.h"
#include "reading.h"
#include "simulation/engine.h"
#include "simulation/model_skin.h"
#include "skin/skn_file.h"

namespace girdle::fuzz {
namespace {

constexpr const char* kModel = R"(
<mujoco>
  <size memory="1M"/>
  <deformable><skin name="skin" file="input.skn"/></deformable>
  <worldbody><body name="thorax"><geom size="1"/><body name="humerus_r"><geom size="1"/></body></body></worldbody>
</mujoco>)";

constexpr std::size_t kMostVertices = 20;

Vector3 TakeVector(InputValues& values) {
  const float x = values.TakeFloat();
  const float y = values.TakeFloat();
  const float z = values.TakeFloat();
  return {x, y, z};
}

// Returns a skin whose corners and weights may be those of no vertex.
BoundSkin SkinOf(InputValues values) {
  BoundSkin skin;
  const std::size_t vertices = 1 + values.TakeBelow(kMostVertices);
  const auto vertex = [&] { return static_cast<int>(values.TakeBelow(vertices + 2)) - 1; };
  for (std::size_t i = 0; i < vertices; ++i) {
    skin.surface.vertices_m.push_back(TakeVector(values));
  }
  skin.surface.triangles.resize(1 + values.TakeBelow(kMostVertices));
  for (Triangle& triangle : skin.surface.triangles) {
    for (int& corner : triangle) {
      corner = vertex();
    }
  }
  for (const char* const body : {"thorax", "humerus_r"}) {
    BoundBone& bone = skin.bones.emplace_back();
    bone.body = body;
    bone.bind.p_TB_m = TakeVector(values);
    bone.weights.resize(values.TakeBelow(kMostVertices));
    for (VertexWeight& share : bone.weights) {
      share.vertex = vertex();
      share.weight = values.TakeFloat();
    }
  }
  return skin;
}

void ExpectVertices(const BoundSkin& skin) {
  const auto is_vertex = [&skin](int vertex) {
    return vertex >= 0 && static_cast<std::size_t>(vertex) < skin.surface.vertices_m.size();
  };
  for (const Triangle& triangle : skin.surface.triangles) {
    for (const int corner : triangle) {
      Expect(is_vertex(corner), "a corner of a skin is a vertex");
    }
  }
  for (const BoundBone& bone : skin.bones) {
    for (const VertexWeight& share : bone.weights) {
      Expect(is_vertex(share.vertex), "a weight of a skin is that of a vertex");
    }
  }
}

// Reads the skin of a model with these bytes as its file.
BoundSkin ReadSkin(const std::string& skn) {
  const ModelPointer model = LoadModel(ModelFiles{{"input.xml", kModel}, {"input.skn", skn}});
  const ModelSkin skin(*model, kName);
  ExpectVertices(skin.bound());
  const DataPointer data = MakeData(*model);
  mj_forward(model.get(), data.get());
  Expect(skin.VerticesInWorld_m(*data).size() == skin.bound().surface.vertices_m.size(),
         "MuJoCo draws each vertex of a skin");
  return skin.bound();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const EngineWatch kWatch;
  const std::string text = BytesOf(bytes, size);
  InputValues values(text);
  if (values.TakeByte() % 2 == 0) {
    static_cast<void>(ResultOf([&] { return ReadSkin(values.rest()); }));
    return 0;
  }
  const BoundSkin skin = SkinOf(values);
  const auto read = ResultOf([&] { return ReadSkin(SknBytes(skin)); });
  Expect(!read || (read->surface.triangles == skin.surface.triangles &&
                   read->surface.vertices_m.size() == skin.surface.vertices_m.size() &&
                   read->bones.size() == skin.bones.size()),
         "a written skin is read as it was");
  return 0;
}

}  // namespace girdle::fuzz
