// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Shoulders as MJCF: a right one, a left one or both on one thorax, in one of two assemblies
/// (assembly.h), three hinges a joint in the order of the measured Euler angles, so that a joint
/// coordinate is the measured angle.
///
/// The left shoulder is the mirror image of the right one: frames, places and axes are mirrored,
/// coordinates are the same.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/assembly.h"
#include "kinematics/shoulder_rhythm.h"
#include "names/model_names.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle {

/// What moves the joints.
enum class Actuation {
  kPlugin,    ///< three commands (elevation, plane, axial) and nine servos, by the engine plugin
              ///< girdle.rhythm
  kPosition,  ///< nine native position servos with the same gains and no plugin
};

inline constexpr std::array<std::string_view, 2> kActuationNames = {"plugin", "position"};
constexpr const auto& WordsOf(Actuation /*which*/) noexcept { return kActuationNames; }

enum class Sides { kRight, kLeft, kBoth };
inline constexpr std::array<std::string_view, 3> kSidesNames = {"right", "left", "both"};
constexpr const auto& WordsOf(Sides /*which*/) noexcept { return kSidesNames; }

/// The sides in the order in which a model has them.
[[nodiscard]] std::vector<Side> SidesOf(Sides sides);

/// A skin in a file beside the model.
struct SkinElement {
  std::string file;  ///< name of an .skn file
  /// Vertices of each landmark of kSkinLandmarkNames, for each side of the model.
  std::vector<std::array<std::vector<int>, kSkinLandmarkCount>> landmarks;
};

struct ShoulderModelOptions {
  Sides sides = Sides::kRight;
  Assembly assembly = Assembly::kTree;
  Lead lead = Lead::kClavicle;  ///< of a loop
  Actuation actuation = Actuation::kPlugin;
  /// What the command for the axial turn is counted from; for kPlugin.
  AxialFrom axial_from = AxialFrom::kRhythm;
  /// Which built-in table the rhythm's is; nothing writes it into the plugin's configuration.
  std::optional<BuiltInTable> table = BuiltInTable::kSmoothed;
  /// With commands for shrug and protraction; for kPlugin.
  bool has_offsets = false;
  /// With commands for how fast elevation, plane and axial change, which the plugin feeds forward;
  /// for kPlugin and a tree.
  bool has_rates = false;
  /// With a soft force that keeps TS and AI from sinking into the anatomy's gliding ellipsoid; for
  /// Lead::kClavicle.
  bool has_thorax_contact = false;
  std::optional<SkinElement> skin = std::nullopt;
};

/// Returns the model as XML, complete in one file. In a model of both shoulders the landmarks of
/// the thorax that have no side lie in the median plane. Joint coordinates start where the
/// controls' zero leads: the arm hanging, or the lowest position of a clamped rhythm. A ligament
/// pulls from the anatomy's slack on, or from the longest that the rhythm makes it anywhere on a
/// grid of 1 deg or in relaxed standing, rounded up to 0.1 mm, if that is longer: what is asked of
/// the joints never stretches it, what pushes them aside does. Radians, meters, kilograms; world z
/// up, x to the front. Throws std::invalid_argument if the rhythm leaves the anatomy's joint
/// ranges, looked for on a grid of 1 deg, or if the options name a table that is not the rhythm's,
/// ask for rates that interpolation or assembly do not have, for a loop of a table with fewer than
/// three planes, or for commands of a model without plugin.
[[nodiscard]] std::string ShoulderModelXml(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                                           const ShoulderModelOptions& options = {});

}  // namespace girdle
