// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/person_body.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "anatomy/person_landmarks.h"
#include "kinematics/lengths.h"
#include "skin/mesh_file.h"
#include "skin/surface_depth.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/text_file.h"

namespace girdle {
namespace {

std::string OutsideText(double depth_m) {
  return RoundedText(-depth_m * kMillimetersPerMeter, 0) + " mm outside the skin of ";
}

// Throws if bones are outside the body.
void CheckLandmarks(const PosedBody& body, const std::vector<Side>& sides,
                    const std::string& mesh_file, const std::string& landmark_file) {
  const SurfaceDepth skin(body.surface);
  for (const Side side : sides) {
    std::string outside;
    double shallowest_m = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const double depth_m =
          skin.Depth_m(OnSideInThorax_m(body.anatomy, body.pose, side, static_cast<Landmark>(i)));
      if (depth_m >= -kOutsideSkin_m) continue;
      ++count;
      shallowest_m = std::min(shallowest_m, depth_m);
      outside += (outside.empty() ? "" : ", ") + std::string(kLandmarks[i].name);
    }
    if (count == 0) continue;
    const bool is_mirrored = side == Side::kLeft;
    const std::string where = ": up to " + OutsideText(shallowest_m) + mesh_file + ". ";
    if (count == kLandmarkCount) {
      throw InputError(landmark_file + ": all landmarks" + where +
                       "The mesh lies elsewhere. Give landmarks in the mesh's own coordinates, in "
                       "meters, and look which of its axes points up");
    }
    throw InputError(
        landmark_file + ": " + outside + (is_mirrored ? " of the left side" : "") + where +
        (is_mirrored ? "The left shoulder is taken for the mirror image of the right one, in "
                       "the same posture. Use --side right, or a mesh that is alike on both sides"
                     : "Correct the landmarks, or give the mesh of the person in the posture in "
                       "which they were taken"));
  }
}

}  // namespace

PosedBody ReadPersonBody(const std::string& mesh_file, const std::string& landmark_file,
                         const Anatomy& adult, const std::vector<Side>& sides) {
  std::ifstream in = OpenTextFile(landmark_file);
  const DigitizedPerson person = ReadDigitizedPerson(in, landmark_file, adult, mesh_file);
  PosedBody body{ReadMeshFile(mesh_file), person.anatomy, person.pose};
  if (const std::optional<std::string> flaw = FlawOfSkin(body.surface)) {
    throw InputError(mesh_file + ": " + *flaw);
  }
  for (Vector3& vertex : body.surface.vertices_m) {
    vertex = glm::conjugate(person.q_AT) * (vertex - person.p_AT_m);
  }
  CheckLandmarks(body, sides, mesh_file, landmark_file);
  return body;
}

}  // namespace girdle
