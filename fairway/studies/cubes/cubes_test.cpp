// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/cubes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "fairway/sim/simulation.hpp"
#include "fairway/studies/cubes/as_coded.hpp"
#include "fairway/studies/cubes/as_heard.hpp"
#include "fairway/studies/cubes/rows.hpp"

namespace fairway::cubes {
namespace {

/// One run of each method in the smallest case, as coded and corrected.
std::vector<Cell> few_cells() {
  std::vector<Cell> cells = comparison_cells(Code::as_coded, 2);
  std::ranges::move(comparison_cells(Code::corrected, 2), std::back_inserter(cells));
  std::erase_if(cells, [](const Cell& cell) { return cell.place != "cube20_4"; });
  return cells;
}

std::string csv_of(const Store& store) {
  std::ostringstream csv;
  store.export_csv(csv);
  return csv.str();
}

TEST(Cubes, TheExperimentHasThePublishedSize) {
  const auto count = [](const std::vector<Cell>& cells) {
    std::size_t runs = 0;
    for (const Cell& cell : cells) runs += cell.runs.size();
    return std::pair{cells.size(), runs};
  };
  EXPECT_EQ(count(tuning_cells()), std::pair(std::size_t{144}, std::size_t{720}));
  EXPECT_EQ(count(comparison_cells(Code::as_coded, published_runs)),
            std::pair(std::size_t{24}, std::size_t{120}));
}

TEST(Cubes, AnyNumberOfThreadsGivesTheSameBits) {
  std::vector<Cell> cells = few_cells();
  Store one = Store::in_memory(), three = Store::in_memory();
  make_crossings(cells, {.jobs = 1, .store = &one});
  make_crossings(cells, {.jobs = 3, .store = &three});
  EXPECT_EQ(csv_of(one), csv_of(three));
}

TEST(Cubes, WhatTheStoreHasIsNotRunAgain) {
  std::vector<Cell> first = few_cells(), second = few_cells();
  Store store = Store::in_memory();
  ASSERT_TRUE(make_crossings(first, {.store = &store}));
  std::atomic<bool> stop{true};  // nothing may be begun, and nothing needs to be
  ASSERT_TRUE(make_crossings(second, {.store = &store, .stop = &stop}));
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].results, second[i].results);
}

TEST(Cubes, EveryPublishedNumberHasARowWithAVerdict) {
  std::vector<Cell> cells = few_cells();
  ASSERT_TRUE(make_crossings(cells, {}));
  const std::vector<StudyRow> rows = rows_of(cells);
  for (const Method& method : methods()) {
    for (const Quantity& quantity : published_quantities()) {
      const auto row = std::ranges::find_if(rows, [&](const StudyRow& r) {
        return r.mode == "as_coded" && r.method == method.name && r.quantity == quantity.name;
      });
      ASSERT_NE(row, rows.end());
      EXPECT_EQ(row->published, published("cube20_4", method.name, quantity.name));
      EXPECT_NE(row->verdict, Verdict::no_reference);
    }
  }
}

TEST(Cubes, EveryoneStartsFacingAwayFromTheGoalAndShortOfTheVertex) {
  for (const CubeCase& cube : {comparison_cases()[1], comparison_cases()[4]}) {
    const Scenario scenario = cube_scenario(cube, methods()[0], Code::as_coded, {}, 1);
    Simulation simulation{scenario, cube_catalogs()};
    while (!is_avoiding(simulation.agents()[0].mission.phase())) simulation.step({});
    double sum = 0;
    ASSERT_EQ(simulation.agents().size(), 8U);
    for (const Agent& agent : simulation.agents()) {
      const Vec3 to_goal = agent.mission.leg()->position - agent.vehicle.state().p_n;
      const double ahead = std::cos(agent.own.yaw) * to_goal.x() + std::sin(agent.own.yaw) * to_goal.y();
      EXPECT_LT(ahead, 0.0);
      sum += to_goal.norm();
    }
    // published means: 29.6 m and 100.0 m
    EXPECT_NEAR(sum / 8, cube.half_edge_m < 20 ? 29.6 : 100.0, 1.0) << cube.name;
  }
}

// ---- the published code's ways ----------------------------------------------------------------

Situation with(std::span<const Track> tracks) {
  return {.period = 0.05,
          .own = {.radius = 3},
          .goal = {.position = {30, 0, 0}, .cruise_speed = 0.5},
          .tracks = tracks};
}

TEST(ApfAsCoded, RepulsionGrowsWithEveryMessageAndIsForgottenOnlyWhenNobodyIsNear) {
  Avoider apf{ApfAsCoded{{}}};
  const std::array<Track, 1> near{Track{.id = TrackId{1}, .position = {4.8, 0, 0}}};  // V_i = 0.2
  const std::array<Track, 1> far{Track{.id = TrackId{1}, .position = {9, 0, 0}}};

  // W1 = 1 ahead, 0.5 * 0.2 back a message: the tenth brings it to a stop, then it backs
  Command command;
  for (int message = 1; message <= 9; ++message) {
    command = apf.decide(with(near));
    EXPECT_GT(command.velocity.x(), 0.0) << message;
  }
  for (int message = 0; message < 6; ++message) command = apf.decide(with(near));
  EXPECT_NEAR(command.velocity.x(), -0.5, 1e-12);
  EXPECT_TRUE(command.astern);

  command = apf.decide(with(far));
  EXPECT_NEAR(command.velocity.x(), 0.5, 1e-12);
  EXPECT_EQ(command.mode, Mode::cruise);
}

TEST(OrcaAsCoded, TakesBodyVelocitiesForVelocitiesOverGround) {
  // two head-on along the east axis: in body axes both seem to go north, so neither seems to approach
  Situation s = with({});
  s.own.velocity = {0, 0.5, 0};
  s.own.yaw = pi / 2;
  s.goal.position = {0, 30, 0};
  const std::array<Track, 1> other{
      Track{.id = TrackId{1}, .position = {0, 8, 0}, .velocity = {0, -0.5, 0}, .yaw = -pi / 2, .radius = 3}};
  s.tracks = other;
  s.limits.max_speed = 0.5;
  Avoider as_coded{OrcaAsCoded{{.time_step_s = 0.05}}};
  const Catalog catalog = builtin_avoiders();
  Avoider corrected = catalog.make("orca3d");
  EXPECT_GT(as_coded.decide(s).velocity.y(), corrected.decide(s).velocity.y());
}

/// Potential fields that hear as `params` say, shown somebody who backs away from 4.8 m by 0.1 m a tick; the
/// velocity north at each tick.
std::vector<double> surge_of(const AsHeard::Params& params, int ticks) {
  Avoider avoider{AsHeard{params}, Avoider{ApfAsCoded{{}}}};
  std::vector<double> surge;
  for (int tick = 0; tick < ticks; ++tick) {
    const std::array<Track, 1> track{Track{.id = TrackId{1}, .position = {4.8 + 0.1 * tick, 0, 0}}};
    Situation s = with(track);
    s.time = 0.05 * tick;
    surge.push_back(avoider.decide(s).velocity.x());
  }
  return surge;
}

TEST(AsHeard, WhoHearsAllAtOnceDecidesAsTheCodeAlone) {
  Avoider alone{ApfAsCoded{{}}};
  const std::vector<double> heard = surge_of({}, 20);
  for (int tick = 0; tick < 20; ++tick) {
    const std::array<Track, 1> track{Track{.id = TrackId{1}, .position = {4.8 + 0.1 * tick, 0, 0}}};
    EXPECT_EQ(heard[static_cast<std::size_t>(tick)], alone.decide(with(track)).velocity.x()) << tick;
  }
}

TEST(AsHeard, LateCommandsAreThoseOfBeforeAndLostMessagesPushNobody) {
  const std::vector<double> at_once = surge_of({}, 20), late = surge_of({.command_late_s = 0.2}, 20);
  for (std::size_t tick = 4; tick < 20; ++tick) EXPECT_EQ(late[tick], at_once[tick - 4]) << tick;
  EXPECT_THAT(surge_of({.lost_ratio = 1.0}, 20), ::testing::Each(::testing::DoubleNear(0.5, 1e-12)));
}

TEST(AsHeard, WhatIsLateStandsWhereItStood) {
  // heard where it was at first for ten ticks, it pushes harder than it does where it is
  EXPECT_LT(surge_of({.late_s = 0.5}, 11)[10], surge_of({}, 11)[10]);
}

TEST(RecordedStarts, EveryoneIsAsFarFromTheGoalAsRecordedAndFacesOutward) {
  for (const CubeCase& cube : {comparison_cases()[1], comparison_cases()[4]}) {
    const Scenario scenario = cube_scenario(cube, methods()[0], Code::as_coded_starts, {}, 1);
    for (const VehicleSpec& vehicle : scenario.vehicles) {
      const PublishedMean recorded = recorded_start(cube, vehicle.id);
      const Vec3 to_goal = vehicle.mission.back().position - vehicle.position;
      EXPECT_NEAR(to_goal.norm(), recorded.mean, 5 * recorded.deviation) << vehicle.name;
      const Vec3 outward{std::cos(vehicle.yaw), std::sin(vehicle.yaw), 0};
      EXPECT_LT(outward.dot(to_goal.normalized()), -0.7) << vehicle.name;
    }
  }
}

TEST(StopAndWaitAsCoded, GoesOnOnlyAfterTheHoldIsReleased) {
  Avoider avoider{StopAndWaitAsCoded{{.release_s = 1.0}}, cube_catalogs().avoiders.make("direct")};
  const std::array<Track, 1> near{Track{.id = TrackId{0}, .position = {5, 0, 0}, .priority = 0}};
  Situation s = with(near);
  s.own.id = VehicleId{1};
  s.own.priority = 1;
  EXPECT_EQ(avoider.decide(s).mode, Mode::hold);
  s.tracks = {};
  for (s.time = 0.5; s.time < 0.99; s.time += 0.1) EXPECT_EQ(avoider.decide(s).mode, Mode::hold) << s.time;
  s.time = 1.01;
  EXPECT_EQ(avoider.decide(s).mode, Mode::cruise);
}

}  // namespace
}  // namespace fairway::cubes
