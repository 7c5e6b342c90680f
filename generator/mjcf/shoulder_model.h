// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The right shoulder as MJCF: thorax > clavicle > scapula > humerus, three hinges a joint in the
/// order of the measured Euler angles, so that a joint coordinate is the measured angle.
#pragma once

#include <optional>
#include <string>

#include "kinematics/shoulder_rhythm.h"
#include "tables/anatomy.h"
#include "tables/built_in.h"

namespace girdle {

/// What moves the joints.
enum class Actuation {
  kPlugin,    ///< three commands (elevation, plane, axial) and nine servos, by the engine plugin
              ///< girdle.rhythm
  kPosition,  ///< nine native position servos with the same gains and no plugin
};

struct ShoulderModelOptions {
  Actuation actuation = Actuation::kPlugin;
  /// Which built-in table the rhythm's is; nothing writes it into the plugin's configuration.
  std::optional<BuiltInTable> table = BuiltInTable::kDestepped;
  /// With commands for shrug and protraction; for kPlugin.
  bool has_offsets = false;
  /// With commands for how fast elevation, plane and axial change, which the plugin feeds forward;
  /// for kPlugin.
  bool has_rates = false;
};

/// Returns the model as XML, complete in one file. Joint coordinates start where the controls' zero
/// leads: the arm hanging, or the lowest position of a clamped rhythm. Radians, meters, kilograms;
/// world z up, x to the front. Throws std::invalid_argument if the rhythm leaves the anatomy's
/// joint ranges, looked for on a grid of 1 deg, or if the options name a table that is not the
/// rhythm's or ask for rates that the interpolation does not have.
[[nodiscard]] std::string ShoulderModelXml(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                                           const ShoulderModelOptions& options = {});

}  // namespace girdle
