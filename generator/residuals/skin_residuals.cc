// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/skin_residuals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <stdexcept>
#include <utility>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "kinematics/lengths.h"
#include "kinematics/worst_case.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr const char* kGroup = "skin";
constexpr double kPercent = 100;

// MuJoCo blends skin in single precision, a metre and a half above the floor.
constexpr double kSinglePrecision_mm = 1e-3;
// In an adult. The AC joint rises 15.7 to 17.7, the acromion's tip, further out, 23 to 25, and with
// an arm that turns in GH alone the skin 1 at most.
constexpr double kAcromionRise_mm = 8;
// Of an arm that turns in GH alone it is 14 and more.
constexpr double kBelowHalf_percent = 5;
// Skin about the joint, in an adult.
constexpr double kAroundAc_m = 0.06;
// Skin and what lies between it and the bone, of people of any size.
constexpr double kDepth_mm = 3;
// Squad is as smooth over elevation as published: what is left of slerp's jumps is its second
// derivative over the step of the differences.
constexpr double kSquadJump_percent = 1;
constexpr double kSmoothJump_mm_per_deg = 1e-6;

constexpr ArmCommand kLow = {30 * kRadiansPerDegree, 0};
constexpr double kHigh_rad = 120 * kRadiansPerDegree;
// Frontal, scapular, sagittal. The frontal one, where people dropped out last, is the one checked
// for squeezed skin: the others fold it in front of the joint, which no bone prevents.
constexpr std::array<double, 3> kPlanes_rad = {0, 40 * kRadiansPerDegree, 90 * kRadiansPerDegree};
constexpr double kGrid_rad = 15 * kRadiansPerDegree;

// The skin over the AC joint.
constexpr std::array<std::string_view, 2> kAcSkin = {kSkinAcName, kSkinAcromionName};

double MmPerDegree(double m_per_rad) {
  return m_per_rad * kMillimetersPerMeter * kRadiansPerDegree;
}

std::string PlaneText(double plane_rad) {
  return ", plane " + RoundedText(DegreesFromRadians(plane_rad), 0);
}

// What is wrong with a skin said with the model's name.
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
  // Of skins that are not of one kind nothing is known.
  if (a.size() != b.size()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double largest_m = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest_m = WorseOf(largest_m, glm::distance(a[i], b[i]));
  }
  return largest_m;
}

// Adds the largest values of the AC skin, or of all landmarks.
void AddTo(Extreme& extreme, const LandmarkLargest& largest, bool all, double factor,
           const std::string& with) {
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    if (all || std::find(kAcSkin.begin(), kAcSkin.end(), kSkinLandmarkNames[k]) != kAcSkin.end()) {
      extreme.Add(factor * largest[k].value(), std::string(kSkinLandmarkNames[k]) + with,
                  largest[k].place());
    }
  }
}

// One of the interpolations as published, or smooth, on the table that it uses by default.
struct Interpolated {
  Interpolation interpolation;
  ShoulderRhythm rhythm;
  std::string table;  ///< for the report
};

std::vector<Interpolated> InterpolatedRhythms() {
  std::vector<Interpolated> rhythms;
  for (const Interpolation interpolation :
       {Interpolation::kSlerp, Interpolation::kSquad, Interpolation::kSmooth}) {
    const RhythmOptions options =
        interpolation == Interpolation::kSmooth
            ? RhythmOptions{}
            : RhythmOptions{interpolation, Closure::kTable, Range::kClamp};
    rhythms.push_back({interpolation, BuiltInRhythm(options),
                       ", table " + std::string(Name(DefaultTable(interpolation)))});
  }
  return rhythms;
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

// The whole way: joint angles in, MuJoCo's vertices out, against the pose that was meant.
void SkinMeter::ComparePose(const ArmCommand& command) {
  const ShoulderPose pose = PoseFor(command);
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
  lines.push_back(posed_mm_.Worst(kGroup, "MuJoCo - pose asked for", "mm", kSinglePrecision_mm));
  lines.push_back({kGroup, "bones - where they were bound",
                   kMillimetersPerMeter * on_bones_.MisplacedBones_m(side_), "mm",
                   kSinglePrecision_mm, "bind pose"});
  AddRises(lines);
  AddAreas(lines);
  AddSteps(lines);
  AddJumps(lines);
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
    // Of an arm that does not go so far nothing is known.
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
  for (const Interpolated& interpolated : InterpolatedRhythms()) {
    const LandmarkLargest steps = LargestSteps_m(
        landmarks_,
        [&](const ArmCommand& command) { return OnGirdle(interpolated.rhythm.SolvePose(command)); },
        interpolated.rhythm.table(), planes_rad);
    Extreme step;
    AddTo(step, steps, false, kMillimetersPerMeter, interpolated.table);
    lines.push_back(step.Worst(kGroup,
                               "step of AC skin, " + std::string(Name(interpolated.interpolation)),
                               "mm/deg", std::nullopt));
  }
}

void SkinMeter::AddJumps(std::vector<Residual>& lines) const {
  const std::vector<Interpolated> rhythms = InterpolatedRhythms();
  for (const Direction direction : {Direction::kElevation, Direction::kPlane}) {
    const std::string over =
        " over " + std::string(kDirectionNames[static_cast<std::size_t>(direction)]) + " knots, ";
    double slerp = std::numeric_limits<double>::quiet_NaN();
    for (const Interpolated& interpolated : rhythms) {
      const bool is_smooth = interpolated.interpolation == Interpolation::kSmooth;
      const LandmarkLargest jumps = LargestJumps_m_per_rad(
          landmarks_,
          [&](const ArmCommand& command) {
            return OnGirdle(interpolated.rhythm.SolvePose(command));
          },
          interpolated.rhythm.table(), direction);
      Extreme jump;
      AddTo(jump, jumps, is_smooth, MmPerDegree(1), interpolated.table);
      const std::string item = (is_smooth ? "jump of all landmarks" : "jump of AC skin") + over +
                               std::string(Name(interpolated.interpolation));
      lines.push_back(jump.Worst(kGroup, item, "mm/deg",
                                 is_smooth ? std::optional(kSmoothJump_mm_per_deg) : std::nullopt));
      if (interpolated.interpolation == Interpolation::kSlerp) {
        slerp = jump.worst();
      }
      if (interpolated.interpolation == Interpolation::kSquad) {
        Residual ratio = jump.Worst(
            kGroup, item + " of slerp's", "%",
            direction == Direction::kElevation ? std::optional(kSquadJump_percent) : std::nullopt);
        ratio.value = kPercent * jump.worst() / slerp;
        lines.push_back(std::move(ratio));
      }
    }
  }
}

void SkinMeter::AddDepths(std::vector<Residual>& lines) const {
  const auto shallowest = [this](const ShoulderPose& pose) {
    const LandmarkDepths depths_m = LandmarkDepths_m(on_bones_, pose, side_);
    const auto* const least = std::min_element(depths_m.begin(), depths_m.end());
    return std::pair(
        kMillimetersPerMeter * *least,
        std::string(kLandmarks[static_cast<std::size_t>(least - depths_m.begin())].name));
  };
  const auto [bound_mm, bound_name] = shallowest(bind_);
  lines.push_back({kGroup, "depth of landmarks, bind pose", bound_mm, "mm", kDepth_mm, bound_name,
                   Bound::kMoreThan});

  Residual posed{kGroup,
                 "depth of landmarks, all poses",
                 std::numeric_limits<double>::infinity(),
                 "mm",
                 std::nullopt,
                 ""};
  const ArmRectangle& domain = rhythm_.rhythm().domain();
  for (const double elevation_rad :
       EvenSteps(domain.lowest_elevation_rad, domain.highest_elevation_rad, kGrid_rad)) {
    for (const double plane_rad :
         EvenSteps(domain.first_plane_rad, domain.last_plane_rad, kGrid_rad)) {
      const ShoulderSolution solution = rhythm_.rhythm().Solve({elevation_rad, plane_rad});
      if (solution.used.elevation_rad != elevation_rad || solution.used.plane_rad != plane_rad) {
        continue;  // beyond what an arm reaches: another place of the grid answers for it
      }
      const auto [depth_mm, name] = shallowest(PoseFor(solution.used));
      if (depth_mm < posed.value) {
        posed.value = depth_mm;
        posed.where = PlaceOf(name, solution.used);
      }
    }
  }
  lines.push_back(std::move(posed));
}

}  // namespace girdle
