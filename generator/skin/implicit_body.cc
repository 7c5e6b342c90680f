// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/implicit_body.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "kinematics/shoulder_rhythm.h"
#include "skin/smooth_union.h"
#include "skin/surface_nets.h"
#include "tables/body_size.h"
#include "tables/built_in.h"

namespace girdle {
namespace {

// As the arms are held: far enough from the body to leave the axilla open, near enough to rest that
// no joint is strained.
constexpr double kBindElevation_deg = 45;

// End of a muscle on the right side of an adult: in the frame of its bone, with its radius [mm].
struct End {
  Segment segment;
  Vector3 place_mm;
  double radius_mm;
};
struct Muscle {
  End from;
  End to;
};
constexpr Segment kT = Segment::kThorax;
constexpr Segment kC = Segment::kClavicle;
constexpr Segment kS = Segment::kScapula;
constexpr Segment kH = Segment::kHumerus;

// Drawn after textbook figures of a lean adult; both sides have them.
constexpr Muscle kMuscles[] = {
    // Sternocleidomastoid.
    {{kT, {-4, 8, 17}, 7}, {kT, {-62, 118, 50}, 13}},
    // Trapezius: the neck's slope in two strands, then its middle and lower parts.
    {{kT, {-82, 112, 28}, 24}, {kC, {-8, 6, 112}, 12}},
    {{kT, {-104, 88, 20}, 26}, {kS, {-8, -6, -12}, 11}},
    {{kT, {-112, 52, 14}, 22}, {kS, {-22, -12, -50}, 12}},
    {{kT, {-138, -10, 16}, 14}, {kS, {-12, -6, -110}, 12}},
    {{kT, {-148, -130, 12}, 8}, {kS, {-8, -6, -124}, 11}},
    // Erector spinae.
    {{kT, {-128, 40, 22}, 18}, {kT, {-140, -150, 30}, 19}},
    {{kT, {-140, -150, 30}, 19}, {kT, {-126, -420, 36}, 24}},
    // Infraspinatus, teres and the subscapular wall.
    {{kS, {-12, -40, -100}, 15}, {kS, {-10, -40, -40}, 18}},
    {{kS, {-8, -95, -128}, 14}, {kH, {-6, -50, 4}, 15}},
    // Latissimus.
    {{kT, {-112, -240, 88}, 26}, {kH, {4, -62, -8}, 13}},
    {{kT, {-92, -150, 112}, 24}, {kH, {4, -62, -8}, 15}},
    // Pectoralis: three strands from the sternum, and from the clavicle.
    {{kT, {8, -24, 22}, 13}, {kH, {14, -72, 0}, 14}},
    {{kT, {16, -58, 26}, 15}, {kT, {-6, -50, 104}, 20}},
    {{kT, {-6, -50, 104}, 20}, {kH, {14, -78, -2}, 15}},
    {{kT, {20, -96, 30}, 15}, {kT, {6, -88, 92}, 19}},
    {{kT, {6, -88, 92}, 19}, {kH, {12, -84, -6}, 14}},
    {{kC, {6, -8, 50}, 12}, {kH, {16, -70, 2}, 14}},
    // Rectus abdominis.
    {{kT, {22, -150, 28}, 12}, {kT, {16, -420, 30}, 18}},
    // Deltoid: before, beside and behind.
    {{kC, {6, -2, 118}, 12}, {kH, {20, -48, 6}, 20}},
    {{kH, {20, -48, 6}, 20}, {kH, {13, -128, 10}, 17}},
    {{kS, {-4, -14, 15}, 13}, {kH, {16, -40, 20}, 19}},
    {{kH, {16, -40, 20}, 19}, {kH, {12, -132, 12}, 16}},
    {{kS, {-30, -19, -16}, 13}, {kH, {-4, -46, 22}, 19}},
    {{kS, {-20, -12, -66}, 12}, {kH, {-12, -52, 12}, 18}},
    {{kH, {-4, -46, 22}, 19}, {kH, {8, -130, 14}, 15}},
    // Biceps and triceps.
    {{kH, {13, -110, -4}, 24}, {kH, {13, -190, -2}, 25}},
    {{kH, {13, -190, -2}, 25}, {kH, {8, -262, 0}, 20}},
    {{kH, {-12, -80, 2}, 26}, {kH, {-15, -170, 2}, 26}},
    {{kH, {-15, -170, 2}, 26}, {kH, {-8, -268, 0}, 22}},
    // Forearm.
    {{kH, {6, -292, 12}, 28}, {kH, {8, -345, 12}, 27}},
    {{kH, {4, -292, -12}, 27}, {kH, {4, -345, -10}, 27}},
    {{kH, {8, -345, 12}, 27}, {kH, {2, -515, 12}, 15}},
    {{kH, {4, -345, -10}, 27}, {kH, {2, -515, -12}, 15}},
    // Palm, fingers and thumb.
    {{kH, {2, -540, 14}, 14}, {kH, {2, -592, 26}, 13}},
    {{kH, {2, -540, -14}, 14}, {kH, {2, -592, -26}, 12}},
    {{kH, {2, -545, 0}, 14}, {kH, {2, -595, 0}, 13}},
    {{kH, {2, -600, 28}, 10}, {kH, {12, -668, 26}, 8}},
    {{kH, {2, -604, 10}, 10}, {kH, {14, -684, 9}, 8}},
    {{kH, {2, -602, -9}, 10}, {kH, {14, -678, -9}, 8}},
    {{kH, {2, -594, -27}, 9}, {kH, {12, -648, -26}, 7}},
    {{kH, {6, -540, 24}, 12}, {kH, {16, -592, 52}, 9}},
};

// The trunk, in the middle, thorax frame [mm].
struct Mass {
  Vector3 center_mm;
  Vector3 radii_mm;
};
constexpr Mass kTrunk[] = {
    {{-62, -140, 0}, {93, 200, 140}},  // rib cage
    {{-58, -370, 0}, {80, 190, 124}},  // belly
    {{-62, -20, 0}, {62, 60, 92}},     // between the shoulders
};
struct Neck {
  Vector3 place_mm;
  double radius_mm;
};
constexpr Neck kThroat = {{-74, 10, 0}, 50};
constexpr Neck kJaw = {{-52, 130, 0}, 50};
constexpr double kNeckCut_mm = 112;
constexpr double kWaistCut_mm = -390;

// Skin over bone that lies right under it [mm].
constexpr double kCover_mm = 9;
constexpr double kBladeCover_mm = 12;
constexpr double kHead_mm = 33;
constexpr double kShaft_mm = 32;

// Muscles and trunk run into each other over this much.
constexpr double kBlend_mm = 9;
constexpr double kEdge_mm = 4;
// Around all solids [m].
constexpr double kMargin_m = 0.03;

constexpr double kMillimeter_m = 1e-3;

class BodyBuilder {
 public:
  explicit BodyBuilder(const PosedBody& body)
      : body_(body), scales_(ScalesOf(body.anatomy, BuiltInAnatomy())) {
    const double size = Millimeter_m(kT);
    solids_.blend_m = kBlend_mm * size;
    solids_.rounding_m = kEdge_mm * size;
  }

  void AddTrunk() {
    const double mm = Millimeter_m(kT);
    for (const Mass& mass : kTrunk) {
      solids_.ellipsoids.push_back({mass.center_mm * mm, mass.radii_mm * mm});
    }
    Add(kThroat.place_mm * mm, kThroat.radius_mm * mm, kJaw.place_mm * mm, kJaw.radius_mm * mm);
    const auto median = [this](Landmark landmark) {
      return InMedianPlane(body_.anatomy.landmark_m(landmark));
    };
    const double cover_m = kCover_mm * mm;
    Add(median(Landmark::kC7), cover_m, median(Landmark::kT8), cover_m);
    Add(median(Landmark::kIJ), cover_m, median(Landmark::kPX), cover_m);
    solids_.cuts.push_back({{0, kNeckCut_mm * mm, 0}, glm::normalize(Vector3{-0.25, 1, 0})});
    solids_.cuts.push_back({{0, kWaistCut_mm * mm, 0}, {0, -1, 0}});
  }

  void AddShoulder(Side side, bool has_arm) {
    for (const Muscle& muscle : kMuscles) {
      if (has_arm || (muscle.from.segment != kH && muscle.to.segment != kH)) {
        Add(Place_m(muscle.from.segment, muscle.from.place_mm, side),
            muscle.from.radius_mm * Millimeter_m(muscle.from.segment),
            Place_m(muscle.to.segment, muscle.to.place_mm, side),
            muscle.to.radius_mm * Millimeter_m(muscle.to.segment));
      }
    }
    CoverGirdle(side);
    if (has_arm) {
      CoverArm(side);
    }
  }

  [[nodiscard]] TriangleMesh Surface() const {
    Box box{Vector3{1, 1, 1} * 1e9, Vector3{-1, -1, -1} * 1e9};
    const auto include = [&box](const Vector3& center_m, const Vector3& radii_m) {
      box.lowest_m = glm::min(box.lowest_m, center_m - radii_m - kMargin_m);
      box.highest_m = glm::max(box.highest_m, center_m + radii_m + kMargin_m);
    };
    for (const RoundCone& cone : solids_.cones) {
      include(cone.from_m, Vector3(cone.from_radius_m));
      include(cone.to_m, Vector3(cone.to_radius_m));
    }
    for (const TurnedEllipsoid& ellipsoid : solids_.ellipsoids) {
      include(ellipsoid.center_m, ellipsoid.radii_m);
    }
    return SurfaceNets(solids_, box, kImplicitCell_m * scales_[static_cast<std::size_t>(kT)]);
  }

 private:
  // An adult's millimeter, in meters of this person's bone.
  [[nodiscard]] double Millimeter_m(Segment segment) const {
    return scales_[static_cast<std::size_t>(segment)] * kMillimeter_m;
  }
  [[nodiscard]] Vector3 Place_m(Segment segment, const Vector3& place_mm, Side side) const {
    return OnSideInThorax_m(body_.anatomy, body_.pose, side, segment,
                            place_mm * Millimeter_m(segment));
  }
  [[nodiscard]] Vector3 Landmark_m(Landmark landmark, Side side) const {
    return OnSideInThorax_m(body_.anatomy, body_.pose, side,
                            kLandmarks[static_cast<std::size_t>(landmark)].segment,
                            body_.anatomy.landmark_m(landmark));
  }
  void Add(const Vector3& from_m, double from_radius_m, const Vector3& to_m, double to_radius_m) {
    solids_.cones.push_back({from_m, from_radius_m, to_m, to_radius_m});
  }

  // Clavicle and scapula, wherever they are.
  void CoverGirdle(Side side) {
    const double cover_m = kCover_mm * Millimeter_m(kS);
    const double blade_m = kBladeCover_mm * Millimeter_m(kS);
    const auto link = [&](Landmark from, Landmark to, double radius_m) {
      Add(Landmark_m(from, side), radius_m, Landmark_m(to, side), radius_m);
    };
    link(Landmark::kSC, Landmark::kPAC, kCover_mm * Millimeter_m(kC));
    link(Landmark::kPAC, Landmark::kACJ, cover_m);
    link(Landmark::kTS, Landmark::kAA, cover_m);
    link(Landmark::kTS, Landmark::kAI, blade_m);
    link(Landmark::kAI, Landmark::kGC, blade_m);
    const Vector3 tip_m =
        OnSideInThorax_m(body_.anatomy, body_.pose, side, kS, AcromionTip_m(body_.anatomy));
    Add(Landmark_m(Landmark::kAA, side), cover_m, tip_m, cover_m);
    const double head_m = kHead_mm * Millimeter_m(kS);
    const Vector3 center_m = Landmark_m(Landmark::kGH, side);
    Add(center_m, head_m, center_m, head_m);
  }

  void CoverArm(Side side) {
    const double mm = Millimeter_m(kH);
    const Vector3 elbow_m =
        OnSideInThorax_m(body_.anatomy, body_.pose, side, kH, body_.anatomy.elbow_m());
    Add(Landmark_m(Landmark::kGH, side), kHead_mm * mm, elbow_m, kShaft_mm * mm);
    Add(Landmark_m(Landmark::kEM, side), kCover_mm * mm, Landmark_m(Landmark::kEL, side),
        kCover_mm * mm);
  }

  const PosedBody& body_;
  SegmentScales scales_;
  SmoothUnion solids_;
};

}  // namespace

PosedBody ImplicitBody(const Anatomy& anatomy, const std::vector<Side>& sides) {
  const ShoulderRhythm rhythm(BuiltInRhythmTable(BuiltInTable::kDestepped));
  PosedBody body{{}, anatomy, rhythm.Solve({RadiansFromDegrees(kBindElevation_deg), 0}).pose};
  BodyBuilder builder(body);
  builder.AddTrunk();
  for (const Side side : {Side::kRight, Side::kLeft}) {
    builder.AddShoulder(side, std::find(sides.begin(), sides.end(), side) != sides.end());
  }
  body.surface = builder.Surface();
  return body;
}

}  // namespace girdle
