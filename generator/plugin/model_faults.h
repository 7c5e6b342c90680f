// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What of a compiled model differs from what the servos need, where MuJoCo itself says nothing.
///
/// An <include>, an attachment or a parent's defaults can change a shoulder without a word: the
/// time step, the integrator, the unit of the joint ranges, springs and friction of the joints.
#pragma once

#include <string>

#include "kinematics/assembled_rhythm.h"
#include "plugin/engine_views.h"
#include "plugin/rhythm_binding.h"

namespace girdle {

/// Returns what is off with the line to write, or nothing; several faults are separated by
/// semicolons.
///   ranges      read as degrees;
///   time step   longer than LongestTimestep_s;
///   loop        whose constraint is disabled;
///   force       of a servo that is kept within a narrow range;
///   damping     disabled, with terms beside the linear one, or with a lag far from that of the
///               emitted models;
///   stiffness, friction loss   of a joint that has a servo;
///   ligaments   of the compiled sites that are longer than their slack where the rhythm goes.
[[nodiscard]] std::string ModelFaults(const CompiledView& compiled, const RhythmBinding& binding,
                                      const AssembledRhythm& rhythm);

}  // namespace girdle
