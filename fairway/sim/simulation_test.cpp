// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/record/frame_hash.hpp"

namespace fairway {
namespace {

VehicleSpec vehicle(std::uint32_t id, const Vec3& from, const Vec3& to, const std::string& model,
                    const std::string& algorithm) {
  VehicleSpec spec{.id = id,
                   .name = "v" + std::to_string(id),
                   .model = Choice{.name = model, .path = "model"},
                   .avoider = Choice{.name = algorithm, .path = "avoider"},
                   .position = from,
                   .yaw = std::atan2(to.y() - from.y(), to.x() - from.x()),
                   .radius_m = 1.5,
                   .priority = static_cast<std::int32_t>(id)};
  spec.limits.max_speed = 0.5;
  spec.mission = {{.kind = LegKind::transit, .position = to, .speed_mps = 0.5, .arrival_m = 2.0}};
  return spec;
}

/// Eight vehicles that swap places across a circle.
Scenario swap(const std::string& model, const std::string& algorithm) {
  Scenario scenario{.name = "swap", .duration_s = 400, .seed = 1};
  for (std::uint32_t i = 0; i < 8; ++i) {
    const double a = 2 * pi * i / 8 + 0.01 * i;
    const Vec3 from{20 * std::cos(a), 20 * std::sin(a), 10};
    scenario.vehicles.push_back(vehicle(i, from, {-from.x(), -from.y(), 10}, model, algorithm));
  }
  return scenario;
}

std::vector<Measure> measured(const Scenario& scenario) {
  RunMetrics metrics{{scenario.exam.crit_dist_m, scenario.exam.safety_distance_m}};
  const std::array<FrameSink*, 1> sinks{&metrics};
  Simulation{scenario, builtin_catalogs()}.run(sinks);
  return metrics.measures();
}

double value(const std::vector<Measure>& measures, const std::string& quantity,
             int vehicle = Measure::fleet) {
  for (const Measure& m : measures) {
    if (m.quantity == quantity && m.vehicle == vehicle) return m.value;
  }
  ADD_FAILURE() << quantity << " was not measured";
  return std::nan("");
}

TEST(Simulation, AloneAVehicleArrivesInAboutTheStraightLineTime) {
  Scenario scenario{.name = "alone", .duration_s = 200};
  scenario.vehicles = {vehicle(0, {0, 0, 5}, {40, 0, 5}, "kinematic", "orca3d")};
  const auto measures = measured(scenario);
  EXPECT_EQ(value(measures, "arrived_ratio"), 1.0);
  EXPECT_NEAR(value(measures, "navigation_time_s", 0), 76.0, 3.0);  // 38 m at 0.5 m/s
}

TEST(Simulation, TheSameScenarioGivesTheSameBits) {
  for (const char* algorithm : {"apf", "orca3d", "orca3d+stop_and_wait"}) {
    const Scenario scenario = swap("sparus2", algorithm);
    EXPECT_EQ(measured(scenario), measured(scenario)) << algorithm;
  }
}

TEST(Simulation, BetweenDecisionsACommandStands) {
  Scenario scenario = swap("kinematic", "apf");
  scenario.steps_per_decision = 4;
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.time_decisions();
  int changes = 0;
  Command before = simulation.agents()[0].pilot.command();
  for (int i = 0; i < 400; ++i) {
    simulation.step({});
    const Command& now = simulation.agents()[0].pilot.command();
    if (i % 4 != 0) {
      EXPECT_EQ(now, before) << i;
    }
    changes += now == before ? 0 : 1;
    before = now;
  }
  EXPECT_EQ(simulation.decision_times().count, 100 * 8);
  EXPECT_GT(changes, 50);
}

TEST(Simulation, WhoGoesUnderWayLaterDecidesAtOnce) {
  Scenario scenario{.name = "later", .duration_s = 20};
  scenario.steps_per_decision = 4;
  scenario.vehicles = {vehicle(0, {0, 0, 5}, {40, 0, 5}, "kinematic", "direct")};
  Leg wait{.kind = LegKind::keep_position};
  wait.duration_s = 5.0;
  scenario.vehicles[0].mission.insert(scenario.vehicles[0].mission.begin(), wait);
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.run({});
  EXPECT_GT(simulation.agents()[0].own.position.x(), 5.0);
}

TEST(Simulation, AStepDoesNotAllocate) {
  for (const char* model : {"sparus2", "kinematic"}) {
    for (const char* algorithm : {"direct", "apf", "orca3d", "apf+stop_and_wait", "orca3d+stop_and_wait"}) {
      const Scenario scenario = swap(model, algorithm);
      Simulation simulation{scenario, builtin_catalogs()};
      RunMetrics metrics{{6, 3}};
      const std::array<FrameSink*, 1> sinks{&metrics};
      for (int i = 0; i < 10; ++i) simulation.step(sinks);
      const long before = allocation_count();
      for (int i = 0; i < 2000; ++i) simulation.step(sinks);
      EXPECT_EQ(allocation_count(), before) << model << " under " << algorithm;
    }
  }
}

TEST(Simulation, AStepOfMethodsThatCommandForcesDoesNotAllocate) {
  for (const char* algorithm :
       {"hard_switching", "wall_following", "wall_following+safety_filter", "orca3d+safety_filter"}) {
    Scenario scenario = swap("minerva_transport", algorithm);
    ObstacleSpec rock{.kind = Obstacle::Kind::sphere};
    rock.position = {5, 0, 10};
    rock.radius = 1.0;
    ObstacleSpec drifter = rock;
    drifter.position = {-5, 5, 10};
    drifter.velocity = {0.1, 0, 0};
    scenario.obstacles = {rock, drifter};
    Simulation simulation{scenario, builtin_catalogs()};
    RunMetrics metrics{{6, 3}};
    const std::array<FrameSink*, 1> sinks{&metrics};
    for (int i = 0; i < 10; ++i) simulation.step(sinks);
    const long before = allocation_count();
    for (int i = 0; i < 1000; ++i) simulation.step(sinks);
    EXPECT_EQ(allocation_count(), before) << algorithm;
  }
}

/// Kinematic vehicles under orca3d on a lattice of 11 m, each on its way through the others.
Scenario fleet_of(std::size_t count) {
  Scenario scenario{.name = "fleet", .duration_s = 1e4, .stop_when_done = false};
  scenario.perception.range_m = 15.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2.4 * i;
    const Vec3 from{11.0 * (i % 5), 11.0 * (i / 5 % 5), 11.0 * (i / 25)};
    const Vec3 to = from + 500.0 * Vec3{std::cos(angle), std::sin(angle), 0.0};
    scenario.vehicles.push_back(vehicle(i, from, to, "kinematic", "orca3d"));
    scenario.vehicles.back().avoider.edit().params = {{"crit_dist_m", 15.0}, {"max_neighbours_count", 10.0}};
  }
  return scenario;
}

TEST(Simulation, AStepOfAFleetDoesNotAllocateWhateverItsSize) {
  for (const std::size_t count : {30U, 200U, 500U}) {
    const Scenario scenario = fleet_of(count);
    Simulation simulation{scenario, builtin_catalogs()};
    RunMetrics metrics{{6, 3}};
    const std::array<FrameSink*, 1> sinks{&metrics};
    simulation.step(sinks);
    const long before = allocation_count();
    for (int i = 0; i < 100; ++i) simulation.step(sinks);
    EXPECT_EQ(allocation_count(), before) << count;
  }
}

TEST(Simulation, WhetherTracksAreKeptChangesNothing) {
  struct Keeper final : FrameSink {
    void write(const Frame& frame) override {
      for (const VehicleFrame& vehicle : frame.vehicles) {
        place += vehicle.state.p_n;
        most = std::max(most, vehicle.tracks.size());
      }
    }
    bool wants_tracks() const override { return wants; }
    bool wants{true};
    Vec3 place = Vec3::Zero();
    std::size_t most{};
  };
  const auto run = [](bool wants) {
    Keeper keeper;
    keeper.wants = wants;
    const std::array<FrameSink*, 1> sinks{&keeper};
    Simulation simulation{fleet_of(100), builtin_catalogs()};
    for (int i = 0; i < 400; ++i) simulation.step(sinks);
    return keeper;
  };
  const Keeper with = run(true), without = run(false);
  EXPECT_EQ(with.place, without.place);
  EXPECT_EQ(with.most, 10U) << "no more than orca3d looks at";
  EXPECT_EQ(without.most, 0U);
}

TEST(Simulation, EveryoneDecidesOnTheSameInstant) {
  // two alike vehicles in a mirrored encounter stay mirrored: neither saw the other's move first
  Scenario scenario{.name = "mirror", .duration_s = 60};
  scenario.vehicles = {vehicle(0, {-10, 0, 5}, {10, 0.5, 5}, "kinematic", "orca3d"),
                       vehicle(1, {10, 0, 5}, {-10, -0.5, 5}, "kinematic", "orca3d")};
  Simulation simulation{scenario, builtin_catalogs()};
  for (int i = 0; i < 600; ++i) {
    simulation.step({});
    const Vec3 a = simulation.agents()[0].vehicle.state().p_n, b = simulation.agents()[1].vehicle.state().p_n;
    ASSERT_NEAR(a.x(), -b.x(), 1e-6) << i;
    ASSERT_NEAR(a.y(), -b.y(), 1e-6) << i;
  }
}

TEST(Simulation, OrdersFromOutsideLeadWhereTheAvoidersWouldHave) {
  const Scenario scenario = swap("sparus2", "orca3d");
  Simulation own{scenario, builtin_catalogs()};
  Simulation commanded{scenario, builtin_catalogs()};
  Simulation steered{scenario, builtin_catalogs()};
  std::vector<Avoider> avoiders;
  for (const Agent& agent : own.agents()) avoiders.push_back(agent.avoider);
  for (int i = 0; i < 300; ++i) {
    own.step({});
    commanded.look();
    steered.look();
    for (std::size_t v = 0; v < avoiders.size(); ++v) {
      ASSERT_TRUE(commanded.is_deciding(v));
      const Command command = avoiders[v].decide(commanded.situation(v));
      commanded.order(v, command);
      const Agent& agent = steered.agents()[v];
      steered.order(v, command, steer(agent.ship().steering, command, agent.own.yaw));
    }
    commanded.act({});
    steered.act({});
  }
  for (std::size_t v = 0; v < avoiders.size(); ++v) {
    const Vec3& place = own.agents()[v].vehicle.state().p_n;
    EXPECT_EQ(commanded.agents()[v].vehicle.state().p_n, place);
    EXPECT_EQ(steered.agents()[v].vehicle.state().p_n, place);
  }
}

TEST(Simulation, WhoIsToldToHoldFromOutsideHoldsUntilReleased) {
  Simulation simulation{swap("sparus2", "orca3d"), builtin_catalogs()};
  simulation.order(0, Command{.mode = Mode::hold});
  const Vec3 start = simulation.agents()[0].vehicle.state().p_n;
  for (int i = 0; i < 400; ++i) simulation.step({});
  EXPECT_LT((simulation.agents()[0].vehicle.state().p_n - start).norm(), 0.1);
  simulation.release(0);
  for (int i = 0; i < 400; ++i) simulation.step({});
  EXPECT_GT((simulation.agents()[0].vehicle.state().p_n - start).norm(), 5.0);
}

TEST(Simulation, AMissionWaitsAtItsRendezvousForTheSlowest) {
  Scenario scenario{.name = "rendezvous", .duration_s = 300};
  for (std::uint32_t i = 0; i < 2; ++i) {
    VehicleSpec spec = vehicle(i, {0, 10.0 * i, 5}, {60, 10.0 * i, 5}, "kinematic", "direct");
    const double there = i == 0 ? 5 : 30;
    spec.mission.insert(spec.mission.begin(),
                        {.kind = LegKind::go_to, .position = {there, 10.0 * i, 5}, .speed_mps = 0.5});
    spec.mission.insert(spec.mission.begin() + 1, {.kind = LegKind::rendezvous});
    scenario.vehicles.push_back(spec);
  }
  Simulation simulation{scenario, builtin_catalogs()};
  std::array<double, 2> started{-1, -1};
  while (!simulation.is_done()) {
    simulation.step({});
    for (std::size_t i = 0; i < 2; ++i) {
      if (started[i] < 0 && simulation.agents()[i].mission.phase() == Phase::under_way)
        started[i] = simulation.time();
    }
  }
  EXPECT_GT(started[0], 55.0);  // 29 m at 0.5 m/s
  EXPECT_EQ(started[0], started[1]);
}

TEST(Simulation, AVehicleThatArrivedHoldsItsPlaceAndGivesWay) {
  Scenario scenario{.name = "hold", .duration_s = 120, .stop_when_done = false};
  scenario.vehicles = {vehicle(0, {0, 0, 5}, {6, 0, 5}, "sparus2", "direct")};
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.run({});
  const Agent& agent = simulation.agents()[0];
  EXPECT_EQ(agent.mission.phase(), Phase::arrived);
  EXPECT_EQ(agent.own.priority, last_priority);
  EXPECT_LT((agent.vehicle.state().p_n - Vec3(4.0, 0, 5)).norm(), 1.5);  // it entered the 2 m at x = 4
  EXPECT_LT(agent.vehicle.state().v_b.norm(), 0.02);
}

TEST(Simulation, AnUnknownNameIsRefusedWithItsPlaceAndTheNearest) {
  Scenario scenario = swap("sparus2", "orca3d");
  scenario.vehicles[1].avoider =
      Choice{.name = "orca", .path = "vehicles[1].avoider", .where = {"x.yaml", 14, 5}};
  try {
    Simulation{scenario, builtin_catalogs()};
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "x.yaml:14:5: vehicles[1].avoider: unknown algorithm \"orca\"; did you mean orca3d?");
  }
  scenario.vehicles[1].avoider = Choice{.name = "orca3d",
                                        .params = {{"time_horizon", 5.0}},
                                        .path = "vehicles[1].avoider",
                                        .where = {"x.yaml", 14, 5},
                                        .param_where = {{"x.yaml", 15, 7}}};
  try {
    Simulation{scenario, builtin_catalogs()};
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::StartsWith("x.yaml:15:7: vehicles[1].avoider.time_horizon: unknown parameter"));
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean time_horizon_s?"));
  }
}

TEST(Simulation, ACopyCarriesOnAlike) {
  Simulation a{swap("sparus2", "apf+stop_and_wait"), builtin_catalogs()};
  for (int i = 0; i < 500; ++i) a.step({});
  Simulation b = a;
  for (int i = 0; i < 500; ++i) {
    a.step({});
    b.step({});
  }
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(a.agents()[i].vehicle.state().p_n, b.agents()[i].vehicle.state().p_n);
}

/// Frames of a run that becomes that of `changed` at `tick`.
std::vector<std::uint64_t> hashes_of(const Scenario& before, const Scenario& changed, int tick,
                                     Simulation* at_the_end = nullptr) {
  struct Hashes final : FrameSink {
    void write(const Frame& frame) override { all.push_back(frame_hash(frame)); }
    std::vector<std::uint64_t> all;
  } hashes;
  Simulation run{before, builtin_catalogs()};
  FrameSink* sink = &hashes;
  while (!run.is_done()) {
    if (count(run.tick()) == tick) run.change(before, changed, builtin_catalogs());
    run.step({&sink, 1});
  }
  if (at_the_end != nullptr) *at_the_end = run;
  return hashes.all;
}

TEST(Simulation, ChangedToWhatItIsItGoesOnAlike) {
  const Scenario scenario = swap("sparus2", "apf+stop_and_wait");
  EXPECT_EQ(hashes_of(scenario, scenario, 500), hashes_of(scenario, scenario, -1));
}

TEST(Simulation, ChangedOnItsWayItIsTheSameUpToThenAndAnotherFromThenOn) {
  const Scenario before = swap("kinematic", "orca3d");
  Scenario changed = before;
  for (VehicleSpec& spec : changed.vehicles) spec.avoider.edit().name = "apf";
  const auto whole = hashes_of(before, before, -1), both = hashes_of(before, changed, 400);
  const auto parted = std::ranges::mismatch(whole, both);
  EXPECT_EQ(parted.in1 - whole.begin(), 400);
  EXPECT_EQ(hashes_of(before, changed, 0), hashes_of(changed, changed, -1))
      << "at the start it is the other run";
  EXPECT_EQ(hashes_of(before, changed, 400), both) << "and it repeats";
}

TEST(Simulation, ChangedGoalsAreReachedByThoseUnderWayAndByThoseWhoHadArrived) {
  Scenario before{.name = "alone", .duration_s = 400};
  before.vehicles = {vehicle(0, {0, 0, 5}, {20, 0, 5}, "kinematic", "direct"),
                     vehicle(1, {0, 50, 5}, {60, 50, 5}, "kinematic", "direct")};
  Scenario changed = before;
  changed.vehicles[0].mission[0].position = {0, 10, 5};
  changed.vehicles[1].mission[0].position = {40, 60, 5};
  constexpr int tick = 60 * 20;  // the first has arrived after 36 s, the second not yet
  Simulation end{before, builtin_catalogs()};
  hashes_of(before, changed, tick, &end);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(end.agents()[i].mission.phase(), Phase::arrived);
    const Vec3 away = end.agents()[i].vehicle.state().p_n - changed.vehicles[i].mission[0].position;
    EXPECT_LT(away.norm(), 2.5) << i;
  }
}

TEST(Simulation, AnExchangeThatEndsOnTheWayLeavesOthersToBeSeen) {
  const Scenario before = swap("kinematic", "orca3d");
  Scenario changed = before;
  changed.exchange.name = "acoustic";
  const auto whole = hashes_of(before, before, -1), both = hashes_of(before, changed, 400);
  EXPECT_GE(std::ranges::mismatch(whole, both).in1 - whole.begin(), 400);
  EXPECT_NE(whole, both);
}

TEST(Simulation, WhatCannotChangeOnTheWayIsRefusedByItsName) {
  const Scenario before = swap("kinematic", "orca3d");
  const auto refused = [&](const auto& edit) {
    Scenario changed = before;
    edit(changed);
    Simulation run{before, builtin_catalogs()};
    return refusal_by([&] { run.change(before, changed, builtin_catalogs()); });
  };
  using testing::EndsWith;
  EXPECT_THAT(refused([](Scenario& s) { s.step_s = 0.1; }), EndsWith("and not: step_s: 0.1"));
  EXPECT_THAT(refused([](Scenario& s) { s.vehicles[3].radius_m = 7; }), EndsWith("and not: radius_m: 7"));
  EXPECT_THAT(refused([](Scenario& s) { s.vehicles.pop_back(); }), testing::HasSubstr("and not: "));
  EXPECT_THAT(refused([](Scenario& s) { s.vehicles[2].mission[0].kind = LegKind::rendezvous; }),
              testing::HasSubstr("and not: "));
  EXPECT_THAT(refused([](Scenario& s) { s.vehicles[1].avoider.edit().name = "orca4d"; }),
              testing::HasSubstr("did you mean"));
  EXPECT_EQ(refused([](Scenario& s) { s.vehicles[1].avoider.edit().name = "apf"; }), "accepted");
}

}  // namespace
}  // namespace fairway
