// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A whole anatomy as one line of text, as models carry it.
#pragma once

#include <string>

#include "anatomy/anatomy.h"

namespace girdle {

/// Returns every number of an anatomy [m, kg, kg m^2, rad, N/m], so that they read back exactly.
///
/// The line is a list of rows with a semicolon and a blank between: `IJ 0 0 0; PX 0 -0.16 0; ...`.
/// A row is a name and its numbers. Landmarks come first, then segments (mass, centre of mass,
/// moments of inertia), ranges (lower, upper), ellipsoids (centre, radii), ligaments, and the body.
/// `gh_origin` is not written.
[[nodiscard]] std::string AnatomyAsLine(const Anatomy& anatomy);

/// Returns the anatomy of a line. Throws InputError that names `place` if the line is not one that
/// AnatomyAsLine returns: another row than expected, another count of numbers, a number that is not
/// finite, a length or a place more than 10 m away, or a mass, moment of inertia, radius, slack
/// length, stiffness or height that is not positive.
[[nodiscard]] Anatomy AnatomyFromLine(const std::string& line, const std::string& place);

/// Returns whether two anatomies have equal numbers, but for the rounding of the machines that
/// computed them: 1e-9 of a number or, of small ones, 1e-9.
[[nodiscard]] bool IsSame(const Anatomy& a, const Anatomy& b);

}  // namespace girdle
