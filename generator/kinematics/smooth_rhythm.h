// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The smooth interpolant of a measured rhythm, and its continuation to every direction that an arm
/// reaches.
///
/// Within the table, each joint's rotations q are interpolated about a base point m:
///
///     q = exp(u) m,   u = log(q m^-1) at the table's positions
///
/// m is the mean of the joint's rotations (Frechet's mean: the sum of the logarithms at it is
/// zero). u is interpolated by a tensor-product spline with continuous second derivatives
/// (surface_spline.h). The result passes through every position and is as smooth as the spline,
/// because exp is analytic.
///
/// A base point is needed because no coordinates of rotations are equally good everywhere. The mean
/// leaves no choice: it turns with the data. If all rotations of a joint are turned in the parent
/// or in the child, the interpolant turns by the same rotation. Chains and blends of slerps (squad
/// and its C2 relatives) have no coefficients that can be computed once, and they are C2 in one
/// direction only.
///
/// The humerus's turn about its own long axis is a number, tau. The table's arm is q_TC q_CS q_SH =
/// S Ry(tau), where S is the smallest rotation from the hanging arm to where the table's arm
/// points. The same kind of spline interpolates tau.
///
/// Outside the table a rule answers. It is fitted to in-vivo measurements above 120 deg of
/// elevation and outside planes 0 to 90 (Henninger, Bourne, Matsuki, Sahara and others, as
/// collected by Moissenet et al., J Biomech 2025, doi 10.1016/j.jbiomech.2025.112642). The rule is
/// a model, not a measurement: it misses those sets by 1 to 4 deg rms. It has a continuous first
/// derivative. At elevations 0 and 180, where the plane has no meaning, it has one value.
#pragma once

#include <cstddef>
#include <optional>

#include "kinematics/four.h"
#include "kinematics/rhythm_table.h"
#include "kinematics/rotation_algebra.h"
#include "kinematics/surface_spline.h"

namespace girdle {

/// Clavicle in thorax and scapula in clavicle as the two elements of one rotation; tau [rad].
template <typename T>
struct GirdleOf {
  QuaternionOf<PairOf<T>> q_TC_CS;
  T turn_rad;
};

/// Clavicle in thorax and scapula in clavicle as the two elements of one rotation; humerus in
/// scapula.
template <typename T>
struct JointsOf {
  QuaternionOf<PairOf<T>> q_TC_CS;
  QuaternionOf<T> q_SH;
};

/// SC and AC, tau, and their rates by elevation and plane. The rates of SC and AC are angular
/// velocities of the child in the parent, in the parent's axes [rad/rad].
struct GirdleRates {
  MovingRotation<Pair> q_TC_CS;
  double turn_rad;
  double turn_by_elevation;
  double turn_by_plane;
};

/// SC and AC, and GH, with their angular velocities by elevation and plane, in the parent's axes.
struct JointRates {
  MovingRotation<Pair> q_TC_CS;
  MovingRotation<double> q_SH;
};

// Members are in the order in which they are made from each other.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
class SmoothRhythm {
 public:
  static constexpr std::size_t kFewestElevations = 4;
  static constexpr std::size_t kFewestPlanes = 3;

  /// Throws std::invalid_argument if the table has too few knots, or if a rotation is half a turn
  /// from the mean of its joint.
  explicit SmoothRhythm(const RhythmTable& table);

  /// Throws std::invalid_argument if the rule for the whole range cannot continue this table: if
  /// the lowest or highest row is more than a right angle from the rule's rotation at elevation 0
  /// or 180. `table` is the one that this object was made with.
  void CheckWholeRange(const RhythmTable& table) const;

  /// Returns clavicle, scapula and tau. T is double or Jet<double, 1 or 2>. A jet's coordinates are
  /// the two arguments: it carries the derivatives by elevation and plane. Precondition: elevation
  /// in [0, pi]. The plane may be any number. Outside the table the rule answers.
  template <typename T>
  [[nodiscard]] GirdleOf<T> Girdle(double elevation_rad, double plane_rad) const noexcept;

  /// Returns all three joints as the table has them, also the humerus in the scapula. T is double
  /// or Jet<double, 1 or 2>. Precondition: the direction is within the table.
  template <typename T>
  [[nodiscard]] JointsOf<T> Joints(double elevation_rad, double plane_rad) const noexcept;

  /// Girdle and Joints with first derivatives, in less time than with jets. Precondition: the
  /// direction is within the table.
  [[nodiscard]] GirdleRates RatesOfGirdle(double elevation_rad, double plane_rad) const noexcept;
  [[nodiscard]] JointRates RatesOfJoints(double elevation_rad, double plane_rad) const noexcept;

  /// Girdle<double> of four commands of one region. Each command has the bits that it has alone.
  /// The first function is for region 0, the second for all other regions. Both are defined in
  /// smooth_rhythm_rule.h, so that a caller can compile them for its processor.
  [[nodiscard]] GirdleOf<Four> GirdlesInTable(const Four& elevations_rad,
                                              const Four& planes_rad) const noexcept;
  [[nodiscard]] GirdleOf<Four> GirdlesBeyondTable(const Four& elevations_rad,
                                                  const Four& planes_rad) const noexcept;
  /// q_SH of Joints for four commands. Each command has the bits that it has alone.
  [[nodiscard]] QuaternionOf<Four> HumeriInScapulae(const Four& elevations_rad,
                                                    const Four& planes_rad) const noexcept;

  static constexpr std::size_t kRegions = 18;
  /// Returns the region that contains a command, less than kRegions. All commands of a region take
  /// the same way through the rule. Region 0 is the table.
  [[nodiscard]] std::size_t RegionOf(double elevation_rad, double plane_rad) const noexcept;

 private:
  struct Edges {
    double lowest_rad;
    double highest_rad;
    double first_plane_rad;
    double last_plane_rad;
  };
  struct Mean {
    QuaternionOf<Pair> q_TC_CS;
    QuaternionOf<double> q_SH;
  };

  [[nodiscard]] static Mean MeanOf(const RhythmTable& table);

  [[nodiscard]] MovingRotation<Pair> MovingGirdle(const SurfaceGrid::Place& place) const noexcept;

  /// u of SC and AC, and tau; or derivatives of them.
  template <typename T>
  struct Surfaces {
    VectorOf<PairOf<T>> u;
    T turn_rad;
  };
  /// The derivative of order I by elevation and J by plane. One coordinate has type T, the other is
  /// a number. For T = Four both may have type T.
  template <typename T, std::size_t I, std::size_t J, typename E, typename P>
  [[nodiscard]] Surfaces<T> SurfacesAt(const E& elevation_rad, const P& plane_rad) const noexcept;
  template <std::size_t I, std::size_t J, typename E, typename P>
  [[nodiscard]] Surfaces<Four> SurfacesOfFour(const E& elevation_rad,
                                              const P& plane_rad) const noexcept;

  /// The table at its first or last plane: SC and AC, their angular velocities by plane (parent's
  /// axes), and tau with its derivative by plane.
  template <typename T>
  struct Edge {
    QuaternionOf<PairOf<T>> q;
    VectorOf<PairOf<T>> w;
    T turn_rad;
    T turn_by_plane;
  };
  template <typename T, typename E>
  [[nodiscard]] Edge<T> EdgeAt(const E& elevation_rad, bool is_above) const noexcept;

  /// sin(theta) and sin(min(theta, 90 deg)).
  template <typename T>
  struct ElevationSine {
    T sine;
    T sine_to_level;
  };
  template <typename T>
  [[nodiscard]] static ElevationSine<T> SineOf(const T& elevation_rad) noexcept;

  /// A corner of the table and an inner place on the same edge, both with derivatives by elevation.
  struct Corner {
    Edge<Dual<double>> edge;
    Edge<Dual<double>> inner_edge;
  };
  /// The first or last elevation of the table.
  struct EndRow {
    double elevation_rad;
    std::optional<double> inner_elevation_rad;
    ElevationSine<Dual<double>> sine;
    ElevationSine<double> inner_sine;
    Corner first_plane;
    Corner last_plane;
  };
  [[nodiscard]] EndRow EndRowAt(double elevation_rad,
                                std::optional<double> inner_elevation_rad) const noexcept;
  /// Values of an end row at a plane, as the rule needs them. Slopes by elevation are optional.
  template <typename T>
  struct Row {
    QuaternionOf<PairOf<T>> q;
    VectorOf<PairOf<T>> w;
    T turn_rad;
    T turn_by_elevation;
    QuaternionOf<PairOf<T>> inner_q;
  };
  /// Makes jets of rows that have derivatives by plane only.
  [[nodiscard]] static Row<Jet<double, 1>> AsJets(const Row<Dual<double>>& row) noexcept;
  template <typename T>
  [[nodiscard]] Row<T> RowAt(const T& plane_rad, const EndRow& end,
                             bool with_slopes) const noexcept;

  template <typename T>
  struct Beyond;
  template <typename T>
  [[nodiscard]] Beyond<T> BeyondAt(const T& plane_rad) const noexcept;
  template <typename S, typename T>
  [[nodiscard]] GirdleOf<S> Across(const Edge<S>& edge, const Beyond<T>& beyond,
                                   const ElevationSine<S>& elevation) const noexcept;
  template <typename T>
  [[nodiscard]] GirdleOf<T> AboveTable(const T& elevation_rad, const T& plane_rad) const noexcept;
  template <typename T>
  [[nodiscard]] GirdleOf<T> BelowTable(const T& elevation_rad, const T& plane_rad) const noexcept;
  template <typename T>
  [[nodiscard]] GirdleOf<T> BeyondTable(const T& elevation_rad, const T& plane_rad) const noexcept;

  Edges edges_;
  SurfaceGrid grid_;
  Mean mean_;
  SurfaceSpline<Pair, 3> girdle_;        ///< u of SC and AC
  SurfaceSpline<double, 1> turn_;        ///< tau
  SurfaceSpline<Pair, 2> glenohumeral_;  ///< u of GH: (x, y), (z, 0)
  /// girdle_ and turn_ side by side: (SC x, AC x, SC y, AC y), (SC z, AC z, tau, 0).
  SurfaceSpline<Four, 2> four_;
  SurfaceSpline<Four, 1> glenohumeral_four_;  ///< (x, y, z, 0)
  QuaternionOf<FourPairs> mean_fours_;        ///< mean_ of SC and AC, each number four times
  QuaternionOf<Pair> hanging_;                ///< SC and AC of the rule at elevation 0
  QuaternionOf<Pair> upright_;                ///< SC and AC of the rule at elevation 180
  double hanging_turn_rad_ = 0;               ///< tau at elevation 0
  double span_rad_;  ///< elevations below the highest row that the mean rate is taken over
  EndRow bottom_;
  EndRow top_;
};

}  // namespace girdle
