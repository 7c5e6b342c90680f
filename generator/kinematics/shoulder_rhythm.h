// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Data-driven shoulder inverse kinematics: from where the arm points to the rotations of SC, AC
/// and GH.
///
/// Kim, Park, Jung, Han, "Data-driven shoulder inverse kinematics"; equation numbers are theirs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>

#include "kinematics/arm_directions.h"
#include "kinematics/arm_reach.h"
#include "kinematics/rhythm_table.h"
#include "kinematics/shoulder_pose.h"
#include "kinematics/words.h"

namespace girdle {

class SmoothRhythm;
class SquadRhythm;

/// How rotations between the measured positions are found.
enum class Interpolation {
  kSmooth,  ///< twice continuously differentiable in both directions, see smooth_rhythm.h
  kSquad,   ///< as published: C1 along elevation, continuous along plane
  kSlerp,   ///< the paper's comparison: continuous
};

/// How the three joints are made to agree with the direction commanded.
enum class Closure {
  /// SC and AC from the table, GH such that the humerus points exactly where it was commanded to,
  /// with the table's own turn about its long axis: GH = (q_TC q_CS)^-1 q_TH.
  kExact,
  kTable,  ///< as published: all three joints come from the table, the arm goes where they take it
};

/// What happens outside the table.
enum class Range {
  kWhole,  ///< all that an arm can reach (arm_reach.h), by the rule of smooth_rhythm.h
  kClamp,  ///< the table's nearest elevation answers, and its nearest plane
};

/// What an axial turn is counted from: which humerus of a direction has axial 0 (axial_zero.h).
enum class AxialFrom {
  /// The rhythm's own humerus: exact closure's S Ry(tau), or the table's.
  kRhythm,
  /// ISB's third humerothoracic angle: q_TH = Y(plane) X(-elevation) Y(axial). As the plane it has
  /// no meaning of its own hanging and straight up: there plane and axial mean something together.
  kIsb,
  /// The humerus with ISB's zero at elevation 90, plane 20, swung from there to the direction by
  /// the smallest rotation: one humerus for a direction, hanging and straight up as well.
  kSwing,
};

/// Words of the command line and of the plugin's configuration, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kInterpolationNames = {"smooth", "squad", "slerp"};
inline constexpr std::array<std::string_view, 2> kClosureNames = {"exact", "table"};
inline constexpr std::array<std::string_view, 2> kRangeNames = {"whole", "clamp"};
inline constexpr std::array<std::string_view, 3> kAxialFromNames = {"rhythm", "isb", "swing"};

constexpr const auto& WordsOf(Interpolation /*which*/) noexcept { return kInterpolationNames; }
constexpr const auto& WordsOf(Closure /*which*/) noexcept { return kClosureNames; }
constexpr const auto& WordsOf(Range /*which*/) noexcept { return kRangeNames; }
constexpr const auto& WordsOf(AxialFrom /*which*/) noexcept { return kAxialFromNames; }

/// The method as published is {kSquad, kTable}.
struct RhythmOptions {
  Interpolation interpolation = Interpolation::kSmooth;
  Closure closure = Closure::kExact;
  /// Nothing stands for whole where there is a rule for it, with smooth and exact, else clamp.
  std::optional<Range> range = std::nullopt;
};

/// The range that options without one stand for.
[[nodiscard]] Range DefaultRange(Interpolation interpolation, Closure closure) noexcept;

/// What is asked of the shoulder.
struct ArmCommand {
  double elevation_rad = 0;  ///< angle between humerus and hanging down, [0, pi]
  double plane_rad = 0;      ///< 0 frontal, pi/2 sagittal
  double axial_rad =
      0;  ///< turn about the humerus's own long axis, counted from `axial_from`, internal +
  double shrug_rad = 0;        ///< clavicle raised beyond the rhythm, up +
  double protraction_rad = 0;  ///< clavicle protracted beyond the rhythm, forward +
  AxialFrom axial_from = AxialFrom::kRhythm;

  [[nodiscard]] bool operator==(const ArmCommand&) const noexcept = default;
};

/// Where a solution comes from.
enum class Origin {
  kMeasured,  ///< between measured positions
  kDerived,   ///< between positions one of which has a derived SC and AC (RhythmPosition::measured)
  kModelled,  ///< outside the table, by a rule
};
inline constexpr std::array<std::string_view, 3> kOriginNames = {"measured", "derived", "modelled"};
constexpr const auto& WordsOf(Origin /*which*/) noexcept { return kOriginNames; }

/// Result of the inverse kinematics. "Not reached" is part of it, not an error.
struct ShoulderSolution {
  ShoulderPose pose;
  /// The command that the pose answers: a direction in the range (ArmReach says which one) and, for
  /// axial, shrug and protraction, what the joints' ranges allow. Its axial turn is counted from
  /// the rhythm's own.
  ArmCommand used;
  /// ShoulderRhythm::IsClamped of the two.
  bool clamped;
  Origin origin;
  /// The table's cell that holds the command used, or the nearest to it.
  RhythmCell cell;
  /// Angle between the direction commanded, or the one used if that is farther, and the nearest
  /// direction of the table's domain [rad]; 0 inside.
  double distance_rad;
};

/// How a joint turns with the command: angular velocities of the child in the parent, in the
/// parent's axes [rad/rad].
struct AngularRate {
  Vector3 by_elevation;
  Vector3 by_plane;
};

/// A pose and its first derivatives, SC, AC, GH.
struct ShoulderRates {
  ShoulderPose pose;
  std::array<AngularRate, kJointCount> joints;
};

/// First derivatives of the joint coordinates [rad/rad], in the order of kCoordinateNames.
struct AngleRates {
  JointAngles by_elevation;
  JointAngles by_plane;
};

/// First and second derivatives of one joint's rotation: its angular velocities as above and what
/// they change by [rad/rad^2].
struct RotationDerivatives {
  AngularRate rate;
  Vector3 by_elevation_twice;      ///< of rate.by_elevation by elevation
  Vector3 by_elevation_and_plane;  ///< of rate.by_elevation by plane
  Vector3 by_plane_twice;          ///< of rate.by_plane by plane
};

/// First and second derivatives of one joint coordinate [rad/rad, rad/rad^2].
struct AngleDerivatives {
  double by_elevation;
  double by_plane;
  double by_elevation_twice;
  double by_elevation_and_plane;
  double by_plane_twice;
};

struct ShoulderDerivatives {
  std::array<RotationDerivatives, kJointCount> joints;
  std::array<AngleDerivatives, kCoordinateCount> angles;  ///< in the order of kCoordinateNames
};

/// Interpolant of a measured shoulder rhythm. Immutable; evaluation is thread-safe and allocates
/// nothing. Copies share what is interpolated. An object that was moved from can only be destroyed
/// or assigned to.
class ShoulderRhythm {
 public:
  /// `ranges` bound what axial, shrug and protraction add; the rhythm itself they do not touch.
  /// Throws std::invalid_argument if neighbouring planes differ by 180 degrees or more, so that the
  /// way between them is not determined; if the table has too few knots for the interpolation; or
  /// if the whole range is wanted where there is no rule for it.
  explicit ShoulderRhythm(RhythmTable table, RhythmOptions options = {},
                          const JointRanges& ranges = Unbounded());

  /// Returns the pose for a command. Total: the plane is an angle, so that whole turns do not
  /// matter; a direction outside the range is answered by ArmReach::AnswerTo, with the range clamp
  /// by the nearest elevation and plane; a NaN, and a plane that is not finite, counts as the
  /// lowest elevation or plane, and an axial turn or offset that is not finite as none: the
  /// rhythm's own.
  ///
  /// Where a direction is answered by another one, an axial turn from the rhythm's or the swing's
  /// zero stays the number that it is, and one from ISB's is carried: the humerus that was asked
  /// for is taken to the direction that answers by the smallest rotation. Of a carried turn,
  /// counted from the rhythm's own, ShareOfCarried of axial_zero.h counts, all of it up to 60 deg
  /// away.
  ///
  /// An axial turn from the rhythm's zero is a number: what is beyond GH's range is answered by its
  /// nearer end. One from ISB's or the swing's is an angle of the humerus, of which data write 350
  /// for -10: of the turns that differ by 360 deg it is that for which GH's axial coordinate is
  /// within half a turn of kGhAxialMiddle_rad. An angle cannot be brought to a range without a
  /// jump. There is one, where GH's axial coordinate would be 135 or, the same, -225 deg: the
  /// answer goes back by up to 360 deg times the share of the turn that counts, and by no more than
  /// from one end of GH's range to the other, with the built-in ranges 240 deg. Everywhere else,
  /// and with the rhythm's zero everywhere, the answer of the range whole to commands without
  /// offsets is continuous.
  ///
  /// With squad or slerp: equations (4) to (12). Offsets turn the clavicle's angles; the scapula
  /// keeps its place on the clavicle, and with closure exact the arm its direction.
  [[nodiscard]] ShoulderSolution Solve(const ArmCommand& command) const noexcept;

  /// The pose alone, in less time; `used` takes the command that it answers.
  [[nodiscard]] ShoulderPose SolvePose(const ArmCommand& command,
                                       ArmCommand* used = nullptr) const noexcept;

  /// The axial turn that a command asks for [rad], counted from another zero where the command is
  /// answered: ISB's from the plane of the command, the others from the direction that answers it.
  /// Where a share of ISB's counts and no turn gives as much, it is the one that gives most.
  [[nodiscard]] double AxialCountedFrom(AxialFrom zero, const ArmCommand& command) const noexcept;

  /// Returns the share of a command's axial turn that counts, in [0, 1], and of its rate: 1 unless
  /// ISB's is carried by more than 60 deg.
  [[nodiscard]] double AxialShare(const ArmCommand& command) const noexcept;

  /// The axial turn that a pose has [rad], in [-pi, pi], counted from a zero; `used` is the command
  /// that the pose answers. With closure exact and kIsb it is the third angle Y-X'-Y'' of q_TH.
  /// With closure table the arm may point beside where it was told to; the zero is then the one of
  /// where it was told to, and turns are those that are left when S of axial_zero.h is taken away.
  [[nodiscard]] double AxialOf(AxialFrom zero, const ShoulderPose& pose,
                               const ArmCommand& used) const noexcept;

  /// Whether a command that is answered with the one used is clamped: another direction, turn or
  /// offset than the one given. Planes a whole turn apart are one, and hanging all are.
  [[nodiscard]] bool IsClamped(const ArmCommand& command, const ArmCommand& used) const noexcept;

  /// Returns the pose with its derivatives by the elevation and plane commanded, exact but for
  /// rounding; nothing unless the interpolation is smooth. Where the command is not reached they
  /// are those of what answers it, and where a bound or a change of the rule's form makes a kink
  /// they are one of the two. Where it is GH's range that bounds the offsets they count as
  /// constant.
  [[nodiscard]] std::optional<ShoulderRates> SolveRates(const ArmCommand& command) const noexcept;
  [[nodiscard]] std::optional<AngleRates> SolveAngleRates(const ArmCommand& command) const noexcept;
  [[nodiscard]] std::optional<ShoulderDerivatives> SolveDerivatives(
      const ArmCommand& command) const noexcept;

  /// Returns the angle between a direction and the nearest one of the table's domain [rad]; 0
  /// inside, and for a NaN.
  [[nodiscard]] double DistanceOutside(double elevation_rad, double plane_rad) const noexcept;

  [[nodiscard]] const RhythmTable& table() const noexcept { return table_; }
  /// With the range said.
  [[nodiscard]] const RhythmOptions& options() const noexcept { return options_; }
  [[nodiscard]] const JointRanges& ranges() const noexcept { return ranges_; }
  /// Elevations and planes of commands that are not clamped: with the range whole, behind the
  /// frontal plane only as far as LowestPlaneAt.
  [[nodiscard]] const ArmRectangle& domain() const noexcept { return domain_; }
  /// The lowest plane that is not clamped at an elevation of the domain [rad].
  [[nodiscard]] double LowestPlaneAt(double elevation_rad) const noexcept {
    return options_.range == Range::kWhole ? reach_.LowestPlaneAt(elevation_rad)
                                           : domain_.first_plane_rad;
  }

  /// Ranges that bound nothing.
  [[nodiscard]] static JointRanges Unbounded() noexcept;

 private:
  friend class ManySolver;  // of solve_many.cc: the steps of Solve, each for a block of commands

  using Interpolant =
      std::variant<std::shared_ptr<const SmoothRhythm>, std::shared_ptr<const SquadRhythm>>;
  [[nodiscard]] static Interpolant InterpolantOf(const RhythmTable& table,
                                                 Interpolation interpolation);
  /// Null with squad or slerp, which have no derivatives.
  [[nodiscard]] const SmoothRhythm* smooth() const noexcept {
    const auto* const smooth = std::get_if<std::shared_ptr<const SmoothRhythm>>(&interpolant_);
    return smooth == nullptr ? nullptr : smooth->get();
  }
  /// The plane within half a turn of the middle of the domain; NaN for what is not finite.
  [[nodiscard]] double PlaneOnChart(double plane_rad) const noexcept;
  /// The direction asked for as one of the sphere: an elevation in [0, pi], the plane on the chart,
  /// both finite. T is double or a Jet, whose derivatives go through.
  template <typename T>
  [[nodiscard]] ArmDirectionOf<T> AskedDirection(const ArmDirectionOf<T>& direction) const noexcept;
  /// The direction of the range that answers it.
  template <typename T>
  [[nodiscard]] ArmDirectionOf<T> AnswerTo(const ArmDirectionOf<T>& asked) const noexcept;
  /// The rates within the table, without offsets or axial turn.
  [[nodiscard]] ShoulderRates PlainRates(double elevation_rad, double plane_rad) const noexcept;
  /// Whether WithinRange would change nothing, for most commands within the table.
  [[nodiscard]] bool IsPlain(const ArmCommand& command) const noexcept {
    return measured_.Holds(command.elevation_rad, command.plane_rad) && command.axial_rad == 0 &&
           command.shrug_rad == 0 && command.protraction_rad == 0 &&
           command.axial_from == AxialFrom::kRhythm;
  }
  /// T_0 of axial_zero.h for a direction that is asked for and the one that answers it, at which
  /// the rhythm's own turn is tau [rad].
  template <typename T>
  [[nodiscard]] T ZeroOf(AxialFrom zero, const ArmDirectionOf<T>& asked,
                         const ArmDirectionOf<T>& used, const T& tau_rad) const noexcept;
  /// The whole turn of a pose for a direction [rad], in [-pi, pi].
  [[nodiscard]] double WholeTurnOf(const ShoulderPose& pose,
                                   const ArmDirectionOf<double>& used) const noexcept;
  /// AxialShare where `used` answers the direction asked for.
  template <typename T>
  [[nodiscard]] static T ShareOf(AxialFrom zero, const ArmDirectionOf<T>& asked,
                                 const ArmDirectionOf<T>& used) noexcept;
  /// The humerus's turn without an axial one.
  template <typename T>
  struct OwnTurnOf {
    T tau_rad;                  ///< whole turn
    double gh_from_middle_rad;  ///< GH's axial coordinate from kGhAxialMiddle_rad
  };
  [[nodiscard]] OwnTurnOf<double> OwnTurn(const ArmDirectionOf<double>& used) const noexcept;
  /// The axial turn of a command counted from the rhythm's own [rad]; it is finite in the command.
  template <typename T>
  [[nodiscard]] T AxialFromRhythm(const ArmCommand& command, const ArmDirectionOf<T>& asked,
                                  const ArmDirectionOf<T>& used,
                                  const OwnTurnOf<T>& own) const noexcept;
  [[nodiscard]] double AxialFromRhythm(const ArmCommand& command,
                                       const ArmDirectionOf<double>& asked,
                                       const ArmDirectionOf<double>& used) const noexcept;
  /// The direction that answers; the axial turn is counted from the rhythm's own.
  [[nodiscard]] ArmCommand WithinRange(const ArmCommand& command) const noexcept;
  /// The pose for a command within the range; bounds its axial turn and offsets.
  [[nodiscard]] ShoulderPose PoseFor(ArmCommand& used) const noexcept;
  /// The pose without axial turn and offsets.
  [[nodiscard]] ShoulderPose RhythmPoseFor(double elevation_rad, double plane_rad) const noexcept;
  void AddExtras(ShoulderPose& pose, ArmCommand& used) const noexcept {
    if (used.shrug_rad != 0 || used.protraction_rad != 0) [[unlikely]] {
      AddOffsets(pose, used);
    }
    if (used.axial_rad != 0) [[unlikely]] {
      AddAxialTurn(pose, used);
    }
  }
  /// ShoulderSolution::origin and distance_rad.
  [[nodiscard]] Origin OriginFor(const ArmCommand& command, const RhythmCell& cell) const noexcept;
  [[nodiscard]] double DistanceFor(const ArmCommand& command,
                                   const ArmCommand& used) const noexcept;
  /// GH that brings the humerus where it has to be: q_SH = (q_TC q_CS)^-1 q_TH.
  [[nodiscard]] static Quaternion Closed(const ShoulderPose& pose, const Quaternion& q_TH) noexcept;
  /// Turns the clavicle as far as the ranges of SC and GH allow; `used` then says how far.
  void AddOffsets(ShoulderPose& pose, ArmCommand& used) const noexcept;
  void AddAxialTurn(ShoulderPose& pose, ArmCommand& used) const noexcept;
  [[nodiscard]] bool KeepsGhWithin(const ShoulderPose& pose,
                                   const ShoulderPose& rhythm) const noexcept;
  template <int Order>
  struct Jets;
  template <int Order>
  [[nodiscard]] Jets<Order> JetsFor(const ArmCommand& command) const noexcept;

  RhythmTable table_;
  RhythmOptions options_;
  JointRanges ranges_;
  ArmRectangle measured_;  ///< the table's domain
  ArmReach reach_;         ///< of the range whole
  ArmRectangle domain_;
  Interpolant interpolant_;
};

}  // namespace girdle
