// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/transport.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fairway/studies/run_index.hpp"
#include "fairway/studies/transport/findings.hpp"
#include "fairway/studies/transport/voyage_log.hpp"

namespace fairway::transport {
namespace {

/// The published runs, made once.
const std::vector<StudyRow>& rows() {
  static const std::vector<StudyRow> all = [] {
    std::vector<Cell> cells = published_cells();
    for (Cell& cell : cells)
      cell.results = {measure_voyage(cell.runs.front().scenario(), builtin_catalogs(), nullptr)};
    return published_rows(cells);
  }();
  return all;
}

const StudyRow& row(std::string_view cell, std::string_view method, Plant plant, std::string_view quantity) {
  const auto found = std::ranges::find_if(rows(), [&](const StudyRow& r) {
    return r.cell == cell && r.method == method && r.mode == name_of(plant) && r.quantity == quantity;
  });
  if (found == rows().end()) throw std::runtime_error("no row " + std::string(quantity));
  return *found;
}

double measured(std::string_view cell, std::string_view method, std::string_view quantity,
                Plant plant = Plant::paper_compat) {
  return row(cell, method, plant, quantity).measured;
}

TEST(TransportStudy, RowsOfPublishedRunsLeadToThemAndNotToTheirLikes) {
  const std::vector<Cell> published = published_cells();
  const std::vector<Cell> compared = case_cells();
  const auto has = [](const std::vector<Cell>& cells, const StudyRow& row) {
    return std::ranges::count(cells, cell_of(row), &Cell::labels);
  };
  ASSERT_FALSE(rows().empty());
  for (const StudyRow& row : rows()) {
    EXPECT_EQ(has(published, row), 1) << row.cell << " " << row.method;
    EXPECT_EQ(has(compared, row), 0) << row.cell << " " << row.method;
  }
}

TEST(TransportStudy, FirstForcesAreThePrintedOnes) {
  for (const Plant plant : plants) {
    EXPECT_NEAR(measured("one_obstacle", "hard_switching", "initial_surge_force_n", plant), 130, 1e-9);
    EXPECT_NEAR(measured("one_obstacle", "hard_switching", "initial_sway_force_n", plant), 130, 1e-9);
    EXPECT_NEAR(measured("one_obstacle", "wall_following", "initial_surge_force_n", plant), 150, 1e-9);
    EXPECT_NEAR(measured("one_obstacle", "wall_following", "initial_sway_force_n", plant), 250, 1e-9);
  }
}

TEST(TransportStudy, PeakYawMomentIsAQuarterTurnTimesTheGain) {
  EXPECT_NEAR(measured("one_obstacle", "hard_switching", "peak_yaw_moment_nm"), 314.2,
              0.1);  // 200 pi/2, and damping
}

TEST(TransportStudy, DetectionIsWhereItIsPrinted) {
  EXPECT_NEAR(measured("one_obstacle", "hard_switching", "switch_distance_m"), 25.0, 0.5);
  EXPECT_NEAR(measured("one_obstacle", "wall_following", "switch_distance_m"), 25.0, 0.5);
  EXPECT_NEAR(measured("four_obstacles", "wall_following", "switch_distance_m"), 2.0, 0.5);
}

TEST(TransportStudy, FinalDisplacementsAreThePublishedOnesOnTheCompatiblePlant) {
  EXPECT_NEAR(measured("one_obstacle", "wall_following", "displacement_m"), 141.2, 0.5);  // measured 141.20
  EXPECT_NEAR(measured("one_obstacle", "hard_switching", "displacement_m"), 141.7, 0.5);  // measured 141.46
  EXPECT_EQ(row("one_obstacle", "wall_following", Plant::paper_compat, "displacement_m").verdict,
            Verdict::reproduced_assuming);
}

TEST(TransportStudy, OnThePhysicalPlantHardSwitchingDeadlocks) {
  EXPECT_LT(measured("one_obstacle", "hard_switching", "displacement_m", Plant::physical), 60.0);
  EXPECT_EQ(row("one_obstacle", "hard_switching", Plant::physical, "displacement_m").verdict,
            Verdict::not_reproduced);
}

TEST(TransportStudy, ThePrintedTrajectoryIsFollowedFarOffWithoutFeedForward) {
  EXPECT_NEAR(measured("four_obstacles", "rrt_star", "planned_length_m"), 47.94, 0.01);
  EXPECT_GT(measured("four_obstacles", "rrt_star", "rmse_north_m"), 0.7);
}

TEST(TransportStudy, EveryPublishedNumberHasARowOnBothPlants) {
  const auto count = std::ranges::count_if(rows(), [](const StudyRow& r) { return r.published.has_value(); });
  EXPECT_EQ(count, 2 * 39);
  for (const StudyRow& r : rows()) {
    EXPECT_TRUE(!r.published || r.verdict != Verdict::no_reference) << r.quantity;
    EXPECT_TRUE(r.verdict != Verdict::not_reproduced || !r.note.empty()) << r.cell << " " << r.quantity;
  }
}

TEST(TransportStudy, AnUnknownObstacleStopsThePlanAndNotTheBlend) {
  const auto clearance = [](std::string_view method) {
    for (const Method& candidate : compared_methods()) {
      if (candidate.name != method) continue;
      const Scenario scenario = voyage("unknown", candidate, obstacles_of(Case::unknown_obstacle),
                                       goal_of(Case::unknown_obstacle), 600.0, 1);
      for (const Measure& m : measure_voyage(scenario, builtin_catalogs(), nullptr)) {
        if (m.quantity == "footprint_clearance_m") return m.value;
      }
    }
    return std::nan("");
  };
  EXPECT_LT(clearance("rrt_star"), 0.0);
  EXPECT_GT(clearance("blend"), 0.3);
}

TEST(TransportStudy, TheSameBitsOnAnyNumberOfThreads) {
  const auto rows_with = [](unsigned jobs) {
    return rows_json("transport", run_transport({.jobs = jobs, .seeds = 1}).rows).dump();
  };
  EXPECT_EQ(rows_with(1), rows_with(3));
}

}  // namespace
}  // namespace fairway::transport
