// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/published_rhythms.h"

#include <glm/gtc/quaternion.hpp>
#include <string>

#include "text/input_error.h"

namespace girdle {
namespace {

using CompleteAngles = std::array<LinearAngle, kGirdleAngleCount>;

const GirdleAngles& AnglesOf(const RhythmCoefficients& coefficients, std::string_view rhythm) {
  const auto found = coefficients.find(rhythm);
  if (found == coefficients.end()) {
    throw InputError("published rhythms: no rows for '" + std::string(rhythm) + "'");
  }
  return found->second;
}

// Returns all angles: those of the rhythm, and the others from the relaxed posture.
CompleteAngles OverRelaxed(const RhythmCoefficients& coefficients, const GirdleAngles& angles) {
  const GirdleAngles& relaxed = AnglesOf(coefficients, "relaxed");
  CompleteAngles complete;
  for (std::size_t k = 0; k < kGirdleAngleCount; ++k) {
    const std::optional<LinearAngle>& angle = angles[k] ? angles[k] : relaxed[k];
    if (!angle) {
      throw InputError("published rhythms: no row for " + std::string(kGirdleAngleNames[k]) +
                       " of relaxed");
    }
    complete[k] = *angle;
  }
  return complete;
}

DefinedAngles DefinedOf(const GirdleAngles& angles) {
  DefinedAngles defined;
  for (std::size_t k = 0; k < kGirdleAngleCount; ++k) {
    defined.angles[k] = angles[k].has_value();
  }
  return defined;
}

// Returns clavicle and scapula from six numbers, one for each angle.
template <typename AngleOf>
GirdlePose PoseOf(const CompleteAngles& angles, const AngleOf& angle_of) {
  const auto rotation = [&](std::size_t first) {
    return QuaternionFromEuler(
        EulerSequence::kYXZ,
        {angle_of(angles[first]), angle_of(angles[first + 1]), angle_of(angles[first + 2])});
  };
  return {rotation(0), rotation(3)};
}

// Returns a rhythm whose formulas give the Y-X'-Z'' angles themselves.
PublishedRhythm RhythmOfAngles(const RhythmCoefficients& coefficients, std::string_view rows) {
  const GirdleAngles& angles = AnglesOf(coefficients, rows);
  PublishedRhythm rhythm;
  rhythm.defined = DefinedOf(angles);
  rhythm.girdle = [complete = OverRelaxed(coefficients, angles)](double elevation_rad,
                                                                 double plane_rad) {
    return PoseOf(complete,
                  [=](const LinearAngle& angle) { return angle.Angle(elevation_rad, plane_rad); });
  };
  return rhythm;
}

// Returns a rhythm whose hinges turn about the axes of the resting bone B, first y, then x, then z:
// q_TB = q_TB(rest) q(change).
PublishedRhythm RhythmOfTurns(const RhythmCoefficients& coefficients, std::string_view rows) {
  const GirdleAngles& angles = AnglesOf(coefficients, rows);
  PublishedRhythm rhythm;
  rhythm.defined = DefinedOf(angles);
  const CompleteAngles complete = OverRelaxed(coefficients, angles);
  const GirdlePose rest = PoseOf(complete, [](const LinearAngle& angle) { return angle.rest_rad; });
  rhythm.girdle = [complete, rest](double elevation_rad, double plane_rad) -> GirdlePose {
    const GirdlePose turn = PoseOf(
        complete, [=](const LinearAngle& angle) { return angle.Change(elevation_rad, plane_rad); });
    return {rest.q_TC * turn.q_TC, rest.q_TS * turn.q_TS};
  };
  return rhythm;
}

PublishedRhythm Inman(const RhythmCoefficients& coefficients) {
  PublishedRhythm rhythm = RhythmOfAngles(coefficients, "inman");
  rhythm.name = "Inman";
  rhythm.source = "Inman, Saunders, Abbott, J Bone Joint Surg 1944;26:1-30";
  rhythm.says = "upward rotation alone, a third of the elevation from the relaxed posture";
  return rhythm;
}

PublishedRhythm Braman(const RhythmCoefficients& coefficients) {
  PublishedRhythm rhythm = RhythmOfAngles(coefficients, "braman");
  rhythm.name = "Braman";
  rhythm.source = "Braman et al., J Shoulder Elbow Surg 2009;18:960-967";
  rhythm.says = "upward rotation alone, 0.301 of the elevation from the relaxed posture";
  return rhythm;
}

PublishedRhythm DeGrootAndBrand(const RhythmCoefficients& coefficients) {
  PublishedRhythm rhythm = RhythmOfAngles(coefficients, "de_groot_brand");
  rhythm.name = "de Groot and Brand";
  rhythm.source = "de Groot, Brand, Clin Biomech 2001;16:735-743";
  rhythm.says = "all but the clavicle's axial rotation, so neither SC nor AC as a rotation";
  return rhythm;
}

PublishedRhythm MoblArms(const RhythmCoefficients& coefficients) {
  PublishedRhythm rhythm = RhythmOfTurns(coefficients, "mobl_arms");
  rhythm.name = "MoBL-ARMS";
  rhythm.source = "Saul et al., Comput Methods Biomech Biomed Engin 2015;18:1445-1458";
  rhythm.says = "a whole girdle, the same in every plane; the clavicle has no axial rotation";
  return rhythm;
}

PublishedRhythm FrozenGirdle(const RhythmCoefficients& coefficients) {
  PublishedRhythm rhythm = RhythmOfAngles(coefficients, "relaxed");
  rhythm.name = "frozen girdle";
  rhythm.source =
      "relaxed standing posture of Ludewig et al., J Bone Joint Surg Am 2009;91:378-389";
  rhythm.says = "a whole girdle that stays at the relaxed standing posture";
  return rhythm;
}

constexpr std::array<PublishedRhythm (*)(const RhythmCoefficients&), 5> kRhythms = {
    Inman, Braman, DeGrootAndBrand, MoblArms, FrozenGirdle};

}  // namespace

std::vector<PublishedRhythm> PublishedRhythms(const RhythmCoefficients& coefficients) {
  std::vector<PublishedRhythm> rhythms;
  rhythms.reserve(kRhythms.size());
  for (const auto& rhythm : kRhythms) {
    rhythms.push_back(rhythm(coefficients));
  }
  return rhythms;
}

ShoulderPose WithHumerus(const GirdlePose& girdle, const Quaternion& q_TH) noexcept {
  return {girdle.q_TC, glm::conjugate(girdle.q_TC) * girdle.q_TS,
          glm::conjugate(girdle.q_TS) * q_TH};
}

}  // namespace girdle
