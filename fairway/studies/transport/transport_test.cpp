// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/transport.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fairway/experiment/compare.hpp"
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

TEST(TransportStudy, WhatFollowsFromInputsIsNoReproduction) {
  for (const Plant plant : plants) {
    for (const char* quantity :
         {"initial_surge_force_n", "initial_sway_force_n", "switch_distance_m", "peak_yaw_moment_nm"}) {
      for (const char* method : {"hard_switching", "wall_following"})
        EXPECT_EQ(row("one_obstacle", method, plant, quantity).verdict, Verdict::follows_from_inputs)
            << quantity;
    }
    EXPECT_EQ(row("four_obstacles", "rrt_star", plant, "planned_length_m").verdict,
              Verdict::follows_from_inputs);
    EXPECT_FALSE(row("four_obstacles", "rrt_star", plant, "planned_length_m").published);
  }
  // the displacement of a run that arrives is the distance of the goal
  for (const char* method : {"hard_switching", "wall_following"}) {
    EXPECT_NEAR(measured("one_obstacle", method, "displacement_m"), 141.4, 0.5);
    EXPECT_EQ(row("one_obstacle", method, Plant::paper_compat, "displacement_m").verdict,
              Verdict::follows_from_inputs);
  }
}

TEST(TransportStudy, NothingIsReproducedByARunThatWentAnotherWay) {
  // at the fourth obstacle 52 N and 4 N are published, and 426 N in sway are measured: met on another side
  for (const Plant plant : plants) {
    EXPECT_GT(std::abs(measured("four_obstacles", "wall_following", "detection_1_sway_force_n", plant)),
              390.0);
    for (const StudyRow& r : rows()) {
      if (r.cell != "four_obstacles" || r.method != "wall_following" || r.mode != name_of(plant)) continue;
      if (!r.published || r.quantity.starts_with("detection_1_") || r.quantity == "switch_distance_m")
        continue;
      EXPECT_TRUE(r.verdict == Verdict::another_course || r.verdict == Verdict::not_reproduced) << r.quantity;
      EXPECT_NE(r.note.find("on another side"), std::string::npos) << r.quantity;
    }
  }
}

TEST(TransportStudy, ARunIsOnThePublishedCourseWhileItMeetsObstaclesOnTheSamePublishedSide) {
  std::vector<Cell> cells = published_cells();
  std::erase_if(cells, [](const Cell& cell) {
    return cell.place != "four_obstacles" || cell.method != "wall_following" || cell.mode != "physical";
  });
  ASSERT_EQ(cells.size(), 1U);
  const auto verdict_of = [&](std::string_view quantity) {
    for (const StudyRow& r : published_rows(cells)) {
      if (r.quantity == quantity) return r.verdict;
    }
    return Verdict::no_reference;
  };
  // as published, but for the fourth obstacle; the angle of (52, 4) and (52, 50) is 39 degrees, of (52, 70)
  // 49
  cells.front().results = {{{"detection_1_surge_force_n", 0, -29},
                            {"detection_1_sway_force_n", 0, 441},
                            {"detection_3_surge_force_n", 0, 93},
                            {"detection_3_sway_force_n", 0, 154},
                            {"detection_4_surge_force_n", 0, 52},
                            {"detection_4_sway_force_n", 0, 50},
                            {"goal_time_s", 0, 400},
                            {"rms_surge_power_w", 0, 1.64}}};
  double& last = cells.front().results[0][5].value;
  EXPECT_EQ(verdict_of("detection_4_surge_force_n"), Verdict::reproduced);
  EXPECT_EQ(verdict_of("rms_surge_power_w"), Verdict::reproduced);
  last = 70;
  EXPECT_EQ(verdict_of("detection_1_sway_force_n"), Verdict::reproduced);
  EXPECT_EQ(verdict_of("detection_3_sway_force_n"), Verdict::reproduced);
  EXPECT_EQ(verdict_of("detection_4_surge_force_n"), Verdict::another_course);
  EXPECT_EQ(verdict_of("rms_surge_power_w"), Verdict::another_course);
  last = std::nan("");  // not met
  EXPECT_EQ(verdict_of("rms_surge_power_w"), Verdict::another_course);
  last = 4;
  EXPECT_EQ(verdict_of("rms_surge_power_w"), Verdict::reproduced);
  cells.front().results[0][6].value = std::nan("");  // did not come to its goal
  EXPECT_EQ(verdict_of("rms_surge_power_w"), Verdict::another_course);
}

/// Published cells with made-up numbers: those of wall following and of the planned path are as given, all
/// others are 10.
std::vector<Cell> made_up(double wall, double path, double goal_time, double clearance) {
  std::vector<Cell> cells = published_cells();
  for (Cell& cell : cells) {
    const double value = cell.method == "wall_following" ? wall : cell.method == "rrt_star" ? path : 10.0;
    cell.results = {{{"goal_time_s", 0, goal_time + value},
                     {"path_length_m", 0, value},
                     {"body_energy_j", 0, value},
                     {"net_power_w", 0, value},
                     {"displacement_m", 0, value},
                     {"footprint_clearance_m", 0, clearance}}};
  }
  return cells;
}

/// How often the claims say a word.
int said(const std::vector<Cell>& cells, std::string_view word) {
  int count = 0;
  for (const std::string& line : claims(cells)) count += line.find(word) != std::string::npos ? 1 : 0;
  return count;
}

TEST(TransportStudy, WordsFollowTheNumbers) {
  const std::vector<Cell> as_claimed = made_up(9, 8, 0, 0.5);
  EXPECT_EQ(said(as_claimed, ": holds"), 8);  // but for the two that the planned path was slower and longer
  EXPECT_EQ(said(as_claimed, ": reversed"), 2);
  EXPECT_EQ(said(made_up(11, 12, 0, 0.5), ": reversed"), 5);
  EXPECT_EQ(said(made_up(11, 12, 0, 0.5), ": holds"), 5);
  EXPECT_EQ(said(made_up(10, 10, 0, -0.5), ": undecided"), 7);
  EXPECT_EQ(said(made_up(10, 10, 0, -0.5), ": does not hold"), 3);
}

TEST(TransportStudy, WhatDidNotArriveIsNotCompared) {
  const std::vector<Cell> nobody = made_up(9, 8, std::nan(""), std::nan(""));
  EXPECT_EQ(said(nobody, ": not measured"), 10);
  EXPECT_EQ(said(nobody, "nan"), 0);
  EXPECT_EQ(said(nobody, "does not arrive"), 1);
  std::vector<Cell> empty = published_cells();
  EXPECT_EQ(said(empty, "not measured"), 11);
  EXPECT_EQ(said(empty, "nan"), 0);
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
  EXPECT_EQ(count, 2 * 38);
  for (const StudyRow& r : rows()) {
    EXPECT_TRUE(!r.published || r.verdict != Verdict::no_reference) << r.quantity;
    EXPECT_TRUE(r.verdict != Verdict::not_reproduced || !r.note.empty()) << r.cell << " " << r.quantity;
  }
}

TEST(TransportStudy, AnUnknownObstacleStopsThePlanAndNotTheBlend) {
  const auto clearance = [](std::string_view method) {
    const Method& candidate = *std::ranges::find(compared_methods(), method, &Method::name);
    const Scenario scenario = voyage("unknown", candidate, obstacles_of(Case::unknown_obstacle),
                                     goal_of(Case::unknown_obstacle), 600.0, 1);
    return run_value(measure_voyage(scenario, builtin_catalogs(), nullptr), "footprint_clearance_m");
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
