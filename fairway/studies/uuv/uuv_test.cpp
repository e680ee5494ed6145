// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/uuv.hpp"

#include <gtest/gtest.h>

#include "fairway/studies/uuv/findings.hpp"
#include "fairway/studies/uuv/measures.hpp"

namespace fairway::uuv {
namespace {

const Method& planar(std::string_view name) {
  return *std::ranges::find(planar_methods(), name, &Method::name);
}

/// One run of an encounter as published.
Cell met(Encounter encounter, std::string_view setting, std::string_view method) {
  const Scenario scenario = encounter_scenario(encounter, meeting_of(encounter), find_setting(setting),
                                               Hull::point, planar(method), 1);
  Cell cell{
      .place = std::string(name_of(encounter)), .method = std::string(method), .mode = std::string(setting)};
  cell.results = {measure_encounter(scenario, builtin_catalogs(), nullptr)};
  return cell;
}

const StudyRow& row_of(const std::vector<StudyRow>& rows, std::string_view quantity) {
  return *std::ranges::find(rows, quantity, &StudyRow::quantity);
}

/// A cell of the silent cubes whose runs had so many collisions, one run each.
Cell silent_cell(std::string_view mode, const std::vector<double>& collisions) {
  Cell cell{.place = "cube20_8", .method = "apf", .mode = std::string(mode)};
  for (const double count : collisions)
    cell.results.push_back({{"pair_collision_count", Measure::fleet, count}});
  return cell;
}

TEST(UuvEncounter, HeadOnComesOutAsPublishedUnderItsFit) {
  const std::vector<StudyRow> rows = published_rows({met(Encounter::head_on, "fit_head_on", "rvo")});
  for (const std::string_view quantity :
       {"slow_down_time_s", "pass_time_s", "resume_time_s", "arrive_time_s"})
    EXPECT_EQ(row_of(rows, quantity).verdict, Verdict::reproduced_assuming) << quantity;
  EXPECT_EQ(row_of(rows, "contact_count").measured, 0.0);
  EXPECT_EQ(row_of(rows, "keeps_right_ratio").measured, 1.0);
}

TEST(UuvEncounter, AmongShipsComesOutAsPublishedUnderItsFit) {
  const std::vector<StudyRow> rows = published_rows({met(Encounter::multi_obstacle, "fit_ships", "rvo")});
  for (const std::string_view quantity :
       {"slow_down_time_s", "slowest_time_s", "resume_time_s", "arrive_time_s"})
    EXPECT_EQ(row_of(rows, quantity).verdict, Verdict::reproduced_assuming) << quantity;
  EXPECT_EQ(row_of(rows, "contact_count").measured, 0.0);
}

TEST(UuvEncounter, WhoAvoidsNobodyMeetsTheOther) {
  EXPECT_GT(met(Encounter::head_on, "common", "direct").value(0, "contact_count"), 0.0);
}

TEST(UuvEncounter, OnlyThePapersMethodIsJudged) {
  const std::vector<StudyRow> other = published_rows({met(Encounter::head_on, "common", "orca3d")});
  ASSERT_FALSE(other.empty());
  for (const StudyRow& row : other) EXPECT_EQ(row.verdict, Verdict::no_reference) << row.quantity;
  const std::vector<StudyRow> own = published_rows({met(Encounter::head_on, "common", "rvo")});
  EXPECT_LT(std::ranges::count(own, Verdict::no_reference, &StudyRow::verdict), std::ssize(own));
}

TEST(UuvEncounter, AVariationIsThatOfItsSeed) {
  for (const Encounter encounter : encounters) {
    const Meeting one = varied(encounter, 7);
    EXPECT_EQ(one.starts, varied(encounter, 7).starts);
    EXPECT_EQ(one.ships, varied(encounter, 7).ships);
    EXPECT_NE(one.starts, varied(encounter, 8).starts);
    EXPECT_EQ(one.goals, meeting_of(encounter).goals);
  }
}

TEST(UuvGathering, NobodyBeginsOrEndsWithinAnother) {
  for (const Gathering& gathering : gatherings()) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const std::vector<Voyage> voyages = voyages_of(gathering, seed);
      ASSERT_EQ(voyages.size(), gathering.count);
      for (std::size_t i = 0; i < voyages.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_GT((voyages[i].start - voyages[j].start).norm(), 2 * kept_radius) << gathering.name();
          EXPECT_GT((voyages[i].goal - voyages[j].goal).norm(), 2 * kept_radius) << gathering.name();
        }
      }
    }
  }
}

TEST(UuvGathering, TwoWhoSwapAvoidEachOtherAndArrive) {
  const Scenario scenario =
      gathering_scenario(gatherings().front(), awarenesses().front(), gathering_methods().front(), 1);
  Cell cell{.place = "swap_2", .method = "rvo", .mode = "test"};
  cell.results = {measure_fleet(scenario, builtin_catalogs(), nullptr)};
  EXPECT_EQ(collision_runs(cell), 0U);
  EXPECT_TRUE(arrived(cell, 0));
  EXPECT_GT(cell.value(0, "time_ratio"), 0.9);
  EXPECT_GT(cell.value(0, "mean_course_change_rad"), 0.0);
}

TEST(UuvGathering, WithoutPerceptionOrExchangeTheyMeet) {
  const Awareness nothing{"none", "perfect", "acoustic"};
  Scenario scenario = gathering_scenario(gatherings().front(), nothing, gathering_methods().front(), 1);
  scenario.exchange.params = {{"update_rate_hz", 1.0}, {"loss_ratio", 1.0}};
  Cell cell{.place = "swap_2", .method = "rvo", .mode = "test"};
  cell.results = {measure_fleet(scenario, builtin_catalogs(), nullptr)};
  EXPECT_EQ(collision_runs(cell), 1U);
}

TEST(UuvSilence, IsSafeDownToTheLastRateBeforeTheFirstCollision) {
  std::vector<Cell> cells;
  for (const double rate : update_rates_hz) {
    const bool collides = rate == 2.0 || rate < 0.5;
    cells.push_back(
        silent_cell(Channel{Channel::Kind::acoustic, rate, 0.0}.name(), {0.0, collides ? 1.0 : 0.0}));
    cells.push_back(silent_cell(Channel{Channel::Kind::acoustic, rate, 0.5}.name(), {1.0, 0.0}));
  }
  EXPECT_EQ(safe_down_to(cells, "cube20_8", "apf", 0.0), 5.0);
  EXPECT_EQ(safe_down_to(cells, "cube20_8", "apf", 0.5), std::nullopt);
}

/// Cells of every method in every silent cube, over every channel, with as many collisions in their one run.
std::vector<Cell> silence(double collisions) {
  std::vector<Cell> cells;
  for (const std::string_view cube : silent_cubes()) {
    for (const Method& method : silence_methods()) {
      for (const double rate : update_rates_hz) {
        for (const double loss : loss_ratios) {
          Cell cell = silent_cell(Channel{Channel::Kind::acoustic, rate, loss}.name(), {collisions});
          cell.place = std::string(cube);
          cell.method = std::string(method.name);
          cells.push_back(std::move(cell));
        }
      }
    }
  }
  return cells;
}

TEST(UuvSilence, SentencesFollowTheRunsAndAreWithheldWhereThereAreNone) {
  for (const std::string& sentence : silence_sentences(silence(0.0))) {
    EXPECT_NE(sentence.find("0.1 Hz without loss, 0.1 Hz with half"), std::string::npos) << sentence;
  }
  for (const std::string& sentence : silence_sentences(silence(1.0))) {
    EXPECT_EQ(sentence.find("0.1 Hz"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("not even at 20 Hz"), std::string::npos) << sentence;
  }
  std::vector<Cell> never_run = silence(0.0);
  for (Cell& cell : never_run) cell.results.clear();
  EXPECT_TRUE(silence_sentences(never_run).empty());
  EXPECT_TRUE(silence_sentences({}).empty());
  EXPECT_EQ(silence_sentences(silence(0.0)).size(), silence_methods().size());
}

TEST(UuvSilence, TheMethodRunsOverTheChannelThatIsNamed) {
  const Method& strong = silence_methods().back();
  const Scenario scenario = silence_scenario("cube20_8", strong, {Channel::Kind::acoustic, 0.5, 0.25}, 3);
  EXPECT_EQ(scenario.exchange.name, "acoustic");
  EXPECT_EQ(scenario.seed, 3U);
  EXPECT_EQ(scenario.vehicles.size(), 8U);
  EXPECT_EQ(scenario.vehicles.front().avoider->name, "apf+inflate");
  const ParamValues w2{{"crit_dist_m", 6.0}, {"w2_ratio", 2.5}};
  EXPECT_EQ(scenario.vehicles.front().avoider->params, w2);
  EXPECT_EQ(silence_scenario("cube20_8", strong, {}, 3).exchange.name, "perfect");
}

}  // namespace
}  // namespace fairway::uuv
