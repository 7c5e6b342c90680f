// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The smooth interpolant of a measured rhythm, and its continuation to all that an arm can do.
///
/// Within the table: with m the mean of a joint's rotations (Frechet's: the sum of logarithms at it
/// is zero), u = log(q m^-1) of every position is interpolated by a twice continuously
/// differentiable tensor-product spline (surface_spline.h), and q = exp(u) m. The curve passes
/// through every position; exp being analytic it is as smooth as the spline. A base point is needed
/// because rotations have no coordinates that are the same everywhere; the mean is the one that
/// needs no choice: it turns with the data, so that turning all rotations of a joint in the parent
/// or in the child turns the interpolant alike. Chained or blended slerps (squad, and its C2
/// relatives) have no coefficients that could be computed once, and are C2 in one direction only.
///
/// The humerus's turn about its own long axis is a number, tau: the table's arm q_TC q_CS q_SH is
/// S Ry(tau), S the smallest rotation that takes the hanging arm where the table's arm points. It
/// is interpolated by the same spline.
///
/// Outside the table: a rule fitted to what was measured in vivo above 120 deg of elevation and
/// outside planes 0 to 90 (Henninger, Bourne, Matsuki, Sahara and others, as collected by Moissenet
/// et al., J Biomech 2025, doi 10.1016/j.jbiomech.2025.112642). It is a model, not a measurement;
/// it misses those sets by 1 to 4 deg rms. It has a continuous first derivative, and one value
/// at elevations 0 and 180, where the plane has no meaning.
#pragma once

#include <cstddef>
#include <optional>

#include "kinematics/four.h"
#include "kinematics/rhythm_table.h"
#include "kinematics/rotation_algebra.h"
#include "kinematics/surface_spline.h"

namespace girdle {

/// Clavicle in thorax and scapula in clavicle as the two elements of one rotation, and tau [rad].
template <typename T>
struct GirdleOf {
  QuaternionOf<PairOf<T>> q_TC_CS;
  T turn_rad;
};

/// The same two, and humerus in scapula.
template <typename T>
struct JointsOf {
  QuaternionOf<PairOf<T>> q_TC_CS;
  QuaternionOf<T> q_SH;
};

/// SC and AC, tau, and how they change with elevation and plane: angular velocities of the child in
/// the parent, parent's axes.
struct GirdleRates {
  MovingRotation<Pair> q_TC_CS;
  double turn_rad;
  double turn_by_elevation;
  double turn_by_plane;
};

/// SC and AC, and GH, likewise.
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

  /// Throws std::invalid_argument if the table has too few knots, or rotations half a turn from
  /// their mean.
  explicit SmoothRhythm(const RhythmTable& table);

  /// Throws std::invalid_argument if the rule for the whole range cannot go on from this table, the
  /// one it was made with: its lowest or highest rows are more than a right angle from where the
  /// rule goes.
  void CheckWholeRange(const RhythmTable& table) const;

  /// Clavicle, scapula and tau for T double or Jet<double, 1 or 2>, whose coordinates are the two
  /// arguments: jets carry the derivatives by elevation and plane. Elevation in [0, pi], plane
  /// anything; outside the table by the rule.
  template <typename T>
  [[nodiscard]] GirdleOf<T> Girdle(double elevation_rad, double plane_rad) const noexcept;

  /// All three joints, within the table, the humerus in the scapula from the table too. T as above.
  template <typename T>
  [[nodiscard]] JointsOf<T> Joints(double elevation_rad, double plane_rad) const noexcept;

  /// The same with first derivatives, within the table, in less time than with jets.
  [[nodiscard]] GirdleRates RatesOfGirdle(double elevation_rad, double plane_rad) const noexcept;
  [[nodiscard]] JointRates RatesOfJoints(double elevation_rad, double plane_rad) const noexcept;

  /// Girdle<double> of four commands of one region, with the bits that each has alone: the first
  /// function for the region 0, the second for every other. Their definitions are in
  /// smooth_rhythm_rule.h, for a caller who compiles them for his processor.
  [[nodiscard]] GirdleOf<Four> GirdlesInTable(const Four& elevations_rad,
                                              const Four& planes_rad) const noexcept;
  [[nodiscard]] GirdleOf<Four> GirdlesBeyondTable(const Four& elevations_rad,
                                                  const Four& planes_rad) const noexcept;
  /// q_SH of Joints, likewise.
  [[nodiscard]] QuaternionOf<Four> HumeriInScapulae(const Four& elevations_rad,
                                                    const Four& planes_rad) const noexcept;

  static constexpr std::size_t kRegions = 18;
  /// Returns in which region a command lies, below kRegions: all of a region take the same way
  /// through the rule. 0 is the table.
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

  /// u of SC and AC, and tau, or derivatives of them.
  template <typename T>
  struct Surfaces {
    VectorOf<PairOf<T>> u;
    T turn_rad;
  };
  /// The derivative of order (I, J). One coordinate is of type T and the other a number; for T =
  /// Four both may be of type T.
  template <typename T, std::size_t I, std::size_t J, typename E, typename P>
  [[nodiscard]] Surfaces<T> SurfacesAt(const E& elevation_rad, const P& plane_rad) const noexcept;
  template <std::size_t I, std::size_t J, typename E, typename P>
  [[nodiscard]] Surfaces<Four> SurfacesOfFour(const E& elevation_rad,
                                              const P& plane_rad) const noexcept;

  /// The table at its first or last plane: SC and AC, how they turn with the plane (parent's axes),
  /// and tau.
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

  /// A corner of the table, with its derivatives by elevation, and a place on the edge further in.
  struct Corner {
    Edge<Dual<double>> edge;
    Edge<Dual<double>> inner_edge;
  };
  /// The first or the last elevation of the table.
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
  /// What the rule needs of such a row at a plane, slopes by elevation if asked for.
  template <typename T>
  struct Row {
    QuaternionOf<PairOf<T>> q;
    VectorOf<PairOf<T>> w;
    T turn_rad;
    T turn_by_elevation;
    QuaternionOf<PairOf<T>> inner_q;
  };
  /// From derivatives by plane alone.
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
  QuaternionOf<FourPairs> mean_fours_;        ///< mean_ of SC and AC
  QuaternionOf<Pair> hanging_;                ///< where the rule goes at elevation 0
  QuaternionOf<Pair> upright_;                ///< at elevation 180
  double hanging_turn_rad_ = 0;               ///< tau at elevation 0
  double span_rad_;                           ///< below the top, over which the mean rate is taken
  EndRow bottom_;
  EndRow top_;
};

}  // namespace girdle
