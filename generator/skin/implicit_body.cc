// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/implicit_body.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "kinematics/shoulder_rhythm.h"
#include "rhythm_tables/built_in_tables.h"
#include "skin/smooth_union.h"
#include "skin/surface_nets.h"

namespace girdle {
namespace {

// Elevation of the arms when the skin is bound. It is high enough to leave the axilla open, and
// near enough to hanging to strain no joint.
constexpr double kBindElevation_deg = 45;

// End of a muscle on the right side of an adult, in the frame of its bone, and its radius there
// [mm].
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

// Muscles drawn after textbook figures of a lean adult, for both sides.
constexpr Muscle kMuscles[] = {
    // Sternocleidomastoid.
    {{kT, {-8, 8, 16}, 6}, {kT, {-72, 128, 44}, 13}},
    // Trapezius: the neck's slope in two strands, then its middle and lower parts.
    {{kT, {-84, 104, 34}, 24}, {kC, {-10, -4, 112}, 9}},
    {{kT, {-96, 100, 28}, 30}, {kS, {-10, -14, -14}, 8}},
    {{kT, {-106, 52, 22}, 25}, {kS, {-20, -16, -46}, 8}},
    {{kT, {-128, 8, 24}, 24}, {kS, {-10, -10, -100}, 14}},
    {{kT, {-136, -110, 20}, 18}, {kS, {-4, -20, -118}, 15}},
    // Erector spinae.
    {{kT, {-124, 40, 22}, 20}, {kT, {-132, -150, 32}, 26}},
    {{kT, {-132, -150, 32}, 26}, {kT, {-118, -420, 40}, 30}},
    // Where the trapezius leaves the scapula, and the latissimus over the inferior angle.
    {{kT, {-132, -120, 28}, 22}, {kS, {0, -112, -128}, 17}},
    {{kT, {-124, -200, 40}, 26}, {kS, {2, -124, -120}, 17}},
    {{kS, {2, -118, -122}, 18}, {kH, {0, -58, -6}, 14}},
    // Infraspinatus and teres.
    {{kS, {-8, -42, -104}, 19}, {kS, {-8, -40, -40}, 16}},
    {{kS, {-2, -92, -122}, 17}, {kS, {-4, -60, -60}, 16}},
    {{kS, {-4, -92, -118}, 16}, {kH, {-6, -50, 4}, 16}},
    // Latissimus and the wall of the chest under the axilla.
    {{kT, {-102, -300, 86}, 34}, {kT, {-98, -160, 116}, 37}},
    {{kT, {-98, -160, 116}, 37}, {kH, {2, -58, -8}, 15}},
    {{kT, {-136, -114, 129}, 35}, {kT, {-114, -190, 116}, 33}},
    {{kT, {-86, -110, 106}, 34}, {kH, {4, -50, -10}, 18}},
    // Pectoralis: three strands from the sternum, and one from the clavicle.
    {{kT, {4, -22, 24}, 14}, {kH, {14, -72, 0}, 15}},
    {{kT, {12, -58, 32}, 18}, {kT, {-10, -54, 104}, 22}},
    {{kT, {-10, -54, 104}, 22}, {kH, {14, -80, -2}, 15}},
    {{kT, {18, -98, 36}, 17}, {kT, {4, -98, 84}, 21}},
    {{kT, {4, -98, 84}, 21}, {kH, {12, -84, -6}, 11}},
    {{kC, {4, -10, 44}, 8}, {kH, {16, -70, 2}, 15}},
    // The clavicle's forward bow.
    {{kC, {6, 0, 4}, 6}, {kC, {13, 0, 45}, 7}},
    {{kC, {13, 0, 45}, 7}, {kC, {4, 0, 105}, 7}},
    // Rectus abdominis.
    {{kT, {10, -160, 34}, 18}, {kT, {4, -300, 36}, 22}},
    {{kT, {4, -300, 36}, 22}, {kT, {2, -440, 36}, 24}},
    // Deltoid: front, side and back.
    {{kC, {4, -4, 116}, 9}, {kH, {20, -46, 4}, 21}},
    {{kH, {20, -46, 4}, 21}, {kH, {13, -128, 10}, 14}},
    {{kS, {-4, -16, 14}, 10}, {kH, {16, -38, 20}, 20}},
    {{kH, {16, -38, 20}, 20}, {kH, {12, -132, 12}, 14}},
    {{kS, {-28, -20, -16}, 10}, {kH, {-4, -44, 22}, 20}},
    {{kS, {-18, -14, -62}, 9}, {kH, {-12, -52, 12}, 18}},
    {{kH, {-4, -44, 22}, 20}, {kH, {8, -130, 14}, 13}},
    // Biceps and triceps, around the tissue between them.
    {{kH, {2, -95, 0}, 30}, {kH, {0, -195, 0}, 31}},
    {{kH, {0, -195, 0}, 31}, {kH, {0, -255, 0}, 24}},
    {{kH, {12, -105, -4}, 22}, {kH, {13, -185, -2}, 23}},
    {{kH, {13, -185, -2}, 23}, {kH, {8, -240, 0}, 15}},
    {{kH, {-12, -80, 2}, 26}, {kH, {-14, -170, 2}, 23}},
    {{kH, {-14, -170, 2}, 23}, {kH, {-8, -245, 0}, 15}},
    // Forearm.
    {{kH, {4, -318, 10}, 24}, {kH, {2, -540, 10}, 10}},
    {{kH, {2, -318, -10}, 23}, {kH, {2, -540, -10}, 10}},
    // A closed hand.
    {{kH, {4, -572, 14}, 15}, {kH, {6, -606, 16}, 17}},
    {{kH, {4, -572, -14}, 14}, {kH, {6, -606, -16}, 15}},
    {{kH, {14, -566, 26}, 9}, {kH, {22, -598, 20}, 9}},
};

// Solids of the trunk in the median plane, thorax frame [mm].
struct Mass {
  Vector3 center_mm;
  Vector3 radii_mm;
};
constexpr Mass kTrunk[] = {
    {{-61, -146, 0}, {98, 210, 155}},  // rib cage
    {{-58, -400, 0}, {86, 210, 142}},  // belly
    {{-64, -20, 0}, {64, 64, 92}},     // between the shoulders
};
// The forehead and the back of the head. With them, the height above the jugular notch agrees with
// the rest of a person's stature (kJugularNotchShare).
constexpr Mass kCranium = {{-52, 214, 0}, {98, 94, 77}};
// Round cones in the median plane, thorax frame [mm].
struct MedianCone {
  Vector3 from_mm;
  double from_radius_mm;
  Vector3 to_mm;
  double to_radius_mm;
};
constexpr MedianCone kNeckAndFace[] = {
    {{-76, 10, 0}, 54, {-66, 165, 0}, 47},  // neck
    {{-28, 196, 0}, 62, {-4, 128, 0}, 42},  // face
    {{-32, 126, 0}, 40, {14, 110, 0}, 22},  // jaw and chin
    {{36, 202, 0}, 7, {46, 174, 0}, 9},     // nose
};
constexpr double kWaistCut_mm = -390;
// End of the arm on a side without one, humerus frame.
constexpr double kArmCut_mm = -105;

// Thickness of the skin over bone directly under it [mm].
constexpr double kCover_mm = 5;
constexpr double kBladeCover_mm = 14;
constexpr double kCoracoidCover_mm = 21;
constexpr double kInferiorCover_mm = 20;
constexpr double kJointCover_mm = 6;
constexpr double kElbowCover_mm = 4;
// Place on the arm from which it narrows toward the epicondyles, humerus frame.
constexpr double kAboveElbow_mm = -210;
constexpr double kBesideElbow_mm = 16;
constexpr double kHead_mm = 30;
constexpr double kShaft_mm = 25;

// Width over which muscles and trunk blend into each other.
constexpr double kBlend_mm = 14;
constexpr double kEdge_mm = 4;
// Margin around all solids, in cells.
constexpr double kMargin = 3;
// Largest slope of the union of the solids near the surface. Cones and cuts have a slope of 1. The
// trunk's ellipsoids have at most 1.37 outside and near their surface; they are steeper only deep
// inside, far from the surface.
constexpr double kSteepest = 1.5;

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
    solids_.ellipsoids.push_back({kCranium.center_mm * mm, kCranium.radii_mm * mm});
    for (const MedianCone& cone : kNeckAndFace) {
      Add(cone.from_mm * mm, cone.from_radius_mm * mm, cone.to_mm * mm, cone.to_radius_mm * mm);
    }
    const auto median = [this](Landmark landmark) {
      return InMedianPlane(body_.anatomy.landmark_m(landmark));
    };
    const double cover_m = kCover_mm * mm;
    Add(median(Landmark::kC7), cover_m, median(Landmark::kT8), cover_m);
    Add(median(Landmark::kIJ), cover_m, median(Landmark::kPX), cover_m);
    solids_.cuts.push_back({{0, kWaistCut_mm * mm, 0}, {0, -1, 0}});
  }

  void AddShoulder(Side side, bool has_arm) {
    SmoothUnion arm;
    arm.blend_m = solids_.blend_m;
    arm.rounding_m = solids_.rounding_m;
    SmoothUnion& arm_solids = has_arm ? solids_ : arm;
    for (const Muscle& muscle : kMuscles) {
      const bool is_of_arm = muscle.from.segment == kH || muscle.to.segment == kH;
      Add(Place_m(muscle.from.segment, muscle.from.place_mm, side),
          muscle.from.radius_mm * Millimeter_m(muscle.from.segment),
          Place_m(muscle.to.segment, muscle.to.place_mm, side),
          muscle.to.radius_mm * Millimeter_m(muscle.to.segment), is_of_arm ? arm_solids : solids_);
    }
    CoverGirdle(side);
    CoverArm(side, arm_solids);
    if (!has_arm) {
      const Vector3 cut_m = Place_m(kH, {0, kArmCut_mm, 0}, side);
      arm.cuts.push_back({cut_m, glm::normalize(cut_m - Place_m(kH, {0, 0, 0}, side))});
      solids_.parts.push_back(arm);
    }
  }

  [[nodiscard]] TriangleMesh Surface() const {
    const double cell_m = kImplicitCell_m * scales_[static_cast<std::size_t>(kT)];
    const double margin_m = kMargin * cell_m;
    Box box{Vector3{1, 1, 1} * 1e9, Vector3{-1, -1, -1} * 1e9};
    const auto include = [&box, margin_m](const Vector3& center_m, const Vector3& radii_m) {
      box.lowest_m = glm::min(box.lowest_m, center_m - radii_m - margin_m);
      box.highest_m = glm::max(box.highest_m, center_m + radii_m + margin_m);
    };
    const auto include_cones = [&include](const SmoothUnion& solids) {
      for (const RoundCone& cone : solids.cones) {
        include(cone.from_m, Vector3(cone.from_radius_m));
        include(cone.to_m, Vector3(cone.to_radius_m));
      }
    };
    include_cones(solids_);
    std::for_each(solids_.parts.begin(), solids_.parts.end(), include_cones);
    for (const TurnedEllipsoid& ellipsoid : solids_.ellipsoids) {
      include(ellipsoid.center_m, ellipsoid.radii_m);
    }
    return SurfaceNets(solids_, box, cell_m, kSteepest);
  }

 private:
  // Returns an adult's millimeter in meters, scaled to this person's bone.
  [[nodiscard]] double Millimeter_m(Segment segment) const {
    return scales_[static_cast<std::size_t>(segment)] * kMillimeter_m;
  }
  [[nodiscard]] Vector3 Place_m(Segment segment, const Vector3& place_mm, Side side) const {
    return OnSideInThorax_m(body_.anatomy, body_.pose, side, segment,
                            place_mm * Millimeter_m(segment));
  }
  [[nodiscard]] Vector3 Landmark_m(Landmark landmark, Side side) const {
    return OnSideInThorax_m(body_.anatomy, body_.pose, side, landmark);
  }
  void Add(const Vector3& from_m, double from_radius_m, const Vector3& to_m, double to_radius_m) {
    Add(from_m, from_radius_m, to_m, to_radius_m, solids_);
  }
  static void Add(const Vector3& from_m, double from_radius_m, const Vector3& to_m,
                  double to_radius_m, SmoothUnion& solids) {
    solids.cones.push_back({from_m, from_radius_m, to_m, to_radius_m});
  }

  // Covers clavicle and scapula with solids in any pose.
  void CoverGirdle(Side side) {
    const double cover_m = kCover_mm * Millimeter_m(kS);
    const double blade_m = kBladeCover_mm * Millimeter_m(kS);
    const auto link = [&](Landmark from, Landmark to, double radius_m) {
      Add(Landmark_m(from, side), radius_m, Landmark_m(to, side), radius_m);
    };
    link(Landmark::kSC, Landmark::kPAC, kCover_mm * Millimeter_m(kC));
    link(Landmark::kPAC, Landmark::kPAC, kJointCover_mm * Millimeter_m(kS));
    link(Landmark::kPAC, Landmark::kACJ, cover_m);
    link(Landmark::kTS, Landmark::kAA, cover_m);
    link(Landmark::kTS, Landmark::kAI, blade_m);
    link(Landmark::kAI, Landmark::kAI, kInferiorCover_mm * Millimeter_m(kS));
    link(Landmark::kAI, Landmark::kGC, blade_m);
    link(Landmark::kGC, Landmark::kPC, kCoracoidCover_mm * Millimeter_m(kS));
    const Vector3 tip_m =
        OnSideInThorax_m(body_.anatomy, body_.pose, side, kS, AcromionTip_m(body_.anatomy));
    Add(Landmark_m(Landmark::kAA, side), cover_m, tip_m, cover_m);
    const double head_m = kHead_mm * Millimeter_m(kS);
    const Vector3 center_m = Landmark_m(Landmark::kGH, side);
    Add(center_m, head_m, center_m, head_m);
  }

  void CoverArm(Side side, SmoothUnion& solids) const {
    const double mm = Millimeter_m(kH);
    const Vector3 elbow_m =
        OnSideInThorax_m(body_.anatomy, body_.pose, side, kH, body_.anatomy.elbow_m());
    Add(Landmark_m(Landmark::kGH, side), kHead_mm * mm, elbow_m, kShaft_mm * mm, solids);
    for (const auto& [epicondyle, outward_mm] :
         {std::pair(Landmark::kEM, -kBesideElbow_mm), std::pair(Landmark::kEL, kBesideElbow_mm)}) {
      Add(Place_m(kH, {0, kAboveElbow_mm, outward_mm}, side), kBesideElbow_mm * mm,
          Landmark_m(epicondyle, side), kElbowCover_mm * mm, solids);
    }
  }

  const PosedBody& body_;
  SegmentScales scales_;
  SmoothUnion solids_;
};

}  // namespace

PosedBody ImplicitBody(const Anatomy& anatomy, const std::vector<Side>& sides) {
  const ShoulderRhythm rhythm(BuiltInRhythmTable(BuiltInTable::kSmoothed));
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
