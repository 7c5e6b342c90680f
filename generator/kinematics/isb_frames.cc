// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/isb_frames.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "kinematics/lengths.h"

namespace girdle {
namespace {

// A humerus that is turned farther than this about its long axis is no human one.
constexpr double kFarthestTurn_rad = 120 * kRadiansPerDegree;
// From this elevation on, the way back to hanging is ill determined.
constexpr double kNearlyUp_rad = 150 * kRadiansPerDegree;

struct NamedPoint {
  std::string_view name;
  Vector3 position_m;
};

std::string Millimeters(double length_m) {
  return std::to_string(std::lround(kMillimetersPerMeter * length_m)) + " mm";
}

std::string Text(std::string_view name) { return std::string(name); }

// Returns a flaw of the last of three landmarks if one of them is nearly on the line through the
// others.
std::optional<LandmarkFlaw> FlawOfPlane(const NamedPoint& a, const NamedPoint& b,
                                        const NamedPoint& c) {
  const double longest_m = std::max({glm::distance(a.position_m, b.position_m),
                                     glm::distance(b.position_m, c.position_m),
                                     glm::distance(c.position_m, a.position_m)});
  const double off_m = std::min({DistanceFromLine(a.position_m, b.position_m, c.position_m),
                                 DistanceFromLine(b.position_m, c.position_m, a.position_m),
                                 DistanceFromLine(c.position_m, a.position_m, b.position_m)});
  if (off_m >= kNearlyOnALine * longest_m) {
    return std::nullopt;
  }
  return LandmarkFlaw{c.name, Text(a.name) + ", " + Text(b.name) + " and " + Text(c.name) +
                                  " lie nearly on a line, " + Millimeters(off_m) +
                                  " off it, and tell no frame. Measure them again"};
}

LandmarkFlaw Swapped(std::string_view blamed, std::string_view other, const std::string& why) {
  return {blamed, why + ": " + Text(other) + " and " + Text(blamed) +
                      " have each other's place. Swap their names"};
}

// Returns a flaw of a thorax. The side is not checked.
std::optional<LandmarkFlaw> FlawOfThorax(const ThoraxPoints& thorax) {
  const NamedPoint others[] = {{"PX", thorax.px_m}, {"C7", thorax.c7_m}, {"T8", thorax.t8_m}};
  for (const NamedPoint& other : others) {
    if (glm::distance(thorax.sc_m, other.position_m) < glm::distance(thorax.sc_m, thorax.ij_m)) {
      return Swapped(other.name, "IJ", "SC lies nearer to " + Text(other.name) + " than to IJ");
    }
  }
  if (glm::dot(thorax.ij_m - thorax.px_m, thorax.c7_m - thorax.t8_m) <= 0) {
    return Swapped("T8", "C7", "T8 to C7 does not go up as PX to IJ does");
  }
  const Vector3 lower_m = (thorax.px_m + thorax.t8_m) / 2.0;
  if (auto flaw = FlawOfPlane({"IJ", thorax.ij_m}, {"C7", thorax.c7_m},
                              {"the middle of PX and T8", lower_m})) {
    return LandmarkFlaw{"T8", flaw->message};
  }
  const Vector3 forward =
      ThoraxFrame(thorax.ij_m, thorax.px_m, thorax.c7_m, thorax.t8_m) * Vector3(1, 0, 0);
  if (glm::dot(thorax.px_m - thorax.t8_m, forward) <= 0) {
    return Swapped("T8", "PX", "PX lies behind T8");
  }
  return std::nullopt;
}

std::optional<LandmarkFlaw> FlawOfScapula(const ScapulaPoints& scapula) {
  if (auto flaw = FlawOfPlane({"PAC", scapula.pac_m}, {"TS", scapula.ts_m}, {"AI", scapula.ai_m})) {
    return flaw;
  }
  if (glm::distance(scapula.pac_m, scapula.ai_m) < glm::distance(scapula.pac_m, scapula.ts_m)) {
    return Swapped("AI", "TS", "AI lies nearer to PAC than TS does");
  }
  return std::nullopt;
}

}  // namespace

Quaternion ThoraxFrame(const Vector3& ij, const Vector3& px, const Vector3& c7,
                       const Vector3& t8) noexcept {
  const Vector3 y = glm::normalize((ij + c7) / 2.0 - (px + t8) / 2.0);
  const Vector3 z = glm::normalize(glm::cross(ij - c7, y));
  return glm::quat_cast(Matrix3(glm::cross(y, z), y, z));
}

Quaternion ClavicleFrame(const Vector3& sc, const Vector3& pac, const Vector3& thorax_y) noexcept {
  const Vector3 z = ClavicleAxis(sc, pac);
  const Vector3 x = glm::normalize(glm::cross(thorax_y, z));
  return glm::quat_cast(Matrix3(x, glm::cross(z, x), z));
}

Quaternion ScapulaFrame(const Vector3& pac, const Vector3& ts, const Vector3& ai) noexcept {
  const Vector3 z = glm::normalize(pac - ts);
  const Vector3 x = glm::normalize(glm::cross(pac - ai, z));
  return glm::quat_cast(Matrix3(x, glm::cross(z, x), z));
}

Quaternion HumerusFrame(const Vector3& gh, const Vector3& em, const Vector3& el) noexcept {
  const Vector3 y = glm::normalize(gh - (em + el) / 2.0);
  const Vector3 x = glm::normalize(glm::cross(y, el - em));
  return glm::quat_cast(Matrix3(x, y, glm::cross(x, y)));
}

Vector3 ClavicleAxis(const Vector3& sc, const Vector3& pac) noexcept {
  return glm::normalize(pac - sc);
}

double DistanceFromLine(const Vector3& point, const Vector3& a, const Vector3& b) noexcept {
  const double length = glm::distance(a, b);
  return length == 0 ? glm::distance(point, a) : glm::length(glm::cross(point - a, b - a)) / length;
}

std::optional<LandmarkFlaw> FlawOfRightShoulder(const ThoraxPoints& thorax,
                                                const ScapulaPoints& scapula,
                                                const HumerusPoints& humerus) {
  if (auto flaw = FlawOfThorax(thorax)) {
    return flaw;
  }
  if (auto flaw = FlawOfScapula(scapula)) {
    return flaw;
  }
  if (auto flaw = FlawOfPlane({"GH", humerus.gh_m}, {"EM", humerus.em_m}, {"EL", humerus.el_m})) {
    return flaw;
  }
  // The sides are checked: SC is to the right of the median plane, the coracoid process is in front
  // of the blade, and the acromion's angle is behind it.
  const Vector3 right =
      ThoraxFrame(thorax.ij_m, thorax.px_m, thorax.c7_m, thorax.t8_m) * Vector3(0, 0, 1);
  const Vector3 forward =
      ScapulaFrame(scapula.pac_m, scapula.ts_m, scapula.ai_m) * Vector3(1, 0, 0);
  const bool is_left_thorax = glm::dot(thorax.sc_m - thorax.ij_m, right) <= 0;
  const bool is_left_scapula = glm::dot(scapula.pc_m - scapula.aa_m, forward) <= 0;
  if (is_left_thorax && is_left_scapula) {
    return LandmarkFlaw{"SC",
                        "these are landmarks of a left shoulder. Make it a right one: negate z_m "
                        "in every row",
                        true};
  }
  if (is_left_thorax) {
    return LandmarkFlaw{"SC",
                        "SC lies to the left of IJ and C7, but the scapula is a right one. Give "
                        "the right SC, swap the names of PX and C7 if they have each other's "
                        "place, or negate z_m in the thorax's rows if they are mirrored"};
  }
  if (is_left_scapula) {
    return LandmarkFlaw{"PC",
                        "PC lies behind AA, as in a left scapula. Swap their names if they have "
                        "each other's place, or negate z_m in the scapula's rows if it is "
                        "mirrored"};
  }
  return std::nullopt;
}

bool IsHumerusTurnedAround(const Quaternion& q_TH) noexcept {
  const Vector3 y_H = q_TH * Vector3(0, 1, 0);
  if (y_H.y < std::cos(kNearlyUp_rad)) {
    return false;
  }
  // q = swing twist. The twist is about y; a swing by the shortest way has none.
  const double twist_rad = 2 * std::atan2(q_TH.y, q_TH.w);
  return std::abs(std::remainder(twist_rad, 2 * kPi)) > kFarthestTurn_rad;
}

}  // namespace girdle
