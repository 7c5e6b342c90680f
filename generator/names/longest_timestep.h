// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The longest time steps at which a shoulder still moves correctly, and the message for longer
/// ones.
#pragma once

#include <algorithm>
#include <string>

#include "kinematics/assembly.h"
#include "text/number_text.h"

namespace girdle {

/// How MuJoCo integrates the joints' damping.
enum class DampingScheme {
  kImplicit,       ///< `implicit`, `implicitfast`, and `Euler` with its default flags
  kRungeKutta,     ///< `RK4`
  kExplicitEuler,  ///< `Euler` with <flag eulerdamp="disable"/>
};

/// Returns the longest step [s]: a whole number of milliseconds, at most 10. The arm goes once a
/// second from hanging to elevation 150 and back, or swings past hanging. At this step a loop keeps
/// its joint closed within 1 mm, and a tree's largest joint error is within a twentieth of that at
/// 1 ms. After a command that jumps, the arm comes to rest. Measured with the models that girdle
/// generate emits (scripts/longest_steps), for either leading bone.
[[nodiscard]] constexpr double LongestTimestep_s(Assembly assembly, DampingScheme scheme) noexcept {
  const bool is_tree = assembly == Assembly::kTree;
  switch (scheme) {
    case DampingScheme::kImplicit:
      return is_tree ? 0.010 : 0.005;
    case DampingScheme::kRungeKutta:
      return is_tree ? 0.002 : 0.001;
    case DampingScheme::kExplicitEuler:
      break;
  }
  return 0.001;
}

/// Returns the fault of a time step with the line to write, or an empty text if there is none.
[[nodiscard]] inline std::string TimestepFault(double timestep_s, Assembly assembly,
                                               DampingScheme scheme) {
  constexpr double kRounding = 1e-9;
  const double longest_s = LongestTimestep_s(assembly, scheme);
  if (timestep_s <= longest_s * (1 + kRounding)) {
    return "";
  }
  std::string kind(Name(assembly));
  if (scheme != DampingScheme::kImplicit) {
    kind += scheme == DampingScheme::kRungeKutta ? " with RK4" : " with Euler without eulerdamp";
  }
  const double mended_s =
      std::min(timestep_s, LongestTimestep_s(assembly, DampingScheme::kImplicit));
  return "the time step is " + NumberText(timestep_s) + " s, and the longest for a " + kind +
         " is " + NumberText(longest_s) + " s: write <option timestep=\"" + NumberText(mended_s) +
         "\" integrator=\"implicitfast\"/>";
}

}  // namespace girdle
