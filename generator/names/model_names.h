// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Names in emitted models. They are public API, shared by the writer, the plugin, the simulation
/// and the tests.
///
/// Names of elements of one side end in `_r` or `_l`: joint and actuator `sc_protraction_r`, body
/// `scapula_r`, site `TS_r`. If a model is attached to another one, a prefix may stand before them.
/// model/README.md lists all names.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "kinematics/shoulder_pose.h"
#include "names/side.h"

namespace girdle {

/// Name of the engine plugin in `<plugin plugin="...">`.
inline constexpr const char* kPluginName = "girdle.rhythm";

/// Keys of the plugin's configuration.
inline constexpr const char* kInterpolationKey =
    "interpolation";                                   ///< a word of kInterpolationNames
inline constexpr const char* kClosureKey = "closure";  ///< a word of kClosureNames
inline constexpr const char* kRangeKey = "range";      ///< a word of kRangeNames
inline constexpr const char* kAxialFromKey =
    "axial_from";  ///< a word of kAxialFromNames; rhythm if absent
inline constexpr const char* kTableKey =
    "table";  ///< a word of kBuiltInTableNames or RhythmTableToLine; DefaultTable if absent
inline constexpr const char* kStiffnessKey =
    "kp";  ///< one number, or nine in the order of kCoordinateNames [N m/rad]
inline constexpr const char* kTranslationStiffnessKey =
    "kp_translation";                            ///< one number [N/m]; for Lead::kScapula
inline constexpr const char* kSideKey = "side";  ///< a word of kSideNames; right if absent

inline constexpr std::size_t kCommandCount = 3;
inline constexpr std::size_t kOffsetCount = 2;
inline constexpr std::size_t kRateCount = 3;

/// Stems of the command actuators [rad], in the order of ArmCommand.
inline constexpr std::array<std::string_view, kCommandCount> kCommandNames = {"elevation", "plane",
                                                                              "axial"};
/// Stems of columns with the axial turn of the command used: counted from the rhythm's own turn,
/// and as ISB's third angle.
inline constexpr std::array<std::string_view, 2> kUsedAxialNames = {"used_axial", "used_axial_isb"};
/// Stems of columns with the offsets of the command used, in the order of kOffsetNames.
inline constexpr std::array<std::string_view, kOffsetCount> kUsedOffsetNames = {"used_shrug",
                                                                                "used_protraction"};
/// Stems of optional commands of a model: offsets of the clavicle [rad].
inline constexpr std::array<std::string_view, kOffsetCount> kOffsetNames = {"shrug", "protraction"};
/// Stems of optional commands of a model: rates of the commands [rad/s], for velocity feed-forward.
inline constexpr std::array<std::string_view, kRateCount> kRateNames = {"elevation_rate",
                                                                        "plane_rate", "axial_rate"};

inline constexpr std::size_t kAllCommandCount = kCommandCount + kOffsetCount + kRateCount;
/// Stems of all commands: commands, offsets, rates.
inline constexpr std::array<std::string_view, kAllCommandCount> kAllCommandNames = {
    kCommandNames[0], kCommandNames[1], kCommandNames[2], kOffsetNames[0],
    kOffsetNames[1],  kRateNames[0],    kRateNames[1],    kRateNames[2]};

/// Limits of the clavicle's offsets from the rhythm [rad]. Joint ranges limit them further.
inline constexpr CoordinateRange kShrugRange = {-15 * kRadiansPerDegree, 35 * kRadiansPerDegree};
inline constexpr CoordinateRange kProtractionRange = {-25 * kRadiansPerDegree,
                                                      30 * kRadiansPerDegree};

/// Stem of the names of the plugin's instance and of its sensor.
inline constexpr std::string_view kRhythmName = "rhythm";
/// The `<text>` element that holds the anatomy of a model, as AnatomyAsLine writes it.
inline constexpr std::string_view kAnatomyName = "girdle_anatomy";
/// Name of the defaults class of all elements of a model.
inline constexpr std::string_view kDefaultsName = "girdle";

/// Indices into the plugin's sensor. All values are radians.
namespace sensor_layout {
inline constexpr std::size_t kCommanded =
    0;  ///< elevation, plane and axial as used: within the ranges of the controls and of the
        ///< rhythm; axial is counted from the rhythm's own turn, whatever zero the control has
inline constexpr std::size_t kReached =
    kCommanded + kCommandCount;  ///< elevation, plane and axial of the simulated humerus
inline constexpr std::size_t kTarget = kReached + kCommandCount;   ///< nine joint targets
inline constexpr std::size_t kError = kTarget + kCoordinateCount;  ///< nine, target minus position
inline constexpr std::size_t kDistance =
    kError + kCoordinateCount;  ///< angle between the command and the nearest table direction
/// ISB's third angle Y-X'-Y'' of the commanded humerus, then of the simulated one.
inline constexpr std::size_t kCommandedIsb = kDistance + 1;
inline constexpr std::size_t kReachedIsb = kCommandedIsb + 1;
inline constexpr std::size_t kSize = kReachedIsb + 1;
}  // namespace sensor_layout

/// Stem of the name of the equality that closes the AC joint in an assembly loop.
inline constexpr std::string_view kConnectName = "AC";

/// The two sites of a joint. Sites of landmarks have the landmark's name (`TS_r`, or `IJ`, which
/// has no side). Where two bones meet, the second bone has a site of its own at the same place. The
/// distance between both sites is the residual of the joint.
struct JointSites {
  std::string_view parent;  ///< on the bone nearer to the thorax
  std::string_view child;
};
inline constexpr std::array<JointSites, kJointCount> kJointSites = {{
    {"SC", "SC_clavicle"},
    {"PAC", "PAC_scapula"},
    {"GH", "GH_humerus"},
}};

/// Returns the name of a ligament's attachment. A ligament is a tendon (`conoid_r`) between the
/// sites `conoid_clavicle_r` and `conoid_scapula_r`.
[[nodiscard]] inline std::string LigamentEndName(std::string_view ligament, std::string_view bone) {
  return std::string(ligament) + "_" + std::string(bone);
}

/// Stem of the thorax geom that the scapula glides on, in models with thorax contact. The geoms of
/// the scapula that touch it, and the contact pairs, have the names of the landmarks (`TS_r`).
inline constexpr std::string_view kGlidingName = "gliding";

/// Name of the skin, in models that have one, and stems of its landmarks. A landmark is a
/// `<numeric>` element (`skin_acromion_r`) that contains indices of vertices. If there are several,
/// their mean is the landmark.
inline constexpr std::string_view kSkinName = "skin";
inline constexpr std::size_t kSkinLandmarkCount = 5;
inline constexpr std::string_view kSkinAcName = "skin_ac";
inline constexpr std::string_view kSkinAcromionName = "skin_acromion";
inline constexpr std::array<std::string_view, kSkinLandmarkCount> kSkinLandmarkNames = {
    kSkinAcName, kSkinAcromionName, "skin_mid_clavicle", "skin_scapular_spine", "skin_deltoid"};

/// A keyframe of emitted models. `hanging` is the lowest position of the frontal plane, where a
/// model with all controls at zero stands. `relaxed` is relaxed standing, held by trims.
struct NamedPose {
  std::string_view name;
  double elevation_deg;
  double plane_deg;
};
inline constexpr std::string_view kHangingName = "hanging";
inline constexpr std::string_view kRelaxedName = "relaxed";
inline constexpr std::array<NamedPose, 9> kKeyframes = {{
    {kHangingName, 0, 0},
    {kRelaxedName, 0, 0},
    {"abduction_30", 30, 0},
    {"abduction_60", 60, 0},
    {"abduction_90", 90, 0},
    {"abduction_120", 120, 0},
    {"abduction_150", 150, 0},
    {"flexion_90", 90, 90},
    {"across_90", 90, 120},
}};

}  // namespace girdle
