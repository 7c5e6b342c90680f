// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How stiffly the nine joint coordinates follow their targets.
#pragma once

#include <array>

#include "kinematics/shoulder_pose.h"

namespace girdle {

/// Servo and passive properties of the three hinges of one joint.
struct JointDynamics {
  double stiffness_N_m_per_rad;  ///< of the servo: torque per radian of tracking error
  double damping_N_m_s_per_rad;  ///< of the hinge, integrated implicitly by MuJoCo
  double armature_kg_m2;         ///< keeps light bones well conditioned
};

/// SC, AC (or ST, which carries the same), GH. The damping is near critical for what hangs on the
/// joint (about 0.2, 0.1, 0.06 kg m^2 with the arm raised: c = 2 sqrt(k I)), so that targets are
/// reached without overshoot and the lag is damping / stiffness, 20 ms.
inline constexpr std::array<JointDynamics, kJointCount> kJointDynamics = {{
    {1500, 30, 0.02},
    {1000, 20, 0.02},
    {500, 10, 0.01},
}};

/// Of the plugin's servos in a model that does not say how stiff they are: as of GH.
inline constexpr double kDefaultStiffness_N_m_per_rad = kJointDynamics[2].stiffness_N_m_per_rad;

/// In an assembly loop, of the hinges of a bone that follows instead of leading: only what keeps it
/// from ringing.
inline constexpr double kFollowerDamping_N_m_s_per_rad = 0.5;

/// Servo and passive properties of the three slides of the scapula in the thorax.
struct TranslationDynamics {
  double stiffness_N_per_m;
  double damping_N_s_per_m;
  double armature_kg;
};

/// Where the scapula leads: near critical for scapula and arm (3 kg), with the same lag of 20 ms.
inline constexpr TranslationDynamics kLeadingTranslation = {10000, 200, 0.05};
/// Where it follows the clavicle: the connect holds it, and the damping keeps what the connect
/// pushes there and back at long time steps from ringing: at 5 ms the joint opens by centimeters
/// with 300 N s/m. SC lags by the drag, with 1000 by so much that it stretches a ligament.
inline constexpr TranslationDynamics kFollowingTranslation = {0, 700, 0.05};

/// How the connect of an assembly loop holds the AC joint. A constraint of time constant t and
/// damping ratio r gives way by a (t r)^2 to what it does not foresee, the acceleration a with
/// which the arm swings about SC (16 m/s^2 where it goes from 0 to 150 deg and back at 1 Hz): 0.03
/// mm with the shortest t there is at 2 ms, two steps. With r = 0.3 it rings at 5 ms where the
/// scapula leads. How hard it is (solimp) does not show.
inline constexpr std::array<double, 2> kConnectSolref = {0.004, 0.36};
inline constexpr std::array<double, 3> kConnectSolimp = {0.99, 0.99, 0.001};

/// How hard the thorax pushes TS and AI out of the gliding ellipsoid: F = k p at a depth p, with k
/// as in other shoulder models.
inline constexpr double kThoraxContactStiffness_N_per_m = 20'000;
/// With an impedance d, one number in solimp, MuJoCo's direct solref (-s, -b) gives F = s p / ((1 -
/// d) w) at rest, w [1/kg] the scapula's inverse weight (body_invweight0), so that s = (1 - d) k w.
/// With other bones, and with other armature beside them, k goes with 1 / w. b = 2 sqrt(s d) is
/// critical.
inline constexpr double kThoraxContactImpedance = 0.5;
inline constexpr std::array<double, 3> kThoraxContactSolimp = {kThoraxContactImpedance,
                                                               kThoraxContactImpedance, 0.001};
/// Inverse weights [1/kg] of the built-in scapula, where it hangs from the clavicle and where it
/// hangs from the thorax.
inline constexpr double kTreeInverseWeight_per_kg = 0.265;
inline constexpr double kLoopInverseWeight_per_kg = 0.603;
/// (-s, -b) for the inverse weight of a scapula, with b given.
[[nodiscard]] constexpr std::array<double, 2> ThoraxContactSolref(double inverse_weight_per_kg,
                                                                  double damping_per_s) noexcept {
  return {-(1 - kThoraxContactImpedance) * kThoraxContactStiffness_N_per_m * inverse_weight_per_kg,
          -damping_per_s};
}
/// Of the built-in scapula.
inline constexpr std::array<double, 2> kTreeThoraxContactSolref =
    ThoraxContactSolref(kTreeInverseWeight_per_kg, 73);
inline constexpr std::array<double, 2> kLoopThoraxContactSolref =
    ThoraxContactSolref(kLoopInverseWeight_per_kg, 110);

}  // namespace girdle
