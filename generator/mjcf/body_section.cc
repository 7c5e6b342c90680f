// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <string_view>

#include "names/joint_dynamics.h"

namespace girdle {
namespace {

// Points touch the gliding ellipsoid, but a geom must have a radius.
constexpr double kContactRadius_m = 1e-4;

// The thorax frame's axes in the world: x to x, y to z, z to -y.
Quaternion ThoraxInWorld() { return QuaternionFromEuler(EulerSequence::kYXZ, {0, kPi / 2, 0}); }

// Returns the axes of a joint's three hinges in the child's frame at the hinges' reference angles.
// With q = R1(a) R2(b) R3(c), a turn of hinge 1 by d gives R1(a + d) R2(b) R3(c) = q Rot(q^-1 e1,
// d), and so on.
std::array<Vector3, 3> HingeAxes(EulerSequence sequence, const Vector3& reference_rad) {
  const Vector3 x{1, 0, 0};
  const Vector3 y{0, 1, 0};
  const Vector3 z{0, 0, 1};
  const bool tilts_last = sequence == EulerSequence::kYXZ;
  const Vector3 e1 = tilts_last ? y : x;
  const Vector3 e2 = tilts_last ? x : z;
  const Vector3 e3 = tilts_last ? z : y;
  const Quaternion whole = QuaternionFromEuler(sequence, reference_rad);
  const Quaternion last = QuaternionFromEuler(sequence, {0, 0, reference_rad.z});
  return {glm::conjugate(whole) * e1, glm::conjugate(last) * e2, e3};
}

void WriteInertial(const ModelPlan& plan, XmlElement& body, Segment segment, Side side) {
  const SegmentInertia& inertia = plan.anatomy.segment(segment);
  Vector3 center_m = OnSide(side, inertia.center_of_mass_m);
  if (segment == Segment::kThorax && plan.sides.size() > 1) {
    center_m.z = 0;
  }
  body.Add("inertial")
      .Set("pos", center_m)
      .Set("mass", inertia.mass_kg)
      .Set("diaginertia", inertia.inertia_kg_m2);
}

void WriteUnsidedLandmarks(const ModelPlan& plan, XmlElement& thorax) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    if (!kLandmarks[i].sided) {
      thorax.Add("site")
          .Set("name", kLandmarks[i].name)
          .Set("pos", plan.sides.size() > 1
                          ? InMedianPlane(plan.anatomy.landmarks_m[i])
                          : OnSide(plan.sides.front(), plan.anatomy.landmarks_m[i]));
    }
  }
}

void WriteLandmarks(const ModelPlan& plan, XmlElement& body, Segment segment, Side side) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    if (kLandmarks[i].segment == segment && kLandmarks[i].sided) {
      body.Add("site")
          .Set("name", SidedName(kLandmarks[i].name, side))
          .Set("pos", OnSide(side, plan.anatomy.landmarks_m[i]));
    }
  }
}

void WriteLigamentEnds(const ModelPlan& plan, XmlElement& body, Segment segment, Side side) {
  const std::string_view bone = Name(segment);
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    const Ligament& ligament = plan.anatomy.ligaments[i];
    if (segment == Segment::kClavicle || segment == Segment::kScapula) {
      body.Add("site")
          .Set("name", SidedName(LigamentEndName(kLigamentNames[i], bone), side))
          .Set("pos", OnSide(side, segment == Segment::kClavicle ? ligament.clavicle_m
                                                                 : ligament.scapula_m));
    }
  }
}

// Writes the slides along the thorax's axes, which q_ST expresses in the body's own frame.
void WriteSlides(const ModelPlan& plan, XmlElement& body, const Vector3& p_m,
                 const Quaternion& q_ST, Side side) {
  const TranslationDynamics& dynamics =
      plan.drives_place() ? kLeadingTranslation : kFollowingTranslation;
  for (int i = 0; i < 3; ++i) {
    Vector3 axis{0, 0, 0};
    axis[i] = 1;
    body.Add("joint")
        .Set("name", SidedName(kTranslationNames[static_cast<std::size_t>(i)], side))
        .Set("type", "slide")
        .Set("axis", OnSide(side, q_ST * axis))
        .Set("ref", p_m[i])
        .Set("damping", dynamics.damping_N_s_per_m)
        .Set("armature", dynamics.armature_kg);
  }
}

// Writes the three hinges of a joint, with the reference angles `reference_rad`.
void WriteHinges(const ModelPlan& plan, XmlElement& body, std::size_t joint,
                 const Vector3& reference_rad, Side side) {
  const std::array<Vector3, 3> axes = HingeAxes(kJointSequences[joint], reference_rad);
  for (std::size_t hinge = 0; hinge < 3; ++hinge) {
    const std::size_t k = 3 * joint + hinge;
    const CoordinateRange& range = plan.RangeOf(k);
    body.Add("joint")
        .Set("name", SidedName(plan.coordinates[k], side))
        .Set("axis", AxisOnSide(side, axes[hinge]))
        .Set("ref", plan.rest_rad[k])
        .Set("range", std::array{range.lower_rad, range.upper_rad})
        .Set("damping", plan.StiffnessOf(k) > 0 ? kJointDynamics[joint].damping_N_m_s_per_rad
                                                : kFollowerDamping_N_m_s_per_rad)
        .Set("armature", kJointDynamics[joint].armature_kg_m2);
  }
}

void WriteGlidingPoints(const ModelPlan& plan, XmlElement& scapula, Side side) {
  for (const Landmark landmark : kGlidingLandmarks) {
    scapula.Add("geom")
        .Set("name", SidedName(DefinitionOf(landmark).name, side))
        .Set("type", "sphere")
        .Set("size", kContactRadius_m)
        .Set("pos", OnSide(side, plan.anatomy.landmark_m(landmark)))
        .Set("group", 4);
  }
}

// Writes a moving bone at `p_m` of its parent, with the three hinges of `joint`. A scapula that
// hangs from the thorax has three slides as well.
XmlElement WriteBone(const ModelPlan& plan, XmlElement& parent, Segment segment, std::size_t joint,
                     const Vector3& p_m, Side side) {
  const std::string name = SidedName(Name(segment), side);
  const Vector3 reference_rad{plan.rest_rad[3 * joint], plan.rest_rad[3 * joint + 1],
                              plan.rest_rad[3 * joint + 2]};
  const Quaternion reference = QuaternionFromEuler(kJointSequences[joint], reference_rad);
  XmlElement body = parent.Add("body")
                        .Set("name", name)
                        .Set("pos", OnSide(side, p_m))
                        .Set("quat", OnSide(side, reference))
                        .Set("gravcomp", 1);
  WriteInertial(plan, body, segment, side);
  if (segment == Segment::kScapula && plan.is_loop()) {
    WriteSlides(plan, body, p_m, glm::conjugate(reference), side);
  }
  WriteHinges(plan, body, joint, reference_rad, side);
  body.Add("geom").Set("name", name).Set("type", "mesh").Set("mesh", name);
  body.Add("site").Set("name", SidedName(kJointSites[joint].child, side));
  WriteLandmarks(plan, body, segment, side);
  WriteLigamentEnds(plan, body, segment, side);
  if (segment == Segment::kScapula && plan.options.has_thorax_contact) {
    WriteGlidingPoints(plan, body, side);
  }
  return body;
}

}  // namespace

void WriteBodies(const ModelPlan& plan, XmlElement root) {
  XmlElement thorax = root.Add("worldbody")
                          .Add("body")
                          .Set("name", "thorax")
                          .Set("pos", Vector3{0, 0, plan.anatomy.jugular_notch_height_m})
                          .Set("quat", ThoraxInWorld())
                          .Set("childclass", kDefaultsName);
  WriteInertial(plan, thorax, Segment::kThorax, plan.sides.front());
  thorax.Add("geom")
      .Set("name", "ribcage")
      .Set("type", "mesh")
      .Set("mesh", "ribcage")
      .Set("material", "rib");
  WriteUnsidedLandmarks(plan, thorax);
  for (const Side side : plan.sides) {
    WriteLandmarks(plan, thorax, Segment::kThorax, side);
    if (plan.options.has_thorax_contact) {
      thorax.Add("geom")
          .Set("name", SidedName(kGlidingName, side))
          .Set("type", "ellipsoid")
          .Set("size", plan.anatomy.gliding.radii_m)
          .Set("pos", OnSide(side, plan.anatomy.gliding.center_m))
          .Set("group", 4);
    }
  }
  for (const Side side : plan.sides) {
    XmlElement clavicle = WriteBone(plan, thorax, Segment::kClavicle, 0,
                                    plan.anatomy.landmark_m(Landmark::kSC), side);
    XmlElement scapula = plan.is_loop() ? WriteBone(plan, thorax, Segment::kScapula, 1,
                                                    plan.PlaceOfScapula(plan.rest), side)
                                        : WriteBone(plan, clavicle, Segment::kScapula, 1,
                                                    plan.anatomy.landmark_m(Landmark::kPAC), side);
    WriteBone(plan, scapula, Segment::kHumerus, 2, plan.anatomy.landmark_m(Landmark::kGH), side);
  }
}

}  // namespace girdle
