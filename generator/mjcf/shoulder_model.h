// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Shoulders as MJCF: a right one, a left one, or both on one thorax, in one of two assemblies
/// (assembly.h).
///
/// Each joint has three hinges in the order of its measured Euler angles, so a joint coordinate is
/// the measured angle. The left shoulder is the mirror image of the right one: frames, positions
/// and axes are mirrored, coordinates are equal.
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

/// The actuators that move the joints.
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

/// Returns the sides in their order in a model.
[[nodiscard]] std::vector<Side> SidesOf(Sides sides);

/// A skin in a file next to the model.
struct SkinElement {
  std::string file;  ///< name of an .skn file
  /// Vertices of each landmark of kSkinLandmarkNames, for each side of the model.
  std::vector<std::array<std::vector<int>, kSkinLandmarkCount>> landmarks;
};

/// Options of a model. ShoulderModelXml throws if an option is set that is for another actuation,
/// assembly or lead.
struct ShoulderModelOptions {
  Sides sides = Sides::kRight;
  Assembly assembly = Assembly::kTree;
  Lead lead = Lead::kClavicle;  ///< of a loop; a tree has kClavicle
  Actuation actuation = Actuation::kPlugin;
  /// The zero of the axial command; for kPlugin.
  AxialFrom axial_from = AxialFrom::kRhythm;
  /// The built-in table that the rhythm uses. If empty, the whole table is written into the
  /// plugin's configuration.
  std::optional<BuiltInTable> table = BuiltInTable::kSmoothed;
  /// Whether the model has commands for shrug and protraction; for kPlugin.
  bool has_offsets = false;
  /// Whether the model has commands for the rates of elevation, plane and axial, which the plugin
  /// feeds forward; for kPlugin and a tree.
  bool has_rates = false;
  /// Whether a soft force keeps TS and AI out of the anatomy's gliding ellipsoid; for
  /// Lead::kClavicle.
  bool has_thorax_contact = false;
  std::optional<SkinElement> skin = std::nullopt;
};

/// Returns the model as XML, complete in one file.
///
/// Units are radians, meters and kilograms. In the world z is up and x points to the front. In a
/// model of both shoulders, the landmarks of the thorax that have no side are in the median plane.
/// Joint coordinates start where controls of zero lead: the arm hangs, or is at the lowest position
/// of a clamped rhythm.
///
/// A ligament pulls from its slack length on. The slack length is the larger of two: the anatomy's,
/// and the ligament's longest length in the rhythm (on a grid of 1 deg and in relaxed standing),
/// rounded up to 0.1 mm. So no commanded pose stretches a ligament, but forces that push the joints
/// aside do.
///
/// Throws std::invalid_argument if the rhythm leaves the anatomy's joint ranges, which is checked
/// on a grid of 1 deg. Throws it also if the options exclude each other. They do so if they name a
/// table that is not the rhythm's, rates that the interpolation or the assembly does not have, a
/// loop with a table of fewer than three planes, or commands of a model without plugin.
[[nodiscard]] std::string ShoulderModelXml(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                                           const ShoulderModelOptions& options = {});

}  // namespace girdle
