// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/model_skin.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr const char* kAnew = " or make the model anew with girdle generate --skin";

// Returns the index of Girdle's skin in a model; negative if there is none.
int NumberIn(const mjModel& model) {
  return mj_name2id(&model, mjOBJ_SKIN, std::string(kSkinName).c_str());
}

Vector3 VectorAt(const float* v) { return {v[0], v[1], v[2]}; }

// Expresses vertices and bones in the frame of a bone as bound.
void PutInFrameOf(const BoneFrame& frame, BoundSkin& skin) {
  const Quaternion q = glm::conjugate(frame.q_TB);
  for (Vector3& vertex_m : skin.surface.vertices_m) {
    vertex_m = q * (vertex_m - frame.p_TB_m);
  }
  for (BoundBone& bone : skin.bones) {
    bone.bind = {q * bone.bind.q_TB, q * (bone.bind.p_TB_m - frame.p_TB_m)};
  }
}

BoundSkin SkinOf(const mjModel& model, int skin) {
  BoundSkin bound;
  const float* const vertices = model.skin_vert + 3 * model.skin_vertadr[skin];
  for (int i = 0; i < model.skin_vertnum[skin]; ++i) {
    bound.surface.vertices_m.push_back(VectorAt(vertices + 3 * i));
  }
  const int* const faces = model.skin_face + 3 * model.skin_faceadr[skin];
  for (int i = 0; i < model.skin_facenum[skin]; ++i) {
    bound.surface.triangles.push_back({faces[3 * i], faces[3 * i + 1], faces[3 * i + 2]});
  }
  const int first = model.skin_boneadr[skin];
  for (int bone = first; bone < first + model.skin_bonenum[skin]; ++bone) {
    const char* const name = mj_id2name(&model, mjOBJ_BODY, model.skin_bonebodyid[bone]);
    const float* const q = model.skin_bonebindquat + 4 * bone;
    BoundBone& added = bound.bones.emplace_back();
    added.body = name == nullptr ? "" : name;
    added.bind = {glm::normalize(Quaternion(q[0], q[1], q[2], q[3])),
                  VectorAt(model.skin_bonebindpos + 3 * bone)};
    const int shares = model.skin_bonevertadr[bone];
    for (int i = shares; i < shares + model.skin_bonevertnum[bone]; ++i) {
      added.weights.push_back({model.skin_bonevertid[i], model.skin_bonevertweight[i]});
    }
  }
  return bound;
}

}  // namespace

bool HasSkin(const mjModel& model) { return NumberIn(model) >= 0; }

std::optional<ShoulderPose> BindPose(const mjModel& model, Side side) {
  return HasSkin(model) ? BindPose(SkinOf(model, NumberIn(model)), side) : std::nullopt;
}

void ModelSkin::SceneDeleter::operator()(mjvScene* scene) const noexcept {
  mjv_freeScene(scene);
  delete scene;  // NOLINT(cppcoreguidelines-owning-memory): this is its owner
}

ModelSkin::ModelSkin(const mjModel& model, std::string model_name)
    : model_(model), model_name_(std::move(model_name)) {
  if (!HasSkin(model)) {
    throw InputError(model_name_ + ": has no skin \"" + std::string(kSkinName) +
                     "\". Make a model that has one with girdle generate --skin");
  }
  const int skin = NumberIn(model);
  bound_ = SkinOf(model, skin);
  const int first = model.skin_boneadr[skin];
  bodies_.assign(model.skin_bonebodyid + first,
                 model.skin_bonebodyid + first + model.skin_bonenum[skin]);
  const std::string thorax = SkinBone{}.name();
  const auto found = std::find_if(bound_.bones.begin(), bound_.bones.end(),
                                  [&](const BoundBone& bone) { return bone.body == thorax; });
  if (found == bound_.bones.end()) {
    throw InputError(model_name_ + ": the skin does not hang on the body \"" + thorax +
                     "\". Bind it to that one too," + kAnew);
  }
  PutInFrameOf(BoneFrame(found->bind), bound_);

  scene_.reset(new mjvScene);
  mjv_defaultScene(scene_.get());
  // The scene draws no solids, so room for one is enough.
  constexpr int kSolids = 1;
  mjv_makeScene(&model, scene_.get(), kSolids);
}

SkinLandmarkVertices ModelSkin::Landmarks(Side side) const {
  SkinLandmarkVertices landmarks;
  const auto last = static_cast<double>(bound_.surface.vertices_m.size()) - 1;
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    const std::string name = SidedName(kSkinLandmarkNames[k], side);
    const int numeric = mj_name2id(&model_, mjOBJ_NUMERIC, name.c_str());
    const std::string place = "<numeric name=\"" + name + "\">";
    if (numeric < 0) {
      throw InputError(model_name_ + ": has a skin and no " + place +
                       ", which says which of its vertices are the landmark's. Restore it," +
                       kAnew);
    }
    const mjtNum* const numbers = model_.numeric_data + model_.numeric_adr[numeric];
    for (int i = 0; i < model_.numeric_size[numeric]; ++i) {
      if (!(numbers[i] >= 0 && numbers[i] <= last && numbers[i] == std::floor(numbers[i]))) {
        throw InputError(model_name_ + ": " + place + " holds " + NumberText(numbers[i]) +
                         ", expected a vertex of the skin, 0 to " + NumberText(last) +
                         ". Restore it," + kAnew);
      }
      landmarks[k].push_back(static_cast<int>(numbers[i]));
    }
  }
  return landmarks;
}

std::vector<BoneFrame> ModelSkin::BonesInWorld(const mjData& data) const {
  std::vector<BoneFrame> frames;
  for (const int body : bodies_) {
    const mjtNum* const q = data.xquat + 4 * body;
    const mjtNum* const p = data.xpos + 3 * body;
    frames.push_back({{q[0], q[1], q[2], q[3]}, {p[0], p[1], p[2]}});
  }
  return frames;
}

std::vector<Vector3> ModelSkin::VerticesInWorld_m(mjData& data) const {
  mjvOption option;
  mjv_defaultOption(&option);
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  constexpr int kNoSolids = 0;
  mjv_updateScene(&model_, &data, &option, nullptr, &camera, kNoSolids, scene_.get());
  const int skin = NumberIn(model_);
  const float* const vertices = scene_->skinvert + 3 * scene_->skinvertadr[skin];
  std::vector<Vector3> vertices_m;
  vertices_m.reserve(bound_.surface.vertices_m.size());
  for (int i = 0; i < scene_->skinvertnum[skin]; ++i) {
    vertices_m.push_back(VectorAt(vertices + 3 * i));
  }
  return vertices_m;
}

}  // namespace girdle
