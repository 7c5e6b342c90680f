// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The right shoulder as MJCF: thorax > clavicle > scapula > humerus, three hinges a joint in the
/// order of the measured Euler angles, so that a joint coordinate is the measured angle.
#pragma once

#include <string>

#include "kinematics/shoulder_rhythm.h"
#include "tables/anatomy.h"

namespace girdle {

/// What moves the joints.
enum class Actuation {
  kPlugin,    ///< three commands (elevation, plane, axial) and nine servos, by the engine plugin
              ///< girdle.rhythm
  kPosition,  ///< nine native position servos with the same gains and no plugin
};

struct ShoulderModelOptions {
  Actuation actuation = Actuation::kPlugin;
  /// Writes the rhythm's table into the plugin's configuration; otherwise the plugin uses the one
  /// built into it.
  bool carries_table = false;
};

/// Returns the model as XML, complete in one file. Joint coordinates start at the rhythm's lowest
/// position in its first plane, where the controls' zero is clamped to. Radians, meters, kilograms;
/// world z up, x to the front. Throws std::invalid_argument if the rhythm leaves the anatomy's
/// joint ranges.
[[nodiscard]] std::string ShoulderModelXml(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                                           const ShoulderModelOptions& options = {});

}  // namespace girdle
