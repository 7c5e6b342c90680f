// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/solve_many.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "kinematics/assembled_rhythm.h"
#include "kinematics/euler_angles.h"
#include "kinematics/humerus_rotation.h"
#include "kinematics/smooth_rhythm.h"
#include "kinematics/smooth_rhythm_rule.h"

// All calls of such a function are inlined and compiled for AVX2. A file compiled for AVX2 as a
// whole would contain inline functions of the standard library that other processors cannot run.
// With sanitizers one such function takes minutes to compile, so that its calls are not inlined
// there; this changes only the speed.
#if defined(__x86_64__) && defined(__GNUC__)
#define GIRDLE_HAS_AVX2 1
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GIRDLE_AVX2 [[gnu::target("avx2"), gnu::noinline]]
#else
#define GIRDLE_AVX2 [[gnu::target("avx2"), gnu::noinline, gnu::flatten]]
#endif
#else
#define GIRDLE_HAS_AVX2 0
#endif

namespace girdle {
namespace {

// Commands in a block, which a thread takes at a time. A region's last four may need up to three
// copies of a command to be full; those are few in a block of this size.
constexpr std::size_t kBlock = 256;

// ---- Four poses at a time.

// Commands of one region, in whole fours. The last command is repeated to fill its four.
struct FourWork {
  const SmoothRhythm& smooth;
  std::span<const double> elevations_rad;
  std::span<const double> planes_rad;
  std::span<const std::uint16_t> places;  ///< of each command's pose in `poses`
  std::span<ShoulderPose> poses;
};

// Stores each of four rotations in one pose.
GIRDLE_INLINE void Store(const QuaternionOf<Four>& q, Quaternion& a, Quaternion& b, Quaternion& c,
                         Quaternion& d) noexcept {
  Four in_a = q.w;
  Four in_b = q.x;
  Four in_c = q.y;
  Four in_d = q.z;
  Four::Transpose(in_a, in_b, in_c, in_d);
  a = {in_a[0], in_a[1], in_a[2], in_a[3]};
  b = {in_b[0], in_b[1], in_b[2], in_b[3]};
  c = {in_c[0], in_c[1], in_c[2], in_c[3]};
  d = {in_d[0], in_d[1], in_d[2], in_d[3]};
}

template <bool IsInTable, bool IsExact>
GIRDLE_INLINE void SolveFours(const FourWork& work) noexcept {
  for (std::size_t i = 0; i < work.places.size(); i += Four::kSize) {
    const Four theta = Four::From(work.elevations_rad.data() + i);
    const Four psi = Four::From(work.planes_rad.data() + i);
    const GirdleOf<Four> girdle = IsInTable ? work.smooth.GirdlesInTable(theta, psi)
                                            : work.smooth.GirdlesBeyondTable(theta, psi);
    const QuaternionOf<Four> q_TC = Element(girdle.q_TC_CS, 0);
    const QuaternionOf<Four> q_CS = Element(girdle.q_TC_CS, 1);
    const QuaternionOf<Four> q_SH =
        IsExact ? Inverse(q_TC * q_CS) * HumerusRotation(theta, psi, girdle.turn_rad)
                : work.smooth.HumeriInScapulae(theta, psi);
    const auto store = [&](const QuaternionOf<Four>& q, Quaternion ShoulderPose::*joint) {
      Store(q, work.poses[work.places[i]].*joint, work.poses[work.places[i + 1]].*joint,
            work.poses[work.places[i + 2]].*joint, work.poses[work.places[i + 3]].*joint);
    };
    store(q_TC, &ShoulderPose::q_TC);
    store(q_CS, &ShoulderPose::q_CS);
    store(q_SH, &ShoulderPose::q_SH);
  }
}

// Returns the rotations of four poses, or their negatives, so that w is not negative.
GIRDLE_INLINE QuaternionOf<Four> PositiveFours(const Quaternion& a, const Quaternion& b,
                                               const Quaternion& c, const Quaternion& d) noexcept {
  Four w(a.w, a.x, a.y, a.z);
  Four x(b.w, b.x, b.y, b.z);
  Four y(c.w, c.x, c.y, c.z);
  Four z(d.w, d.x, d.y, d.z);
  Four::Transpose(w, x, y, z);
  return {Four::WhereLess(w, 0.0, -w, w), Four::WhereLess(w, 0.0, -x, x),
          Four::WhereLess(w, 0.0, -y, y), Four::WhereLess(w, 0.0, -z, z)};
}

// Returns the angles of all poses, as AnglesFromPose does.
GIRDLE_INLINE void AnglesOfFours(std::span<const ShoulderPose> poses,
                                 std::span<JointAngles> angles_rad) noexcept {
  const std::size_t count = poses.size();
  for (std::size_t first = 0; first < count; first += Four::kSize) {
    const std::array<std::size_t, Four::kSize> places = {first, std::min(first + 1, count - 1),
                                                         std::min(first + 2, count - 1),
                                                         std::min(first + 3, count - 1)};
    const auto positive = [&](Quaternion ShoulderPose::*joint) {
      return PositiveFours(poses[places[0]].*joint, poses[places[1]].*joint,
                           poses[places[2]].*joint, poses[places[3]].*joint);
    };
    const QuaternionOf<Four> sc = positive(&ShoulderPose::q_TC);
    const QuaternionOf<Four> ac = positive(&ShoulderPose::q_CS);
    const QuaternionOf<Four> gh = positive(&ShoulderPose::q_SH);
    const VectorOf<FourPairs> girdle_rad = EulerAngles(
        FourPairs(sc.w, ac.w), FourPairs(sc.y, ac.y), FourPairs(sc.x, ac.x), FourPairs(sc.z, ac.z));

    const FourPairs sine{gh.y + gh.x, gh.x - gh.y};
    const FourPairs cosine{gh.w - gh.z, gh.z + gh.w};
    const FourPairs half_rad = Atan2(sine, cosine);
    const FourPairs squared = sine * sine + cosine * cosine;
    const Four flexion_rad =
        Atan2OfLanes(Four(0.5 * (squared[1] - squared[0])), Sqrt(Four(squared[0] * squared[1])));
    const Four axial_rad = WithinHalfTurn(half_rad[0] - half_rad[1] - kGhAxialMiddle_rad);
    const std::array<Four, kCoordinateCount> coordinates = {
        girdle_rad[0][0],
        girdle_rad[1][0],
        girdle_rad[2][0],
        girdle_rad[0][1],
        girdle_rad[1][1],
        girdle_rad[2][1],
        WithinHalfTurn(half_rad[0] + half_rad[1]),
        flexion_rad,
        axial_rad + kGhAxialMiddle_rad};
    for (std::size_t i = 0; i < Four::kSize; ++i) {
      for (std::size_t k = 0; k < kCoordinateCount; ++k) {
        angles_rad[places[i]][k] = coordinates[k][i];
      }
    }
  }
}

#if GIRDLE_HAS_AVX2
GIRDLE_AVX2 void SolveInTable(const FourWork& work) noexcept { SolveFours<true, true>(work); }
GIRDLE_AVX2 void SolveInTableWithItsArm(const FourWork& work) noexcept {
  SolveFours<true, false>(work);
}
GIRDLE_AVX2 void SolveBeyondTable(const FourWork& work) noexcept { SolveFours<false, true>(work); }
GIRDLE_AVX2 void Angles(std::span<const ShoulderPose> poses,
                        std::span<JointAngles> angles_rad) noexcept {
  AnglesOfFours(poses, angles_rad);
}
#endif

// ---- All poses.

// Threads that are joined at the end. Clang's library has no std::jthread yet.
class Helpers {
 public:
  explicit Helpers(std::size_t count) { threads_.reserve(count); }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;
  ~Helpers() {
    for (std::thread& thread : threads_) {
      thread.join();
    }
  }

  // Throws std::system_error if the system cannot start another thread.
  template <typename Work>
  void Start(const Work& work) {
    threads_.emplace_back(work);
  }

 private:
  std::vector<std::thread> threads_;
};

// Calls `solve(first, count)` for blocks that together cover 0 to `count`, in the given number of
// threads.
template <typename Solve>
void InThreads(std::size_t count, std::size_t threads, const Solve& solve) {
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t block = next++; block < blocks; block = next++) {
      solve(block * kBlock, std::min(kBlock, count - block * kBlock));
    }
  };
  const std::size_t useful = std::min(threads, blocks);
  Helpers helpers(useful);
  for (std::size_t i = 1; i < useful; ++i) {
    try {
      helpers.Start(work);
    } catch (const std::system_error&) {
      break;  // the system gives no more threads; those that run suffice
    }
  }
  work();
}

void Check(std::span<const ArmCommand> commands, const ManySolutions& solutions,
           const SolveManyOptions& options) {
  const auto check = [&commands](const auto& span, const char* name) {
    if (span && span->size() != commands.size()) {
      throw std::invalid_argument("SolveMany: " + std::string(name) + " has " +
                                  std::to_string(span->size()) + " elements for " +
                                  std::to_string(commands.size()) +
                                  " commands. Give one element for each command");
    }
  };
  check(solutions.poses, "poses");
  check(solutions.angles_rad, "angles_rad");
  check(solutions.used, "used");
  check(solutions.origins, "origins");
  check(solutions.distances_rad, "distances_rad");
  if (options.threads == 0) {
    throw std::invalid_argument("SolveMany: 0 threads. Give at least 1");
  }
  if (!HasInstructions(options.instructions)) {
    throw std::invalid_argument(
        "SolveMany: this processor has no AVX2. Give Instructions::kQuickest");
  }
}

}  // namespace

bool HasInstructions(Instructions instructions) noexcept {
#if GIRDLE_HAS_AVX2
  return instructions != Instructions::kAvx2 || __builtin_cpu_supports("avx2") != 0;
#else
  return instructions != Instructions::kAvx2;
#endif
}

// Solves the commands of one block.
class ManySolver {
 public:
  ManySolver(const ShoulderRhythm& rhythm, const ManySolutions& solutions,
             const SolveManyOptions& options) noexcept
      : rhythm_(rhythm),
        solutions_(solutions),
        has_avx2_(options.instructions != Instructions::kPortable &&
                  HasInstructions(Instructions::kAvx2)) {}

  void Solve(std::span<const ArmCommand> commands, std::size_t first) const noexcept {
    std::array<ShoulderPose, kBlock> own_poses;  // NOLINT(*-member-init): set by SolvePoses
    const std::span poses = solutions_.poses ? solutions_.poses->subspan(first, commands.size())
                                             : std::span(own_poses).first(commands.size());
    if (solutions_.poses || solutions_.angles_rad || solutions_.used || solutions_.origins ||
        solutions_.distances_rad) {
      SolvePoses(commands, first, poses);
    }
    if (solutions_.angles_rad) {
      FindAngles(poses, solutions_.angles_rad->subspan(first, commands.size()));
    }
  }

 private:
  // Commands sorted by region, each region in whole fours behind the one before.
  struct Sorted {
    static constexpr std::size_t kMost = kBlock + SmoothRhythm::kRegions * (Four::kSize - 1);
    alignas(Four) std::array<double, kMost> elevations_rad;
    alignas(Four) std::array<double, kMost> planes_rad;
    std::array<std::uint16_t, kMost> places;
  };

  void SolvePoses(std::span<const ArmCommand> commands, std::size_t first,
                  std::span<ShoulderPose> poses) const noexcept {
    const bool by_fours = GIRDLE_HAS_AVX2 != 0 && has_avx2_ && rhythm_.smooth() != nullptr;
    std::array<double, kBlock> elevations_rad;  // NOLINT(*-member-init): those to come
    std::array<double, kBlock> planes_rad;      // NOLINT(*-member-init)
    std::array<std::uint16_t, kBlock> places;   // NOLINT(*-member-init)
    std::size_t count = 0;
    bool all_in_table = true;
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const ArmCommand& command = commands[i];
      ArmCommand used = command;
      if (!rhythm_.IsPlain(command)) [[unlikely]] {
        used = rhythm_.WithinRange(command);
        all_in_table = false;
      }
      const bool has_extras =
          used.axial_rad != 0 || used.shrug_rad != 0 || used.protraction_rad != 0;
      if (!by_fours || has_extras) {
        poses[i] = rhythm_.PoseFor(used);
      } else {
        elevations_rad[count] = used.elevation_rad;
        planes_rad[count] = used.plane_rad;
        places[count] = static_cast<std::uint16_t>(i);
        ++count;
      }
      Report(first + i, command, used);
    }
#if GIRDLE_HAS_AVX2
    if (count > 0) {
      SolveFours(std::span(elevations_rad).first(count), std::span(planes_rad).first(count),
                 std::span(places).first(count), all_in_table, poses);
    }
#endif
  }

  void Report(std::size_t i, const ArmCommand& command, const ArmCommand& used) const noexcept {
    if (solutions_.used) {
      (*solutions_.used)[i] = used;
    }
    if (solutions_.origins) {
      (*solutions_.origins)[i] =
          rhythm_.OriginFor(command, rhythm_.table().CellAt(used.elevation_rad, used.plane_rad));
    }
    if (solutions_.distances_rad) {
      (*solutions_.distances_rad)[i] = rhythm_.DistanceFor(command, used);
    }
  }

#if GIRDLE_HAS_AVX2
  void SolveFours(std::span<const double> elevations_rad, std::span<const double> planes_rad,
                  std::span<const std::uint16_t> places, bool all_in_table,
                  std::span<ShoulderPose> poses) const noexcept {
    constexpr std::size_t kRegions = SmoothRhythm::kRegions;
    const SmoothRhythm& smooth = *rhythm_.smooth();
    std::array<std::uint8_t, kBlock> regions;    // NOLINT(*-member-init): set below
    std::array<std::size_t, kRegions> sizes{};   // of the regions
    std::array<std::size_t, kRegions> starts{};  // of the regions among those sorted
    if (all_in_table) {
      regions.fill(0);
      sizes[0] = places.size();
    } else {
      for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t region = smooth.RegionOf(elevations_rad[i], planes_rad[i]);
        regions[i] = static_cast<std::uint8_t>(region);
        ++sizes[region];
      }
    }
    std::size_t next = 0;
    for (std::size_t region = 0; region < kRegions; ++region) {
      starts[region] = next;
      next += (sizes[region] + Four::kSize - 1) / Four::kSize * Four::kSize;
    }
    Sorted sorted;  // NOLINT(*-member-init): as far as it is used
    std::array<std::size_t, kRegions> ends = starts;
    const auto put = [&](std::size_t region, double theta, double psi, std::uint16_t place) {
      const std::size_t end = ends[region]++;
      sorted.elevations_rad[end] = theta;
      sorted.planes_rad[end] = psi;
      sorted.places[end] = place;
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
      put(regions[i], elevations_rad[i], planes_rad[i], places[i]);
    }
    for (std::size_t region = 0; region < kRegions; ++region) {
      if (sizes[region] == 0) {
        continue;
      }
      while (ends[region] % Four::kSize != 0) {
        const std::size_t last = ends[region] - 1;
        put(region, sorted.elevations_rad[last], sorted.planes_rad[last], sorted.places[last]);
      }
      const std::size_t start = starts[region];
      const std::size_t size = ends[region] - start;
      const FourWork work{smooth, std::span(sorted.elevations_rad).subspan(start, size),
                          std::span(sorted.planes_rad).subspan(start, size),
                          std::span(sorted.places).subspan(start, size), poses};
      if (region != 0) {
        SolveBeyondTable(work);
      } else if (rhythm_.options().closure == Closure::kExact) {
        SolveInTable(work);
      } else {
        SolveInTableWithItsArm(work);
      }
    }
  }
#endif

  void FindAngles(std::span<const ShoulderPose> poses,
                  std::span<JointAngles> angles_rad) const noexcept {
#if GIRDLE_HAS_AVX2
    if (has_avx2_) {
      Angles(poses, angles_rad);
      return;
    }
#endif
    for (std::size_t i = 0; i < poses.size(); ++i) {
      angles_rad[i] = AnglesFromPose(poses[i]);
    }
  }

  const ShoulderRhythm& rhythm_;
  const ManySolutions& solutions_;
  bool has_avx2_;
};

void SolveMany(const ShoulderRhythm& rhythm, std::span<const ArmCommand> commands,
               const ManySolutions& solutions, const SolveManyOptions& options) {
  Check(commands, solutions, options);
  const ManySolver solver(rhythm, solutions, options);
  InThreads(commands.size(), options.threads, [&](std::size_t first, std::size_t count) noexcept {
    solver.Solve(commands.subspan(first, count), first);
  });
}

void SolveMany(const AssembledRhythm& rhythm, std::span<const ArmCommand> commands,
               const ManySolutions& solutions, const SolveManyOptions& options) {
  if (rhythm.assembly() == Assembly::kTree) {
    SolveMany(rhythm.rhythm(), commands, solutions, options);
    return;
  }
  Check(commands, solutions, options);
  InThreads(commands.size(), options.threads, [&](std::size_t first, std::size_t count) noexcept {
    for (std::size_t i = first; i < first + count; ++i) {
      ArmCommand used;
      const ShoulderPose pose = rhythm.SolvePose(commands[i], &used);
      if (solutions.poses) {
        (*solutions.poses)[i] = pose;
      }
      if (solutions.angles_rad) {
        (*solutions.angles_rad)[i] = DrivenAngles(rhythm.assembly(), pose);
      }
      if (solutions.used) {
        (*solutions.used)[i] = used;
      }
    }
  });
  SolveMany(rhythm.rhythm(), commands,
            {.origins = solutions.origins, .distances_rad = solutions.distances_rad}, options);
}

}  // namespace girdle
