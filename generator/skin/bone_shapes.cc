// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/bone_shapes.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "anatomy/ellipsoid.h"

namespace girdle {
namespace {

// Radii for an adult's bones [m]. They scale with the bones.
constexpr double kHumeralHead_m = 0.022;
constexpr double kShaft_m = 0.012;
// Thicker than the bone, because a share of a hundredth of the thorax would move the elbow by
// millimeters.
constexpr double kLowerArm_m = 0.024;
constexpr double kNeck_m = 0.030;
constexpr double kClavicle_m = 0.006;
constexpr double kBlade_m = 0.008;
// The rib cage is narrower than drawn by this factor, so that skin is nearer to the ribs than to
// the girdle only where there is no girdle.
constexpr double kRibcageShare = 0.96;

Vector3 Middle(const Vector3& a, const Vector3& b) { return (a + b) / 2.0; }

class ShapeMaker {
 public:
  explicit ShapeMaker(const PosedBody& body)
      : body_(body), scales_(ScalesOf(body.anatomy, BuiltInAnatomy())) {}

  [[nodiscard]] BoneShape Thorax() const {
    const Anatomy& anatomy = body_.anatomy;
    Ellipsoid ribs = anatomy.ribcage;
    ribs.radii_m *= kRibcageShare;
    const double scale = Scale(Segment::kThorax);
    const Vector3 notch = InMedianPlane(anatomy.landmark_m(Landmark::kIJ));
    const Vector3 c7 = InMedianPlane(anatomy.landmark_m(Landmark::kC7));
    const Vector3 t8 = InMedianPlane(anatomy.landmark_m(Landmark::kT8));
    const Vector3 xiphoid = InMedianPlane(anatomy.landmark_m(Landmark::kPX));
    // The neck, from between C7 and the notch upward. It is as high as it is deep from front to
    // back.
    const Vector3 throat = Middle(notch, c7) + Vector3{0, 0.02 * scale, 0};
    const Vector3 jaw = throat + Vector3{0, glm::length(notch - c7), 0};
    const double thin = kShaft_m * scale;
    return {{{throat, jaw, kNeck_m * scale},
             {c7, t8, thin},
             {t8, {t8.x, ribs.center_m.y - ribs.radii_m.y, 0}, thin},
             {notch, xiphoid, thin}},
            {ribs}};
  }

  [[nodiscard]] BoneShape Clavicle(Side side) const {
    return {{{At(Landmark::kSC, side), At(Landmark::kACJ, side),
              kClavicle_m * Scale(Segment::kClavicle)}},
            {}};
  }

  [[nodiscard]] BoneShape Scapula(Side side) const {
    const Vector3 joint = At(Landmark::kACJ, side);
    const Vector3 tip = OnSideInThorax_m(body_.anatomy, body_.pose, side, Segment::kScapula,
                                         AcromionTip_m(body_.anatomy));
    const Vector3 angle = At(Landmark::kAA, side);
    const Vector3 root = At(Landmark::kTS, side);
    const Vector3 inferior = At(Landmark::kAI, side);
    const Vector3 neck = Middle(inferior, At(Landmark::kGH, side));
    const double thick = kBlade_m * Scale(Segment::kScapula);
    return {{{joint, tip, 0},
             {tip, angle, 0},
             {angle, root, 0},
             {root, inferior, thick},
             {inferior, neck, thick},
             {At(Landmark::kGC, side), At(Landmark::kPC, side), 2 * thick}},
            {}};
  }

  [[nodiscard]] BoneShape Humerus(Side side) const {
    const double scale = Scale(Segment::kHumerus);
    const Vector3 head = At(Landmark::kGH, side);
    const Vector3 elbow = OnSideInThorax_m(body_.anatomy, body_.pose, side, Segment::kHumerus,
                                           body_.anatomy.elbow_m());
    const Vector3 middle = Middle(head, elbow);
    return {{{head, head, kHumeralHead_m * scale},
             {head, middle, kShaft_m * scale},
             {middle, elbow, kLowerArm_m * scale}},
            {}};
  }

 private:
  [[nodiscard]] double Scale(Segment segment) const {
    return scales_[static_cast<std::size_t>(segment)];
  }
  [[nodiscard]] Vector3 At(Landmark landmark, Side side) const {
    return OnSideInThorax_m(body_.anatomy, body_.pose, side, landmark);
  }

  const PosedBody& body_;
  SegmentScales scales_;
};

void Append(const BoneShape& from, BoneShape& to) {
  to.rods.insert(to.rods.end(), from.rods.begin(), from.rods.end());
  to.ellipsoids.insert(to.ellipsoids.end(), from.ellipsoids.begin(), from.ellipsoids.end());
}

}  // namespace

std::vector<BoneShape> BoneShapesOf(const PosedBody& body, const std::vector<SkinBone>& bones) {
  const ShapeMaker maker(body);
  const auto has = [&bones](Side side) {
    return std::any_of(bones.begin(), bones.end(), [side](const SkinBone& bone) {
      return bone.segment != Segment::kThorax && bone.side == side;
    });
  };
  std::vector<BoneShape> shapes;
  for (const SkinBone& bone : bones) {
    switch (bone.segment) {
      case Segment::kThorax:
        shapes.push_back(maker.Thorax());
        for (const Side side : {Side::kRight, Side::kLeft}) {
          if (!has(side)) {
            Append(maker.Clavicle(side), shapes.back());
            Append(maker.Scapula(side), shapes.back());
            Append(maker.Humerus(side), shapes.back());
          }
        }
        break;
      case Segment::kClavicle:
        shapes.push_back(maker.Clavicle(bone.side));
        break;
      case Segment::kScapula:
        shapes.push_back(maker.Scapula(bone.side));
        break;
      case Segment::kHumerus:
        shapes.push_back(maker.Humerus(bone.side));
        break;
    }
  }
  return shapes;
}

double DistanceFrom_m(const BoneShape& shape, const Vector3& point_m) noexcept {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Rod& rod : shape.rods) {
    const Vector3 along = rod.to_m - rod.from_m;
    const double length_squared = glm::dot(along, along);
    const double t =
        length_squared > 0
            ? std::clamp(glm::dot(point_m - rod.from_m, along) / length_squared, 0.0, 1.0)
            : 0;
    nearest_m = std::min(nearest_m, glm::length(point_m - (rod.from_m + t * along)) - rod.radius_m);
  }
  for (const Ellipsoid& ellipsoid : shape.ellipsoids) {
    nearest_m = std::min(nearest_m, DistanceFromEllipsoid(ellipsoid, point_m));
  }
  return std::max(nearest_m, 0.0);
}

}  // namespace girdle
