// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Pictures of the bones of a right shoulder, drawn through the landmarks of an anatomy.
///
/// They are for the eye: no collision, no mass. The shapes hang on the landmarks, so that they
/// follow another person's anatomy; what lies between is drawn after textbook figures and grows
/// with the bone. The same anatomy always gives the same mesh.
///
/// All vertices are metres in the frame of the bone's own segment (ISB; x anterior, y up, z right).
/// Each is a closed surface, or several that may reach into each other: every edge of a piece is
/// shared by exactly two triangles.
#pragma once

#include "anatomy/anatomy.h"
#include "anatomy/triangle_mesh.h"

namespace girdle {

/// Returns the scapula in the scapula frame (origin PAC, z from TS to PAC): the blade through TS
/// and AI, the spine from TS over AA and the acromion to the AC joint, the coracoid process to PC,
/// and the glenoid, which opens from GC towards GH.
[[nodiscard]] TriangleMesh ScapulaMesh(const Anatomy& anatomy);

/// Returns the rib cage in the thorax frame (origin IJ): ten pairs of ribs on the `ribcage`
/// ellipsoid, the sternum from IJ to PX, and the spine, whose spinous processes end on the line
/// through C7 and T8. It is symmetric: landmarks are taken into the median plane, because both
/// shoulders hang on the same trunk.
[[nodiscard]] TriangleMesh RibcageMesh(const Anatomy& anatomy);

/// Returns the clavicle in the clavicle frame (origin SC, z from SC to PAC): an S that is convex
/// forward next to the sternum and flat towards the acromion.
[[nodiscard]] TriangleMesh ClavicleMesh(const Anatomy& anatomy);

/// Returns the humerus in the humerus frame (origin GH, y from the elbow's midpoint to GH): the
/// head about GH, which fits the glenoid at GC, both tubercles, the shaft, the epicondyles at EM
/// and EL, and the joint surface between them.
[[nodiscard]] TriangleMesh HumerusMesh(const Anatomy& anatomy);

}  // namespace girdle
