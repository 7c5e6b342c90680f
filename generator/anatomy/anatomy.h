// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Bones, masses, joint ranges and thorax surfaces of one right shoulder.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/assembly.h"
#include "kinematics/words.h"

namespace girdle {

enum class Segment { kThorax, kClavicle, kScapula, kHumerus };
inline constexpr std::size_t kSegmentCount = 4;
inline constexpr std::array<std::string_view, kSegmentCount> kSegmentNames = {"thorax", "clavicle",
                                                                              "scapula", "humerus"};
constexpr const auto& WordsOf(Segment /*which*/) noexcept { return kSegmentNames; }

/// Bony landmarks, ISB abbreviations.
enum class Landmark {
  kIJ,   ///< jugular notch, the thorax's origin
  kPX,   ///< xiphoid process
  kC7,   ///< seventh cervical vertebra
  kT8,   ///< eighth thoracic vertebra
  kSC,   ///< sternoclavicular joint, the clavicle's origin
  kPAC,  ///< most dorsal point of the AC joint: the clavicle's end and the scapula's origin
  kTS,   ///< root of the scapular spine
  kAI,   ///< inferior angle
  kAA,   ///< acromial angle
  kPC,   ///< coracoid process
  kACJ,  ///< centre of the AC joint
  kGC,   ///< centre of the glenoid
  kGH,   ///< glenohumeral rotation centre, the humerus's origin
  kEM,   ///< medial epicondyle
  kEL,   ///< lateral epicondyle
};
inline constexpr std::size_t kLandmarkCount = 15;

struct LandmarkDefinition {
  std::string_view name;
  Segment segment;    ///< in whose frame it is given
  bool sided = true;  ///< false in the mid-plane of the body
};

/// In the order of Landmark.
inline constexpr std::array<LandmarkDefinition, kLandmarkCount> kLandmarks = {{
    {"IJ", Segment::kThorax, false},
    {"PX", Segment::kThorax, false},
    {"C7", Segment::kThorax, false},
    {"T8", Segment::kThorax, false},
    {"SC", Segment::kThorax},
    {"PAC", Segment::kClavicle},
    {"TS", Segment::kScapula},
    {"AI", Segment::kScapula},
    {"AA", Segment::kScapula},
    {"PC", Segment::kScapula},
    {"ACJ", Segment::kScapula},
    {"GC", Segment::kScapula},
    {"GH", Segment::kScapula},
    {"EM", Segment::kHumerus},
    {"EL", Segment::kHumerus},
}};

inline constexpr std::array<std::string_view, kLandmarkCount> kLandmarkNames = [] {
  std::array<std::string_view, kLandmarkCount> names;
  std::transform(kLandmarks.begin(), kLandmarks.end(), names.begin(),
                 [](const LandmarkDefinition& landmark) { return landmark.name; });
  return names;
}();
constexpr const auto& WordsOf(Landmark /*which*/) noexcept { return kLandmarkNames; }

[[nodiscard]] constexpr const LandmarkDefinition& DefinitionOf(Landmark landmark) noexcept {
  return kLandmarks[static_cast<std::size_t>(landmark)];
}

/// Landmarks of the scapula's medial border: what glides on the thorax.
inline constexpr std::array<Landmark, 2> kGlidingLandmarks = {Landmark::kTS, Landmark::kAI};

/// Mass properties in the segment's own frame; the principal axes are the frame's.
struct SegmentInertia {
  double mass_kg = 0;
  Vector3 center_of_mass_m{0, 0, 0};
  Vector3 inertia_kg_m2{0, 0, 0};  ///< about the centre of mass, along x, y, z
};

/// Surface in the thorax frame, axes parallel to it.
struct Ellipsoid {
  Vector3 center_m{0, 0, 0};
  Vector3 radii_m{0, 0, 0};
};

/// Stature of the person of data/ [m]. The specimen's own is not known to us. It is that of a man
/// with such a humerus (Trotter and Gleser 1952: 3.08 x length + 70.45 cm, standard error 4 cm),
/// which over all is GH to elbow, 2.3 cm of head above and 1.5 cm of joint surface below.
inline constexpr double kAdultStature_m = 1.71;
/// Height of a standing person's jugular notch as a share of the stature (shoulder height of
/// Drillis and Contini 1966, which is that of the notch).
inline constexpr double kJugularNotchShare = 0.82;
/// The two parts of the coracoclavicular ligament.
enum class LigamentName { kConoid, kTrapezoid };
inline constexpr std::size_t kLigamentCount = 2;
inline constexpr std::array<std::string_view, kLigamentCount> kLigamentNames = {"conoid",
                                                                                "trapezoid"};
constexpr const auto& WordsOf(LigamentName /*which*/) noexcept { return kLigamentNames; }

/// A straight band from the clavicle to the scapula that pulls when it is longer than slack and
/// never pushes.
struct Ligament {
  Vector3 clavicle_m{0, 0, 0};  ///< attachment, clavicle frame
  Vector3 scapula_m{0, 0, 0};   ///< attachment, scapula frame
  double slack_m = 0;           ///< longest length without force
  double stiffness_N_per_m = 0;
  double failure_elongation_m = 0;  ///< beyond slack, where ligaments tear
  double published_m = 0;           ///< length measured in cadavers, for comparison only: mean ...
  double published_sd_m = 0;        ///< ... and standard deviation
};

struct Anatomy {
  std::array<Vector3, kLandmarkCount> landmarks_m{};  ///< each in the frame of its segment
  std::array<SegmentInertia, kSegmentCount> segments{};
  JointRanges ranges{};
  /// Of the scapula in the thorax, in the order of kScapulothoracicNames.
  std::array<CoordinateRange, 3> scapulothoracic_ranges{};
  Ellipsoid ribcage;                                 ///< what is drawn as the thorax
  Ellipsoid gliding;                                 ///< what the scapula glides on
  std::array<Ligament, kLigamentCount> ligaments{};  ///< in the order of LigamentName
  /// How GH was found where it was not measured, a sentence without its subject and its full stop;
  /// empty otherwise.
  std::string gh_origin;
  /// Whether the bones are those of data/, or grown alike: only of these it is known how near TS
  /// and AI keep to `gliding`.
  bool has_adult_proportions = true;
  /// Of IJ above the floor in standing.
  double jugular_notch_height_m = kJugularNotchShare * kAdultStature_m;

  [[nodiscard]] const Vector3& landmark_m(Landmark landmark) const noexcept {
    return landmarks_m[static_cast<std::size_t>(landmark)];
  }
  [[nodiscard]] const SegmentInertia& segment(Segment segment) const noexcept {
    return segments[static_cast<std::size_t>(segment)];
  }
  [[nodiscard]] const Ligament& ligament(LigamentName name) const noexcept {
    return ligaments[static_cast<std::size_t>(name)];
  }
  /// Middle between the epicondyles, humerus frame [m].
  [[nodiscard]] Vector3 elbow_m() const noexcept {
    return (landmark_m(Landmark::kEM) + landmark_m(Landmark::kEL)) / 2.0;
  }
};

/// Where a landmark of the thorax that has no side is in a model of both shoulders: in the median
/// plane. The thorax frame, which halves it, stays.
[[nodiscard]] inline Vector3 InMedianPlane(const Vector3& p_T) noexcept {
  return {p_T.x, p_T.y, 0};
}

/// Each reads one file of an anatomy into `anatomy` and throws InputError, with file and line, at
/// the first value that cannot be: unknown, missing or repeated rows, a landmark given in another
/// segment's frame or more than a metre away (millimetres where metres are meant), a mass, inertia
/// or radius that is not positive, an inertia that no body can have, an empty range, a ligament
/// longer than a shoulder or without stiffness.
void ReadLandmarks(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadSegments(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadJointRanges(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadThoraxEllipsoids(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadLigaments(std::istream& in, const std::string& name, Anatomy& anatomy);

/// Returns the anatomy's landmarks as a file that ReadLandmarks and ReadPersonAnatomy read:
/// `comments`, each a line that begins with `#`, the header, the rows. Numbers read back as they
/// are.
[[nodiscard]] std::string LandmarksToCsv(const Anatomy& anatomy,
                                         const std::vector<std::string>& comments);

/// Returns the anatomy's ellipsoids as a file that ReadThoraxEllipsoids reads: `comments`, each a
/// line that begins with `#`, the header, the rows. Numbers are rounded to kLengthDecimals.
[[nodiscard]] std::string ThoraxEllipsoidsToCsv(const Anatomy& anatomy,
                                                const std::vector<std::string>& comments);

}  // namespace girdle
