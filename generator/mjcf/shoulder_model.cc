// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/shoulder_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "anatomy/posed_bones.h"
#include "kinematics/assembled_rhythm.h"
#include "mjcf/bone_meshes.h"
#include "mjcf/xml_element.h"
#include "names/joint_dynamics.h"
#include "names/model_names.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr double kTimestep_s = 0.002;
// How far a user may push a joint off its target.
constexpr double kTrimRange_rad = 30 * kRadiansPerDegree;
constexpr double kTranslationTrimRange_m = 0.03;
// No arm is faster: a pitcher's humerus turns at 120 rad/s.
constexpr double kFastestCommand_rad_per_s = 150;

constexpr double kLandmarkRadius_m = 0.004;
constexpr double kLigamentRadius_m = 0.002;
constexpr int kMeshDecimals = 4;  // 0.1 mm
// What touches the gliding ellipsoid is a point; a geom has to have a radius.
constexpr double kContactRadius_m = 1e-4;

// The thorax frame's axes in the world: x to x, y to z, z to -y.
Quaternion ThoraxInWorld() { return QuaternionFromEuler(EulerSequence::kYXZ, {0, kPi / 2, 0}); }

// Mirror images for a left shoulder (rotation.h).
Quaternion OnSide(Side side, const Quaternion& q_AB) {
  return side == Side::kRight ? q_AB : Mirrored(q_AB);
}
Vector3 OnSide(Side side, const Vector3& p_A) { return side == Side::kRight ? p_A : Mirrored(p_A); }
// An axis of turning has a sense that the mirror turns round.
Vector3 AxisOnSide(Side side, const Vector3& axis) {
  return side == Side::kRight ? axis : -Mirrored(axis);
}

TriangleMesh OnSide(Side side, TriangleMesh mesh) {
  if (side == Side::kLeft) {
    for (Vector3& vertex : mesh.vertices_m) {
      vertex = Mirrored(vertex);
    }
    for (std::array<int, 3>& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return mesh;
}

// Lengths of ligaments are told to 0.1 mm.
constexpr double kLengthStepsPerMeter = 1e4;
double RoundedToStep(double length_m) {
  return std::round(length_m * kLengthStepsPerMeter) / kLengthStepsPerMeter;
}

constexpr std::array<double, 4> kSkinColor = {0.82, 0.71, 0.62, 1};

// What glides on the thorax.
constexpr std::array<Landmark, 2> kGliding = {Landmark::kTS, Landmark::kAI};

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

// Calls `visit(command)` all over a domain, a degree apart.
template <typename Visit>
void ForEachCommand(const ArmRectangle& domain, const Visit& visit) {
  constexpr double kStep_rad = kRadiansPerDegree;
  const auto steps = [](double from_rad, double to_rad) {
    return static_cast<int>(std::ceil((to_rad - from_rad) / kStep_rad - 0.5));
  };
  const int planes = steps(domain.first_plane_rad, domain.last_plane_rad);
  const int elevations = steps(domain.lowest_elevation_rad, domain.highest_elevation_rad);
  for (int j = 0; j <= planes; ++j) {
    for (int i = 0; i <= elevations; ++i) {
      visit(ArmCommand{domain.lowest_elevation_rad + i * kStep_rad,
                       domain.first_plane_rad + j * kStep_rad});
    }
  }
}

using LigamentLengths = std::array<double, kLigamentCount>;  ///< [m]

void TakeLonger(const Anatomy& anatomy, const ShoulderPose& pose, LigamentLengths& longest_m) {
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    longest_m[i] = std::max(longest_m[i], LigamentLength_m(anatomy.ligaments[i], anatomy, pose));
  }
}

// The anatomy's slack, or the longest length rounded up.
LigamentLengths SlackFor(const Anatomy& anatomy, const LigamentLengths& longest_m) {
  LigamentLengths slack_m{};
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    slack_m[i] = std::max(anatomy.ligaments[i].slack_m,
                          std::ceil(longest_m[i] * kLengthStepsPerMeter) / kLengthStepsPerMeter);
  }
  return slack_m;
}

class ShoulderModelWriter {
 public:
  ShoulderModelWriter(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                      const ShoulderModelOptions& options)
      : anatomy_(anatomy),
        assembled_(rhythm, options.assembly),
        rhythm_(assembled_.rhythm()),
        options_(options),
        sides_(SidesOf(options.sides)),
        coordinates_(DrivenCoordinates(options.assembly)),
        rest_(assembled_.SolvePose({})),
        rest_rad_(DrivenAngles(options.assembly, rest_)) {}

  std::string Write() {
    CheckOptions();
    CheckTable();
    const LigamentLengths slack_m = SurveyRhythm();
    XmlElement root = file_.root();
    root.Set("model", "girdle " +
                          std::string(kSidesNames[static_cast<std::size_t>(options_.sides)]) +
                          (sides_.size() > 1 ? " shoulders" : " shoulder"));
    WriteComments(root);
    root.Add("compiler").Set("angle", "radian");
    root.Add("option").Set("timestep", kTimestep_s).Set("integrator", "implicitfast");
    if (options_.actuation == Actuation::kPlugin) {
      XmlElement plugin = root.Add("extension").Add("plugin").Set("plugin", kPluginName);
      for (const Side side : sides_) {
        WriteInstance(plugin, side);
      }
    }
    WriteDefaults(root.Add("default"));
    WriteAssets(root.Add("asset"));
    WriteBodies(root.Add("worldbody"));
    if (options_.skin) {
      WriteSkin(root.Add("deformable"), root.Add("custom"));
    }
    if (options_.has_thorax_contact) {
      WriteContacts(root.Add("contact"));
    }
    if (options_.assembly == Assembly::kLoop) {
      WriteEqualities(root.Add("equality"));
    }
    WriteLigaments(root.Add("tendon"), slack_m);
    XmlElement actuator = root.Add("actuator");
    for (const Side side : sides_) {
      if (options_.actuation == Actuation::kPlugin) {
        WritePluginActuators(actuator, side);
      } else {
        WritePositionActuators(actuator, side);
      }
    }
    if (options_.actuation == Actuation::kPlugin) {
      XmlElement sensor = root.Add("sensor");
      for (const Side side : sides_) {
        sensor.Add("plugin")
            .Set("name", SidedName(kRhythmName, side))
            .Set("instance", SidedName(kRhythmName, side));
      }
    }
    WriteKeyframes(root.Add("keyframe"));
    return file_.Text();
  }

 private:
  void CheckOptions() const {
    if (options_.has_rates && rhythm_.options().interpolation != Interpolation::kSmooth) {
      throw std::invalid_argument("rate commands need the interpolation smooth");
    }
    if (options_.has_rates && options_.assembly == Assembly::kLoop) {
      throw std::invalid_argument("rate commands need the assembly tree");
    }
    if (options_.actuation == Actuation::kPosition &&
        (options_.has_offsets || options_.has_rates)) {
      throw std::invalid_argument(
          "commands for offsets and rates need the plugin: position servos are given joint angles");
    }
    if (options_.assembly == Assembly::kTree && options_.lead != Lead::kClavicle) {
      throw std::invalid_argument("in a tree nothing but the clavicle can lead");
    }
    if (options_.skin && options_.skin->landmarks.size() != sides_.size()) {
      throw std::invalid_argument("a skin needs landmarks of every side of the model");
    }
    if (options_.has_thorax_contact && options_.lead == Lead::kScapula) {
      throw std::invalid_argument("thorax contact needs a clavicle that leads");
    }
  }

  // A model that names another table than its own would load and be wrong.
  void CheckTable() const {
    if (options_.table && RhythmTableToLine(rhythm_.table()) !=
                              RhythmTableToLine(BuiltInRhythmTable(*options_.table))) {
      throw std::invalid_argument("the rhythm's table is not the built-in table " +
                                  std::string(Name(*options_.table)) +
                                  ". Name the one that it is, or none");
    }
  }

  // Checks the ranges, and returns the ligaments' slack, both wherever the rhythm goes: most of
  // writing's time is spent here.
  [[nodiscard]] LigamentLengths SurveyRhythm() const {
    LigamentLengths longest_m{};
    TakeLonger(anatomy_, HangingIn(RelaxedStanding(), rhythm_), longest_m);
    ForEachCommand(rhythm_.domain(), [&](const ArmCommand& command) {
      ArmCommand used;
      const ShoulderPose pose = assembled_.SolvePose(command, &used);
      CheckRanges(used, DrivenAngles(options_.assembly, pose));
      TakeLonger(anatomy_, pose, longest_m);
    });
    return SlackFor(anatomy_, longest_m);
  }

  [[nodiscard]] const CoordinateRange& RangeOf(std::size_t coordinate) const {
    return options_.assembly == Assembly::kLoop && coordinate / 3 == 1
               ? anatomy_.scapulothoracic_ranges[coordinate - 3]
               : anatomy_.ranges[coordinate];
  }

  void CheckRanges(const ArmCommand& used, const JointAngles& angles_rad) const {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const CoordinateRange& range = RangeOf(k);
      // Rounding may take an angle over the range that its table ends at.
      constexpr double kRounding_rad = 1e-9;
      if (angles_rad[k] < range.lower_rad - kRounding_rad ||
          angles_rad[k] > range.upper_rad + kRounding_rad) {
        const auto degrees = [](double angle_rad) {
          return RoundedText(DegreesFromRadians(angle_rad), 6);
        };
        throw std::invalid_argument(std::string(coordinates_[k]) + " is " + degrees(angles_rad[k]) +
                                    " deg at plane " + degrees(used.plane_rad) + ", elevation " +
                                    degrees(used.elevation_rad) + ", outside the joint's range " +
                                    degrees(range.lower_rad) + " to " + degrees(range.upper_rad) +
                                    " deg. Check the signs and the sequence of the table's angles");
      }
    }
  }

  void WriteComments(XmlElement root) const {
    const RhythmOptions& rhythm = rhythm_.options();
    const bool is_loop = options_.assembly == Assembly::kLoop;
    root.AddComment(
        "Emitted by girdle generate. Interpolation " + std::string(Name(rhythm.interpolation)) +
        ", closure " + std::string(Name(rhythm.closure)) + ", range " +
        std::string(Name(*rhythm.range)) + ", table " +
        (options_.table ? std::string(Name(*options_.table)) + " (Ludewig et al. 2009)"
         : options_.actuation == Actuation::kPlugin ? "in the plugin's configuration"
                                                    : "the user's own") +
        (is_loop ? ", assembly loop, the " +
                       std::string(kLeadNames[static_cast<std::size_t>(options_.lead)]) + " leads"
                 : ""));
    root.AddComment("A joint coordinate is the measured Euler angle [rad]: SC and " +
                    std::string(is_loop ? "ST" : "AC") + " Y-X'-Z'', GH X-Z'-Y'', ISB frames" +
                    (is_loop ? "; the slides are PAC's place [m]" : "") +
                    "; qpos0 is where controls of zero lead");
  }

  // Stiffness of the servo of a coordinate; none for what follows.
  [[nodiscard]] double StiffnessOf(std::size_t coordinate) const {
    const bool follows = options_.lead == Lead::kScapula && coordinate < 2;
    return follows ? 0 : kJointDynamics[coordinate / 3].stiffness_N_m_per_rad;
  }

  void WriteInstance(XmlElement plugin, Side side) const {
    XmlElement instance = plugin.Add("instance").Set("name", SidedName(kRhythmName, side));
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
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      stiffness += (stiffness.empty() ? "" : " ") + NumberText(StiffnessOf(k));
    }
    configure(kStiffnessKey, stiffness);
    if (options_.lead == Lead::kScapula) {
      configure(kTranslationStiffnessKey, NumberText(kLeadingTranslation.stiffness_N_per_m));
    }
    if (side == Side::kLeft) {
      configure(kSideKey, kSideNames[static_cast<std::size_t>(side)]);
    }
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
    girdle.Add("tendon")
        .Set("width", kLigamentRadius_m)
        .Set("group", 2)
        .Set("rgba", std::array{0.93, 0.93, 0.88, 1.0});
  }

  void WriteAssets(XmlElement asset) const {
    asset.Add("material").Set("name", "bone").Set("rgba", std::array{0.89, 0.85, 0.76, 1.0});
    asset.Add("material").Set("name", "rib").Set("rgba", std::array{0.75, 0.77, 0.8, 1.0});
    WriteMesh(asset, "ribcage", RibcageMesh(anatomy_));
    for (const Side side : sides_) {
      WriteMesh(asset, SidedName("clavicle", side), OnSide(side, ClavicleMesh(anatomy_)));
      WriteMesh(asset, SidedName("scapula", side), OnSide(side, ScapulaMesh(anatomy_)));
      WriteMesh(asset, SidedName("humerus", side), OnSide(side, HumerusMesh(anatomy_)));
    }
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
    asset.Add("mesh").Set("name", name).Set("vertex", vertices).Set("face", faces);
  }

  void WriteBodies(XmlElement world) const {
    XmlElement thorax = world.Add("body")
                            .Set("name", "thorax")
                            .Set("pos", Vector3{0, 0, anatomy_.jugular_notch_height_m})
                            .Set("quat", ThoraxInWorld())
                            .Set("childclass", "girdle");
    WriteInertial(thorax, Segment::kThorax, sides_.front());
    thorax.Add("geom")
        .Set("name", "ribcage")
        .Set("type", "mesh")
        .Set("mesh", "ribcage")
        .Set("material", "rib");
    WriteUnsidedLandmarks(thorax);
    for (const Side side : sides_) {
      WriteLandmarks(thorax, Segment::kThorax, side);
      if (options_.has_thorax_contact) {
        thorax.Add("geom")
            .Set("name", SidedName(kGlidingName, side))
            .Set("type", "ellipsoid")
            .Set("size", anatomy_.gliding.radii_m)
            .Set("pos", OnSide(side, anatomy_.gliding.center_m))
            .Set("group", 4);
      }
    }
    for (const Side side : sides_) {
      XmlElement clavicle =
          WriteBone(thorax, Segment::kClavicle, 0, anatomy_.landmark_m(Landmark::kSC), side);
      const bool is_loop = options_.assembly == Assembly::kLoop;
      XmlElement scapula =
          is_loop ? WriteBone(thorax, Segment::kScapula, 1, PlaceOfScapula(rest_), side)
                  : WriteBone(clavicle, Segment::kScapula, 1, anatomy_.landmark_m(Landmark::kPAC),
                              side);
      WriteBone(scapula, Segment::kHumerus, 2, anatomy_.landmark_m(Landmark::kGH), side);
    }
  }

  // PAC in the thorax frame [m] where the clavicle takes it.
  [[nodiscard]] Vector3 PlaceOfScapula(const ShoulderPose& pose) const {
    return LandmarkInThorax_m(anatomy_, pose, Landmark::kPAC);
  }

  // A moving bone, at `p_m` of its parent, hanging there by the three hinges of `joint`; a scapula
  // that hangs from the thorax by three slides as well.
  XmlElement WriteBone(XmlElement& parent, Segment segment, std::size_t joint, const Vector3& p_m,
                       Side side) const {
    const std::string name = SidedName(kSegmentNames[static_cast<std::size_t>(segment)], side);
    const EulerSequence sequence = kJointSequences[joint];
    const Vector3 reference_rad{rest_rad_[3 * joint], rest_rad_[3 * joint + 1],
                                rest_rad_[3 * joint + 2]};
    const Quaternion reference = QuaternionFromEuler(sequence, reference_rad);
    XmlElement body = parent.Add("body")
                          .Set("name", name)
                          .Set("pos", OnSide(side, p_m))
                          .Set("quat", OnSide(side, reference))
                          .Set("gravcomp", 1);
    WriteInertial(body, segment, side);
    if (segment == Segment::kScapula && options_.assembly == Assembly::kLoop) {
      WriteSlides(body, p_m, glm::conjugate(reference), side);
    }
    const std::array<Vector3, 3> axes = HingeAxes(sequence, reference_rad);
    for (std::size_t hinge = 0; hinge < 3; ++hinge) {
      const std::size_t k = 3 * joint + hinge;
      const CoordinateRange& range = RangeOf(k);
      body.Add("joint")
          .Set("name", SidedName(coordinates_[k], side))
          .Set("axis", AxisOnSide(side, axes[hinge]))
          .Set("ref", rest_rad_[k])
          .Set("range", std::array{range.lower_rad, range.upper_rad})
          .Set("damping", StiffnessOf(k) > 0 ? kJointDynamics[joint].damping_N_m_s_per_rad
                                             : kFollowerDamping_N_m_s_per_rad)
          .Set("armature", kJointDynamics[joint].armature_kg_m2);
    }
    body.Add("geom").Set("name", name).Set("type", "mesh").Set("mesh", name);
    body.Add("site").Set("name", SidedName(kJointSites[joint].child, side));
    WriteLandmarks(body, segment, side);
    WriteLigamentEnds(body, segment, side);
    if (segment == Segment::kScapula && options_.has_thorax_contact) {
      for (const Landmark landmark : kGliding) {
        body.Add("geom")
            .Set("name", LandmarkName(landmark, side))
            .Set("type", "sphere")
            .Set("size", kContactRadius_m)
            .Set("pos", OnSide(side, anatomy_.landmark_m(landmark)))
            .Set("group", 4);
      }
    }
    return body;
  }

  [[nodiscard]] static std::string LandmarkName(Landmark landmark, Side side) {
    return SidedName(kLandmarks[static_cast<std::size_t>(landmark)].name, side);
  }

  void WriteLigamentEnds(XmlElement& body, Segment segment, Side side) const {
    const std::string_view bone = kSegmentNames[static_cast<std::size_t>(segment)];
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      const Ligament& ligament = anatomy_.ligaments[i];
      if (segment == Segment::kClavicle || segment == Segment::kScapula) {
        body.Add("site")
            .Set("name", SidedName(LigamentEndName(kLigamentNames[i], bone), side))
            .Set("pos", OnSide(side, segment == Segment::kClavicle ? ligament.clavicle_m
                                                                   : ligament.scapula_m));
      }
    }
  }

  // Ligaments pull and never push: from no length to slack there is no force.
  void WriteLigaments(XmlElement tendon, const LigamentLengths& slack_m) const {
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      const Ligament& ligament = anatomy_.ligaments[i];
      for (const Side side : sides_) {
        XmlElement spatial =
            tendon.Add("spatial")
                .Set("name", SidedName(kLigamentNames[i], side))
                .Set("class", "girdle")
                .Set("stiffness", ligament.stiffness_N_per_m)
                .Set("springlength", std::array{0.0, slack_m[i]})
                .Set("range",
                     std::array{0.0, RoundedToStep(slack_m[i] + ligament.failure_elongation_m)});
        for (const Segment segment : {Segment::kClavicle, Segment::kScapula}) {
          const std::string_view bone = kSegmentNames[static_cast<std::size_t>(segment)];
          spatial.Add("site").Set("site",
                                  SidedName(LigamentEndName(kLigamentNames[i], bone), side));
        }
      }
    }
  }

  // Nothing else collides, so that the pairs alone say what touches.
  void WriteContacts(XmlElement contact) const {
    const std::array<double, 2>& solref =
        options_.assembly == Assembly::kTree ? kTreeThoraxContactSolref : kLoopThoraxContactSolref;
    for (const Side side : sides_) {
      for (const Landmark landmark : kGliding) {
        contact.Add("pair")
            .Set("name", LandmarkName(landmark, side))
            .Set("geom1", SidedName(kGlidingName, side))
            .Set("geom2", LandmarkName(landmark, side))
            .Set("condim", 1)
            .Set("solref", solref)
            .Set("solimp", kThoraxContactSolimp);
      }
    }
  }

  // The slides go along the thorax's axes, which the body's own frame has at q_ST.
  void WriteSlides(XmlElement& body, const Vector3& p_m, const Quaternion& q_ST, Side side) const {
    const TranslationDynamics& dynamics =
        options_.lead == Lead::kScapula ? kLeadingTranslation : kFollowingTranslation;
    for (int i = 0; i < 3; ++i) {
      Vector3 axis{0, 0, 0};
      axis[i] = 1;
      body.Add("joint")
          .Set("name", SidedName(kTranslationNames[static_cast<std::size_t>(i)], side))
          .Set("type", "slide")
          .Set("axis", OnSide(side, q_ST * axis))
          .Set("ref", p_m[i])
          .Set("damping", dynamics.damping_N_s_per_m)
          .Set("armature", dynamics.armature_kg);
    }
  }

  void WriteInertial(XmlElement& body, Segment segment, Side side) const {
    const SegmentInertia& inertia = anatomy_.segment(segment);
    Vector3 center_m = OnSide(side, inertia.center_of_mass_m);
    if (segment == Segment::kThorax && sides_.size() > 1) {
      center_m.z = 0;
    }
    body.Add("inertial")
        .Set("pos", center_m)
        .Set("mass", inertia.mass_kg)
        .Set("diaginertia", inertia.inertia_kg_m2);
  }

  void WriteUnsidedLandmarks(XmlElement& thorax) const {
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      if (!kLandmarks[i].sided) {
        thorax.Add("site")
            .Set("name", kLandmarks[i].name)
            .Set("pos", sides_.size() > 1 ? InMedianPlane(anatomy_.landmarks_m[i])
                                          : OnSide(sides_.front(), anatomy_.landmarks_m[i]));
      }
    }
  }

  void WriteLandmarks(XmlElement& body, Segment segment, Side side) const {
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      if (kLandmarks[i].segment == segment && kLandmarks[i].sided) {
        body.Add("site")
            .Set("name", SidedName(kLandmarks[i].name, side))
            .Set("pos", OnSide(side, anatomy_.landmarks_m[i]));
      }
    }
  }

  void WriteSkin(XmlElement deformable, XmlElement custom) const {
    deformable.Add("skin")
        .Set("name", kSkinName)
        .Set("file", options_.skin->file)
        .Set("rgba", kSkinColor);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
        const std::vector<int>& vertices = options_.skin->landmarks[i][k];
        custom.Add("numeric")
            .Set("name", SidedName(kSkinLandmarkNames[k], sides_[i]))
            .Set("data", std::vector<double>(vertices.begin(), vertices.end()));
      }
    }
  }

  void WriteEqualities(XmlElement equality) const {
    for (const Side side : sides_) {
      equality.Add("connect")
          .Set("name", SidedName(kConnectName, side))
          .Set("site1", SidedName(kJointSites[1].parent, side))
          .Set("site2", SidedName(kJointSites[1].child, side))
          .Set("solref", kConnectSolref)
          .Set("solimp", kConnectSolimp);
    }
  }

  void WritePluginActuators(XmlElement& actuator, Side side) const {
    const ArmRectangle& domain = rhythm_.domain();
    // A command has no force of its own; MuJoCo wants it to act on something all the same.
    const auto write_command = [&](std::string_view name, const CoordinateRange& range) {
      actuator.Add("plugin")
          .Set("name", SidedName(name, side))
          .Set("joint", SidedName(kCoordinateNames[kGhAxialIndex], side))
          .Set("instance", SidedName(kRhythmName, side))
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
    const auto write_servo = [&](std::string_view coordinate, double trim) {
      actuator.Add("plugin")
          .Set("name", SidedName(coordinate, side))
          .Set("joint", SidedName(coordinate, side))
          .Set("instance", SidedName(kRhythmName, side))
          .Set("ctrlrange", std::array{-trim, trim});
    };
    for (const std::string_view coordinate : coordinates_) {
      write_servo(coordinate, kTrimRange_rad);
    }
    if (options_.lead == Lead::kScapula) {
      for (const std::string_view translation : kTranslationNames) {
        write_servo(translation, kTranslationTrimRange_m);
      }
    }
  }

  void WritePositionActuators(XmlElement& actuator, Side side) const {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      if (StiffnessOf(k) > 0) {
        const CoordinateRange& range = RangeOf(k);
        actuator.Add("position")
            .Set("name", SidedName(coordinates_[k], side))
            .Set("joint", SidedName(coordinates_[k], side))
            .Set("kp", StiffnessOf(k))
            .Set("ctrlrange", std::array{range.lower_rad, range.upper_rad});
      }
    }
    if (options_.lead == Lead::kScapula) {
      for (const std::string_view translation : kTranslationNames) {
        actuator.Add("position")
            .Set("name", SidedName(translation, side))
            .Set("joint", SidedName(translation, side))
            .Set("kp", kLeadingTranslation.stiffness_N_per_m);
      }
    }
  }

  // The axial turns that keep the table's own GH within its range at every position. Where closure
  // has turned GH further the rhythm bounds them by the joint's range.
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
    for (const NamedPose& named : kKeyframes) {
      const ShoulderSolution solution = rhythm_.Solve(
          {RadiansFromDegrees(named.elevation_deg), RadiansFromDegrees(named.plane_deg)});
      // Only rest is the nearest pose there is; the others are what their names say or are not
      // there.
      if (named.name != kRestName && solution.clamped) {
        continue;
      }
      const ShoulderPose target = assembled_.SolvePose(solution.used);
      const ShoulderPose pose =
          named.name == kRelaxedName ? HangingIn(RelaxedStanding(), rhythm_) : target;
      std::vector<double> positions;
      std::vector<double> controls;
      for (std::size_t side = 0; side < sides_.size(); ++side) {
        AppendPositions(positions, pose);
        AppendControls(controls, solution.used, target, pose);
      }
      keyframe.Add("key").Set("name", named.name).Set("qpos", positions).Set("ctrl", controls);
    }
  }

  // One side's joints, body by body.
  void AppendPositions(std::vector<double>& positions, const ShoulderPose& pose) const {
    const JointAngles angles_rad = DrivenAngles(options_.assembly, pose);
    positions.insert(positions.end(), angles_rad.begin(), angles_rad.begin() + 3);
    if (options_.assembly == Assembly::kLoop) {
      const Vector3 p_m = PlaceOfScapula(pose);
      positions.insert(positions.end(), {p_m.x, p_m.y, p_m.z});
    }
    positions.insert(positions.end(), angles_rad.begin() + 3, angles_rad.end());
  }

  // One side's controls that hold the joints at `pose`: the plugin's trims make up for what it is
  // off the plugin's own target.
  void AppendControls(std::vector<double>& controls, const ArmCommand& command,
                      const ShoulderPose& target, const ShoulderPose& pose) const {
    const JointAngles target_rad = DrivenAngles(options_.assembly, target);
    const JointAngles angles_rad = DrivenAngles(options_.assembly, pose);
    const Vector3 p_m = PlaceOfScapula(pose);
    const bool has_place = options_.lead == Lead::kScapula;
    if (options_.actuation == Actuation::kPosition) {
      for (std::size_t k = 0; k < kCoordinateCount; ++k) {
        if (StiffnessOf(k) > 0) {
          controls.push_back(angles_rad[k]);
        }
      }
      if (has_place) {
        controls.insert(controls.end(), {p_m.x, p_m.y, p_m.z});
      }
      return;
    }
    controls.insert(controls.end(), {command.elevation_rad, command.plane_rad, 0});
    controls.resize(controls.size() + (options_.has_offsets ? kOffsetCount : 0) +
                    (options_.has_rates ? kRateCount : 0));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      controls.push_back(angles_rad[k] - target_rad[k]);
    }
    if (has_place) {
      const Vector3 trim_m = p_m - PlaceOfScapula(target);
      controls.insert(controls.end(), {trim_m.x, trim_m.y, trim_m.z});
    }
  }

  const Anatomy& anatomy_;
  AssembledRhythm assembled_;
  const ShoulderRhythm& rhythm_;  ///< of assembled_
  const ShoulderModelOptions& options_;
  std::vector<Side> sides_;
  std::array<std::string_view, kCoordinateCount> coordinates_;
  ShoulderPose rest_;
  JointAngles rest_rad_;
  XmlFile file_{"mujoco"};
};

}  // namespace

std::vector<Side> SidesOf(Sides sides) {
  switch (sides) {
    case Sides::kRight:
      return {Side::kRight};
    case Sides::kLeft:
      return {Side::kLeft};
    case Sides::kBoth:
      break;
  }
  return {Side::kRight, Side::kLeft};
}

std::string ShoulderModelXml(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                             const ShoulderModelOptions& options) {
  return ShoulderModelWriter(anatomy, rhythm, options).Write();
}

}  // namespace girdle
