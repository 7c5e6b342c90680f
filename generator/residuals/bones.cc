// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Bones: compares the model's bones with those of the anatomy.
//
//     landmark   |R_WB^T (p_W - p_WB) - p_B|,  p_B the anatomy's point on bone B
//     mass, centre of mass, moments of inertia   those of MuJoCo's bodies minus the anatomy's,
//     the moments as |R diag(I) R^T - diag(I_anatomy)|, R the body's principal axes
//
// A bone is rigid, so one pose is enough: that of the table's first position.

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "anatomy/posed_bones.h"
#include "kinematics/lengths.h"
#include "names/side.h"
#include "residuals/extreme.h"
#include "residuals/residual_groups.h"
#include "residuals/shown_angles.h"

namespace girdle {
namespace {

// A millionth of a gram, and a millionth of a gram times a square meter. The model holds 17 digits.
constexpr double kExact_kg = 1e-9;
constexpr double kExact_kg_m2 = 1e-9;

// In the anatomy, the principal axes are the bone's own, so that a bone and its mirror image have
// equal tensors.
double InertiaOff_kg_m2(const mjModel& model, int body, const Vector3& wanted_kg_m2) {
  const mjtNum* const q = model.body_iquat + 4 * body;
  const glm::dmat3 axes = glm::mat3_cast(Quaternion{q[0], q[1], q[2], q[3]});
  const mjtNum* const moments_kg_m2 = model.body_inertia + 3 * body;
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double element_kg_m2 = i == j ? -wanted_kg_m2[i] : 0;
      for (int k = 0; k < 3; ++k) {
        element_kg_m2 += axes[k][i] * moments_kg_m2[k] * axes[k][j];
      }
      squared += element_kg_m2 * element_kg_m2;
    }
  }
  return std::sqrt(squared);
}

class BonesGroup : public ResidualGroup {
 public:
  explicit BonesGroup(const MeasuredShoulder& shoulder) : shoulder_(shoulder) {}

  void TakePose(const ShownPose& pose) override {
    if (pose.position == nullptr || !landmarks_mm_.empty()) {
      return;
    }
    AddLandmarks(pose.state);
    AddInertias(pose.command);
  }

  void AddLines(std::vector<Residual>& lines) override {
    lines.push_back(landmarks_mm_.Worst(kBonesGroup, "landmarks", "mm", kExact_mm));
    lines.push_back(masses_kg_.Worst(kBonesGroup, "masses", "kg", kExact_kg));
    lines.push_back(centers_mm_.Worst(kBonesGroup, "centres of mass", "mm", kExact_mm));
    lines.push_back(
        inertias_kg_m2_.Worst(kBonesGroup, "moments of inertia", "kg m^2", kExact_kg_m2));
  }

 private:
  // In a model with both shoulders, the thorax is symmetric.
  [[nodiscard]] Vector3 OnThorax(const Vector3& point_m) const {
    return shoulder_.simulation.shoulders().size() > 1 ? InMedianPlane(point_m) : point_m;
  }

  void AddLandmarks(const ShoulderState& state) {
    const std::array<Vector3, kSegmentCount> origins_m = {
        state.landmark_m(Landmark::kIJ), state.child_site_m(0), state.child_site_m(1),
        state.child_site_m(2)};
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const auto segment = static_cast<std::size_t>(kLandmarks[i].segment);
      const Vector3 on_bone_m =
          glm::conjugate(state.q_WB[segment]) * (state.site_m[i] - origins_m[segment]);
      const Vector3& own_m = shoulder_.anatomy.landmarks_m[i];
      landmarks_mm_.Add(kMillimetersPerMeter *
                            glm::distance(on_bone_m, kLandmarks[i].sided ? own_m : OnThorax(own_m)),
                        kLandmarks[i].name, state.command);
    }
  }

  void AddInertias(const ArmCommand& command) {
    const mjModel& model = shoulder_.simulation.model();
    const ShoulderElements& elements = shoulder_.simulation.elements();
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const int body = elements.bodies[i];
      const SegmentInertia& inertia = shoulder_.anatomy.segments[i];
      const std::string_view name = kSegmentNames[i];
      masses_kg_.Add(model.body_mass[body] - inertia.mass_kg, name, command);
      const mjtNum* const p_m = model.body_ipos + 3 * body;
      const Vector3 center_m{p_m[0], p_m[1], p_m[2]};
      const bool is_thorax = i == static_cast<std::size_t>(Segment::kThorax);
      centers_mm_.Add(
          kMillimetersPerMeter * glm::distance(OnSide(elements.side, center_m),
                                               is_thorax ? OnThorax(inertia.center_of_mass_m)
                                                         : inertia.center_of_mass_m),
          name, command);
      inertias_kg_m2_.Add(InertiaOff_kg_m2(model, body, inertia.inertia_kg_m2), name, command);
    }
  }

  MeasuredShoulder shoulder_;
  Extreme landmarks_mm_;
  Extreme masses_kg_;
  Extreme centers_mm_;
  Extreme inertias_kg_m2_;
};

}  // namespace

ResidualGroupPointer MakeBonesGroup(const MeasuredShoulder& shoulder) {
  return std::make_unique<BonesGroup>(shoulder);
}

}  // namespace girdle
