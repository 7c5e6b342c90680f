// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/shoulder_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <vector>

#include "kinematics/model_names.h"
#include "mjcf/bone_meshes.h"
#include "mjcf/joint_dynamics.h"
#include "mjcf/xml_element.h"
#include "tables/number_text.h"
#include "tables/rhythm_table_csv.h"

namespace girdle {
namespace {

// Height of the jugular notch of a standing adult, for the scene: share of the stature (Drillis and
// Contini 1966) times an average stature [m].
constexpr double kJugularNotchHeight_m = 0.82 * 1.71;
constexpr double kTimestep_s = 0.002;
// How far a user may push a joint off its target.
constexpr double kTrimRange_rad = 30 * kRadiansPerDegree;
// No arm is faster: a pitcher's humerus turns at 120 rad/s.
constexpr double kFastestCommand_rad_per_s = 150;

constexpr double kLandmarkRadius_m = 0.004;
constexpr int kMeshDecimals = 4;  // 0.1 mm

// The thorax frame's axes in the world: x to x, y to z, z to -y.
Quaternion ThoraxInWorld() { return QuaternionFromEuler(EulerSequence::kYXZ, {0, kPi / 2, 0}); }

std::string Right(std::string_view stem) { return SidedName(stem, kRightSuffix); }

std::string LandmarkSiteName(const LandmarkDefinition& landmark) {
  return landmark.sided ? Right(landmark.name) : std::string(landmark.name);
}

// Axes of a joint's three hinges in the child's frame, which stands at the hinges' reference
// angles. With q = R1(a) R2(b) R3(c), a turn of hinge 1 by d gives R1(a + d) R2(b) R3(c) = q
// Rot(q^-1 e1, d), and so on.
std::array<Vector3, 3> HingeAxes(EulerSequence sequence, const Vector3& reference_rad) {
  const Vector3 x{1, 0, 0};
  const Vector3 y{0, 1, 0};
  const Vector3 z{0, 0, 1};
  const bool tilts_last = sequence == EulerSequence::kYXZ;
  const Vector3 e1 = tilts_last ? y : x;
  const Vector3 e2 = tilts_last ? x : z;
  const Vector3 e3 = tilts_last ? z : y;
  const Quaternion whole = QuaternionFromEuler(sequence, reference_rad);
  const Quaternion last = QuaternionFromEuler(sequence, {0, 0, reference_rad.z});
  return {glm::conjugate(whole) * e1, glm::conjugate(last) * e2, e3};
}

class ShoulderModelWriter {
 public:
  ShoulderModelWriter(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                      const ShoulderModelOptions& options)
      : anatomy_(anatomy),
        rhythm_(rhythm),
        options_(options),
        rest_rad_(AnglesFromPose(rhythm.SolvePose({}))) {}

  std::string Write() {
    if (options_.has_rates && rhythm_.options().interpolation != Interpolation::kSmooth) {
      throw std::invalid_argument("rate commands need the interpolation smooth");
    }
    CheckTable();
    CheckRanges();
    XmlElement root = file_.root();
    root.Set("model", "girdle right shoulder");
    const RhythmOptions& rhythm = rhythm_.options();
    root.AddComment("Emitted by girdle generate. Interpolation " +
                    std::string(Name(rhythm.interpolation)) + ", closure " +
                    std::string(Name(rhythm.closure)) + ", range " +
                    std::string(Name(*rhythm.range)) + ", table " +
                    (options_.table ? std::string(Name(*options_.table)) + " (Ludewig et al. 2009)"
                                    : "in the plugin's configuration"));
    root.AddComment(
        "A joint coordinate is the measured Euler angle [rad]: SC and AC Y-X'-Z'', GH X-Z'-Y'', "
        "ISB frames; qpos0 is where controls of zero lead");
    root.Add("compiler").Set("angle", "radian");
    root.Add("option").Set("timestep", kTimestep_s).Set("integrator", "implicitfast");
    if (options_.actuation == Actuation::kPlugin) {
      WriteExtension(root.Add("extension"));
    }
    WriteDefaults(root.Add("default"));
    WriteAssets(root.Add("asset"));
    WriteBodies(root.Add("worldbody"));
    if (options_.actuation == Actuation::kPlugin) {
      WritePluginActuators(root.Add("actuator"));
      root.Add("sensor")
          .Add("plugin")
          .Set("name", Right(kRhythmName))
          .Set("instance", Right(kRhythmName));
    } else {
      WritePositionActuators(root.Add("actuator"));
    }
    WriteKeyframes(root.Add("keyframe"));
    return file_.Text();
  }

 private:
  // A model that names another table than its own would load and be wrong.
  void CheckTable() const {
    if (options_.table && RhythmTableToLine(rhythm_.table()) !=
                              RhythmTableToLine(BuiltInRhythmTable(*options_.table))) {
      throw std::invalid_argument("the rhythm's table is not the built-in table " +
                                  std::string(Name(*options_.table)) +
                                  ". Name the one that it is, or none");
    }
  }

  void CheckRanges() const {
    constexpr double kStep_rad = kRadiansPerDegree;
    const ArmRectangle& domain = rhythm_.domain();
    const auto steps = [](double from_rad, double to_rad) {
      return static_cast<int>(std::ceil((to_rad - from_rad) / kStep_rad - 0.5));
    };
    const int planes = steps(domain.first_plane_rad, domain.last_plane_rad);
    const int elevations = steps(domain.lowest_elevation_rad, domain.highest_elevation_rad);
    for (int j = 0; j <= planes; ++j) {
      for (int i = 0; i <= elevations; ++i) {
        CheckRangesAt(
            {domain.lowest_elevation_rad + i * kStep_rad, domain.first_plane_rad + j * kStep_rad});
      }
    }
  }

  void CheckRangesAt(const ArmCommand& command) const {
    ArmCommand used;
    const JointAngles angles_rad = AnglesFromPose(rhythm_.SolvePose(command, &used));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const CoordinateRange& range = anatomy_.ranges[k];
      // Rounding may take an angle over the range that its table ends at.
      constexpr double kRounding_rad = 1e-9;
      if (angles_rad[k] < range.lower_rad - kRounding_rad ||
          angles_rad[k] > range.upper_rad + kRounding_rad) {
        const auto degrees = [](double angle_rad) {
          return RoundedText(DegreesFromRadians(angle_rad), 6);
        };
        throw std::invalid_argument(std::string(kCoordinateNames[k]) + " is " +
                                    degrees(angles_rad[k]) + " deg at plane " +
                                    degrees(used.plane_rad) + ", elevation " +
                                    degrees(used.elevation_rad) + ", outside the joint's range " +
                                    degrees(range.lower_rad) + " to " + degrees(range.upper_rad) +
                                    " deg. Check the signs and the sequence of the table's angles");
      }
    }
  }

  void WriteExtension(XmlElement extension) const {
    XmlElement instance = extension.Add("plugin")
                              .Set("plugin", kPluginName)
                              .Add("instance")
                              .Set("name", Right(kRhythmName));
    const auto configure = [&instance](const char* key, std::string_view value) {
      instance.Add("config").Set("key", key).Set("value", value);
    };
    configure(kInterpolationKey, Name(rhythm_.options().interpolation));
    configure(kClosureKey, Name(rhythm_.options().closure));
    configure(kRangeKey, Name(*rhythm_.options().range));
    if (options_.table) {
      configure(kTableKey, Name(*options_.table));
    }
    std::string stiffness;
    for (const JointDynamics& joint : kJointDynamics) {
      for (int hinge = 0; hinge < 3; ++hinge) {
        stiffness += (stiffness.empty() ? "" : " ") + NumberText(joint.stiffness_N_m_per_rad);
      }
    }
    configure(kStiffnessKey, stiffness);
    if (!options_.table) {
      configure(kTableKey, RhythmTableToLine(rhythm_.table()));
    }
  }

  static void WriteDefaults(XmlElement defaults) {
    XmlElement girdle = defaults.Add("default").Set("class", "girdle");
    // Bones are drawn; they neither collide nor weigh.
    girdle.Add("geom")
        .Set("contype", 0)
        .Set("conaffinity", 0)
        .Set("group", 1)
        .Set("mass", 0)
        .Set("material", "bone");
    girdle.Add("site")
        .Set("size", kLandmarkRadius_m)
        .Set("group", 3)
        .Set("rgba", std::array{0.85, 0.25, 0.1, 1.0});
  }

  void WriteAssets(XmlElement asset) const {
    asset.Add("material").Set("name", "bone").Set("rgba", std::array{0.89, 0.85, 0.76, 1.0});
    asset.Add("material").Set("name", "rib").Set("rgba", std::array{0.75, 0.77, 0.8, 1.0});
    WriteMesh(asset, "ribcage", RibcageMesh(anatomy_));
    WriteMesh(asset, Right("clavicle"), ClavicleMesh(anatomy_));
    WriteMesh(asset, Right("scapula"), ScapulaMesh(anatomy_));
    WriteMesh(asset, Right("humerus"), HumerusMesh(anatomy_));
  }

  static void WriteMesh(XmlElement asset, const std::string& name, const TriangleMesh& mesh) {
    std::string vertices;
    for (const Vector3& vertex : mesh.vertices_m) {
      for (const double coordinate : {vertex.x, vertex.y, vertex.z}) {
        vertices += (vertices.empty() ? "" : " ") + RoundedText(coordinate, kMeshDecimals);
      }
    }
    std::string faces;
    for (const std::array<int, 3>& triangle : mesh.triangles) {
      for (const int vertex : triangle) {
        faces += (faces.empty() ? "" : " ") + std::to_string(vertex);
      }
    }
    // Bones are drawn, not weighed: "shell" spares MuJoCo's check of enclosed volumes.
    asset.Add("mesh")
        .Set("name", name)
        .Set("inertia", "shell")
        .Set("vertex", vertices)
        .Set("face", faces);
  }

  void WriteBodies(XmlElement world) const {
    XmlElement thorax = world.Add("body")
                            .Set("name", "thorax")
                            .Set("pos", Vector3{0, 0, kJugularNotchHeight_m})
                            .Set("quat", ThoraxInWorld())
                            .Set("childclass", "girdle");
    WriteInertial(thorax, Segment::kThorax);
    thorax.Add("geom")
        .Set("name", "ribcage")
        .Set("type", "mesh")
        .Set("mesh", "ribcage")
        .Set("material", "rib");
    WriteLandmarks(thorax, Segment::kThorax);

    XmlElement clavicle = WriteBone(thorax, Segment::kClavicle, 0, Landmark::kSC);
    XmlElement scapula = WriteBone(clavicle, Segment::kScapula, 1, Landmark::kPAC);
    WriteBone(scapula, Segment::kHumerus, 2, Landmark::kGH);
  }

  // A moving bone, hanging at `origin` of its parent by the three hinges of `joint`.
  XmlElement WriteBone(XmlElement& parent, Segment segment, std::size_t joint,
                       Landmark origin) const {
    const std::string name = Right(kSegmentNames[static_cast<std::size_t>(segment)]);
    const EulerSequence sequence = kJointSequences[joint];
    const Vector3 reference_rad{rest_rad_[3 * joint], rest_rad_[3 * joint + 1],
                                rest_rad_[3 * joint + 2]};
    XmlElement body = parent.Add("body")
                          .Set("name", name)
                          .Set("pos", anatomy_.landmark_m(origin))
                          .Set("quat", QuaternionFromEuler(sequence, reference_rad))
                          .Set("gravcomp", 1);
    WriteInertial(body, segment);
    const std::array<Vector3, 3> axes = HingeAxes(sequence, reference_rad);
    for (std::size_t hinge = 0; hinge < 3; ++hinge) {
      const std::size_t k = 3 * joint + hinge;
      body.Add("joint")
          .Set("name", Right(kCoordinateNames[k]))
          .Set("axis", axes[hinge])
          .Set("ref", rest_rad_[k])
          .Set("range", std::array{anatomy_.ranges[k].lower_rad, anatomy_.ranges[k].upper_rad})
          .Set("damping", kJointDynamics[joint].damping_N_m_s_per_rad)
          .Set("armature", kJointDynamics[joint].armature_kg_m2);
    }
    body.Add("geom").Set("name", name).Set("type", "mesh").Set("mesh", name);
    body.Add("site").Set("name", Right(kJointSites[joint].child));
    WriteLandmarks(body, segment);
    return body;
  }

  void WriteInertial(XmlElement& body, Segment segment) const {
    const SegmentInertia& inertia = anatomy_.segment(segment);
    body.Add("inertial")
        .Set("pos", inertia.center_of_mass_m)
        .Set("mass", inertia.mass_kg)
        .Set("diaginertia", inertia.inertia_kg_m2);
  }

  void WriteLandmarks(XmlElement& body, Segment segment) const {
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      if (kLandmarks[i].segment == segment) {
        body.Add("site")
            .Set("name", LandmarkSiteName(kLandmarks[i]))
            .Set("pos", anatomy_.landmarks_m[i]);
      }
    }
  }

  void WritePluginActuators(XmlElement actuator) const {
    const ArmRectangle& domain = rhythm_.domain();
    // A command has no force of its own; MuJoCo wants it to act on something all the same.
    const auto write_command = [&actuator](std::string_view name, const CoordinateRange& range) {
      actuator.Add("plugin")
          .Set("name", Right(name))
          .Set("joint", Right(kCoordinateNames[kGhAxialIndex]))
          .Set("instance", Right(kRhythmName))
          .Set("gear", 0)
          .Set("ctrlrange", std::array{range.lower_rad, range.upper_rad});
    };
    write_command(kCommandNames[0], {domain.lowest_elevation_rad, domain.highest_elevation_rad});
    write_command(kCommandNames[1], {domain.first_plane_rad, domain.last_plane_rad});
    write_command(kCommandNames[2], AxialRange());
    if (options_.has_offsets) {
      write_command(kOffsetNames[0], kShrugRange);
      write_command(kOffsetNames[1], kProtractionRange);
    }
    if (options_.has_rates) {
      for (const std::string_view rate : kRateNames) {
        write_command(rate, {-kFastestCommand_rad_per_s, kFastestCommand_rad_per_s});
      }
    }
    for (const std::string_view coordinate : kCoordinateNames) {
      actuator.Add("plugin")
          .Set("name", Right(coordinate))
          .Set("joint", Right(coordinate))
          .Set("instance", Right(kRhythmName))
          .Set("ctrlrange", std::array{-kTrimRange_rad, kTrimRange_rad});
    }
  }

  void WritePositionActuators(XmlElement actuator) const {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      actuator.Add("position")
          .Set("name", Right(kCoordinateNames[k]))
          .Set("joint", Right(kCoordinateNames[k]))
          .Set("kp", kJointDynamics[k / 3].stiffness_N_m_per_rad)
          .Set("ctrlrange", std::array{anatomy_.ranges[k].lower_rad, anatomy_.ranges[k].upper_rad});
    }
  }

  // The axial turns that keep GH within its range at every measured position.
  [[nodiscard]] CoordinateRange AxialRange() const {
    const RhythmTable& table = rhythm_.table();
    double lowest_rad = table.position(0, 0).angles_rad[kGhAxialIndex];
    double highest_rad = lowest_rad;
    for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
      for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
        const double axial_rad = table.position(plane, elevation).angles_rad[kGhAxialIndex];
        lowest_rad = std::min(lowest_rad, axial_rad);
        highest_rad = std::max(highest_rad, axial_rad);
      }
    }
    const CoordinateRange& range = anatomy_.ranges[kGhAxialIndex];
    return {range.lower_rad - lowest_rad, range.upper_rad - highest_rad};
  }

  void WriteKeyframes(XmlElement keyframe) const {
    for (const NamedPose& pose : kKeyframes) {
      const ShoulderSolution solution = rhythm_.Solve(
          {RadiansFromDegrees(pose.elevation_deg), RadiansFromDegrees(pose.plane_deg)});
      // Only rest is the nearest pose there is; the others are what their names say or are not
      // there.
      if (pose.name != kRestName && solution.clamped) {
        continue;
      }
      const JointAngles target_rad = AnglesFromPose(solution.pose);
      const JointAngles angles_rad = pose.name == kRelaxedName
                                         ? AnglesFromPose(HangingIn(RelaxedStanding(), rhythm_))
                                         : target_rad;
      keyframe.Add("key")
          .Set("name", pose.name)
          .Set("qpos", angles_rad)
          .Set("ctrl", KeyframeControls(solution.used, target_rad, angles_rad));
    }
  }

  // Controls that hold the joints at `angles_rad`: the plugin's trims make up for what they are off
  // its targets.
  [[nodiscard]] std::vector<double> KeyframeControls(const ArmCommand& command,
                                                     const JointAngles& target_rad,
                                                     const JointAngles& angles_rad) const {
    if (options_.actuation == Actuation::kPosition) {
      return {angles_rad.begin(), angles_rad.end()};
    }
    std::vector<double> controls = {command.elevation_rad, command.plane_rad};
    controls.resize(kCommandCount + (options_.has_offsets ? kOffsetCount : 0) +
                    (options_.has_rates ? kRateCount : 0));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      controls.push_back(angles_rad[k] - target_rad[k]);
    }
    return controls;
  }

  const Anatomy& anatomy_;
  const ShoulderRhythm& rhythm_;
  const ShoulderModelOptions& options_;
  JointAngles rest_rad_;
  XmlFile file_{"mujoco"};
};

}  // namespace

std::string ShoulderModelXml(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                             const ShoulderModelOptions& options) {
  return ShoulderModelWriter(anatomy, rhythm, options).Write();
}

}  // namespace girdle
