// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <thread>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

constexpr std::array thread_counts{1U, 2U, 5U};

/// Kinematic vehicles under `algorithm`, near each other in a box, each on its way somewhere. More than 150
/// have as much room each as these.
Scenario crowd(std::size_t count, const std::string& algorithm) {
  Scenario scenario{.name = "crowd", .duration_s = 5.0};
  scenario.perception.range_m = 15.0;
  Rng rng{7};
  const double room = std::fmax(1.0, std::cbrt(static_cast<double>(count) / 150.0));
  const auto anywhere = [&] {
    return Vec3{rng.uniform(0, 60 * room), rng.uniform(0, 60 * room), rng.uniform(5, 5 + 25 * room)};
  };
  for (std::size_t i = 0; i < count; ++i) {
    VehicleSpec vehicle{.id = static_cast<std::uint32_t>(i),
                        .name = "v" + std::to_string(i),
                        .model = Choice{.name = "kinematic"},
                        .avoider = Choice{.name = algorithm},
                        .position = anywhere(),
                        .radius_m = 0.5,
                        .priority = static_cast<std::int32_t>(i),
                        .cooperative = i % 10 != 0};
    vehicle.limits.max_speed = 0.5;
    vehicle.mission = {{.kind = LegKind::transit, .position = anywhere(), .speed_mps = 0.5}};
    scenario.vehicles.push_back(std::move(vehicle));
  }
  return scenario;
}

/// Of every frame and of the tracks in it.
struct Hash final : FrameSink {
  explicit Hash(bool tracks) : with_tracks{tracks} {}
  void write(const Frame& frame) override {
    value = mix_hash(mix_hash(value, frame_hash(frame)), with_tracks ? perception_hash(frame) : 0);
  }
  bool wants_tracks() const override { return with_tracks; }

  bool with_tracks;
  std::uint64_t value{};
};

TEST(Threads, AnyNumberOfThemGivesTheSameBits) {
  for (const char* algorithm : {"orca3d", "apf+stop_and_wait"}) {
    for (const bool with_tracks : {false, true}) {
      std::vector<std::uint64_t> hashes;
      std::vector<std::vector<Measure>> measures;
      for (const std::size_t threads : thread_counts) {
        Simulation simulation{crowd(150, algorithm), builtin_catalogs()};
        simulation.share_out(threads);
        Hash hash{with_tracks};
        RunMetrics metrics{{6.0, 3.0}};
        const std::array<FrameSink*, 2> sinks{&hash, &metrics};
        simulation.run(sinks);
        hashes.push_back(hash.value);
        measures.push_back(metrics.measures());
      }
      EXPECT_EQ(hashes, std::vector(thread_counts.size(), hashes[0])) << algorithm;
      EXPECT_EQ(measures, std::vector(thread_counts.size(), measures[0])) << algorithm;
    }
  }
}

/// While somebody sees every decision, each vehicle is asked alone.
struct Onlooker final : DecisionObserver {
  void see(std::size_t, const Situation&, const Command&) override { ++seen; }
  int seen{};
};

TEST(Company, WhoDecidesTogetherDecidesAsAlone) {
  for (const bool with_tracks : {false, true}) {
    for (const int steps_per_decision : {1, 4}) {
      Scenario scenario = crowd(150, "orca3d");
      scenario.steps_per_decision = steps_per_decision;
      for (std::size_t i = 0; i < scenario.vehicles.size(); i += 7)
        scenario.vehicles[i].avoider = Choice{.name = i % 2 == 0 ? "apf" : "orca3d+stop_and_wait"};
      scenario.obstacles.push_back(
          {.kind = Obstacle::Kind::sphere, .charted = false, .position = {30, 30, 15}, .radius = 4.0});
      std::vector<std::uint64_t> hashes;
      for (const bool alone : {false, true}) {
        Simulation simulation{scenario, builtin_catalogs()};
        Onlooker onlooker;
        if (alone) simulation.observe(&onlooker);
        Hash hash{with_tracks};
        const std::array<FrameSink*, 1> sinks{&hash};
        simulation.run(sinks);
        EXPECT_EQ(onlooker.seen > 0, alone);
        hashes.push_back(hash.value);
      }
      EXPECT_EQ(hashes[0], hashes[1]) << "every " << steps_per_decision;
    }
  }
}

TEST(Company, WhoDecidesTogetherIsCountedAndTimed) {
  Scenario scenario = crowd(20, "orca3d");
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.time_decisions();
  for (int i = 0; i < 10; ++i) simulation.step({});
  const DecisionTimes times = simulation.decision_times();
  EXPECT_EQ(times.count, 200);
  EXPECT_GT(times.total_s, 0.0);
  EXPECT_LE(times.worst_s, times.total_s);
}

TEST(Threads, OfTwoThatBreakTheFirstOneIsNamed) {
  for (const std::size_t threads : thread_counts) {
    Simulation simulation{crowd(150, "orca3d"), builtin_catalogs()};
    simulation.share_out(threads);
    simulation.look();
    for (const std::size_t index : {140U, 70U})
      simulation.order(index, {.velocity = Vec3::Constant(std::nan(""))});
    simulation.act({});
    ASSERT_TRUE(simulation.divergence());
    EXPECT_EQ(simulation.divergence()->vehicle, 70U);
  }
}

RunMetrics metrics_of(const Scenario& scenario) {
  Surroundings surroundings;
  for (const ObstacleSpec& spec : scenario.obstacles)
    surroundings.obstacles.push_back({spec.view(), spec.velocity});
  return RunMetrics{{6.0, 3.0}, std::move(surroundings)};
}

/// In so many steps after the first `first_steps`.
long allocations_in(int steps, const Scenario& scenario, std::size_t threads, int first_steps = 3,
                    bool measured = true) {
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.share_out(threads);
  RunMetrics metrics = metrics_of(scenario);
  const std::array<FrameSink*, 1> metrics_alone{&metrics};
  const std::span<FrameSink* const> sinks{metrics_alone.data(), measured ? 1U : 0U};
  for (int i = 0; i < first_steps; ++i) simulation.step(sinks);
  const long before = allocation_count();
  for (int i = 0; i < steps; ++i) simulation.step(sinks);
  return allocation_count() - before;
}

TEST(Threads, NothingAllocatesAfterTheFirstSteps) {
  for (const std::size_t count : {8U, 150U, 1000U})
    for (const bool measured : {true, false})
      for (const std::size_t threads : {1U, 3U})
        EXPECT_EQ(allocations_in(50, crowd(count, "orca3d"), threads, 3, measured), 0)
            << count << " on " << threads << (measured ? ", measured" : "");
}

/// A crowd among so many obstacles, some of them charted, some drifting, which it meets within 20 m.
Scenario among(std::size_t obstacles, const std::string& algorithm) {
  Scenario scenario = crowd(150, algorithm);
  scenario.perception.obstacle_range_m = 20.0;
  Rng rng{8};
  const auto anywhere = [&] {
    return Vec3{rng.uniform(-100, 160), rng.uniform(-100, 160), rng.uniform(0, 40)};
  };
  for (std::size_t i = 0; i < obstacles; ++i) {
    ObstacleSpec spec{.charted = i % 2 == 0, .position = anywhere(), .radius = 1.0};
    if (i % 10 == 1) spec.velocity = {0.1, 0.2, 0.0};
    if (i % 3 == 1 && !spec.moves()) {
      spec.kind = Obstacle::Kind::segment;
      spec.from = spec.position;
      spec.to = spec.position + Vec3{3, 5, 1};
    }
    scenario.obstacles.push_back(spec);
  }
  return scenario;
}

TEST(Threads, NothingAllocatesAmongManyObstacles) {
  for (const char* algorithm : {"orca3d", "apf+stop_and_wait", "rvo", "direct"})
    for (const std::size_t threads : {1U, 3U})
      EXPECT_EQ(allocations_in(24, among(2000, algorithm), threads), 0) << algorithm << " on " << threads;
}

TEST(Threads, AmongManyObstaclesWhoIsShownAllOfThemDecidesTheSame) {
  for (const char* algorithm : {"orca3d", "apf+stop_and_wait", "bvc", "rvo", "direct"}) {
    const Scenario scenario = among(300, algorithm);
    std::vector<std::uint64_t> hashes;
    std::vector<std::vector<Measure>> measures;
    for (const std::size_t threads : {0U, 1U, 2U, 3U}) {
      Simulation simulation{scenario, builtin_catalogs()};
      Onlooker onlooker;
      if (threads == 0) simulation.observe(&onlooker);  // and is shown all
      simulation.share_out(threads);
      Hash hash{threads == 2};
      RunMetrics metrics = metrics_of(scenario);
      const std::array<FrameSink*, 2> sinks{&hash, &metrics};
      simulation.run(sinks);
      if (!hash.with_tracks) hashes.push_back(hash.value);
      measures.push_back(metrics.measures());
    }
    EXPECT_EQ(hashes, std::vector(hashes.size(), hashes[0])) << algorithm;
    EXPECT_EQ(measures, std::vector(measures.size(), measures[0])) << algorithm;
  }
}

TEST(Threads, NothingAllocatesUnderModemsOnceEveryoneHasSpoken) {
  Scenario scenario = crowd(64, "orca3d");
  scenario.exchange.name = "acoustic";
  scenario.duration_s = 600.0;
  EXPECT_EQ(allocations_in(1000, scenario, 1, 4000), 0);
}

TEST(Threads, ACopyHasItsOwn) {
  Simulation a{crowd(100, "orca3d"), builtin_catalogs()};
  a.share_out(2);
  for (int i = 0; i < 10; ++i) a.step({});
  Simulation b = a;
  std::thread other{[&] {
    for (int i = 0; i < 20; ++i) b.step({});
  }};
  for (int i = 0; i < 20; ++i) a.step({});
  other.join();
  for (std::size_t i = 0; i < 100; ++i)
    EXPECT_EQ(a.agents()[i].vehicle.state().p_n, b.agents()[i].vehicle.state().p_n);
}

}  // namespace
}  // namespace fairway
