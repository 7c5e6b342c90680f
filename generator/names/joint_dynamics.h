// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How stiffly and with how much damping the joint coordinates follow their targets.
#pragma once

#include <array>

#include "kinematics/shoulder_pose.h"

namespace girdle {

/// Servo and passive properties of the three hinges of one joint.
struct JointDynamics {
  double stiffness_N_m_per_rad;  ///< of the servo: torque for each radian of tracking error
  double damping_N_m_s_per_rad;  ///< of the hinge; MuJoCo integrates it implicitly
  double armature_kg_m2;  ///< rotor inertia of the hinge; it keeps light bones well conditioned
};

/// Values of SC, AC and GH. ST has those of AC. The damping c is nearly critical for the inertia I
/// that hangs on the joint: c = 2 sqrt(k I), with I about 0.2, 0.1 and 0.06 kg m^2 if the arm is
/// raised. So the joints reach their targets without overshoot, and the lag is damping / stiffness,
/// 20 ms.
inline constexpr std::array<JointDynamics, kJointCount> kJointDynamics = {{
    {1500, 30, 0.02},
    {1000, 20, 0.02},
    {500, 10, 0.01},
}};

/// Stiffness of the plugin's servos if a model does not give it. It is that of GH.
inline constexpr double kDefaultStiffness_N_m_per_rad = kJointDynamics[2].stiffness_N_m_per_rad;

/// Damping of the hinges of a bone that follows in an assembly loop. It only prevents ringing.
inline constexpr double kFollowerDamping_N_m_s_per_rad = 0.5;

/// Servo and passive properties of the three slides of the scapula in the thorax.
struct TranslationDynamics {
  double stiffness_N_per_m;
  double damping_N_s_per_m;
  double armature_kg;
};

/// If the scapula leads: nearly critical for scapula and arm (3 kg), with a lag of 20 ms.
inline constexpr TranslationDynamics kLeadingTranslation = {10000, 200, 0.05};
/// If the scapula follows the clavicle, the connect holds it. At long time steps the connect pushes
/// it back and forth, and the damping prevents ringing: with 300 N s/m the joint opens by
/// centimeters at 5 ms. The damping also makes SC lag. With 1000 N s/m it lags so much that a
/// ligament is stretched.
inline constexpr TranslationDynamics kFollowingTranslation = {0, 700, 0.05};

/// Solref of the connect that holds the AC joint of an assembly loop. A constraint with time
/// constant t and damping ratio r yields by a (t r)^2 to an acceleration a that it does not
/// foresee. Here a is that of the arm swinging about SC: 16 m/s^2 if it goes from 0 to 150 deg and
/// back at 1 Hz. The joint then opens by 0.03 mm with the shortest t possible at 2 ms, which is two
/// steps. With r = 0.3 it rings at 5 ms if the scapula leads. Its hardness (solimp) has no visible
/// effect.
inline constexpr std::array<double, 2> kConnectSolref = {0.004, 0.36};
inline constexpr std::array<double, 3> kConnectSolimp = {0.99, 0.99, 0.001};

/// Stiffness with which the thorax pushes TS and AI out of the gliding ellipsoid: F = k p at a
/// depth p. k is that of other shoulder models.
inline constexpr double kThoraxContactStiffness_N_per_m = 20'000;
/// Impedance d, one number in solimp. MuJoCo's direct solref (-s, -b) then gives F = s p / ((1 - d)
/// w) at rest, where w [1/kg] is the scapula's inverse weight (body_invweight0). So s = (1 - d) k
/// w. With other bones or another armature, k changes as 1 / w. b = 2 sqrt(s d) is critical.
inline constexpr double kThoraxContactImpedance = 0.5;
inline constexpr std::array<double, 3> kThoraxContactSolimp = {kThoraxContactImpedance,
                                                               kThoraxContactImpedance, 0.001};
/// Inverse weights [1/kg] of the built-in scapula: hanging from the clavicle (tree) and from the
/// thorax (loop).
inline constexpr double kTreeInverseWeight_per_kg = 0.265;
inline constexpr double kLoopInverseWeight_per_kg = 0.603;
/// Returns the solref (-s, -b) for the inverse weight of a scapula, with the given b.
[[nodiscard]] constexpr std::array<double, 2> ThoraxContactSolref(double inverse_weight_per_kg,
                                                                  double damping_per_s) noexcept {
  return {-(1 - kThoraxContactImpedance) * kThoraxContactStiffness_N_per_m * inverse_weight_per_kg,
          -damping_per_s};
}
/// Solrefs of the built-in scapula.
inline constexpr std::array<double, 2> kTreeThoraxContactSolref =
    ThoraxContactSolref(kTreeInverseWeight_per_kg, 73);
inline constexpr std::array<double, 2> kLoopThoraxContactSolref =
    ThoraxContactSolref(kLoopInverseWeight_per_kg, 110);

}  // namespace girdle
