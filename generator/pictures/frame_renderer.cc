// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/frame_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <new>
#include <utility>

#include "kinematics/rotation.h"
#include "names/model_names.h"
#include "text/input_error.h"
#include "text/near_names.h"
#include "text/split.h"

namespace girdle {
namespace {

// Most geoms that MuJoCo may add to a scene. Their memory is a few megabytes.
constexpr int kMostSceneGeoms = 10000;
// Opacity of the skin if bones are drawn in it.
constexpr float kTranslucent = 0.35F;

// Directions of cameras in MuJoCo's angles: azimuth 0 looks along x, which is forward, from behind.
// Elevation is negative looking down.
struct Direction {
  double azimuth_deg;
  double elevation_deg;
};
// Directions in the order of kCameraWords. The last one is for a right arm.
constexpr std::array<Direction, kCameraWords.size()> kDirections = {
    {{180, 0}, {0, 0}, {0, -90}, {133, -29}}};
constexpr std::size_t kOblique = 3;

void ExpectSize(const PictureSize& size) {
  for (const int length : {size.width, size.height}) {
    if (length < kSmallestPicture || length > kLargestPicture) {
      throw InputError("a picture of " + std::to_string(size.width) + "x" +
                       std::to_string(size.height) + " pixels: width and height are " +
                       std::to_string(kSmallestPicture) + " to " + std::to_string(kLargestPicture));
    }
  }
}

// A number of <visual> that the renderer allocates memory by.
struct VisualLimit {
  const char* element;
  const char* attribute;
  int value;
  int least;
  int most;
};

// Throws InputError about the first number of <visual> that is outside its limits. MuJoCo reports
// some of them as errors of OpenGL, and allocates memory for others until there is none.
void ExpectVisual(const mjModel& model, const std::string& name) {
  constexpr int kMostPixels = 8192;     // a shadow of 256 MB
  constexpr int kMostSamples = 64;      // of a pixel; no renderer takes more
  constexpr int kMostSlices = 1000;     // a sphere of a million triangles
  constexpr int kMostQuads = 100;       // along an edge of a box
  constexpr int kMostUnused = 100'000;  // a picture has the size of its view instead
  const auto& quality = model.vis.quality;
  const auto& global = model.vis.global;
  for (const VisualLimit& limit : std::to_array<VisualLimit>({
           {"global", "offwidth", global.offwidth, 1, kMostUnused},
           {"global", "offheight", global.offheight, 1, kMostUnused},
           {"quality", "shadowsize", quality.shadowsize, 0, kMostPixels},
           {"quality", "offsamples", quality.offsamples, 0, kMostSamples},
           {"quality", "numslices", quality.numslices, 1, kMostSlices},
           {"quality", "numstacks", quality.numstacks, 1, kMostSlices},
           {"quality", "numquads", quality.numquads, 1, kMostQuads},
       })) {
    if (limit.value < limit.least || limit.value > limit.most) {
      throw InputError(name + ": <" + limit.element + " " + limit.attribute + "=\"" +
                       std::to_string(limit.value) + "\"> of its <visual> cannot be drawn. Write " +
                       std::to_string(limit.least) + " to " + std::to_string(limit.most) +
                       ", or omit it");
    }
  }
}

// Throws InputError if the textures of a model take too much memory. OpenGL and its programs hold
// about four copies of them.
void ExpectTextures(const mjModel& model, const std::string& name) {
  constexpr mjtSize kBytesPerMegabyte = 1'000'000;
  constexpr mjtSize kMost_MB = 220;
  if (model.ntexdata > kMost_MB * kBytesPerMegabyte) {
    throw InputError(name + ": its textures have " +
                     std::to_string(model.ntexdata / kBytesPerMegabyte) +
                     " MB of pixels, more than the " + std::to_string(kMost_MB) +
                     " that can be drawn. Make them smaller");
  }
}

// Returns the meaning of an error number of OpenGL.
std::string GlErrorText(int error) {
  constexpr int kOutOfMemory = 0x0505;
  return error == kOutOfMemory ? "has no memory left" : "refuses to draw";
}

// A box around points in the world.
class Box {
 public:
  void Add(const Vector3& p_m) {
    lower_m_ = glm::min(lower_m_, p_m);
    upper_m_ = glm::max(upper_m_, p_m);
  }
  [[nodiscard]] bool is_empty() const { return lower_m_.x > upper_m_.x; }
  [[nodiscard]] Vector3 center_m() const { return 0.5 * (lower_m_ + upper_m_); }
  [[nodiscard]] Vector3 size_m() const { return upper_m_ - lower_m_; }

 private:
  Vector3 lower_m_{std::numeric_limits<double>::infinity()};
  Vector3 upper_m_{-std::numeric_limits<double>::infinity()};
};

// Returns a corner of a box of two units a side about the origin.
constexpr int kCorners = 8;
Vector3 CornerSigns(int corner) {
  return {(corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1};
}

// Adds the corners of MuJoCo's bounding box of a geom, which is in the geom's own axes.
void AddGeom(const mjModel& model, const mjData& data, int geom, Box& box) {
  const mjtNum* const c = model.geom_aabb + 6 * geom;
  const Vector3 center_m{c[0], c[1], c[2]};
  const Vector3 half_m{c[3], c[4], c[5]};
  const mjtNum* const p = data.geom_xpos + 3 * geom;
  for (int corner = 0; corner < kCorners; ++corner) {
    const Vector3 p_m = center_m + CornerSigns(corner) * half_m;
    const std::array<mjtNum, 3> in_geom = {p_m.x, p_m.y, p_m.z};
    std::array<mjtNum, 3> turned{};
    mju_mulMatVec3(turned.data(), data.geom_xmat + 9 * geom, in_geom.data());
    box.Add({p[0] + turned[0], p[1] + turned[1], p[2] + turned[2]});
  }
}

// Brightens the headlight of a model without lights to that of the scenes that girdle generate
// writes, because MuJoCo's default leaves most of the picture dark.
void LightUp(mjModel& model) {
  constexpr float kAmbient = 0.35F;
  constexpr float kDiffuse = 0.65F;
  if (model.nlight > 0) {
    return;
  }
  for (int k = 0; k < 3; ++k) {
    float& ambient = model.vis.headlight.ambient[k];
    float& diffuse = model.vis.headlight.diffuse[k];
    ambient = std::max(ambient, kAmbient);
    diffuse = std::max(diffuse, kDiffuse);
  }
}

// Whether a model has a left shoulder only.
bool IsLeftAlone(const mjModel& model) {
  const auto has = [&model](Side side) {
    return mj_name2id(&model, mjOBJ_BODY, SidedName("humerus", side).c_str()) >= 0;
  };
  return has(Side::kLeft) && !has(Side::kRight);
}

// Returns the visualization group of a geom. MuJoCo counts groups beyond the last as the last.
int GroupOf(const mjModel& model, int geom) {
  return std::clamp(model.geom_group[geom], 0, mjNGROUP - 1);
}

// Returns a box around the bodies that are shown, in the model's initial state and in all its
// keyframes. If nothing is shown, the box is around MuJoCo's middle of the model. Overwrites the
// scene.
Box BoxOfKeyframes(const mjModel& model, const mjvOption& option, mjvCamera& camera,
                   mjvScene& scene) {
  Box box;
  const DataPointer data = MakeData(model);
  for (int key = -1; key < model.nkey; ++key) {
    if (key >= 0) {
      mj_resetDataKeyframe(&model, data.get(), key);
    }
    mj_fwdPosition(&model, data.get());
    for (int geom = 0; geom < model.ngeom; ++geom) {
      if (model.geom_bodyid[geom] != 0 && option.geomgroup[GroupOf(model, geom)] != 0) {
        AddGeom(model, *data, geom, box);
      }
    }
    if (option.flags[mjVIS_SKIN] != 0 && model.nskin > 0) {
      // MuJoCo has no other function that computes the skin without a warning.
      mjv_updateScene(&model, data.get(), &option, nullptr, &camera, mjCAT_ALL, &scene);
      for (mjtSize vertex = 0; vertex < model.nskinvert; ++vertex) {
        const float* const p = scene.skinvert + 3 * vertex;
        box.Add({p[0], p[1], p[2]});
      }
    }
  }
  if (box.is_empty()) {
    const mjtNum* const p = model.stat.center;
    for (const double half_m : {-model.stat.extent / 2, model.stat.extent / 2}) {
      box.Add(Vector3{p[0], p[1], p[2]} + half_m);
    }
  }
  return box;
}

// Returns the least distance [m] along a direction from which all corners of a box are in the
// picture. The angle is from the bottom to the top of the picture.
double DistanceToSee_m(const Box& box, const Direction& from, double field_of_view_deg,
                       const PictureSize& size) {
  const double azimuth_rad = RadiansFromDegrees(from.azimuth_deg);
  const double elevation_rad = RadiansFromDegrees(from.elevation_deg);
  const Vector3 level{std::cos(azimuth_rad), std::sin(azimuth_rad), 0};
  const Vector3 forward = std::cos(elevation_rad) * level + Vector3{0, 0, std::sin(elevation_rad)};
  const Vector3 up = -std::sin(elevation_rad) * level + Vector3{0, 0, std::cos(elevation_rad)};
  const Vector3 right = glm::cross(forward, up);
  const double tangent_up = std::tan(RadiansFromDegrees(field_of_view_deg) / 2);
  const double tangent_right = tangent_up * size.width / size.height;
  double distance_m = 0;
  for (int corner = 0; corner < kCorners; ++corner) {
    const Vector3 p_m = 0.5 * CornerSigns(corner) * box.size_m();
    distance_m = std::max({distance_m,
                           std::abs(glm::dot(p_m, right)) / tangent_right - glm::dot(p_m, forward),
                           std::abs(glm::dot(p_m, up)) / tangent_up - glm::dot(p_m, forward)});
  }
  return distance_m;
}

}  // namespace

std::vector<std::string> CameraNames(const mjModel& model) {
  std::vector<std::string> names;
  for (int i = 0; i < model.ncam; ++i) {
    const char* const name = mj_id2name(&model, mjOBJ_CAMERA, i);
    if (name != nullptr && *name != '\0') {
      names.emplace_back(name);
    }
  }
  for (const std::string_view word : kCameraWords) {
    if (std::find(names.begin(), names.end(), word) == names.end()) {
      names.emplace_back(word);
    }
  }
  return names;
}

namespace {

ModelPointer CheckedCopy(const mjModel& model, const std::string& name, const View& view) {
  ExpectSize(view.size);
  const std::vector<std::string> cameras = CameraNames(model);
  if (std::find(cameras.begin(), cameras.end(), view.camera) == cameras.end()) {
    throw InputError(
        name + ": has no camera \"" + view.camera + "\". " +
        DidYouMean(view.camera, std::vector<std::string_view>(cameras.begin(), cameras.end())) +
        "Choose one of: " + Joined(cameras));
  }
  if (model.nskin == 0 && view.show && *view.show != Show::kBones) {
    throw InputError(name +
                     ": has no skin to show. Show its bones, or make a model that has a skin");
  }
  ExpectVisual(model, name);
  ExpectTextures(model, name);
  ModelPointer copy(mj_copyModel(nullptr, &model));
  if (copy == nullptr) {
    throw std::bad_alloc();
  }
  copy->vis.global.offwidth = view.size.width;
  copy->vis.global.offheight = view.size.height;
  LightUp(*copy);
  return copy;
}

}  // namespace

void FrameRenderer::SceneDeleter::operator()(mjvScene* scene) const noexcept {
  mjv_freeScene(scene);
  delete scene;
}

void FrameRenderer::RendererDeleter::operator()(mjrContext* renderer) const noexcept {
  mjr_freeContext(renderer);
  delete renderer;
}

FrameRenderer::FrameRenderer(const mjModel& model, std::string name, const View& view)
    : name_(std::move(name)),
      view_(view),
      show_(view.show.value_or(model.nskin > 0 ? Show::kSkin : Show::kBones)),
      model_(CheckedCopy(model, name_, view)) {
  mjv_defaultOption(&option_);
  option_.flags[mjVIS_SKIN] = show_ == Show::kBones ? 0 : 1;
  if (show_ == Show::kSkin) {
    option_.flags[mjVIS_TENDON] = 0;
  }
  scene_.reset(new mjvScene);
  mjv_defaultScene(scene_.get());
  mjv_makeScene(model_.get(), scene_.get(), kMostSceneGeoms);
  renderer_.reset(new mjrContext);
  mjr_defaultContext(renderer_.get());
  try {
    mjr_makeContext(model_.get(), renderer_.get(), mjFONTSCALE_100);
  } catch (const EngineError& error) {
    FailDrawing(error.what());
  }
  if (const std::string warned = EngineWatch::TakeWarnings(); !warned.empty()) {
    FailDrawing(warned);
  }
  mjr_setBuffer(mjFB_OFFSCREEN, renderer_.get());
  if (renderer_->currentBuffer != mjFB_OFFSCREEN) {
    throw InputError("cannot draw pictures: " + context_.Description() +
                     " has no buffer off the screen. Set " + kGlVariable + "=osmesa");
  }
  mjv_defaultCamera(&camera_);
  camera_.fixedcamid = mj_name2id(model_.get(), mjOBJ_CAMERA, view_.camera.c_str());
  camera_.type = camera_.fixedcamid < 0 ? mjCAMERA_FREE : mjCAMERA_FIXED;
  if (camera_.fixedcamid < 0) {
    const auto* const word = std::find(kCameraWords.begin(), kCameraWords.end(), view_.camera);
    AimFrom(static_cast<std::size_t>(word - kCameraWords.begin()));
  }
}

FrameRenderer::~FrameRenderer() {
  // Resources of a context can be freed only while the context is current.
  if (!context_.MakeCurrent()) {
    static_cast<void>(renderer_.release());  // NOLINT(bugprone-unused-return-value): it leaks
  }
}

void FrameRenderer::FailDrawing(const std::string& reason) const {
  throw InputError(name_ + ": cannot be drawn with " + context_.Description() +
                   ", which lacks room or support for its textures and shadows, or for this size "
                   "of a picture (" +
                   reason + "). Lower them, or set " + kGlVariable + "=osmesa");
}

// Aims at the middle of a box around all poses of the bodies, from where all its corners are
// visible.
void FrameRenderer::AimFrom(std::size_t direction) {
  const Box box = BoxOfKeyframes(*model_, option_, camera_, *scene_);
  Direction from = kDirections[direction];
  if (direction == kOblique && IsLeftAlone(*model_)) {
    from.azimuth_deg = -from.azimuth_deg;
  }
  constexpr double kMargin = 1.05;
  camera_.azimuth = from.azimuth_deg;
  camera_.elevation = from.elevation_deg;
  camera_.distance = kMargin * DistanceToSee_m(box, from, model_->vis.global.fovy, view_.size);
  for (int k = 0; k < 3; ++k) {
    camera_.lookat[k] = box.center_m()[k];
  }
}

void FrameRenderer::UpdateScene(mjData& data) {
  mjv_updateScene(model_.get(), &data, &option_, nullptr, &camera_, mjCAT_ALL, scene_.get());
  if (scene_->ngeom >= kMostSceneGeoms) {
    throw InputError(name_ + ": has more to draw than " + std::to_string(kMostSceneGeoms) +
                     " geoms, sites and tendons. Remove some");
  }
  if (show_ == Show::kSkin) {
    HideBones();
  }
  if (show_ == Show::kBoth) {
    for (int i = 0; i < scene_->ngeom; ++i) {
      if (scene_->geoms[i].type == mjGEOM_SKIN) {
        scene_->geoms[i].rgba[3] *= kTranslucent;
      }
    }
  }
  KeepSkinBetweenClipPlanes();
}

// Removes the geoms of bodies that move a skin from the scene. A bone that comes through the skin
// is therefore visible only if bones are shown.
void FrameRenderer::HideBones() {
  const int* const bones = model_->skin_bonebodyid;
  mjvGeom* const geoms = scene_->geoms;
  const auto is_bone = [&](const mjvGeom& geom) {
    if (geom.objtype != mjOBJ_GEOM && geom.objtype != mjOBJ_SITE) {
      return false;
    }
    const int body = geom.objtype == mjOBJ_GEOM ? model_->geom_bodyid[geom.objid]
                                                : model_->site_bodyid[geom.objid];
    return std::find(bones, bones + model_->nskinbone, body) != bones + model_->nskinbone;
  };
  scene_->ngeom = static_cast<int>(std::remove_if(geoms, geoms + scene_->ngeom, is_bone) - geoms);
}

// Moves the clip planes so that the skin lies between them. MuJoCo places them by the extent of the
// model, which counts geoms only.
void FrameRenderer::KeepSkinBetweenClipPlanes() {
  if (option_.flags[mjVIS_SKIN] == 0) {
    return;
  }
  constexpr float kMargin = 1.05F;
  // Least distance of the near plane as a share of the far plane's. With a nearer one, the depth of
  // distant parts is too inaccurate.
  constexpr float kNearest = 1e-4F;
  for (mjvGLCamera& camera : scene_->camera) {
    float nearest = camera.frustum_near;
    float farthest = camera.frustum_far;
    for (mjtSize vertex = 0; vertex < model_->nskinvert; ++vertex) {
      float depth = 0;
      for (int k = 0; k < 3; ++k) {
        depth += camera.forward[k] * (scene_->skinvert[3 * vertex + k] - camera.pos[k]);
      }
      // Vertices behind the camera are not visible.
      nearest = depth > 0 ? std::min(nearest, depth / kMargin) : nearest;
      farthest = std::max(farthest, depth * kMargin);
    }
    nearest = std::max(nearest, std::min(camera.frustum_near, kNearest * farthest));
    if (camera.orthographic == 0) {
      // The edges of the picture are given at the near plane.
      const float scale = nearest / camera.frustum_near;
      camera.frustum_center *= scale;
      camera.frustum_width *= scale;
      camera.frustum_bottom *= scale;
      camera.frustum_top *= scale;
    }
    camera.frustum_near = nearest;
    camera.frustum_far = farthest;
  }
}

Picture FrameRenderer::Draw(mjData& data) {
  if (!context_.MakeCurrent()) {
    throw InputError("cannot draw pictures: OpenGL does not take its context back");
  }
  UpdateScene(data);
  const mjrRect viewport{0, 0, view_.size.width, view_.size.height};
  mjr_render(viewport, scene_.get(), renderer_.get());
  Picture picture{view_.size, {}};
  const std::size_t row = 3 * static_cast<std::size_t>(view_.size.width);
  picture.rgb.resize(row * static_cast<std::size_t>(view_.size.height));
  mjr_readPixels(picture.rgb.data(), nullptr, viewport, renderer_.get());
  if (const std::string warned = EngineWatch::TakeWarnings(); !warned.empty()) {
    FailDrawing(warned);
  }
  if (const int error = mjr_getError(); error != 0) {
    FailDrawing("OpenGL " + GlErrorText(error));
  }
  // OpenGL's rows go from the bottom to the top.
  for (auto top = picture.rgb.begin(), bottom = picture.rgb.end() - static_cast<long>(row);
       top < bottom; top += static_cast<long>(row), bottom -= static_cast<long>(row)) {
    std::swap_ranges(top, top + static_cast<long>(row), bottom);
  }
  if (const std::optional<PictureFault> fault = FaultOf(picture)) {
    throw InputError(*fault == PictureFault::kBlank
                         ? name_ + ": the picture is blank: camera " + view_.camera +
                               " sees nothing. Choose another one: " + Joined(CameraNames(*model_))
                         : "cannot draw pictures: " + context_.Description() +
                               " returns noise. Set " + kGlVariable + "=osmesa");
  }
  return picture;
}

}  // namespace girdle
