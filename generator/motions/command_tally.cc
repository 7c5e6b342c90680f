// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/command_tally.h"

#include "kinematics/worst_case.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Returns the reason why commands were clamped.
std::string ReasonText(const CommandTally& tally, Range range) {
  std::string text;
  if (tally.beyond > 0) {
    text = std::to_string(tally.beyond) + " beyond " +
           (range == Range::kWhole ? "what an arm reaches" : "the table");
  }
  if (tally.clamped > tally.beyond) {
    text += (text.empty() ? "" : ", ") + std::to_string(tally.clamped - tally.beyond) +
            " beyond the range of a joint or control";
  }
  return text;
}

}  // namespace

void CommandTally::Add(const ShoulderRhythm& rhythm, const ArmCommand& command,
                       const ArmCommand& used, Origin origin, double distance_rad) noexcept {
  ++rows;
  clamped += rhythm.IsClamped(command, used) ? 1 : 0;
  beyond += rhythm.IsClamped({command.elevation_rad, command.plane_rad},
                             {used.elevation_rad, used.plane_rad})
                ? 1
                : 0;
  derived += origin == Origin::kDerived ? 1 : 0;
  modelled += origin == Origin::kModelled ? 1 : 0;
  farthest_rad = WorseOf(farthest_rad, distance_rad);
}

void CommandTally::Add(const CommandTally& other) noexcept {
  rows += other.rows;
  clamped += other.clamped;
  beyond += other.beyond;
  derived += other.derived;
  modelled += other.modelled;
  gaps += other.gaps;
  bridged += other.bridged;
  farthest_rad = WorseOf(farthest_rad, other.farthest_rad);
}

std::string TallyText(const CommandTally& tally, const TallySubject& subject) {
  constexpr int kDecimals = 1;
  std::string text =
      CountText(tally.rows, subject.counted) + ", " + std::to_string(tally.clamped) + " clamped";
  if (tally.clamped > 0) {
    text += " (" + ReasonText(tally, subject.range) +
            (subject.has_used_columns ? "; see the columns used_*" : "") + ")";
  }
  if (tally.derived > 0) {
    text += ", " + std::to_string(tally.derived) + " derived";
  }
  text += ", " + std::to_string(tally.modelled) + " modelled";
  if (tally.modelled > 0) {
    text += " (up to " + RoundedText(DegreesFromRadians(tally.farthest_rad), kDecimals) +
            " deg from measured directions)";
  }
  if (tally.gaps > 0) {
    text += ", " + CountText(tally.gaps, "gap");
  }
  if (tally.bridged > 0) {
    text += ", " + std::to_string(tally.bridged) + " bridged";
  }
  if (subject.axial_from) {
    text += ", axial from " + std::string(Name(*subject.axial_from));
  }
  if (subject.hanging) {
    text += ", relative to hanging (" + std::string(Name(*subject.hanging)) + ")";
  }
  return text;
}

}  // namespace girdle
