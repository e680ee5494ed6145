// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/metrics/encounters.hpp"
#include "fairway/view/film_water.hpp"
#include "fairway/view/testing/unpack.hpp"

namespace fairway {
namespace {

using nlohmann::json;
using testing::Columns;
using testing::columns_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::run_scenario_into;
using testing::shipped;
using testing::thoughts_of;

/// Keeps what a film must give back, in its order.
class Witness final : public FrameSink {
 public:
  void write(const Frame& frame) override {
    values["time_s"].push_back(frame.time);
    for (const VehicleFrame& v : frame.vehicles) {
      put("position_m", v.state.p_n, false);
      const Eigen::Quaterniond& q = v.state.q_nb;
      for (const double x : {q.w(), q.x(), q.y(), q.z()})
        values["attitude"].push_back(static_cast<double>(static_cast<float>(x)));
      put("velocity_mps", v.state.v_n(), true);
      put("command_mps", v.command.velocity, true);
      put("goal_m", v.goal, true);
      put("force_n", v.wrench.head<3>(), true);
      values["power_w"].push_back(static_cast<double>(static_cast<float>(v.power)));
      values["mode"].push_back(static_cast<double>(v.command.mode));
      values["phase"].push_back(static_cast<double>(v.phase));
    }
  }

  Columns values;

 private:
  void put(const char* name, const Vec3& v, bool as_float) {
    for (const double x : v)
      values[name].push_back(as_float ? static_cast<double>(static_cast<float>(x)) : x);
  }
};

std::size_t depths_of(const Scenario& scenario) { return current_depths(scenario.water).size(); }

Columns all_columns(const Film& film, const Scenario& scenario, Packing packing = Packing::compressed) {
  return columns_of(film.part(0, film.size(), packing), FilmColumns::specs(depths_of(scenario)),
                    scenario.vehicles.size());
}

TEST(Film, GivesBackWhatTheFramesSaidPositionsAndTimesToTheBit) {
  const Scenario scenario = shipped("cube20_4_apf");
  Film film{scenario};
  Witness witness;
  run_scenario_into(scenario, {&film, &witness});
  Columns columns = all_columns(film, scenario);
  ASSERT_GT(film.size(), 100u);
  EXPECT_EQ(film.size(), witness.values["time_s"].size());
  for (const auto& [name, values] : witness.values) EXPECT_TRUE(columns[name] == values) << name;
  EXPECT_EQ(witness.values.size() + 6, columns.size()) << "all but currents, alerts, shortfalls and progress";
  EXPECT_EQ(film.notice(), "");
}

TEST(Film, IsTheSameCompressedOrNot) {
  const Scenario scenario = shipped("head_on");
  Film film{scenario};
  run_scenario_into(scenario, {&film}, true);
  const json packed = film.part(0, film.size(), Packing::compressed),
             plain = film.part(0, film.size(), Packing::plain);
  EXPECT_EQ(testing::unpacked(packed, "data"), testing::unpacked(plain, "data"));
  EXPECT_EQ(testing::unpacked(packed, "thoughts"), testing::unpacked(plain, "thoughts"));
  EXPECT_LT(packed["thoughts"].get<std::string>().size(), plain["thoughts"].get<std::string>().size());
}

TEST(Film, InPartsGivesEverythingOnce) {
  const Scenario scenario = shipped("acoustic_pair");
  Film film{scenario, {.every = 3}};
  run_scenario_into(scenario, {&film}, true);
  film.finish();
  Columns joined;
  json events = json::array(), thoughts = thoughts_of({{"thoughts", ""}, {"compression", "none"}});
  for (std::size_t first = 0; first < film.size(); first += 97) {
    const json part = film.part(first, 97, Packing::plain);
    EXPECT_EQ(part["first"], first);
    for (const auto& [name, values] : columns_of(part, FilmColumns::specs(depths_of(scenario)), 2))
      joined[name].insert(joined[name].end(), values.begin(), values.end());
    for (const json& event : part["events"]) events.push_back(event);
    const json thought = thoughts_of(part);
    for (const auto& [list, records] : thought.items())
      for (const json& record : records) thoughts[list].push_back(record);
  }
  const json whole = film.part(0, film.size(), Packing::plain);
  EXPECT_TRUE(joined == all_columns(film, scenario));
  EXPECT_EQ(events, whole["events"]);
  EXPECT_TRUE(thoughts == thoughts_of(whole));
  for (const char* list : {"sketches", "tracks", "flights"}) EXPECT_FALSE(thoughts[list].empty()) << list;
  EXPECT_FALSE(events.empty());
}

TEST(Film, ColumnsApartAreThoseOfAPart) {
  const Scenario scenario = shipped("head_on");
  Film film{scenario};
  run_scenario_into(scenario, {&film});
  json apart = film.part(3, 50, Packing::apart);
  EXPECT_EQ(apart["data"], "");
  EXPECT_EQ(film.column_bytes(3, 50), testing::unpacked(film.part(3, 50, Packing::plain), "data"));
}

TEST(Film, OfThinkersKeepsTheirThoughtsAndNobodyElses) {
  const Scenario scenario = shipped("head_on");
  Film all{scenario}, one{scenario, {.thinkers = {{1}}}};
  run_scenario_into(scenario, {&all, &one}, true);
  const json of_all = thoughts_of(all.part(0, all.size(), Packing::plain));
  const json of_one = thoughts_of(one.part(0, one.size(), Packing::plain));
  for (const char* list : {"sketches", "tracks"}) {
    json expected = json::array();
    for (const json& record : of_all[list])
      if (record["vehicle"] == 1) expected.push_back(record);
    EXPECT_GT(expected.size(), 10u);
    EXPECT_TRUE(of_one[list] == expected) << list;
  }
  json part = one.part(100, 200, Packing::plain);
  part["thoughts"] = one.thoughts_before(one.size());
  EXPECT_TRUE(thoughts_of(part) == of_one) << "from the beginning, whatever the part";
}

TEST(Film, BeyondItsEndHasAnEmptyPart) {
  const Scenario scenario = shipped("head_on");
  Film film{scenario};
  EXPECT_EQ(film.part(0, 10, Packing::compressed)["count"], 0);
  run_scenario_into(scenario, {&film});
  const json part = film.part(film.size() + 5, 10, Packing::plain);
  EXPECT_EQ(part["first"], film.size());
  EXPECT_EQ(part["count"], 0);
  EXPECT_EQ(part["data"], "");
}

TEST(Film, BeyondItsLimitKeepsEverySecondFrameAgainAndAgainAndSaysSo) {
  const Scenario scenario = shipped("crossing");
  Film whole{scenario}, thinned{scenario, {.vehicle_frames = 400}};
  run_scenario_into(scenario, {&whole, &thinned});
  thinned.finish();
  ASSERT_GT(whole.size(), 1000u);
  EXPECT_LE(thinned.size(), 400 / scenario.vehicles.size() + 1);
  EXPECT_GT(thinned.size(), 400 / scenario.vehicles.size() / 2);
  EXPECT_GE(thinned.stride(), 4u);
  EXPECT_EQ(std::size_t{1} << thinned.generation(), thinned.stride());
  EXPECT_THAT(thinned.notice(), HasSubstr("one in " + std::to_string(thinned.stride())));

  const Columns all = all_columns(whole, scenario), kept = all_columns(thinned, scenario);
  const std::size_t wide = scenario.vehicles.size() * 3;
  for (std::size_t i = 0; i < thinned.size(); ++i) {
    const std::size_t from = std::min(i * thinned.stride(), whole.size() - 1);  // and the last of the run
    EXPECT_EQ(kept.at("time_s")[i], all.at("time_s")[from]);
    EXPECT_EQ(kept.at("position_m")[i * wide], all.at("position_m")[from * wide]);
  }
  EXPECT_EQ(thinned.part(0, thinned.size(), Packing::plain)["events"],
            whole.part(0, whole.size(), Packing::plain)["events"]);
}

TEST(Film, KeepsTheLastFrameWhateverItsStrideAndOnce) {
  const Scenario scenario = shipped("head_on");
  for (const std::size_t every : {1u, 2u, 3u, 7u, 100000u}) {
    Film film{scenario, {.every = every}};
    Witness witness;
    run_scenario_into(scenario, {&film, &witness});
    film.finish();
    film.finish();
    const std::vector<double> times = all_columns(film, scenario)["time_s"];
    EXPECT_EQ(times.back(), witness.values["time_s"].back()) << every;
    EXPECT_EQ(std::ranges::adjacent_find(times, std::greater_equal{}), times.end()) << every;
  }
}

TEST(Film, ShowsWhatOfACommandIsBeyondTheVehicleAsTheMetricCountsIt) {
  const Scenario scenario = shipped("remus_crossing", {{"vehicles[0].start.yaw_deg", "180"}});
  Film film{scenario};
  RunMetrics metrics = metrics_for(scenario);
  run_scenario_into(scenario, {&film, &metrics});
  const std::vector<double> shown = all_columns(film, scenario)["shortfall"];
  for (std::size_t vehicle = 0; vehicle < 2; ++vehicle) {
    double seconds = 0.0;
    for (std::size_t i = vehicle; i < shown.size(); i += 2) seconds += shown[i] > 0.0 ? scenario.step_s : 0.0;
    const std::vector<Measure> all = metrics.measures();
    const auto measured = std::ranges::find_if(all, [&](const Measure& m) {
      return m.quantity == "unattainable_time_s" && m.vehicle == static_cast<int>(vehicle);
    });
    EXPECT_NEAR(measured->value, seconds, 1e-9) << vehicle;
    EXPECT_EQ(seconds > 5.0, vehicle == 0) << seconds;
  }
}

TEST(Film, ShowsWhoMakesNoProgressAsTheMetricCountsIt) {
  const Scenario scenario =
      shipped("head_on", {{"vehicles[0].avoider", "vo"}, {"vehicles[1].avoider", "vo"}});
  Film film{scenario};
  RunMetrics metrics = metrics_for(scenario);
  run_scenario_into(scenario, {&film, &metrics});
  const Columns columns = all_columns(film, scenario);
  ASSERT_EQ(columns.at("progress").size(), 2 * film.size());
  for (std::size_t vehicle = 0; vehicle < 2; ++vehicle) {
    const ProgressReport& last = metrics.progress().state(vehicle);
    const std::size_t i = 2 * (film.size() - 1) + vehicle;
    const double time = columns.at("time_s")[film.size() - 1];
    EXPECT_EQ(columns.at("progress")[i], static_cast<double>(last.state));
    EXPECT_NEAR(columns.at("no_progress_s")[i], time - last.last_progress, 1e-4);
    EXPECT_EQ(columns.at("progress_with")[i], last.with ? number(*last.with) : -1.0);
  }
}

TEST(Film, ShowsAWindowWithWhatHappensInIt) {
  const Scenario scenario = shipped("swap_8", {{"duration_s", "70"}});
  Film whole{scenario}, window{scenario, {.from_s = 20.0, .to_s = 60.0}};
  run_scenario_into(scenario, {&whole, &window});
  const std::vector<double> times = all_columns(window, scenario)["time_s"];
  EXPECT_DOUBLE_EQ(times.front(), 20.0);
  EXPECT_DOUBLE_EQ(times.back(), 60.0);
  std::vector<json> expected;
  const json all = whole.part(0, whole.size(), Packing::plain);
  for (const json& event : all["events"]) {
    if (event["time_s"] >= 20.0 && event["time_s"] <= times.back()) expected.push_back(event);
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(window.part(0, window.size(), Packing::plain)["events"], json(expected));
}

/// Counts with the metric itself as frames come by, and holds the film to it after every one.
class Referee final : public FrameSink {
 public:
  Referee(const Scenario& scenario, const Film& film)
      : metric_{{scenario.exam.crit_dist_m, scenario.exam.safety_distance_m}}, film_{film} {}

  void write(const Frame& frame) override {
    metric_.see(frame);
    std::vector<Measure> measures;
    metric_.report(measures);
    const json part = film_.part(film_.size() - 1, 1, Packing::plain);
    for (const json& event : part["events"]) {
      EXPECT_EQ(event["time_s"].get<double>(), frame.time);
      ++seen[{event["kind"], event["vehicle"]}];
    }
    for (const Measure& m : measures) {
      const char* kind = m.quantity == "avoided_count"     ? "avoided"
                         : m.quantity == "collision_count" ? "collided"
                         : m.quantity == "stuck_count"     ? "stuck"
                                                           : nullptr;
      if (kind == nullptr) continue;
      // were this the last frame, those who are still near would count too
      const auto open = metric_.contacts(static_cast<std::size_t>(m.vehicle));
      const auto near = std::ranges::count(open, EncounterMetric::Contact::collided,
                                           &EncounterMetric::OpenEncounter::worst);
      const auto counted = seen[{kind, m.vehicle}] + (kind == std::string_view{"collided"} ? near : 0);
      ASSERT_EQ(counted, m.value) << kind << " of " << m.vehicle << " at " << frame.time;
    }
  }

  std::map<std::pair<std::string, int>, int> seen;

 private:
  EncounterMetric metric_;
  const Film& film_;
};

TEST(Film, HasAnEventAtTheVeryFrameInWhichTheMetricCountsIt) {
  std::set<std::string> kinds;
  const Overrides nobody_avoids{{"vehicles[*].avoider", "direct"}},
      no_patience{{"exam.time_coefficient_ratio", "1.01"}};
  const std::vector<std::pair<const char*, Overrides>> runs{
      {"swap_8", nobody_avoids}, {"cube20_4_apf", {}},      {"priority_wait", {}},
      {"transport_pair", {}},    {"crossing", no_patience}, {"head_on", no_patience}};
  for (const auto& [name, overrides] : runs) {
    const Scenario scenario = shipped(name, overrides);
    Film film{scenario};
    Referee referee{scenario, film};
    run_scenario_into(scenario, {&film, &referee});
    for (const auto& [key, count] : referee.seen) kinds.insert(key.first);
  }
  for (const char* kind : {"detected", "collision", "avoided", "collided", "arrived", "stuck"})
    EXPECT_EQ(kinds.count(kind), 1u) << kind;
}

TEST(Film, ColoursAVehicleByItsOpenEncountersFromFrameToFrame) {
  const Scenario scenario = shipped("swap_8", {{"vehicles[*].avoider", "direct"}});
  Film film{scenario};
  run_scenario_into(scenario, {&film});
  const Columns columns = all_columns(film, scenario);
  const json events = film.part(0, film.size(), Packing::plain)["events"];
  const std::size_t vehicles = scenario.vehicles.size();
  std::vector<std::map<int, int>> open(vehicles);
  std::size_t next = 0;
  std::set<int> colours;
  for (std::size_t i = 0; i < film.size(); ++i) {
    for (; next < events.size() && events[next]["time_s"] <= columns.at("time_s")[i]; ++next) {
      const json& event = events[next];
      std::map<int, int>& others = open[event["vehicle"]];
      if (event["kind"] == "stuck") others.clear();
      if (event["other"].is_null()) continue;
      if (event["kind"] == "detected") others[event["other"]] = 1;
      if (event["kind"] == "collision") others[event["other"]] = 2;
      if (event["kind"] == "avoided" || event["kind"] == "collided") others.erase(event["other"]);
    }
    for (std::size_t v = 0; v < vehicles; ++v) {
      int worst = 0;
      for (const auto& [other, state] : open[v]) worst = std::max(worst, state);
      ASSERT_EQ(columns.at("alert")[i * vehicles + v], worst) << "frame " << i << ", vehicle " << v;
      colours.insert(worst);
    }
  }
  EXPECT_THAT(colours, ElementsAre(0, 1, 2));
}

TEST(Film, HasNoCurrentInStillWaterAndTheWanderingOneWhereThereIs) {
  const Scenario still = shipped("head_on");
  EXPECT_TRUE(current_depths(still.water).empty());

  Scenario wandering = shipped("current_drift");
  wandering.water.current_n = Vec3::Zero();
  wandering.water.current.gauss_markov = {.mean_speed_mps = 0.3, .deviation_mps = 0.1};
  Film film{wandering};
  run_scenario_into(wandering, {&film});
  EXPECT_THAT(current_depths(wandering.water), ElementsAre(0.0));
  const Columns columns = all_columns(film, wandering);
  Sea sea{wandering.water, Rng{wandering.seed}};
  for (std::size_t i = 0; i < film.size(); ++i) {
    const Vec3 current = sea.water_at({3, 4, 5}, columns.at("time_s")[i]).current_n;
    ASSERT_EQ(columns.at("current_mps")[2 * i], static_cast<double>(static_cast<float>(current.x())));
    ASSERT_EQ(columns.at("current_mps")[2 * i + 1], static_cast<double>(static_cast<float>(current.y())));
    sea.advance(wandering.step_s);
  }
  EXPECT_NE(columns.at("current_mps").front(), columns.at("current_mps")[2 * film.size() - 2]);
}

TEST(Film, ShowsAProfileAtEightOfItsDepthsAtMost) {
  WaterSpec water;
  water.current.sheared = ShearedCurrentSpec{.profile = {{0.0, 0.5}, {10.0, 0.2}}};
  EXPECT_THAT(current_depths(water), ElementsAre(0.0, 10.0));
  water.current.sheared->profile.clear();
  for (int i = 0; i < 100; ++i) water.current.sheared->profile.push_back({1.0 * i, 0.1});
  const std::vector<double> depths = current_depths(water);
  EXPECT_EQ(depths.size(), 8u);
  EXPECT_EQ(depths.front(), 0.0);
  EXPECT_EQ(depths.back(), 99.0);
}

}  // namespace
}  // namespace fairway
