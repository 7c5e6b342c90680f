// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Meshes of the bones of a right shoulder, drawn through the landmarks of an anatomy.
///
/// They are for pictures only and have neither collision nor mass. The shapes follow the landmarks,
/// so they fit another person's anatomy. Between the landmarks they follow textbook figures, scaled
/// with the bone. The same anatomy always gives the same mesh.
///
/// All vertices are metres in the frame of the bone's own segment (ISB; x anterior, y up, z right).
/// A mesh is one closed surface, or several closed surfaces that may intersect. Every edge of such
/// a surface is shared by exactly two triangles.
#pragma once

#include "anatomy/anatomy.h"
#include "anatomy/triangle_mesh.h"

namespace girdle {

/// Returns the scapula in the scapula frame (origin PAC, z from TS to PAC). Its parts are the blade
/// through TS and AI, the spine from TS over AA, the acromion to the AC joint, the coracoid process
/// to PC, and the glenoid, which opens from GC towards GH.
[[nodiscard]] TriangleMesh ScapulaMesh(const Anatomy& anatomy);

/// Returns the rib cage in the thorax frame (origin IJ). Its parts are ten pairs of ribs on the
/// `ribcage` ellipsoid, the sternum from IJ to PX, and the spine, whose spinous processes end on
/// the line through C7 and T8. It is symmetric: landmarks are moved into the median plane, because
/// both shoulders belong to the same trunk.
[[nodiscard]] TriangleMesh RibcageMesh(const Anatomy& anatomy);

/// Returns the clavicle in the clavicle frame (origin SC, z from SC to PAC). It is an S, convex
/// forward near the sternum and flat near the acromion.
[[nodiscard]] TriangleMesh ClavicleMesh(const Anatomy& anatomy);

/// Returns the humerus in the humerus frame (origin GH, y from the elbow's midpoint to GH). Its
/// parts are the head about GH, which fits the glenoid at GC, both tubercles, the shaft, the
/// epicondyles at EM and EL, and the joint surface between these.
[[nodiscard]] TriangleMesh HumerusMesh(const Anatomy& anatomy);

}  // namespace girdle
