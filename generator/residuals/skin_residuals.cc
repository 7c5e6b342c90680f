// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/skin_residuals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "kinematics/lengths.h"
#include "kinematics/one_sided_difference.h"
#include "kinematics/worst_case.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr const char* kGroup = "skin";
constexpr double kPercent = 100;

// MuJoCo blends the skin in single precision, at 1.5 m above the floor.
constexpr double kSinglePrecision_mm = 1e-3;
// Least rise of the acromion's skin in an adult. The AC joint rises by 15.7 to 17.7. The acromion's
// tip, further out, rises by 23 to 25. With an arm that turns in GH alone, the skin rises by 1 at
// most.
constexpr double kAcromionRise_mm = 8;
// Largest share of skin that is squeezed below half of its area. With an arm that turns in GH alone
// it is 14 or more.
constexpr double kBelowHalf_percent = 5;
// Radius of the skin around the joint, in an adult.
constexpr double kAroundAc_m = 0.06;
// Skin and the tissue between it and the bone, for people of any size.
constexpr double kDepth_mm = 3;

// Limit of jumps of the AC skin's velocity. Difference quotients of Girdle's own blend are of
// fourth order with a step of 0.02 deg. They leave 5e-11 for smooth, and 2e-10 for squad over
// elevations (3e-9 at twice the step). Second order would leave 3e-5 for squad, whose third
// derivative jumps.
constexpr double kBlendedJump_mm_per_deg = 1e-6;
// Limit of jumps of MuJoCo's vertices, which are rounded to single precision. The step of their
// difference quotients, 1.1 deg at a man's shoulder, is so long that the rounding leaves a tenth of
// this limit; 0.001 was measured. In addition, third order leaves 0.0003 for smooth and 0.0006 to
// 0.001 for squad (0.0001 at half the step); second order would leave 0.07 for squad.
constexpr double kDrawnJump_mm_per_deg = 0.01;
constexpr double kNoiseShare = 0.1;
// Limit in an adult. Squad as published has a corner at knots with uneven spaces: (8) and (9) scale
// every space to one length, and (5) assumes that length. Over plane 40 the jump is 0.13.
constexpr double kUnevenSquadJump_mm_per_deg = 0.2;

constexpr ArmCommand kLow = {30 * kRadiansPerDegree, 0};
constexpr double kHigh_rad = 120 * kRadiansPerDegree;
// Frontal, scapular, and sagittal plane. Squeezed skin is checked in the frontal plane only, where
// people dropped out last. The other planes fold the skin in front of the joint, which no bone
// prevents.
constexpr std::array<double, 3> kPlanes_rad = {0, 40 * kRadiansPerDegree, 90 * kRadiansPerDegree};
constexpr double kGrid_rad = 15 * kRadiansPerDegree;

double MmPerDegree(double m_per_rad) {
  return m_per_rad * kMillimetersPerMeter * kRadiansPerDegree;
}

std::string PlaneText(double plane_rad) {
  return ", plane " + RoundedText(DegreesFromRadians(plane_rad), 0);
}

// Rethrows a fault of the skin with the model's name.
template <typename Make>
auto MadeFor(const std::string& model_name, const Make& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw InputError(model_name + ": " + error.what() +
                     ". Bind it to the thorax and to the bones of every shoulder, or make the "
                     "model anew with girdle generate --skin");
  }
}

double LargestDistance_m(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  // Skins with different numbers of vertices cannot be compared.
  if (a.size() != b.size()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double largest_m = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest_m = WorseOf(largest_m, glm::distance(a[i], b[i]));
  }
  return largest_m;
}

// Adds the largest values of the AC skin, or those of the other landmarks.
void AddTo(Extreme& extreme, const LandmarkLargest& largest, bool is_ac_skin, double factor) {
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    if (IsAcSkin(k) == is_ac_skin) {
      extreme.Add(factor * largest[k].value(), std::string(kSkinLandmarkNames[k]),
                  largest[k].place());
    }
  }
}

// Two neighbouring spaces between knots that differ in length.
struct UnevenKnots {
  double before_rad;
  double behind_rad;
};

// Returns the first uneven spaces. Spaces count as even within the rounding of degrees in a file.
std::optional<UnevenKnots> FirstUneven(const std::vector<double>& knots_rad) {
  constexpr double kRounding_rad = 1e-9;
  for (std::size_t i = 1; i + 1 < knots_rad.size(); ++i) {
    const UnevenKnots spaces{knots_rad[i] - knots_rad[i - 1], knots_rad[i + 1] - knots_rad[i]};
    if (std::abs(spaces.before_rad - spaces.behind_rad) > kRounding_rad) {
      return spaces;
    }
  }
  return std::nullopt;
}

double NarrowestSpace_rad(const std::vector<double>& knots_rad) {
  double narrowest_rad = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < knots_rad.size(); ++i) {
    narrowest_rad = std::min(narrowest_rad, knots_rad[i] - knots_rad[i - 1]);
  }
  return narrowest_rad;
}

std::string DegreesText(double angle_rad) {
  constexpr int kDecimals = 1;
  return RoundedText(DegreesFromRadians(angle_rad), kDecimals);
}

}  // namespace

SkinMeter::SkinMeter(ShoulderSimulation& simulation, const AssembledRhythm& rhythm,
                     const Anatomy& anatomy, GirdleMotion girdle)
    : simulation_(simulation),
      rhythm_(rhythm),
      girdle_(girdle),
      side_(simulation.elements().side),
      skin_(simulation.model(), simulation.name()),
      on_bones_(MadeFor(simulation.name(), [&] { return SkinOnBones(skin_.bound(), anatomy); })),
      vertices_(skin_.Landmarks(side_)),
      landmarks_(on_bones_, vertices_),
      bind_(MadeFor(simulation.name(), [&] { return on_bones_.BindPose(side_); })),
      size_(ScalesOf(anatomy, BuiltInAnatomy())[static_cast<std::size_t>(Segment::kClavicle)]) {}

ShoulderPose SkinMeter::OnGirdle(const ShoulderPose& pose) const {
  return girdle_ == GirdleMotion::kFrozen ? FrozenGirdle(pose, bind_) : pose;
}

ShoulderPose SkinMeter::PoseFor(const ArmCommand& command) const {
  return OnGirdle(rhythm_.SolvePose(command));
}

double SkinMeter::OffBlend_mm() const {
  mjData& data = simulation_.data();
  return kMillimetersPerMeter *
         LargestDistance_m(skin_.VerticesInWorld_m(data),
                           BlendedVertices_m(skin_.bound(), skin_.BonesInWorld(data)));
}

void SkinMeter::CompareMoving(std::string_view motion, const ArmCommand& command) {
  moving_mm_.Add(OffBlend_mm(), motion, command);
}

std::vector<Vector3> SkinMeter::DrawnVerticesIn_m(const ShoulderPose& pose) {
  for (const ShoulderElements& shoulder : simulation_.shoulders()) {
    simulation_.PutAt(shoulder, pose);
  }
  mjData& data = simulation_.data();
  const int thorax = simulation_.elements().bodies[static_cast<std::size_t>(Segment::kThorax)];
  const mjtNum* const p = data.xpos + 3 * thorax;
  const mjtNum* const q = data.xquat + 4 * thorax;
  const Vector3 p_WT{p[0], p[1], p[2]};
  const Quaternion q_TW = glm::conjugate(Quaternion{q[0], q[1], q[2], q[3]});
  std::vector<Vector3> vertices_m = skin_.VerticesInWorld_m(data);
  for (Vector3& vertex_m : vertices_m) {
    vertex_m = q_TW * (vertex_m - p_WT);
  }
  return vertices_m;
}

SkinLandmarkPlaces SkinMeter::DrawnIn_m(const ShoulderPose& pose) {
  const std::vector<Vector3> vertices_m = DrawnVerticesIn_m(pose);
  SkinLandmarkPlaces places;
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    places[k] = {0, 0, 0};
    for (const int vertex : vertices_[k]) {
      places[k] +=
          vertices_m[static_cast<std::size_t>(vertex)] / static_cast<double>(vertices_[k].size());
    }
  }
  return places;
}

// Compares the whole path from joint angles to MuJoCo's vertices with the pose of the command.
void SkinMeter::ComparePose(const ArmCommand& command) {
  const ShoulderPose pose = PoseFor(command);
  const std::vector<Vector3> vertices_m = DrawnVerticesIn_m(pose);
  posed_mm_.Add(kMillimetersPerMeter * LargestDistance_m(vertices_m, on_bones_.VerticesIn_m(pose)),
                "pose", command);
  at_rest_mm_.Add(OffBlend_mm(), "pose", command);
}

std::vector<Residual> SkinMeter::Measure() {
  for (const double plane_rad : kPlanes_rad) {
    for (const double elevation_rad : {kLow.elevation_rad, kPi / 2, kHigh_rad}) {
      ComparePose({elevation_rad, plane_rad});
    }
  }
  std::vector<Residual> lines;
  lines.push_back(
      at_rest_mm_.Worst(kGroup, "MuJoCo - linear blend, at rest", "mm", kSinglePrecision_mm));
  lines.push_back(
      moving_mm_.Worst(kGroup, "MuJoCo - linear blend, moving", "mm", kSinglePrecision_mm));
  lines.push_back(posed_mm_.Worst(kGroup, "MuJoCo - commanded pose", "mm", kSinglePrecision_mm));
  lines.push_back({kGroup, "bones - where they were bound",
                   kMillimetersPerMeter * on_bones_.MisplacedBones_m(side_), "mm",
                   kSinglePrecision_mm, "bind pose"});
  AddRises(lines);
  AddAreas(lines);
  AddSteps(lines);
  for (const Direction direction : {Direction::kElevation, Direction::kPlane}) {
    AddJumps(lines, direction);
  }
  AddDepths(lines);
  return lines;
}

void SkinMeter::AddRises(std::vector<Residual>& lines) const {
  constexpr std::size_t kAcromion = 1;
  static_assert(kSkinLandmarkNames[kAcromion] == kSkinAcromionName);
  for (const double plane_rad : kPlanes_rad) {
    const ArmCommand from{kLow.elevation_rad, plane_rad};
    const ArmCommand to{kHigh_rad, plane_rad};
    const ShoulderPose low = PoseFor(from);
    const ShoulderPose high = PoseFor(to);
    // If the arm does not reach these elevations, the value has no tolerance.
    const bool is_reached =
        !rhythm_.rhythm().Solve(from).clamped && !rhythm_.rhythm().Solve(to).clamped;
    const std::string where = "elevation 30 to 120" + PlaneText(plane_rad);
    lines.push_back({kGroup, "acromion's skin rises" + PlaneText(plane_rad),
                     kMillimetersPerMeter *
                         (landmarks_.In_m(high)[kAcromion].y - landmarks_.In_m(low)[kAcromion].y),
                     "mm", is_reached ? std::optional(size_ * kAcromionRise_mm) : std::nullopt,
                     where, Bound::kMoreThan});
    lines.push_back({kGroup, "acromion's bone rises" + PlaneText(plane_rad),
                     kMillimetersPerMeter * (AcromionIn_m(on_bones_.anatomy(), high, side_).y -
                                             AcromionIn_m(on_bones_.anatomy(), low, side_).y),
                     "mm", std::nullopt, where});
    lines.push_back(
        {kGroup, "AC joint rises" + PlaneText(plane_rad),
         kMillimetersPerMeter * (LandmarkInThorax_m(on_bones_.anatomy(), high, Landmark::kACJ).y -
                                 LandmarkInThorax_m(on_bones_.anatomy(), low, Landmark::kACJ).y),
         "mm", std::nullopt, where});
  }
}

void SkinMeter::AddAreas(std::vector<Residual>& lines) const {
  const Anatomy& anatomy = on_bones_.anatomy();
  const TriangleMesh& surface = on_bones_.bound().surface;
  const std::vector<std::size_t> triangles =
      TrianglesNear(surface,
                    OnSideInThorax_m(anatomy, bind_, side_, Segment::kScapula,
                                     anatomy.landmark_m(Landmark::kACJ)),
                    size_ * kAroundAc_m);
  for (const double plane_rad : kPlanes_rad) {
    const ArmCommand command{kHigh_rad, plane_rad};
    const AreaChange change = MadeFor(simulation_.name(), [&] {
      return ChangeOfAreas(surface, on_bones_.VerticesIn_m(PoseFor(command)), triangles);
    });
    const bool is_checked = plane_rad == 0 && !rhythm_.rhythm().Solve(command).clamped;
    const std::string where = PlaceOf(
        "within " + RoundedText(kMillimetersPerMeter * size_ * kAroundAc_m, 0) + " mm of AC",
        command);
    lines.push_back({kGroup, "area below half" + PlaneText(plane_rad), kPercent * change.below_half,
                     "%", is_checked ? std::optional(kBelowHalf_percent) : std::nullopt, where});
    lines.push_back({kGroup, "area kept" + PlaneText(plane_rad), kPercent * change.kept, "%",
                     std::nullopt, where});
    lines.push_back({kGroup, "5th percentile of area kept" + PlaneText(plane_rad),
                     kPercent * change.fifth_percentile, "%", std::nullopt, where});
  }
}

void SkinMeter::AddSteps(std::vector<Residual>& lines) const {
  const std::vector<double> planes_rad(kPlanes_rad.begin(), kPlanes_rad.end());
  const LandmarkLargest own = LargestSteps_m(
      landmarks_, [this](const ArmCommand& command) { return PoseFor(command); },
      rhythm_.rhythm().table(), planes_rad);
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    Extreme step;
    step.Add(kMillimetersPerMeter * own[k].value(), "the model's rhythm", own[k].place());
    lines.push_back(step.Worst(kGroup, "step of " + std::string(kSkinLandmarkNames[k]), "mm/deg",
                               std::nullopt));
  }
}

SkinMeter::DrawnDifference SkinMeter::DifferenceOfDrawn(Direction direction) {
  // Distance of the AC skin from the world's origin with a low arm. It moves by centimeters only.
  static_cast<void>(DrawnVerticesIn_m(PoseFor(kLow)));
  const std::vector<Vector3> vertices_m = skin_.VerticesInWorld_m(simulation_.data());
  double distance_m = 0;
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    for (const int vertex : vertices_[k]) {
      if (IsAcSkin(k)) {
        distance_m =
            std::max(distance_m, glm::length(vertices_m[static_cast<std::size_t>(vertex)]));
      }
    }
  }
  // Half of the last place of a single-precision number of this size.
  const double rounding_m = distance_m * std::numeric_limits<float>::epsilon() / 2;
  // Largest error of a jump [mm/deg] times the step [rad]. The jump uses values on both sides of
  // the knot, and the value at the knot with the sum of all weights.
  double sum = 0;
  double magnitudes = 0;
  for (const double weight : kOneSidedFirstOfCoarse) {
    sum += weight;
    magnitudes += std::abs(weight);
  }
  const double noise_by_step = MmPerDegree(2 * (magnitudes + std::abs(sum)) * rounding_m);
  const double wanted_rad = noise_by_step / (kNoiseShare * kDrawnJump_mm_per_deg);
  const double room_rad = NarrowestSpace_rad(KnotsAlong(rhythm_.rhythm().table(), direction)) /
                          static_cast<double>(kOneSidedFirstOfCoarse.size());
  if (wanted_rad <= room_rad) {
    return {wanted_rad, kDrawnJump_mm_per_deg};
  }
  return {room_rad, noise_by_step / room_rad / kNoiseShare};
}

void SkinMeter::AddJumps(std::vector<Residual>& lines, Direction direction) {
  const RhythmTable& table = rhythm_.rhythm().table();
  const std::string over = " over " + std::string(Name(direction)) + " knots, ";
  const auto add = [&](const std::string& skin, const std::string& vertices,
                       const LandmarkLargest& jumps, std::optional<double> tolerance) {
    Extreme jump;
    AddTo(jump, jumps, tolerance.has_value(), MmPerDegree(1));
    lines.push_back(jump.Worst(kGroup, "jump of " + skin + over + vertices, "mm/deg", tolerance));
    if (KnotsAlong(table, direction).size() < 3) {
      // The value is zero by construction, because there is no inner knot to cross.
      lines.back().tolerance = std::nullopt;
      lines.back().where = "the table has no inner knots";
    }
  };
  const std::optional<UnevenKnots> uneven = FirstUneven(KnotsAlong(table, direction));
  const bool has_own_bound =
      uneven && rhythm_.rhythm().options().interpolation == Interpolation::kSquad;
  const auto add_ac_skin = [&](const std::string& vertices, const LandmarkLargest& jumps,
                               double tolerance) {
    add("AC skin", vertices, jumps,
        has_own_bound ? std::max(tolerance, size_ * kUnevenSquadJump_mm_per_deg) : tolerance);
    if (has_own_bound) {
      lines.back().where += std::string("; squad is not C1 here: ") +
                            (direction == Direction::kElevation ? "(8)" : "(9)") +
                            " spaces knots " + DegreesText(uneven->before_rad) + " and " +
                            DegreesText(uneven->behind_rad) + " deg apart, (5) assumes even ones";
    }
  };

  const DrawnDifference drawn = DifferenceOfDrawn(direction);
  add_ac_skin(
      "MuJoCo",
      LargestJumps_m_per_rad(
          [this](const ArmCommand& command) { return DrawnIn_m(PoseFor(command)); }, direction,
          FewKnotCrossings(table, direction), {kOneSidedFirstOfCoarse, drawn.step_rad}),
      drawn.tolerance_mm_per_deg);
  const LandmarkLargest blended = LargestJumps_m_per_rad(
      landmarks_, [this](const ArmCommand& command) { return PoseFor(command); }, table, direction);
  add_ac_skin("linear blend", blended, kBlendedJump_mm_per_deg);
  add("other landmarks", "linear blend", blended, std::nullopt);
}

void SkinMeter::AddDepths(std::vector<Residual>& lines) const {
  const auto shallowest = [this](const ShoulderPose& pose) {
    const LandmarkDepths depths_m = LandmarkDepths_m(on_bones_, pose, side_);
    WorstCase<std::string, Worse::kSmaller> least_mm;
    for (std::size_t i = 0; i < depths_m.size(); ++i) {
      least_mm.Add(kMillimetersPerMeter * depths_m[i], kLandmarks[i].name);
    }
    return least_mm;
  };
  const auto bound_mm = shallowest(bind_);
  lines.push_back({kGroup, "depth of landmarks, bind pose", bound_mm.value(), "mm", kDepth_mm,
                   bound_mm.place(), Bound::kMoreThan});

  WorstCase<ReportPlace, Worse::kSmaller> posed_mm;
  const ArmRectangle& domain = rhythm_.rhythm().domain();
  for (const double elevation_rad :
       EvenSteps(domain.lowest_elevation_rad, domain.highest_elevation_rad, kGrid_rad)) {
    for (const double plane_rad :
         EvenSteps(domain.first_plane_rad, domain.last_plane_rad, kGrid_rad)) {
      const ShoulderSolution solution = rhythm_.rhythm().Solve({elevation_rad, plane_rad});
      if (solution.used.elevation_rad != elevation_rad || solution.used.plane_rad != plane_rad) {
        continue;  // beyond the arm's reach; the grid has the position used instead
      }
      const auto least_mm = shallowest(PoseFor(solution.used));
      posed_mm.Add(least_mm.value(), least_mm.place(), solution.used);
    }
  }
  const ReportPlace& place = posed_mm.place();
  lines.push_back({kGroup, "depth of landmarks, all poses", posed_mm.value(), "mm", std::nullopt,
                   PlaceOf(place.motion, place.command)});
}

}  // namespace girdle
