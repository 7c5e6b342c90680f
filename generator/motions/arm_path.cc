// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/arm_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "kinematics/axial_zero.h"
#include "kinematics/rotation.h"

namespace girdle {
namespace {

// Plane and great circle with sines below this [rad] are determined by rounding only.
constexpr double kRounding = 1e-9;

// Returns the direction of the elbow from GH: hanging is -y, plane 0 is z, plane 90 is x.
Vector3 DirectionOf(const ArmCommand& command) noexcept {
  const auto [x, y, z] = UpTheArm<double>({command.elevation_rad, command.plane_rad});
  return {-x, -y, -z};
}

bool Hangs(const ArmCommand& command) noexcept { return command.elevation_rad == 0; }

bool IsUpOrDown(const Vector3& direction) noexcept {
  return std::hypot(direction.x, direction.z) < kRounding;
}

// Returns the unit vector perpendicular to `from` in which the path to `to` begins. Between hanging
// and straight up, the path begins in `vertical_plane_rad`.
Vector3 FirstDirection(const Vector3& from, const Vector3& to, double vertical_plane_rad) noexcept {
  const auto across = [&from](const Vector3& other) {
    return other - glm::dot(from, other) * from;
  };
  const Vector3 shortest = across(to);
  if (glm::length(shortest) > kRounding) {
    return glm::normalize(shortest);
  }
  if (IsUpOrDown(from)) {
    return {std::sin(vertical_plane_rad), 0, std::cos(vertical_plane_rad)};
  }
  return glm::normalize(across({0, -1, 0}));
}

// Slerp of the directions d_0 and d_1. W is the angle between them, and w is the unit vector
// perpendicular to d_0 toward d_1:
//   d(t) = cos(t W) d_0 + sin(t W) w
void TakeAlongGreatCircle(const ArmCommand& from, const ArmCommand& to, double share,
                          ArmCommand& command) noexcept {
  const Vector3 d_0 = DirectionOf(from);
  const Vector3 d_1 = DirectionOf(to);
  const double whole_rad = std::atan2(glm::length(glm::cross(d_0, d_1)), glm::dot(d_0, d_1));
  const Vector3 w = FirstDirection(
      d_0, d_1, from.elevation_rad > to.elevation_rad ? from.plane_rad : to.plane_rad);
  const Vector3 d = std::cos(share * whole_rad) * d_0 + std::sin(share * whole_rad) * w;
  command.elevation_rad = std::atan2(std::hypot(d.x, d.z), -d.y);
  // At hanging or straight up, the plane is that of the nearer end.
  const double nearer_rad = share < 0.5 ? from.plane_rad : to.plane_rad;
  command.plane_rad = IsUpOrDown(d) ? nearer_rad : std::atan2(d.x, d.z);
}

// Returns an angle within half a turn.
double WithinHalfTurn(double angle_rad) noexcept {
  return std::abs(angle_rad) <= kPi ? angle_rad : std::remainder(angle_rad, 2 * kPi);
}

// Successive rows in which the arm hangs.
struct HangingRows {
  std::size_t begin;
  std::size_t end;
};

// Returns the next hanging rows from row `begin` on. Empty, at the end of all rows, if there are
// none.
HangingRows NextHanging(const std::vector<TimedCommand>& rows, std::size_t begin) {
  const auto hangs = [](const TimedCommand& row) { return Hangs(row.command); };
  const auto first =
      std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(begin), rows.end(), hangs);
  const auto last = std::find_if_not(first, rows.end(), hangs);
  return {static_cast<std::size_t>(first - rows.begin()),
          static_cast<std::size_t>(last - rows.begin())};
}

// Returns the command at a share of the path from one to the other, 0 to 1.
ArmCommand OnTheWay(const ArmCommand& from, const ArmCommand& to, double share) noexcept {
  if (share <= 0) {
    return from;
  }
  if (share >= 1) {
    return to;
  }
  ArmCommand command;
  command.axial_from = from.axial_from;
  command.axial_rad = from.axial_rad + share * ShortWay_rad(from.axial_rad, to.axial_rad);
  command.shrug_rad = Between(from.shrug_rad, to.shrug_rad, share);
  command.protraction_rad = Between(from.protraction_rad, to.protraction_rad, share);
  const double turn_rad = ShortWay_rad(from.plane_rad, to.plane_rad);
  if (turn_rad == 0 || (from.elevation_rad == to.elevation_rad && IsUpOrDown(DirectionOf(from)))) {
    // The great circle is vertical, or the arm stays at hanging or straight up.
    command.elevation_rad = Between(from.elevation_rad, to.elevation_rad, share);
    command.plane_rad = WithinHalfTurn(from.plane_rad + share * turn_rad);
  } else {
    TakeAlongGreatCircle(from, to, share, command);
  }
  return command;
}

}  // namespace

double Between(double from, double to, double share) noexcept { return from + share * (to - from); }

double ShortWay_rad(double from_rad, double to_rad) noexcept {
  return std::remainder(to_rad - from_rad, 2 * kPi);
}

ArmPath::ArmPath(const std::vector<TimedCommand>& commands) {
  std::vector<TimedCommand> rows = commands;
  for (TimedCommand& row : rows) {
    if (row.command.axial_from == AxialFrom::kIsb) {
      row.command.axial_rad += row.command.plane_rad;
    }
  }
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    stretches_.push_back({rows[i], rows[i + 1]});
  }
  if (stretches_.empty()) {
    stretches_.push_back({rows.front(), rows.front()});
    return;
  }
  for (HangingRows hanging = NextHanging(rows, 0); hanging.begin < rows.size();
       hanging = NextHanging(rows, hanging.end)) {
    TakePlanesOfTheWay(rows, hanging.begin, hanging.end);
  }
}

void ArmPath::TakePlanesOfTheWay(const std::vector<TimedCommand>& rows, std::size_t begin,
                                 std::size_t end) {
  if (begin == 0 && end == rows.size()) {
    return;
  }
  const double arrival_rad = rows[begin == 0 ? end : begin - 1].command.plane_rad;
  const double leaving_rad = rows[end == rows.size() ? begin - 1 : end].command.plane_rad;
  const double turn_rad = ShortWay_rad(arrival_rad, leaving_rad);
  const double first_s = rows[begin].time_s;
  const double duration_s = rows[end - 1].time_s - first_s;
  for (std::size_t i = begin; i < end; ++i) {
    const double share = duration_s > 0 ? (rows[i].time_s - first_s) / duration_s : 0;
    const double plane_rad = WithinHalfTurn(arrival_rad + share * turn_rad);
    if (i > 0) {
      stretches_[i - 1].to.command.plane_rad = plane_rad;
    }
    if (i + 1 < rows.size()) {
      stretches_[i].from.command.plane_rad = i + 1 == end ? leaving_rad : plane_rad;
    }
  }
}

ArmCommand ArmPath::At(double time_s) const noexcept {
  const auto next = std::upper_bound(
      stretches_.begin(), stretches_.end(), time_s,
      [](double time, const Stretch& stretch) { return time < stretch.from.time_s; });
  const Stretch& stretch = next == stretches_.begin() ? *next : *(next - 1);
  const double duration_s = stretch.to.time_s - stretch.from.time_s;
  ArmCommand command = OnTheWay(stretch.from.command, stretch.to.command,
                                duration_s > 0 ? (time_s - stretch.from.time_s) / duration_s : 0);
  if (command.axial_from == AxialFrom::kIsb) {
    command.axial_rad = WithinHalfTurn(command.axial_rad - command.plane_rad);
  }
  return command;
}

void BridgeCommands(const ArmCommand& before, const ArmCommand& after,
                    std::span<ArmCommand> between) {
  const ArmPath path({{0, before}, {static_cast<double>(between.size() + 1), after}});
  for (std::size_t i = 0; i < between.size(); ++i) {
    between[i] = path.At(static_cast<double>(i + 1));
  }
}

}  // namespace girdle
