// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/cubes/replicas.hpp"

namespace fairway::cubes {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Runs of one cell, by how many collisions each has; every navigation time as given.
Cell made_results(Cell cell, const std::vector<double>& collisions, double navigation_time) {
  for (const double count : collisions) {
    cell.results.push_back({{"navigation_time_s", 0, navigation_time},
                            {"avoidance_time_s", 0, 10},
                            {"avoided_count", 0, 3},
                            {"distance_m", 0, 40},
                            {"collision_count", 0, count},
                            {"stuck_count", 0, 0},
                            {"min_separation_m", Measure::fleet, count > 0 ? 2.5 : 4.5}});
  }
  return cell;
}

/// The cell in which the thesis counted six collisions in two of five runs.
std::vector<Cell> colliding_cell(int replicas) {
  std::vector<Cell> cells = replica_cells(Code::as_coded_replicas, replicas);
  std::erase_if(cells, [](const Cell& c) { return c.place != "cube20_8" || c.method != "apf"; });
  return cells;
}

std::vector<std::string> words_about(const Cell& results) { return findings(rows_of({results})); }

TEST(Findings, OfNothingThereIsNothingToSay) {
  EXPECT_THAT(findings({}), IsEmpty());
  EXPECT_THAT(causes({}), IsEmpty());
  EXPECT_THAT(clearances({}), IsEmpty());
}

TEST(Findings, WhatIsNoNumberIsNotSpokenOf) {
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<StudyRow> rows;
  for (const std::string_view mode : {"as_coded", "as_coded_north", "as_coded_replicas", "corrected"}) {
    for (const std::string_view quantity :
         {"navigation_time_s", "colliding_run_ratio", "collision_free_ratio", "clear_of_6m_ratio",
          "min_separation_m", "navigation_time_deviation_s"}) {
      rows.push_back({.cell = "cube20_8",
                      .method = "apf",
                      .mode = std::string(mode),
                      .quantity = std::string(quantity),
                      .published = 0.4,
                      .measured = nan,
                      .runs = 5});
    }
  }
  EXPECT_THAT(findings(rows), IsEmpty());
  EXPECT_THAT(causes(rows), IsEmpty());
  EXPECT_THAT(clearances(rows), IsEmpty());
}

TEST(Findings, CollisionsThatDoNotComeOutAreSaidNotToAndThoseThatDoAreNot) {
  const std::vector<Cell> cells = colliding_cell(20);
  std::vector<double> none(100, 0.0), many(100, 0.0);
  for (std::size_t i = 0; i < 40; ++i) many[i] = 2.0;

  // 2 of 5 against 0 of 100: p = C(5,2) / C(105,2) = 10 / 5460
  EXPECT_THAT(words_about(made_results(cells[0], none, 150)),
              Contains(HasSubstr("p = 0.0018: not reproduced")));
  EXPECT_THAT(words_about(made_results(cells[0], many, 150)), Contains(HasSubstr("no difference shown")));
  EXPECT_THAT(words_about(made_results(cells[0], many, 150)), Each(Not(HasSubstr("not reproduced"))));
}

TEST(Findings, CoverageFollowsTheRepetitions) {
  const std::vector<Cell> cells = colliding_cell(2);
  const std::vector<double> none(10, 0.0);
  EXPECT_THAT(words_about(made_results(cells[0], none, 151.7)), Contains(HasSubstr("navigation_time_s 1,")));
  EXPECT_THAT(words_about(made_results(cells[0], none, 90.0)), Contains(HasSubstr("navigation_time_s 0,")));
}

TEST(Findings, OfEachWayOfHearingTheCollisionsAreCountedWhereTheyWerePublishedAndWhereNot) {
  const std::vector<Cell> cells = timing_cells(4);
  std::vector<Cell> results;
  for (std::size_t i = 0; i < comparison_cases().size(); ++i)
    results.push_back(made_results(
        cells[i],
        comparison_cases()[i].team == 8 ? std::vector<double>{2, 0, 0, 0} : std::vector<double>{0, 0, 0, 0},
        100));
  EXPECT_THAT(causes(rows_of(results)),
              Contains(HasSubstr("published 2 of 8 (published 4 of 10, p = 0.64), in the others 2 of 16 "
                                 "(published 0 of 20, p = 0.19)")));
}

TEST(Findings, ATrendIsCountedStepByStep) {
  std::vector<StudyRow> rows;
  const auto add = [&](double crit_dist, double there, double here) {
    rows.push_back({.cell = "tuning",
                    .method = "apf",
                    .mode = "as_coded",
                    .quantity = "navigation_time_s",
                    .params = {{"crit_dist_m", crit_dist}},
                    .published = there,
                    .measured = here});
  };
  add(6, 80, 85);
  EXPECT_THAT(findings(rows), Each(Not(HasSubstr("steps"))));  // of one value there is no trend
  add(7, 90, 95);
  add(10, 200, 180);
  EXPECT_THAT(findings(rows), Contains(HasSubstr("2 of 2 steps go the same way")));
  for (StudyRow& row : rows) row.measured = -row.measured;
  EXPECT_THAT(findings(rows), Contains(HasSubstr("0 of 2 steps go the same way")));
}

TEST(Findings, ClearanceIsJudgedByBothDistances) {
  const std::vector<Cell> cells = comparison_cells(Code::corrected, 4);
  const std::vector<StudyRow> rows = rows_of({made_results(cells[1], {0, 0, 0, 1}, 100)});
  EXPECT_THAT(clearances(rows),
              Contains(HasSubstr("of 4 runs 3 kept 3 m between centres and 0 kept 6 m; least 2.50 m")));
}

TEST(Replicas, ThePlaceOfAValueCountsTiesHalf) {
  EXPECT_EQ(place_among(2.0, std::array{1.0, 2.0, 3.0, 4.0}), 0.375);
  EXPECT_EQ(place_among(2.0, {}), std::nullopt);
}

TEST(Replicas, ARepetitionIsFiveDifferentRuns) {
  const std::vector<Cell> cells = colliding_cell(1);
  const Cell five = made_results(cells[0], {1, 0, 0, 0, 2}, 100);
  const Quantity collisions{"collision_count", true};
  EXPECT_THAT(repetitions(five, collisions), Each(3.0));  // there is one draw of five out of five
  EXPECT_THAT(repetitions(five, {"navigation_time_s", false}), Each(100.0));
  EXPECT_THAT(repetitions(made_results(cells[0], {1, 0, 0, 0}, 100), collisions), IsEmpty());

  // of six, each is left out as often as the others: the total is 0 in a sixth of the draws
  const std::vector<double> of_six = repetitions(made_results(cells[0], {1, 0, 0, 0, 0, 0}, 100), collisions);
  EXPECT_EQ(of_six.size(), std::size_t{repetition_count});
  EXPECT_NEAR(static_cast<double>(std::ranges::count(of_six, 0.0)) / repetition_count, 1.0 / 6.0, 0.03);
}

TEST(Replicas, NoneIsARunOfThePublishedPart) {
  for (const Cell& cell : replica_cells(Code::as_coded_starts, 3)) {
    EXPECT_EQ(cell.runs.size(), 15U);
    EXPECT_EQ(cell.runs.front().spec.seed, 6U);
  }
}

}  // namespace
}  // namespace fairway::cubes
