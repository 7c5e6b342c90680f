// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How long things take, as ratios of figures taken in turn in the same run:
///   speed [GIRDLE] [PLUGIN]
/// with the paths of the program and of the plugin, by default those of this build. Options of
/// Google Benchmark (--benchmark_filter=REGEX and so on) go before them.
#include <benchmark/benchmark.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <memory>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/solve_many.h"
#include "mjcf/shoulder_model.h"
#include "pictures/frame_renderer.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/engine.h"
#include "skin/bone_heat.h"
#include "skin/bone_shapes.h"
#include "skin/bound_skin.h"
#include "skin/implicit_body.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr std::size_t kPoses = 4096;  // a power of two: the next one is a bit mask away
constexpr unsigned kSeed = 20090201;

// All things in turn, so many times.
constexpr int kRounds = 41;

constexpr const char* kFloor = "three glm::slerp";
constexpr const char* kHeldWithout = "mj_step, nine position servos, targets held";
constexpr const char* kHeldWith = "mj_step, plugin and sensor, commands held";
constexpr const char* kMovingWithout = "mj_step, nine position servos, given each pose";
constexpr const char* kMovingWith = "mj_step, plugin and sensor, another pose each step";

// Models whose steps are compared, plugin and sensor, commands held.
struct AssembledModel {
  const char* name;
  Assembly assembly;
  Sides sides;
};
constexpr AssembledModel kTreeRight{"tree, right", Assembly::kTree, Sides::kRight};
constexpr AssembledModel kLoopRight{"loop, right", Assembly::kLoop, Sides::kRight};
constexpr AssembledModel kTreeBoth{"tree, both", Assembly::kTree, Sides::kBoth};
constexpr AssembledModel kLoopBoth{"loop, both", Assembly::kLoop, Sides::kBoth};

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A rectangle of positions.
struct Region {
  std::array<double, 2> elevations_deg;
  std::array<double, 2> planes_deg;
};
constexpr Region kTable{{15, 120}, {0, 90}};
// Beyond each edge of it and each corner, where an arm still goes.
constexpr std::array<Region, 4> kBesideTable = {
    {{{15, 120}, {90, 135}}, {{15, 60}, {-60, 0}}, {{120, 180}, {0, 90}}, {{0, 15}, {0, 90}}}};
constexpr std::array<Region, 4> kCorners = {
    {{{120, 180}, {90, 135}}, {{120, 180}, {-30, 0}}, {{0, 15}, {90, 135}}, {{0, 15}, {-60, 0}}}};

// Random positions, as many of each region.
std::vector<ArmCommand> CommandsIn(std::span<const Region> regions) {
  std::mt19937_64 random(kSeed);
  std::vector<ArmCommand> commands(kPoses);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Region& region = regions[i % regions.size()];
    std::uniform_real_distribution<double> elevation_deg(region.elevations_deg[0],
                                                         region.elevations_deg[1]);
    std::uniform_real_distribution<double> plane_deg(region.planes_deg[0], region.planes_deg[1]);
    const double theta_deg = elevation_deg(random);
    commands[i] = {RadiansFromDegrees(theta_deg), RadiansFromDegrees(plane_deg(random))};
  }
  return commands;
}

// Positions of the arm all over the table.
const std::vector<ArmCommand>& RandomCommands() {
  static const std::vector<ArmCommand> kCommands = CommandsIn(std::span(&kTable, 1));
  return kCommands;
}

// Runs `solve` on one command after the other.
template <typename Solve>
void ForEachCommand(benchmark::State& state, const Solve& solve) {
  const std::vector<ArmCommand>& commands = RandomCommands();
  std::size_t i = 0;
  for ([[maybe_unused]] auto iteration : state) {
    benchmark::DoNotOptimize(solve(commands[i]));
    i = (i + 1) % kPoses;
  }
}

void RegisterPoses() {
  // What a user of GLM would do: each joint between two rows of the table.
  benchmark::RegisterBenchmark(kFloor, [](benchmark::State& state) {
    const RhythmTable table = BuiltInRhythmTable(BuiltInTable::kMeasured);
    struct Segment {
      std::array<glm::dquat, kJointCount> from;
      std::array<glm::dquat, kJointCount> to;
      double t;
    };
    std::mt19937_64 random(kSeed);
    std::uniform_int_distribution<std::size_t> plane(0, table.planes_rad().size() - 1);
    std::uniform_int_distribution<std::size_t> row(0, table.elevations_rad().size() - 2);
    std::uniform_real_distribution<double> t(0, 1);
    std::vector<Segment> segments(kPoses);
    for (Segment& segment : segments) {
      const std::size_t j = plane(random);
      const std::size_t i = row(random);
      const ShoulderPose a = PoseFromAngles(table.position(j, i).angles_rad);
      const ShoulderPose b = PoseFromAngles(table.position(j, i + 1).angles_rad);
      segment = {{a.q_TC, a.q_CS, a.q_SH}, {b.q_TC, b.q_CS, b.q_SH}, t(random)};
    }
    std::size_t i = 0;
    for ([[maybe_unused]] auto iteration : state) {
      const Segment& s = segments[i];
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        benchmark::DoNotOptimize(glm::slerp(s.from[joint], s.to[joint], s.t));
      }
      i = (i + 1) % kPoses;
    }
  });
  const auto quaternions = [](const char* name, const RhythmOptions& options) {
    const auto rhythm = std::make_shared<const ShoulderRhythm>(BuiltInRhythm(options));
    benchmark::RegisterBenchmark(name, [rhythm](benchmark::State& state) {
      ForEachCommand(state, [&](const ArmCommand& c) { return rhythm->SolvePose(c); });
    });
  };
  const auto angles = [](const char* name, const RhythmOptions& options) {
    const auto rhythm = std::make_shared<const ShoulderRhythm>(BuiltInRhythm(options));
    benchmark::RegisterBenchmark(name, [rhythm](benchmark::State& state) {
      ForEachCommand(state,
                     [&](const ArmCommand& c) { return AnglesFromPose(rhythm->SolvePose(c)); });
    });
  };
  const auto rates = [](const char* name, const RhythmOptions& options) {
    const auto rhythm = std::make_shared<const ShoulderRhythm>(BuiltInRhythm(options));
    benchmark::RegisterBenchmark(name, [rhythm](benchmark::State& state) {
      ForEachCommand(state, [&](const ArmCommand& c) { return rhythm->SolveRates(c); });
    });
  };
  const RhythmOptions slerp{Interpolation::kSlerp, Closure::kTable, {}};
  const RhythmOptions squad{Interpolation::kSquad, Closure::kTable, {}};
  const RhythmOptions smooth{Interpolation::kSmooth, Closure::kTable, {}};
  quaternions("slerp", slerp);
  quaternions("squad, as published", squad);
  quaternions("smooth", smooth);
  rates("smooth, with first derivatives", smooth);
  quaternions("smooth and exact", {});
  rates("smooth and exact, with first derivatives", {});
  angles("slerp, Euler angles", slerp);
  angles("squad, Euler angles", squad);
  angles("smooth, Euler angles", smooth);
  angles("smooth and exact, Euler angles", {});
  const auto rhythm = std::make_shared<const ShoulderRhythm>(BuiltInRhythm());
  benchmark::RegisterBenchmark(
      "smooth and exact, all derivatives of the angles", [rhythm](benchmark::State& state) {
        ForEachCommand(state, [&](const ArmCommand& c) { return rhythm->SolveDerivatives(c); });
      });
}

// What SolveMany is held against, everything in the same run.
struct ManyPoses {
  std::string place;
  std::vector<ArmCommand> commands;
};
std::vector<ManyPoses> ManyPlaces() {
  return {{"inside", RandomCommands()},
          {"outside", CommandsIn(kBesideTable)},
          {"corners", CommandsIn(kCorners)}};
}
std::string OneByOne(const std::string& place) { return place + ", one by one"; }
std::string OneByOneAngles(const std::string& place) { return place + ", angles, one by one"; }
std::string Many(const std::string& place, int threads) {
  return place + (threads == 1 ? ", SolveMany, one thread" : ", SolveMany, two threads, wall time");
}
std::string ManyAngles(const std::string& place) { return place + ", angles, SolveMany"; }
std::string RatesOneByOne(const std::string& place) {
  return place + ", first derivatives, one by one";
}

void RegisterMany() {
  const auto rhythm = std::make_shared<const ShoulderRhythm>(BuiltInRhythm());
  // Times are of all commands; where there are threads, real ones.
  const auto add = [](const std::string& name, bool has_threads, const auto& work) {
    auto* added = benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) {
      for ([[maybe_unused]] auto iteration : state) {
        work();
        benchmark::ClobberMemory();
      }
    });
    if (has_threads) {
      added->UseRealTime();
    }
  };
  for (const ManyPoses& many : ManyPlaces()) {
    const auto commands = std::make_shared<const std::vector<ArmCommand>>(many.commands);
    const auto poses = std::make_shared<std::vector<ShoulderPose>>(kPoses);
    const auto angles_rad = std::make_shared<std::vector<JointAngles>>(kPoses);
    const auto rates = std::make_shared<std::vector<ShoulderRates>>(kPoses);
    add(OneByOne(many.place), false, [=] {
      for (std::size_t i = 0; i < kPoses; ++i) {
        (*poses)[i] = rhythm->SolvePose((*commands)[i]);
      }
    });
    for (const int threads : {1, 2}) {
      add(Many(many.place, threads), threads > 1, [=] {
        SolveMany(*rhythm, *commands, {.poses = *poses},
                  {.threads = static_cast<std::size_t>(threads)});
      });
    }
    add(OneByOneAngles(many.place), false, [=] {
      for (std::size_t i = 0; i < kPoses; ++i) {
        (*angles_rad)[i] = AnglesFromPose(rhythm->SolvePose((*commands)[i]));
      }
    });
    add(ManyAngles(many.place), false,
        [=] { SolveMany(*rhythm, *commands, {.angles_rad = *angles_rad}); });
    add(RatesOneByOne(many.place), false, [=] {
      for (std::size_t i = 0; i < kPoses; ++i) {
        (*rates)[i] = *rhythm->SolveRates((*commands)[i]);
      }
    });
  }
}

constexpr int kStepsPerRun = 2000;

// Every step asks for another pose, so that nothing can be reused.
ArmCommand CommandOf(int step) {
  return {RadiansFromDegrees(60 + 0.01 * step), RadiansFromDegrees(20 + 0.02 * step)};
}

// Controls of such steps: the commands for the plugin, the joints' angles for servos.
std::vector<std::vector<double>> MovingControls(Actuation actuation) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  std::vector<std::vector<double>> controls;
  for (int step = 0; step < kStepsPerRun; ++step) {
    const ArmCommand command = CommandOf(step);
    const JointAngles angles_rad = AnglesFromPose(rhythm.SolvePose(command));
    controls.emplace_back(angles_rad.begin(), angles_rad.end());
    if (actuation == Actuation::kPlugin) {
      controls.back() = {command.elevation_rad, command.plane_rad};
    }
  }
  return controls;
}

// Steps a model from its fourth keyframe, anew after so many steps.
void Step(benchmark::State& state, const mjModel& model,
          const std::vector<std::vector<double>>& controls) {
  const DataPointer data = MakeData(model);
  int step = kStepsPerRun;
  for ([[maybe_unused]] auto iteration : state) {
    if (step == kStepsPerRun) {
      state.PauseTiming();
      mj_resetDataKeyframe(&model, data.get(), 3);
      step = 0;
      state.ResumeTiming();
    }
    if (!controls.empty()) {
      std::copy(controls[step].begin(), controls[step].end(), data->ctrl);
    }
    mj_step(&model, data.get());
    ++step;
  }
}

void RegisterEngine() {
  const auto load = [](const ShoulderModelOptions& options) {
    return std::shared_ptr<const mjModel>(LoadModel(
        {{"shoulder.xml", ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm(), options)}}));
  };
  const auto model_of = [load](Actuation actuation) { return load({.actuation = actuation}); };
  benchmark::RegisterBenchmark("mj_kinematics of the model",
                               [model = model_of(Actuation::kPlugin)](benchmark::State& state) {
                                 const DataPointer data = MakeData(*model);
                                 for ([[maybe_unused]] auto iteration : state) {
                                   mj_kinematics(model.get(), data.get());
                                 }
                               });
  const auto step = [=](const char* name, Actuation actuation, bool moves) {
    benchmark::RegisterBenchmark(
        name, [model = model_of(actuation),
               controls = moves ? MovingControls(actuation) : std::vector<std::vector<double>>()](
                  benchmark::State& state) { Step(state, *model, controls); });
  };
  step(kHeldWithout, Actuation::kPosition, false);
  step(kHeldWith, Actuation::kPlugin, false);
  step(kMovingWithout, Actuation::kPosition, true);
  step(kMovingWith, Actuation::kPlugin, true);
  for (const AssembledModel& assembled : {kTreeRight, kLoopRight, kTreeBoth, kLoopBoth}) {
    benchmark::RegisterBenchmark(
        assembled.name, [model = load({.sides = assembled.sides, .assembly = assembled.assembly})](
                            benchmark::State& state) { Step(state, *model, {}); });
  }
}

// Keeps the times of all rounds; prints nothing by itself. What other programs take of a shared
// machine does not count.
class RoundReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const bool real = !run.run_name.time_type.empty();
      times_ns_[run.run_name.function_name].push_back(real ? run.GetAdjustedRealTime()
                                                           : run.GetAdjustedCPUTime());
    }
  }

  /// Nothing that was filtered away is known.
  [[nodiscard]] bool Has(const std::string& name) const { return times_ns_.contains(name); }
  [[nodiscard]] double Time_ns(const std::string& name) const { return Median(times_ns_.at(name)); }
  /// Of the times in the same round: a machine that changes its pace changes both.
  [[nodiscard]] double Ratio(const std::string& name, const std::string& to) const {
    std::vector<double> ratios = times_ns_.at(name);
    const std::vector<double>& floor = times_ns_.at(to);
    for (std::size_t round = 0; round < ratios.size(); ++round) {
      ratios[round] /= floor.at(round);
    }
    return Median(std::move(ratios));
  }

 private:
  std::map<std::string, std::vector<double>> times_ns_;
};

void PrintPoses(const RoundReporter& times) {
  if (!times.Has(kFloor)) {
    return;
  }
  std::printf("%-50s %9s %22s\n", "one pose, all three joints, random", "ns", kFloor);
  for (const char* name :
       {kFloor, "slerp", "squad, as published", "smooth", "smooth, with first derivatives",
        "smooth and exact", "smooth and exact, with first derivatives", "slerp, Euler angles",
        "squad, Euler angles", "smooth, Euler angles", "smooth and exact, Euler angles",
        "smooth and exact, all derivatives of the angles", "mj_kinematics of the model"}) {
    if (times.Has(name)) {
      std::printf("%-50s %9.1f %20.2f x\n", name, times.Time_ns(name), times.Ratio(name, kFloor));
    }
  }
}

void PrintMany(const RoundReporter& times) {
  std::printf("\n%-50s %9s %22s %12s\n", "smooth and exact, 4096 random poses, each pose", "ns",
              kFloor, "one by one");
  for (const ManyPoses& many : ManyPlaces()) {
    const std::string& place = many.place;
    for (const auto& [name, one_by_one] :
         {std::pair{OneByOne(place), OneByOne(place)}, std::pair{Many(place, 1), OneByOne(place)},
          std::pair{Many(place, 2), OneByOne(place)},
          std::pair{OneByOneAngles(place), OneByOneAngles(place)},
          std::pair{ManyAngles(place), OneByOneAngles(place)},
          std::pair{RatesOneByOne(place), RatesOneByOne(place)}}) {
      if (times.Has(kFloor) && times.Has(name) && times.Has(one_by_one)) {
        constexpr auto kCount = static_cast<double>(kPoses);
        std::printf("%-50s %9.1f %20.2f x %10.2f x\n", name.c_str(), times.Time_ns(name) / kCount,
                    times.Ratio(name, kFloor) / kCount, times.Ratio(name, one_by_one));
      }
    }
  }
}

void PrintSteps(const RoundReporter& times) {
  std::printf("\n%-50s %9s %22s\n", "one step of the right shoulder", "ns", "added by the plugin");
  for (const auto& [without, with] :
       {std::pair{kHeldWithout, kHeldWith}, std::pair{kMovingWithout, kMovingWith}}) {
    if (times.Has(without) && times.Has(with)) {
      std::printf("%-50s %9.0f\n", without, times.Time_ns(without));
      std::printf("%-50s %9.0f %+20.1f %%\n", with, times.Time_ns(with),
                  100 * (times.Ratio(with, without) - 1));
    }
  }
}

void PrintAssemblies(const RoundReporter& times) {
  constexpr double kNanosecondsPerSecond = 1e9;
  std::printf("\n%-50s %9s %11s %10s\n", "one step, plugin and sensor, commands held", "ns",
              "steps/s", "of a tree");
  for (const auto& [tree, loop] :
       {std::pair{kTreeRight, kLoopRight}, std::pair{kTreeBoth, kLoopBoth}}) {
    for (const AssembledModel& model : {tree, loop}) {
      if (times.Has(tree.name) && times.Has(model.name)) {
        const double time_ns = times.Time_ns(model.name);
        std::printf("%-50s %9.0f %11.0f %8.2f x\n", model.name, time_ns,
                    kNanosecondsPerSecond / time_ns, times.Ratio(model.name, tree.name));
      }
    }
  }
}

// Random positions as a file.
void WritePoses(const std::filesystem::path& path, int rows) {
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> elevation_deg(15, 120);
  std::uniform_real_distribution<double> plane_deg(0, 90);
  std::ofstream out(path);
  std::string text = "elevation_deg,plane_deg\n";
  for (int row = 0; row < rows; ++row) {
    text += RoundedText(elevation_deg(random), 4) + "," + RoundedText(plane_deg(random), 4) + "\n";
  }
  out << text;
  if (!out.flush()) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

template <typename Work>
double Seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Seconds that so many runs of `girdle solve` at the same time take, from file to file.
double SolveSeconds(const std::string& girdle, const std::filesystem::path& folder, int threads,
                    int runs = 1) {
  std::string command;
  for (int run = 0; run < runs; ++run) {
    command += "'" + girdle + "' solve --in '" + (folder / "poses.csv").string() + "' --out '" +
               (folder / ("angles" + std::to_string(run) + ".csv")).string() + "' --threads " +
               std::to_string(threads) + " & ";
  }
  command += "wait";
  return Seconds([&command] {
    // NOLINTNEXTLINE(cert-env33-c): a program of this build, paths of this process
    if (std::system(command.c_str()) != 0) {
      throw std::runtime_error("failed: " + command);
    }
  });
}

void PrintRows(const std::string& girdle) {
  constexpr int kRows = 2'000'000;
  constexpr int kFileRounds = 7;
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       ("girdle_speed_" + std::to_string(std::random_device{}()));
  std::filesystem::create_directory(folder);
  WritePoses(folder / "poses.csv", kRows);
  std::vector<double> one;
  std::vector<double> two;
  std::vector<double> ratios;
  std::vector<double> possible;
  for (int round = 0; round < kFileRounds; ++round) {
    one.push_back(SolveSeconds(girdle, folder, 1));
    two.push_back(SolveSeconds(girdle, folder, 2));
    ratios.push_back(one.back() / two.back());
    possible.push_back(2 * one.back() / SolveSeconds(girdle, folder, 1, 2));
  }
  std::filesystem::remove_all(folder);
  std::printf("\n%-50s %9s %22s\n", "girdle solve, file to file, smooth and exact", "rows/s",
              "one thread");
  std::printf("%-50s %9.0f %20.2f x\n", "one thread", kRows / Median(one), 1.0);
  std::printf("%-50s %9.0f %20.2f x\n", "two threads", kRows / Median(two), Median(ratios));
  std::printf("%-50s %9s %20.2f x\n", "two programs at once, one thread each", "",
              Median(possible));
}

// One thing after another, for some rounds; times and ratios to the first.
struct Timed {
  const char* name;
  std::function<void()> work;
};
void PrintInTurn(const char* title, const char* first, const std::vector<Timed>& things) {
  constexpr int kThingRounds = 9;
  constexpr double kMillisecondsPerSecond = 1e3;
  std::vector<std::vector<double>> times_s(things.size());
  std::vector<std::vector<double>> ratios(things.size());
  for (int round = 0; round < kThingRounds; ++round) {
    for (std::size_t i = 0; i < things.size(); ++i) {
      times_s[i].push_back(Seconds(things[i].work));
      ratios[i].push_back(times_s[i].back() / times_s[0].back());
    }
  }
  std::printf("\n%-50s %9s %22s\n", title, "ms", first);
  for (std::size_t i = 0; i < things.size(); ++i) {
    std::printf("%-50s %9.1f %20.2f x\n", things[i].name,
                kMillisecondsPerSecond * Median(times_s[i]), Median(ratios[i]));
  }
}

void PrintSkins() {
  const std::vector<Side> sides = {Side::kRight, Side::kLeft};
  const std::vector<SkinBone> bones = SkinBonesOf(sides);
  const Anatomy anatomy = BuiltInAnatomy();
  PosedBody body;
  PrintInTurn("body of solids, both sides", "the surface alone",
              {{"surface about the bones", [&] { body = ImplicitBody(anatomy, sides); }},
               {"weights of the bones in it", [&] {
                  const SkinWeights weights = BoneHeat(body.surface, BoneShapesOf(body, bones));
                  benchmark::DoNotOptimize(Bind(body, bones, weights));
                }}});
}

// In software or not, as this machine draws.
void PrintPictures() {
  const std::string file = GIRDLE_SOURCE_DIR "/model/shoulder_skin/scene_both_position.xml";
  const ModelPointer model = LoadModel(file);
  const DataPointer data = MakeData(*model);
  mj_forward(model.get(), data.get());
  const auto drawing = [&](PictureSize size, Show show) {
    const auto renderer = std::make_shared<FrameRenderer>(
        *model, file, View{.camera = "front", .size = size, .show = show});
    return [renderer, &data] { benchmark::DoNotOptimize(renderer->Draw(*data)); };
  };
  const PictureSize full;
  const PictureSize tiny{64, 48};
  PrintInTurn("one frame, both sides", "of few pixels",
              {{"skin, 64 x 48 pixels", drawing(tiny, Show::kSkin)},
               {"skin, 640 x 480 pixels", drawing(full, Show::kSkin)},
               {"bones, 640 x 480 pixels", drawing(full, Show::kBones)}});
}

int Run(int argc, char** argv) {
  std::vector<std::string> words = {argv[0], "--benchmark_min_time=0.01"};
  words.insert(words.end(), argv + 1, argv + argc);
  std::vector<char*> pointers;
  pointers.reserve(words.size());
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  const std::string girdle = count > 1 ? pointers[1] : GIRDLE_BINARY_DIR "/girdle";
  const std::string plugin = count > 2 ? pointers[2] : GIRDLE_BINARY_DIR "/libgirdle_rhythm.so";

  const EngineWatch watch;
  LoadPlugin(plugin);
  RegisterPoses();
  RegisterMany();
  RegisterEngine();
  RoundReporter times;
  for (int round = 0; round < kRounds; ++round) {
    benchmark::RunSpecifiedBenchmarks(&times);
  }
  EngineWatch::ExpectNoWarning("stepping");
  PrintPoses(times);
  PrintMany(times);
  PrintSteps(times);
  PrintAssemblies(times);
  PrintRows(girdle);
  PrintSkins();
  PrintPictures();
  return 0;
}

}  // namespace
}  // namespace girdle

int main(int argc, char** argv) {
  try {
    return girdle::Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed: %s\n", error.what());
    return 2;
  }
}
