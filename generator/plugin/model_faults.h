// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Differences between a compiled model and what the servos need, if MuJoCo itself gives no
/// message.
///
/// An <include>, an attachment or a parent's defaults can change a shoulder silently: the time
/// step, the integrator, the unit of the joint ranges, springs and friction of the joints.
#pragma once

#include <string>

#include "kinematics/assembled_rhythm.h"
#include "plugin/engine_views.h"
#include "plugin/rhythm_binding.h"

namespace girdle {

/// Returns the faults with the lines to write, separated by semicolons, or an empty text. These
/// faults are found:
///   ranges      read as degrees;
///   time step   longer than LongestTimestep_s;
///   loop        with a disabled constraint;
///   force       of a servo, limited to a narrow range;
///   damping     disabled, with terms beside the linear one, or with a lag far from that of the
///               emitted models;
///   stiffness, friction loss   of a joint that has a servo;
///   ligaments   between the compiled sites, longer than their slack in some pose of the rhythm.
[[nodiscard]] std::string ModelFaults(const CompiledView& compiled, const RhythmBinding& binding,
                                      const AssembledRhythm& rhythm);

}  // namespace girdle
