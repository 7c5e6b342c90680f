// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/pair.h"

#include "kinematics/lane_functions.h"

namespace girdle {

Pair Atan2(Pair y, Pair x) noexcept { return Atan2OfLanes(y, x); }

SineAndCosine<Pair> SineAndCosineOf(Pair x) noexcept { return SineAndCosineOfLanes(x); }

double Decay(double x) noexcept { return DecayOfLanes(Pair(x))[0]; }

}  // namespace girdle
