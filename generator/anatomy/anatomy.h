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

/// Bony landmarks, with the abbreviations of the ISB.
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

/// Name and place of a landmark.
struct LandmarkDefinition {
  std::string_view name;
  Segment segment;    ///< the segment in whose frame it is given
  bool sided = true;  ///< false for landmarks in the median plane of the body
};

/// Definitions in the order of Landmark.
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

/// Landmarks of the scapula's medial border, which glides on the thorax.
inline constexpr std::array<Landmark, 2> kGlidingLandmarks = {Landmark::kTS, Landmark::kAI};

/// Mass properties in the segment's own frame. The principal axes of inertia are the axes of that
/// frame.
struct SegmentInertia {
  double mass_kg = 0;
  Vector3 center_of_mass_m{0, 0, 0};
  Vector3 inertia_kg_m2{0, 0, 0};  ///< about the centre of mass, along x, y, z
};

/// An ellipsoid in the thorax frame. Its axes are parallel to those of the frame.
struct Ellipsoid {
  Vector3 center_m{0, 0, 0};
  Vector3 radii_m{0, 0, 0};
};

/// Stature [m] of the person of data/. The stature of the measured specimen is unknown. This is the
/// stature of a man with such a humerus (Trotter and Gleser 1952: 3.08 x length + 70.45 cm,
/// standard error 4 cm). The length is that of the whole humerus: GH to elbow, plus 2.3 cm of head
/// above and 1.5 cm of joint surface below.
inline constexpr double kAdultStature_m = 1.71;
/// Height of a standing person's jugular notch as a share of the stature. Drillis and
/// Contini 1966 call this height the shoulder's.
inline constexpr double kJugularNotchShare = 0.82;
/// The two parts of the coracoclavicular ligament.
enum class LigamentName { kConoid, kTrapezoid };
inline constexpr std::size_t kLigamentCount = 2;
inline constexpr std::array<std::string_view, kLigamentCount> kLigamentNames = {"conoid",
                                                                                "trapezoid"};
constexpr const auto& WordsOf(LigamentName /*which*/) noexcept { return kLigamentNames; }

/// A straight band from the clavicle to the scapula. It pulls if it is longer than its slack length
/// and never pushes.
struct Ligament {
  Vector3 clavicle_m{0, 0, 0};  ///< attachment, clavicle frame
  Vector3 scapula_m{0, 0, 0};   ///< attachment, scapula frame
  double slack_m = 0;           ///< longest length without force
  double stiffness_N_per_m = 0;
  double failure_elongation_m = 0;  ///< beyond slack; a ligament tears at this elongation
  double published_m = 0;           ///< length measured in cadavers, mean; for comparison only
  double published_sd_m = 0;        ///< standard deviation of the published length
};

/// The anatomy of one right shoulder. Lengths are meters in the frame of the named segment, angles
/// radians.
struct Anatomy {
  std::array<Vector3, kLandmarkCount> landmarks_m{};  ///< each in the frame of its own segment
  std::array<SegmentInertia, kSegmentCount> segments{};
  JointRanges ranges{};
  /// Ranges of the scapula in the thorax, in the order of kScapulothoracicNames.
  std::array<CoordinateRange, 3> scapulothoracic_ranges{};
  Ellipsoid ribcage;                                 ///< the surface that is drawn as the thorax
  Ellipsoid gliding;                                 ///< the surface that the scapula glides on
  std::array<Ligament, kLigamentCount> ligaments{};  ///< in the order of LigamentName
  /// How GH was found if it was not measured; empty if it was measured. The text is a sentence
  /// without its subject and its full stop.
  std::string gh_origin;
  /// Whether the bones are those of data/ or scaled copies of them. Only for these it is known how
  /// closely TS and AI follow `gliding`.
  bool has_adult_proportions = true;
  /// Height of IJ above the floor in standing.
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
  /// Midpoint of the epicondyles [m], in the humerus frame.
  [[nodiscard]] Vector3 elbow_m() const noexcept {
    return (landmark_m(Landmark::kEM) + landmark_m(Landmark::kEL)) / 2.0;
  }
};

/// Returns the position of a thorax landmark without side in a model of both shoulders: in the
/// median plane. The thorax frame does not change.
[[nodiscard]] inline Vector3 InMedianPlane(const Vector3& p_T) noexcept {
  return {p_T.x, p_T.y, 0};
}

/// Each function reads one file of an anatomy into `anatomy`. It throws InputError, with file and
/// line, at the first invalid value. Invalid are: unknown, missing or repeated rows; a landmark in
/// the frame of another segment; a landmark more than a metre away (millimetres instead of metres);
/// a mass, inertia or radius that is not positive; an inertia that no body can have; an empty
/// range; a ligament that is longer than a shoulder or has no stiffness.
void ReadLandmarks(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadSegments(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadJointRanges(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadThoraxEllipsoids(std::istream& in, const std::string& name, Anatomy& anatomy);
void ReadLigaments(std::istream& in, const std::string& name, Anatomy& anatomy);

/// Returns the anatomy's landmarks as a file that ReadLandmarks and ReadPersonAnatomy read:
/// `comments`, each a line that begins with `#`, then the header, then the rows. Reading the file
/// gives exactly the same numbers.
[[nodiscard]] std::string LandmarksToCsv(const Anatomy& anatomy,
                                         const std::vector<std::string>& comments);

/// Returns the anatomy's ellipsoids as a file that ReadThoraxEllipsoids reads: `comments`, each a
/// line that begins with `#`, then the header, then the rows. Numbers are rounded to
/// kLengthDecimals.
[[nodiscard]] std::string ThoraxEllipsoidsToCsv(const Anatomy& anatomy,
                                                const std::vector<std::string>& comments);

}  // namespace girdle
