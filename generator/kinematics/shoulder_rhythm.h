// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Data-driven inverse kinematics of the shoulder: the direction of the arm goes in, the rotations
/// of SC, AC and GH come out.
///
/// Method: Kim, Park, Jung, Han, "Data-driven shoulder inverse kinematics". Equation numbers below
/// are the paper's.
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

/// How rotations between the measured positions are computed.
enum class Interpolation {
  kSmooth,  ///< twice continuously differentiable in both directions, see smooth_rhythm.h
  kSquad,   ///< as published: C1 along elevation, continuous along plane
  kSlerp,   ///< the paper's comparison: continuous
};

/// How the three joints are brought to agree with the commanded direction.
enum class Closure {
  /// SC and AC come from the table. GH makes the humerus point exactly in the commanded direction,
  /// with the table's own turn about its long axis: GH = (q_TC q_CS)^-1 q_TH.
  kExact,
  kTable,  ///< as published: all three joints come from the table; the arm may miss the direction
};

/// How a command outside the table is answered.
enum class Range {
  kWhole,  ///< every direction that an arm reaches (arm_reach.h), by the rule of smooth_rhythm.h
  kClamp,  ///< by the nearest elevation and the nearest plane of the table
};

/// The zero of axial turns: which humerus of a direction has axial 0 (axial_zero.h).
enum class AxialFrom {
  /// The rhythm's own humerus. With closure exact it is the humerus that swings from hanging to the
  /// direction by the smallest rotation, after a turn tau about its long axis that the rhythm
  /// gives; with closure table it is the table's humerus.
  kRhythm,
  /// The third humerothoracic angle of the ISB: q_TH = Y(plane) X(-elevation) Y(axial). If the arm
  /// hangs or points straight up, neither plane nor axial has a meaning alone: only both give the
  /// humerus.
  kIsb,
  /// Start from the humerus with ISB's zero at elevation 90 deg, plane 20 deg, and swing it to the
  /// direction by the smallest rotation. Every direction has one such humerus, also hanging and
  /// straight up.
  kSwing,
};

/// Words for the command line and the plugin's configuration, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kInterpolationNames = {"smooth", "squad", "slerp"};
inline constexpr std::array<std::string_view, 2> kClosureNames = {"exact", "table"};
inline constexpr std::array<std::string_view, 2> kRangeNames = {"whole", "clamp"};
inline constexpr std::array<std::string_view, 3> kAxialFromNames = {"rhythm", "isb", "swing"};

constexpr const auto& WordsOf(Interpolation /*which*/) noexcept { return kInterpolationNames; }
constexpr const auto& WordsOf(Closure /*which*/) noexcept { return kClosureNames; }
constexpr const auto& WordsOf(Range /*which*/) noexcept { return kRangeNames; }
constexpr const auto& WordsOf(AxialFrom /*which*/) noexcept { return kAxialFromNames; }

/// How a rhythm is evaluated. The published method is {kSquad, kTable}.
struct RhythmOptions {
  Interpolation interpolation = Interpolation::kSmooth;
  Closure closure = Closure::kExact;
  /// If empty: `kWhole` for `kSmooth` with `kExact`, otherwise `kClamp`.
  std::optional<Range> range = std::nullopt;
};

/// Returns the range that an empty RhythmOptions::range means.
[[nodiscard]] Range DefaultRange(Interpolation interpolation, Closure closure) noexcept;

/// A command to the arm: its direction, its axial turn and the offsets of the clavicle.
struct ArmCommand {
  double elevation_rad = 0;  ///< angle between the humerus and hanging down, [0, pi]
  double plane_rad = 0;      ///< 0 frontal, pi/2 sagittal (forward); whole turns do not matter
  double axial_rad =
      0;  ///< turn about the humerus's long axis, counted from `axial_from`, internal +
  double shrug_rad = 0;        ///< clavicle raised above the rhythm, up +
  double protraction_rad = 0;  ///< clavicle protracted beyond the rhythm, forward +
  AxialFrom axial_from = AxialFrom::kRhythm;

  [[nodiscard]] bool operator==(const ArmCommand&) const noexcept = default;
};

/// The basis of a solution.
enum class Origin {
  kMeasured,  ///< interpolated between measured positions
  kDerived,   ///< interpolated; SC and AC of some position are derived (RhythmPosition::measured)
  kModelled,  ///< outside the table, computed by a rule
};
inline constexpr std::array<std::string_view, 3> kOriginNames = {"measured", "derived", "modelled"};
constexpr const auto& WordsOf(Origin /*which*/) noexcept { return kOriginNames; }

/// Result of the inverse kinematics. "Not reached" is a result, not an error.
struct ShoulderSolution {
  ShoulderPose pose;
  /// The command that the pose answers. Its direction is in the range (ArmReach says which one).
  /// Its axial turn, shrug and protraction are as large as the joints' ranges allow. Its axial turn
  /// is counted from the rhythm's own humerus.
  ArmCommand used;
  /// Whether `used` differs from the command: ShoulderRhythm::IsClamped of both.
  bool clamped;
  Origin origin;
  /// The table's cell that contains `used`, or the nearest cell.
  RhythmCell cell;
  /// Angle [rad] between the commanded direction and the nearest direction of the table's domain; 0
  /// inside. It is the angle of the direction of `used` if that one is larger.
  double distance_rad;
};

/// How a joint turns when the command changes: angular velocities of the child in the parent, in
/// the parent's axes [rad/rad].
struct AngularRate {
  Vector3 by_elevation;
  Vector3 by_plane;
};

/// A pose and its first derivatives, in the order SC, AC, GH.
struct ShoulderRates {
  ShoulderPose pose;
  std::array<AngularRate, kJointCount> joints;
};

/// First derivatives of the joint coordinates [rad/rad], in the order of kCoordinateNames.
struct AngleRates {
  JointAngles by_elevation;
  JointAngles by_plane;
};

/// First and second derivatives of one joint's rotation. `rate` contains its angular velocities;
/// the other members are the derivatives of these velocities [rad/rad^2].
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

/// First and second derivatives of a pose: of its rotations, and of its joint coordinates.
struct ShoulderDerivatives {
  std::array<RotationDerivatives, kJointCount> joints;
  std::array<AngleDerivatives, kCoordinateCount> angles;  ///< in the order of kCoordinateNames
};

/// Answers arm commands with the rotations of SC, AC and GH, interpolated from a measured table.
///
/// A command is a direction of the humerus in the thorax (elevation and plane), an axial turn about
/// the humerus and two offsets of the clavicle. The answer is the pose of a right shoulder: q_TC,
/// q_CS and q_SH, each the rotation of a child in its parent. All angles are radians. RhythmOptions
/// chooses the interpolation, the closure and the range. If a command cannot be reached, another
/// command answers it, and the solution contains that one (`used`).
///
///     const ShoulderRhythm rhythm(table);
///     const ShoulderSolution solution = rhythm.Solve({.elevation_rad = kPi / 2});
///
/// An object is immutable. Evaluation is thread-safe, never fails and allocates nothing. Copies
/// share the interpolant. An object that was moved from can only be destroyed or assigned to.
class ShoulderRhythm {
 public:
  /// `ranges` limit what axial turn, shrug and protraction add. They do not limit the rhythm
  /// itself. Throws std::invalid_argument if neighbouring planes differ by 180 degrees or more,
  /// because the way between them is then not determined. Throws it also if the table has too few
  /// knots for the interpolation, or if `options` choose the whole range where no rule exists for
  /// it.
  explicit ShoulderRhythm(RhythmTable table, RhythmOptions options = {},
                          const JointRanges& ranges = Unbounded());

  /// Returns the pose that answers a command. Total: every command has an answer.
  ///
  /// Direction: whole turns of the plane do not matter. A direction outside the range is answered
  /// by ArmReach::AnswerTo with Range::kWhole, and by the nearest elevation and plane with
  /// Range::kClamp. A NaN elevation counts as the lowest elevation. A plane that is not finite
  /// counts as the lowest plane. If an offset or the axial turn is not finite, the rhythm's own
  /// value is used.
  ///
  /// Axial turn where another direction answers: a turn from the rhythm's or the swing's zero keeps
  /// its number. A turn from ISB's zero is carried: the smallest rotation takes the commanded
  /// humerus to the direction that answers. The carried turn, counted from the rhythm's own, is
  /// multiplied by ShareOfCarried of axial_zero.h, which is 1 up to 60 deg away.
  ///
  /// Axial turn and GH's range: a turn from the rhythm's zero is a number. If it takes GH beyond
  /// its range, the nearer end of the range answers. A turn from ISB's or the swing's zero is an
  /// angle, and data may contain 350 where -10 is meant. Turns that differ by 360 deg are therefore
  /// one; the one that counts puts GH's axial coordinate within half a turn of kGhAxialMiddle_rad.
  ///
  /// Continuity: an angle cannot be brought into a range without a jump. The jump is where GH's
  /// axial coordinate would be 135 deg, which is the angle -225 deg. There the answer goes back by
  /// up to 360 deg times the share that counts, and at most from one end of GH's range to the other
  /// (240 deg with the built-in ranges). Everywhere else, and everywhere with the rhythm's zero,
  /// the answer is continuous with Range::kWhole and no offsets.
  ///
  /// Squad and slerp are equations (4) to (12). Offsets turn the clavicle's angles. The scapula
  /// keeps its place on the clavicle, and with closure exact the arm keeps its direction.
  [[nodiscard]] ShoulderSolution Solve(const ArmCommand& command) const noexcept;

  /// Returns the pose alone, in less time than Solve. If `used` is not null, it receives the
  /// command that the pose answers.
  [[nodiscard]] ShoulderPose SolvePose(const ArmCommand& command,
                                       ArmCommand* used = nullptr) const noexcept;

  /// Returns the axial turn [rad] that a command means, counted from another zero. If another
  /// direction answers the command, ISB's zero is that of the commanded plane; the other two zeros
  /// are those of the direction that answers. If ISB's turn counts only in part (AxialShare) and no
  /// turn gives the command's humerus, the result is the turn that comes nearest to it.
  [[nodiscard]] double AxialCountedFrom(AxialFrom zero, const ArmCommand& command) const noexcept;

  /// Returns the share of a command's axial turn and of its rate that counts, in [0, 1]. It is 1
  /// unless a turn from ISB's zero is carried by more than 60 deg.
  [[nodiscard]] double AxialShare(const ArmCommand& command) const noexcept;

  /// Returns the axial turn [rad] of a pose, in [-pi, pi], counted from `zero`. `used` is the
  /// command that the pose answers. With closure exact and kIsb the result is the third angle
  /// Y-X'-Y'' of q_TH. With closure table the arm may miss the direction of `used`. The zero is
  /// then that of the direction of `used`, and the pose's turn is what remains of q_TH without its
  /// swing S (axial_zero.h).
  [[nodiscard]] double AxialOf(AxialFrom zero, const ShoulderPose& pose,
                               const ArmCommand& used) const noexcept;

  /// Returns whether a command is clamped when `used` answers it: whether `used` has another
  /// direction, turn or offset. Planes that differ by whole turns are equal. All planes are equal
  /// if the arm hangs.
  [[nodiscard]] bool IsClamped(const ArmCommand& command, const ArmCommand& used) const noexcept;

  /// Returns the pose with its derivatives by the commanded elevation and plane, exact to rounding.
  /// Returns nothing unless the interpolation is smooth. If another direction answers the command,
  /// the derivatives are those of the answer. At a kink, where a limit or another form of the rule
  /// begins, they are those of one side. Offsets count as constant where GH's range limits them.
  [[nodiscard]] std::optional<ShoulderRates> SolveRates(const ArmCommand& command) const noexcept;
  [[nodiscard]] std::optional<AngleRates> SolveAngleRates(const ArmCommand& command) const noexcept;
  [[nodiscard]] std::optional<ShoulderDerivatives> SolveDerivatives(
      const ArmCommand& command) const noexcept;

  /// Returns the angle [rad] between a direction and the nearest direction of the table's domain.
  /// It is 0 inside, and 0 for a NaN.
  [[nodiscard]] double DistanceOutside(double elevation_rad, double plane_rad) const noexcept;

  [[nodiscard]] const RhythmTable& table() const noexcept { return table_; }
  /// The options with the range filled in.
  [[nodiscard]] const RhythmOptions& options() const noexcept { return options_; }
  [[nodiscard]] const JointRanges& ranges() const noexcept { return ranges_; }
  /// Elevations and planes of commands that are not clamped. With the range whole, planes behind
  /// the frontal plane are included only down to LowestPlaneAt.
  [[nodiscard]] const ArmRectangle& domain() const noexcept { return domain_; }
  /// The lowest plane [rad] that is not clamped, at an elevation of the domain.
  [[nodiscard]] double LowestPlaneAt(double elevation_rad) const noexcept {
    return options_.range == Range::kWhole ? reach_.LowestPlaneAt(elevation_rad)
                                           : domain_.first_plane_rad;
  }

  /// Ranges that limit nothing.
  [[nodiscard]] static JointRanges Unbounded() noexcept;

 private:
  friend class ManySolver;  // of solve_many.cc: does the steps of Solve for blocks of commands

  using Interpolant =
      std::variant<std::shared_ptr<const SmoothRhythm>, std::shared_ptr<const SquadRhythm>>;
  [[nodiscard]] static Interpolant InterpolantOf(const RhythmTable& table,
                                                 Interpolation interpolation);
  /// Null with squad and slerp, which have no derivatives.
  [[nodiscard]] const SmoothRhythm* smooth() const noexcept {
    const auto* const smooth = std::get_if<std::shared_ptr<const SmoothRhythm>>(&interpolant_);
    return smooth == nullptr ? nullptr : smooth->get();
  }
  /// The plane within half a turn of the middle of the domain. NaN if the plane is not finite.
  [[nodiscard]] double PlaneOnChart(double plane_rad) const noexcept;
  /// The commanded direction with the elevation in [0, pi] and the plane by PlaneOnChart, both
  /// finite. T is double or a Jet; a Jet's derivatives are kept.
  template <typename T>
  [[nodiscard]] ArmDirectionOf<T> AskedDirection(const ArmDirectionOf<T>& direction) const noexcept;
  /// The direction of the range that answers `asked`.
  template <typename T>
  [[nodiscard]] ArmDirectionOf<T> AnswerTo(const ArmDirectionOf<T>& asked) const noexcept;
  /// The rates of a direction within the table, without offsets and axial turn.
  [[nodiscard]] ShoulderRates PlainRates(double elevation_rad, double plane_rad) const noexcept;
  /// Whether WithinRange would change nothing. True for most commands within the table.
  [[nodiscard]] bool IsPlain(const ArmCommand& command) const noexcept {
    return measured_.Holds(command.elevation_rad, command.plane_rad) && command.axial_rad == 0 &&
           command.shrug_rad == 0 && command.protraction_rad == 0 &&
           command.axial_from == AxialFrom::kRhythm;
  }
  /// The zero T_0 of axial_zero.h. `used` is the direction that answers `asked`, and tau [rad] is
  /// the rhythm's own turn there.
  template <typename T>
  [[nodiscard]] T ZeroOf(AxialFrom zero, const ArmDirectionOf<T>& asked,
                         const ArmDirectionOf<T>& used, const T& tau_rad) const noexcept;
  /// The whole turn [rad] of a pose that answers a direction, in [-pi, pi].
  [[nodiscard]] double WholeTurnOf(const ShoulderPose& pose,
                                   const ArmDirectionOf<double>& used) const noexcept;
  /// AxialShare if `used` answers the direction `asked`.
  template <typename T>
  [[nodiscard]] static T ShareOf(AxialFrom zero, const ArmDirectionOf<T>& asked,
                                 const ArmDirectionOf<T>& used) noexcept;
  /// The humerus's turn if no axial turn is added.
  template <typename T>
  struct OwnTurnOf {
    T tau_rad;                  ///< whole turn
    double gh_from_middle_rad;  ///< GH's axial coordinate minus kGhAxialMiddle_rad
  };
  [[nodiscard]] OwnTurnOf<double> OwnTurn(const ArmDirectionOf<double>& used) const noexcept;
  /// The axial turn [rad] of a command, counted from the rhythm's own. Precondition: the command's
  /// axial turn is finite.
  template <typename T>
  [[nodiscard]] T AxialFromRhythm(const ArmCommand& command, const ArmDirectionOf<T>& asked,
                                  const ArmDirectionOf<T>& used,
                                  const OwnTurnOf<T>& own) const noexcept;
  [[nodiscard]] double AxialFromRhythm(const ArmCommand& command,
                                       const ArmDirectionOf<double>& asked,
                                       const ArmDirectionOf<double>& used) const noexcept;
  /// The direction that answers a command, with the axial turn counted from the rhythm's own.
  [[nodiscard]] ArmCommand WithinRange(const ArmCommand& command) const noexcept;
  /// The pose for a command within the range. Limits its axial turn and offsets.
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
  /// GH that closes the chain: q_SH = (q_TC q_CS)^-1 q_TH.
  [[nodiscard]] static Quaternion Closed(const ShoulderPose& pose, const Quaternion& q_TH) noexcept;
  /// Turns the clavicle as far as the ranges of SC and GH allow, and writes that far into `used`.
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
