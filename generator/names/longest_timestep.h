// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The longest time steps with which a shoulder moves as it should, and what is said of longer
/// ones.
#pragma once

#include <algorithm>
#include <string>

#include "kinematics/assembly.h"
#include "text/number_text.h"

namespace girdle {

/// How MuJoCo integrates the joints' damping.
enum class DampingScheme {
  kImplicit,       ///< `implicit`, `implicitfast`, and `Euler` as it is by default
  kRungeKutta,     ///< `RK4`
  kExplicitEuler,  ///< `Euler` with <flag eulerdamp="disable"/>
};

/// Returns the longest step [s], a whole number of milliseconds and at most 10, with which an arm
/// that goes once a second from hanging to elevation 150 and back, or swings past hanging, keeps a
/// loop's joint closed within 1 mm, or a tree's largest joint error within a twentieth of that at 1
/// ms, and comes to rest after a command that jumps. Measured with the models that girdle generate
/// emits (scripts/longest_steps), whichever bone leads.
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

/// Returns what is wrong with a step and the line to write, or nothing.
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
