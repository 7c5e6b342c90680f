// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/skin_continuity.h"

#include <string_view>

#include "kinematics/lengths.h"
#include "kinematics/worst_case.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

std::string SkinPlace(std::string_view landmark, const ArmCommand& command) {
  constexpr int kDecimals = 1;
  return std::string(landmark) + ", elevation " +
         RoundedText(DegreesFromRadians(command.elevation_rad), kDecimals) + ", plane " +
         RoundedText(DegreesFromRadians(command.plane_rad), kDecimals);
}

struct LandmarkPlace {
  std::string_view landmark;
  ArmCommand command;
};

// Returns the largest value over the landmarks. `mm_per_deg` converts the unit of `values`.
SkinFigure LargestOf(const LandmarkLargest& values, bool ac_skin_only, double mm_per_deg) {
  WorstCase<LandmarkPlace> largest;
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    if (!ac_skin_only || IsAcSkin(k)) {
      largest.Add(mm_per_deg * values[k].value(), kSkinLandmarkNames[k], values[k].place());
    }
  }
  return {largest.value(), SkinPlace(largest.place().landmark, largest.place().command)};
}

}  // namespace

SkinContinuity MeasureSkin(const LandmarkSkin& landmarks, const RhythmTable& table) {
  constexpr double kOfJumps = kMillimetersPerMeter * kRadiansPerDegree;  // from m/rad
  constexpr double kOfSteps = kMillimetersPerMeter;                      // from m per degree
  SkinContinuity skin;
  for (const Interpolation interpolation :
       {Interpolation::kSlerp, Interpolation::kSquad, Interpolation::kSmooth}) {
    const ShoulderRhythm rhythm(table, {interpolation, Closure::kTable, {}});
    const PoseFunction pose = [&](const ArmCommand& command) { return rhythm.SolvePose(command); };
    for (const Direction direction : {Direction::kElevation, Direction::kPlane}) {
      const LandmarkLargest jumps = LargestJumps_m_per_rad(landmarks, pose, table, direction);
      skin.jumps.push_back({interpolation, direction, LargestOf(jumps, true, kOfJumps),
                            LargestOf(jumps, false, kOfJumps)});
    }
    skin.steps.push_back(
        {interpolation,
         LargestOf(LargestSteps_m(landmarks, pose, table, table.planes_rad()), true, kOfSteps)});
  }
  return skin;
}

std::string SkinContinuityAsText(const SkinContinuity& skin) {
  constexpr std::size_t kNameWidth = 15;
  constexpr std::size_t kDirectionWidth = 11;
  constexpr std::size_t kNumberWidth = 11;
  constexpr int kDigits = 2;
  std::string text =
      "skin: largest jump of velocity over the table's inner knots, and largest step in a degree "
      "of elevation (mm/deg)\n" +
      AlignedLeft("interpolation", kNameWidth) + AlignedLeft("over", kDirectionWidth) +
      AlignedRight("AC skin", kNumberWidth) + AlignedRight("all", kNumberWidth) +
      "  where the AC skin's is\n";
  const auto number = [](double value) {
    return AlignedRight(SignificantText(value, kDigits), kNumberWidth);
  };
  for (const SkinJumps& row : skin.jumps) {
    text += AlignedLeft(std::string(Name(row.interpolation)), kNameWidth) +
            AlignedLeft(std::string(Name(row.direction)), kDirectionWidth) +
            number(row.ac_skin.value_mm_per_deg) + number(row.all.value_mm_per_deg) + "  " +
            row.ac_skin.where + "\n";
  }
  for (const SkinStep& row : skin.steps) {
    text += AlignedLeft(std::string(Name(row.interpolation)), kNameWidth) +
            AlignedLeft("a degree", kDirectionWidth) + number(row.ac_skin.value_mm_per_deg) +
            AlignedRight("-", kNumberWidth) + "  " + row.ac_skin.where + "\n";
  }
  return text;
}

}  // namespace girdle
