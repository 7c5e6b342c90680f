// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Names in emitted models: public API, shared by the writer, the plugin, the simulation and the
/// tests.
///
/// Elements of one side end in `_r` or `_l`: joint and actuator `sc_protraction_r`, body
/// `scapula_r`, site `TS_r`. Attaching a model to another one may put a prefix before them.
/// model/README.md lists them all.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "kinematics/shoulder_pose.h"
#include "names/side.h"

namespace girdle {

/// The engine plugin's name in `<plugin plugin="...">`.
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
    "kp";  ///< one number, or nine as kCoordinateNames [N m/rad]
inline constexpr const char* kTranslationStiffnessKey =
    "kp_translation";                            ///< one number [N/m]; for Lead::kScapula
inline constexpr const char* kSideKey = "side";  ///< a word of kSideNames; right if absent

inline constexpr std::size_t kCommandCount = 3;
inline constexpr std::size_t kOffsetCount = 2;
inline constexpr std::size_t kRateCount = 3;

/// Stems of the command actuators, in the order of ArmCommand [rad].
inline constexpr std::array<std::string_view, kCommandCount> kCommandNames = {"elevation", "plane",
                                                                              "axial"};
/// Stems of columns with the axial turn of the command used, counted from the rhythm's own and as
/// ISB's third angle.
inline constexpr std::array<std::string_view, 2> kUsedAxialNames = {"used_axial", "used_axial_isb"};
/// Stems of columns with the offsets of the command used, in the order of kOffsetNames.
inline constexpr std::array<std::string_view, kOffsetCount> kUsedOffsetNames = {"used_shrug",
                                                                                "used_protraction"};
/// Stems of those that a model may have beside them: offsets of the clavicle [rad] ...
inline constexpr std::array<std::string_view, kOffsetCount> kOffsetNames = {"shrug", "protraction"};
/// ... and how fast the commands change [rad/s], for velocity feed-forward.
inline constexpr std::array<std::string_view, kRateCount> kRateNames = {"elevation_rate",
                                                                        "plane_rate", "axial_rate"};

inline constexpr std::size_t kAllCommandCount = kCommandCount + kOffsetCount + kRateCount;
/// All of them, in this order.
inline constexpr std::array<std::string_view, kAllCommandCount> kAllCommandNames = {
    kCommandNames[0], kCommandNames[1], kCommandNames[2], kOffsetNames[0],
    kOffsetNames[1],  kRateNames[0],    kRateNames[1],    kRateNames[2]};

/// How far a clavicle can be put beside the rhythm at all [rad]; joint ranges bound it further.
inline constexpr CoordinateRange kShrugRange = {-15 * kRadiansPerDegree, 35 * kRadiansPerDegree};
inline constexpr CoordinateRange kProtractionRange = {-25 * kRadiansPerDegree,
                                                      30 * kRadiansPerDegree};

/// Stem of the plugin's instance and of its sensor.
inline constexpr std::string_view kRhythmName = "rhythm";
/// The `<text>` element that holds the anatomy of a model, as AnatomyAsLine writes it.
inline constexpr std::string_view kAnatomyName = "girdle_anatomy";
/// Class of defaults of all elements of a model.
inline constexpr std::string_view kDefaultsName = "girdle";

/// What the plugin's sensor holds, all in radians.
namespace sensor_layout {
inline constexpr std::size_t kCommanded =
    0;  ///< elevation, plane, axial as used: within the controls' and the rhythm's ranges; axial
        ///< counted from the rhythm's own turn, whatever the control is counted from
inline constexpr std::size_t kReached =
    kCommanded + kCommandCount;  ///< the same of the simulated humerus
inline constexpr std::size_t kTarget = kReached + kCommandCount;   ///< nine joint targets
inline constexpr std::size_t kError = kTarget + kCoordinateCount;  ///< nine, target minus position
inline constexpr std::size_t kDistance =
    kError + kCoordinateCount;  ///< of the command from measured data
/// ISB's third angle Y-X'-Y'' of the humerus, as commanded and of the simulated one.
inline constexpr std::size_t kCommandedIsb = kDistance + 1;
inline constexpr std::size_t kReachedIsb = kCommandedIsb + 1;
inline constexpr std::size_t kSize = kReachedIsb + 1;
}  // namespace sensor_layout

/// Stem of the equality that holds the AC joint together in the assembly loop.
inline constexpr std::string_view kConnectName = "AC";

/// Sites of landmarks bear the landmark's name (`TS_r`; `IJ`, which has no side). Where two bones
/// meet the next bone has a site of its own at the same place, and the distance of the two is the
/// joint's residual.
struct JointSites {
  std::string_view parent;  ///< on the bone nearer to the thorax
  std::string_view child;
};
inline constexpr std::array<JointSites, kJointCount> kJointSites = {{
    {"SC", "SC_clavicle"},
    {"PAC", "PAC_scapula"},
    {"GH", "GH_humerus"},
}};

/// A ligament is a tendon (`conoid_r`) between the sites `conoid_clavicle_r` and
/// `conoid_scapula_r`.
[[nodiscard]] inline std::string LigamentEndName(std::string_view ligament, std::string_view bone) {
  return std::string(ligament) + "_" + std::string(bone);
}

/// Stem of the geom on the thorax that the scapula glides on, in models with thorax contact. What
/// touches it are geoms on the scapula with the names of the landmarks (`TS_r`), and so are the
/// contact pairs.
inline constexpr std::string_view kGlidingName = "gliding";

/// The skin of models that have one, and stems of its landmarks: `<numeric>` elements
/// (`skin_acromion_r`) that hold numbers of vertices, several where their mean is meant.
inline constexpr std::string_view kSkinName = "skin";
inline constexpr std::size_t kSkinLandmarkCount = 5;
inline constexpr std::string_view kSkinAcName = "skin_ac";
inline constexpr std::string_view kSkinAcromionName = "skin_acromion";
inline constexpr std::array<std::string_view, kSkinLandmarkCount> kSkinLandmarkNames = {
    kSkinAcName, kSkinAcromionName, "skin_mid_clavicle", "skin_scapular_spine", "skin_deltoid"};

/// Keyframes of emitted models. `hanging` is the lowest position of the frontal plane, where a
/// model stands with all controls at zero; `relaxed` is relaxed standing, held by trims.
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
