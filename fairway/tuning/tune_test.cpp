// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tune.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/testing/temporary_folder.hpp"
#include "fairway/experiment/ground_digest.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/tuning/tuning_text.hpp"

namespace fairway {
namespace {

const std::string scenario_text = R"(fairway: 1
name: meeting
summary: two that meet
duration_s: 10
defaults: {model: kinematic, avoider: orca3d, tracking: raw, radius_m: 1}
vehicles:
  - {name: a, start: {position_m: [0, 0, 5]}, mission: [{transit: {position_m: [20, 0, 5]}}]}
  - {name: b, start: {position_m: [20, 0, 5], yaw_deg: 180}, mission: [{transit: {position_m: [0, 0, 5]}}]}
)";

const std::string specification = R"(fairway_tuning: 1
name: meeting
method: {algorithm: orca3d, crit_dist_m: 20}
parameters:
  time_horizon_s: {from: 2, to: 60, scale: log}
  max_neighbours_count: {from: 2, to: 12}
  symmetry: [none, starboard]
train: {scenario: meeting.yaml, seeds: {count: 20}}
validation: {scenario: meeting.yaml, seeds: {first: 101, count: 30}}
test: {scenario: meeting.yaml, seeds: {first: 201, count: 40}}
)";

double param(const Scenario& scenario, std::string_view name, double usual) {
  for (const auto& [key, value] : scenario.vehicles[0].avoider->params)
    if (key == name) return std::get<double>(value);
  return usual;
}

/// Stands in for a simulation: best at a horizon of 20 s and 6 neighbours; a horizon below 4 s collides.
std::vector<Measure> pretended(const Scenario& scenario) {
  Rng rng = Rng{scenario.seed}.stream("pretended");
  const double horizon = param(scenario, "time_horizon_s", 5.0);
  const double neighbours = param(scenario, "max_neighbours_count", 10.0);
  const double time = 100.0 + 30.0 * std::fabs(std::log(horizon / 20.0)) + 3.0 * std::fabs(neighbours - 6.0);
  return {{.quantity = "pair_collision_count", .value = horizon < 4.0 ? 1.0 : 0.0},
          {.quantity = "arrived_ratio", .value = 1.0},
          {.quantity = "navigation_time_s", .vehicle = 0, .value = time + 5.0 * rng.normal()}};
}

class Tuning : public ::testing::Test {
 protected:
  void SetUp() override { std::ofstream{folder_.file("meeting.yaml")} << scenario_text; }

  std::string file() const { return folder_.file("spec.yaml"); }
  TuningFile parsed(const std::string& text = specification) const {
    return parse_tuning_file(text, file(), catalogs_.avoiders).tunings.front();
  }

  /// The specification with other parameters, as a mapping on one line.
  static std::string searching(const std::string& parameters) {
    const std::size_t from = specification.find("parameters:"), to = specification.find("train:");
    return specification.substr(0, from) + "parameters: " + parameters + "\n" + specification.substr(to);
  }

  TuningResult tuned(Store& store, unsigned jobs, std::size_t budget = 800,
                     const Simulate& simulate = pretended, const TuningFile* tuning = nullptr) const {
    TrialRuns runs{file(), {.check = {}, .own = {}, .simulate = simulate}, store, {.jobs = jobs}};
    return tune(tuning != nullptr ? *tuning : parsed(), runs, {.budget = budget});
  }

  TemporaryFolder folder_;
  Catalogs catalogs_ = builtin_catalogs();
};

TEST_F(Tuning, FindsWhatIsBestAndSaysHowMuchBetterOnRunsThatItNeverSaw) {
  Store store = Store::in_memory();
  const TuningResult result = tuned(store, 2, 1600);
  EXPECT_FALSE(result.is_usual);
  EXPECT_NEAR(std::log(result.best[0] / 20.0), 0.0, 0.25);
  EXPECT_NEAR(result.best[1], 6.0, 2.0);
  EXPECT_LE(result.runs, 1600U);
  EXPECT_EQ(result.test.runs, 40U);
  EXPECT_EQ(result.test.collision_free.rate, 1.0);
  // 141.6 + 12 s as written, about 100 tuned
  EXPECT_NEAR(result.test.time_difference.mean, 105.0 / 153.6 - 1.0, 0.05);
  EXPECT_LT(result.test.time_difference.high, -0.2);
  EXPECT_LT(result.luck.low, 0.0);
  EXPECT_GT(result.luck.high, 0.0) << "nothing here is luck";
  EXPECT_EQ(shown_by(result.test), Shown::quicker);
}

TEST_F(Tuning, AMethodThatIsUnknownIsToldWhereItIsWritten) {
  const auto refusal = [&](const std::string& method) {
    std::string text = specification;
    text.replace(text.find("{algorithm"), std::string{"{algorithm: orca3d, crit_dist_m: 20}"}.size(), method);
    return refusal_by([&] { parsed(text); }).substr(file().size());
  };
  EXPECT_EQ(refusal("orcad"), ":3:9: method: unknown algorithm \"orcad\"; did you mean orca3d?");
  EXPECT_EQ(refusal("{label: x, algorithm: orcad}"),
            ":3:31: method: unknown algorithm \"orcad\"; did you mean orca3d?");
}

TEST_F(Tuning, ACopyOfAScenarioUnderAnotherNameIsTheSameRun) {
  std::string text = specification;
  text.replace(text.find("validation: {scenario: meeting.yaml, seeds: {first: 101"), 55,
               "validation: {scenario: copy.yaml, seeds: {first: 7");
  std::string copy = "# another comment\n" + scenario_text;
  copy.replace(copy.find("name: meeting"), 13, "name: copy");
  copy.replace(copy.find("avoider: orca3d"), 15, "avoider: apf");  // each run has the method that is tuned
  std::ofstream{folder_.file("copy.yaml")} << copy;
  EXPECT_EQ(
      refusal_by([&] { parsed(text); }).substr(file().size()),
      ":9:24: validation: has copy, which is meeting, under seed 7 as train has; what is judged by must "
      "be new");
  copy.replace(copy.find("duration_s: 10"), 14, "duration_s: 11");
  std::ofstream{folder_.file("copy.yaml")} << copy;
  EXPECT_EQ(refusal_by([&] { parsed(text); }), "accepted");
}

TEST_F(Tuning, WhatItLeavesIsAnAvoiderWhateverWasTyped) {
  Store store = Store::in_memory();
  std::istringstream lines{tuned_avoider(parsed(), tuned(store, 2), "fairway tune --out 'a\nb'")};
  std::string line;
  std::size_t count = 0;
  while (std::getline(lines, line)) count += line.starts_with("#") ? 0 : 1;
  EXPECT_EQ(count, 1U);
}

TEST_F(Tuning, ItsResultIsKnownAgainHoweverLongTheCurve) {
  Store store = Store::in_memory();
  TuningResult result = tuned(store, 2);
  result.curve.resize(20'000, result.curve.front());
  std::ofstream{folder_.file("tuning.json")} << to_json(parsed(), result).dump(2);
  EXPECT_TRUE(is_of_kind(folder_.file("tuning.json"), tuning_document));
  EXPECT_TRUE(is_of_kind(FAIRWAY_SOURCE_DIR "/campaigns/exam/tuned/vo/tuning.json", tuning_document));
}

TEST_F(Tuning, WhatItSawIsKnownByNameAndByWhatIsInIt) {
  Store store = Store::in_memory();
  const nlohmann::json seen = to_json(parsed(), tuned(store, 2))["seen"];
  EXPECT_EQ(seen["train"]["scenarios"], nlohmann::json::array({"meeting"}));
  EXPECT_EQ(seen["train"]["digests"], nlohmann::json::array({ground_digest(scenario_text, "copy.yaml")}));
  EXPECT_EQ(seen["validation"]["digests"], seen["train"]["digests"]);
}

TEST_F(Tuning, IsTheSameOnAnyNumberOfThreadsAndGoesOnWhereItWasStopped) {
  Store one = Store::in_memory(), many = Store::in_memory(), stopped = Store::in_memory();
  const std::string expected = to_json(parsed(), tuned(one, 1)).dump();
  EXPECT_EQ(to_json(parsed(), tuned(many, 4)).dump(), expected);

  std::atomic<int> made{0};
  const Simulate until_stopped = [&](const Scenario& scenario) {
    if (++made > 300) throw RunAbandoned{};
    return pretended(scenario);
  };
  EXPECT_THROW(tuned(stopped, 1, 800, until_stopped), RunAbandoned);
  const std::size_t before = stopped.size();
  EXPECT_GT(before, 200U);
  std::atomic<std::size_t> again{0};
  const Simulate counted = [&](const Scenario& scenario) {
    ++again;
    return pretended(scenario);
  };
  EXPECT_EQ(to_json(parsed(), tuned(stopped, 2, 800, counted)).dump(), expected);
  EXPECT_EQ(before + again, stopped.size()) << "no run is made twice";
}

TEST_F(Tuning, IsTheSameWhereSeveralShareTheRunsAndEveryRunIsMadeByOne) {
  Store one = Store::in_memory();
  const std::string expected = to_json(parsed(), tuned(one, 1)).dump();

  constexpr std::uint32_t count = 3;
  const Origin search{.campaign = "meeting", .digest = "of this search"};
  std::atomic<std::size_t> made{0};
  std::array<std::string, count> found;
  const auto go = [&](std::uint32_t part) {
    Companions companions{folder_.file(""), {part, count}, search, Store::Foreign::refuse};
    const Simulate counted = [&](const Scenario& scenario) {
      ++made;
      return pretended(scenario);
    };
    TrialRuns runs{file(), {.check = {}, .own = {}, .simulate = counted}, companions, {.jobs = 1}, {}};
    found[part] = to_json(parsed(), tune(parsed(), runs, {.budget = 800})).dump();
  };
  {
    std::vector<std::jthread> threads;
    for (std::uint32_t part = 0; part < count; ++part) threads.emplace_back(go, part);
  }
  for (const std::string& document : found) EXPECT_EQ(document, expected);
  EXPECT_EQ(made, one.size());

  EXPECT_EQ(refusal_by([&] {
              Companions{folder_.file(""), {1, count}, {.digest = "another"}, Store::Foreign::refuse};
            }).substr(folder_.file("").size()),
            "1.db: holds the runs of another search: of another specification, budget, seed or number of "
            "shards; take another folder");
}

TEST_F(Tuning, WhereNothingIsBetterTheMethodStaysAsItIsWritten) {
  const Simulate alike = [](const Scenario& scenario) {
    std::vector<Measure> measures = pretended(scenario);
    if (param(scenario, "time_horizon_s", -1.0) > 0.0) measures[0].value = 1.0;  // whatever is tried collides
    return measures;
  };
  Store store = Store::in_memory();
  const TuningResult result = tuned(store, 2, 400, alike);
  EXPECT_TRUE(result.is_usual);
  EXPECT_EQ(result.best, usual_setting(parsed().parameters));
  EXPECT_EQ(result.test.time_difference.mean, 0.0);
  EXPECT_TRUE(tuning_text(parsed(), result).find("nothing was better") != std::string::npos);
}

TEST_F(Tuning, TellsLuckFromGain) {
  // time is noise that a setting brings to a seed: what is best on train is no better on test
  const Simulate noise = [](const Scenario& scenario) {
    std::vector<Measure> measures = pretended(scenario);
    const double horizon = param(scenario, "time_horizon_s", 5.0);
    Rng rng = Rng{scenario.seed}.stream("noise", static_cast<std::uint64_t>(1e6 * horizon));
    measures[0].value = 0.0;
    measures[2].value = 100.0 + 20.0 * rng.normal();
    return measures;
  };
  Store store = Store::in_memory();
  const TuningResult result = tuned(store, 2, 3000, noise);
  ASSERT_FALSE(result.is_usual);
  EXPECT_LT(result.train.time_difference.mean, -0.03) << "on train it looks better";
  EXPECT_GT(result.luck.mean, 0.02);
  EXPECT_GT(result.test.time_difference.high, 0.0) << "on test it is not";
}

TEST_F(Tuning, TellsLuckInSafetyFromGain) {
  // who collides is drawn for each setting and seed: what is safest on train is no safer on test
  const Simulate noise = [](const Scenario& scenario) {
    std::vector<Measure> measures = pretended(scenario);
    const double horizon = param(scenario, "time_horizon_s", 5.0);
    Rng rng = Rng{scenario.seed}.stream("collision", static_cast<std::uint64_t>(1e6 * horizon));
    measures[0].value = rng.uniform(0.0, 1.0) < 0.5 ? 1.0 : 0.0;
    return measures;
  };
  Store store = Store::in_memory();
  const TuningResult result = tuned(store, 2, 3000, noise);
  ASSERT_FALSE(result.is_usual);
  EXPECT_GT(result.train.safer.difference, 0.1) << "on train it looks better";
  EXPECT_GT(result.safety_luck.difference, 0.1);
  EXPECT_GT(result.safety_luck.low, result.safety_luck.difference - 0.5);
  EXPECT_NE(shown_by(result.test), Shown::safer) << "on test it is not";
  EXPECT_EQ(result.safety_luck.difference, result.train.safer.difference - result.test.safer.difference);
}

TEST_F(Tuning, WhoseMeasuresCannotBeStoredHasFailedAtOnceAsWhenItIsReadAgain) {
  // the settings that are quickest measure something twice
  const Simulate twice = [](const Scenario& scenario) {
    std::vector<Measure> measures = pretended(scenario);
    if (param(scenario, "time_horizon_s", 5.0) > 15.0) measures.push_back(measures[2]);
    return measures;
  };
  Store store = Store::in_memory();
  const TuningResult first = tuned(store, 2, 800, twice);
  const std::size_t made = store.size();
  EXPECT_GT(store.failed_count(), 0U);
  const TuningResult again = tuned(store, 2, 800, twice);
  EXPECT_EQ(again.best, first.best);
  EXPECT_EQ(again.runs, first.runs);
  EXPECT_EQ(store.size(), made) << "a search that is repeated asks for no other runs";
}

TEST_F(Tuning, TheAvoiderItWritesIsTheOneItFound) {
  Store store = Store::in_memory();
  const TuningResult result = tuned(store, 2);
  const std::string text = tuned_avoider(parsed(), result, "fairway tune spec.yaml");
  EXPECT_TRUE(text.starts_with("# Tuned by fairway"));
  EXPECT_TRUE(text.find("# fairway tune spec.yaml\n") != std::string::npos);
  EXPECT_TRUE(text.find("time_horizon_s: " + value_text(parsed().parameters[0], result.best[0])) !=
              std::string::npos)
      << text;
  EXPECT_TRUE(text.find("\n# it is shown to be quicker than the method as written.\n") != std::string::npos)
      << text;
}

TEST_F(Tuning, OfAFewSettingsEachIsTriedOnceAndThenTheSearchEnds) {
  // how many there are, less the method's own setting (500, none, 5) where that is among them
  const std::vector<std::pair<std::string, std::size_t>> spaces{
      {"{max_neighbours_count: [5, 6, 9]}", 3},
      {"{max_neighbours_count: [4, 5, 6, 7, 8]}", 5},
      {"{max_neighbours_count: {from: 5, to: 7}}", 3},
      {"{max_neighbours_count: [6, 7, 500], symmetry: }", 3 * 4 - 1},
      {"{max_neighbours_count: {from: 3, to: 7}, symmetry: , time_horizon_s: [4, 5, 6, 8, 10]}", 5 * 4 * 5}};
  for (const auto& [space, expected] : spaces) {
    Store store = Store::in_memory();
    const TuningFile tuning = parsed(searching(space));
    const TuningResult result = tuned(store, 2, 10'000, pretended, &tuning);
    EXPECT_EQ(result.tried, expected) << space;
    EXPECT_EQ(value_text(tuning.parameters[0], result.best[0]), "6") << space;
    EXPECT_EQ(result.budget, 10'000U);
    EXPECT_LT(result.runs, result.budget) << space;
    EXPECT_GE(result.runs, 20 + 5 * expected) << "each has run the first seeds: " << space;
  }
}

TEST_F(Tuning, ASingleSettingBesidesTheMethodsOwnIsComparedWithIt) {
  const Simulate quicker = [](const Scenario& scenario) {
    std::vector<Measure> measures = pretended(scenario);
    for (const auto& [name, value] : scenario.vehicles[0].avoider->params)
      if (name == "symmetry" && value == ParamValue{"starboard"}) measures[2].value -= 50.0;
    return measures;
  };
  const TuningFile tuning = parsed(searching("{symmetry: [none, starboard]}"));
  Store store = Store::in_memory();
  const TuningResult result = tuned(store, 2, 40, quicker, &tuning);
  EXPECT_EQ(result.tried, 1U);
  EXPECT_EQ(result.runs, 40U) << "the method as written and the other, on 20 seeds each";
  EXPECT_EQ(result.best, Setting{1.0});
  EXPECT_FALSE(result.is_usual);
  EXPECT_EQ(refusal_by([&] { refuse_small_budget(tuning, 24); }),
            "a budget of 24 runs is too small to race; this needs 25 to judge one generation");
}

TEST_F(Tuning, WhatTheMethodHasIsItsDefaultEvenWhereThatIsNoneOfTheChoices) {
  const TuningFile tuning =
      parsed(searching("{time_horizon_s: [4, 6, 8, 15], max_neighbours_count: [6, 5e2]}"));
  Store store = Store::in_memory();
  const TuningResult result = tuned(store, 2, 1000, pretended, &tuning);
  ASSERT_EQ(result.best, (Setting{3.0, 0.0}));
  const std::string text = tuning_text(tuning, result);
  EXPECT_NE(text.find(" 15   (it has 5)\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" 6   (it has 5e2)\n"), std::string::npos) << text;
  EXPECT_EQ(to_json(tuning, result)["default"]["parameters"],
            (nlohmann::json{{"time_horizon_s", "5"}, {"max_neighbours_count", "5e2"}}));
  // as pretended: 30 ln(20 / 5) s at its own horizon of 5 s, 30 ln(20 / 15) s at 15 s
  ASSERT_EQ(result.ablations.size(), 2U);
  EXPECT_NEAR(result.ablations[0].appraisal.time_s.mean - result.validation.time_s.mean, 30.0 * std::log(3.0),
              1e-6);
}

TEST_F(Tuning, RefusesWhatCannotBeTunedWithItsPlace) {
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = specification;
    text.replace(text.find(from), from.size(), to);
    return refusal_by([&] { parsed(text); });
  };
  EXPECT_EQ(
      refusal("time_horizon_s", "time_horizon"),
      file() + ":5:3: parameters.time_horizon: is no parameter of orca3d; did you mean time_horizon_s?");
  EXPECT_EQ(refusal("from: 2, to: 60", "from: 60, to: 2"),
            file() + ":5:19: parameters.time_horizon_s: from must be less than to");
  EXPECT_EQ(refusal("[none, starboard]", "[none, port]").substr(file().size()),
            ":7:20: parameters.symmetry[1]: is port; known: none, starboard, drawn, by_id");
  EXPECT_EQ(
      refusal("first: 201", "first: 120"),
      file() + ":10:18: test: has meeting under seed 120 as validation has; what is judged by must be new");
  EXPECT_EQ(refusal("seeds: {count: 20}", "seeds: {count: 4}").substr(file().size()),
            ":8:48: train.seeds.count: is 4; nobody can be told apart by fewer than 5");
  EXPECT_EQ(refusal("crit_dist_m: 20", "time_horizon_s: 20").substr(file().size()),
            ":5:19: parameters.time_horizon_s: is set by method too, so it is not searched for; leave it out "
            "there");
  EXPECT_EQ(refusal("{algorithm: orca3d, crit_dist_m: 20}", "direct").substr(file().size()),
            ":5:3: parameters: direct has no parameters, so there is nothing to tune");
  std::string without = specification;
  without.erase(without.find("parameters:"), without.find("train:") - without.find("parameters:"));
  without.replace(without.find("{algorithm: orca3d, crit_dist_m: 20}"), 36, "direct");
  EXPECT_EQ(refusal_by([&] { parsed(without); }).substr(file().size()),
            ":3:9: method: direct has no parameters, so there is nothing to tune");
  EXPECT_EQ(refusal("{from: 2, to: 12}", "5").substr(file().size()),
            ":6:25: parameters.max_neighbours_count: expected {from: 1, to: 10}, or a list of values, got 5");
}

TEST_F(Tuning, RefusesABudgetThatIsTooSmallToRace) {
  Store store = Store::in_memory();
  EXPECT_EQ(refusal_by([&] { tuned(store, 1, 20); }),
            "a budget of 20 runs is too small to race; this needs 55 to judge one generation");
}

}  // namespace
}  // namespace fairway
