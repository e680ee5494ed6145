// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/study_runs.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/cubes/plan.hpp"
#include "fairway/studies/run_index.hpp"
#include "fairway/studies/surface/plan.hpp"
#include "fairway/studies/transport/plan.hpp"
#include "fairway/studies/uuv/plan.hpp"

namespace fairway {
namespace {

Scenario lone_vehicle() {
  Scenario scenario{.name = "lone"};
  VehicleSpec vehicle{.name = "one"};
  vehicle.model = Choice{.name = "kinematic"};
  vehicle.avoider = Choice{.name = "direct"};
  vehicle.mission = {{.kind = LegKind::transit, .position = {10.0, 0.0, 0.0}}};
  scenario.vehicles = {vehicle};
  return scenario;
}

/// What the run was given.
std::vector<Measure> measure_exchange(const Scenario& scenario, const std::atomic<bool>*,
                                      std::span<FrameSink* const>) {
  const double rate =
      scenario.exchange.params.empty() ? 0.0 : std::get<double>(scenario.exchange.params.front().second);
  return {{"rate_hz", Measure::fleet, rate}};
}

const Overrides half_a_hertz{{"exchange.kind", "acoustic"}, {"exchange.update_rate_hz", "0.5"}};

TEST(StudyOverrides, ReachTheScenarioOfEveryRun) {
  const std::vector<StudyRun> runs{{{"a", {}, 1}, lone_vehicle, measure_exchange},
                                   {{"b", {}, 2}, lone_vehicle, measure_exchange}};
  const auto measures = make_runs(runs, {.jobs = 1, .overrides = half_a_hertz});
  ASSERT_TRUE(measures);
  for (const auto& run : *measures) EXPECT_EQ(run.front().value, 0.5);
}

TEST(StudyOverrides, MakeOtherRunsOfTheSameOnes) {
  Store store = Store::in_memory();
  const std::vector<StudyRun> runs{{{"a", {}, 1}, lone_vehicle, measure_exchange}};
  const auto plain = make_runs(runs, {.jobs = 1, .store = &store});
  const auto changed = make_runs(runs, {.jobs = 1, .store = &store, .overrides = half_a_hertz});
  EXPECT_EQ(plain->front().front().value, 0.0);
  EXPECT_EQ(changed->front().front().value, 0.5);
  EXPECT_EQ(store.size(), 2U);
}

TEST(StudyOverrides, ThatDoNotFitAreRefusedBeforeAnyRun) {
  Store store = Store::in_memory();
  const std::vector<StudyRun> runs{{{"a", {}, 1}, lone_vehicle, measure_exchange}};
  const StudyOptions options{.jobs = 1, .store = &store, .overrides = {{"exchang.kind", "acoustic"}}};
  EXPECT_THROW(make_runs(runs, options), InputError);
  EXPECT_EQ(store.size(), 0U);
}

/// Two kinds of runs of a study, two seeds each.
std::vector<StudyRun> some_runs() {
  std::vector<StudyRun> runs;
  for (const char* method : {"apf", "apf+saw"}) {
    for (const std::uint64_t seed : {1U, 12U}) {
      const auto scenario = [seed] {
        Scenario made = lone_vehicle();
        made.seed = seed;
        made.vehicles.front().position.y() = static_cast<double>(seed);
        return made;
      };
      const MeasureRun measure = [](const Scenario& made, const std::atomic<bool>* stop,
                                    std::span<FrameSink* const> more) {
        return measure_run(made, builtin_catalogs(), stop, more);
      };
      const std::string key = fmt::format("some/cube/{}/as coded/d1ge57/3/{}", method, seed);
      const Labels labels{{"case", "cube"}, {"method", method}, {"mode", "as coded"}, {"w", "0.5"}};
      runs.push_back({{key, labels, seed, {}}, scenario, measure});
    }
  }
  return runs;
}

TEST(StudyRunAlone, IsCalledByWhatIsVariedAndItsSeed) {
  const std::vector<StudyRun> runs = some_runs();
  EXPECT_EQ(name_of(runs[1].spec), "cube/apf/as_coded/w=0.5/12");
  EXPECT_EQ(command_of(spec_under({}, runs[1].spec)), "fairway study some --only cube/apf/as_coded/w=0.5/12");
  EXPECT_EQ(command_of(spec_under({.seeds = 3, .overrides = {{"exam.a[*]", "b c"}}}, runs[1].spec)),
            "fairway study some --seeds 3 --set 'exam.a[*]=b c' --only cube/apf/as_coded/w=0.5/12");
}

TEST(StudyRunAlone, IsFoundByItsNameItsKeyAndTheirBeginnings) {
  const std::vector<StudyRun> runs = some_runs();
  const auto seed_of = [&](std::string_view called) { return find_run(runs, called).spec.seed; };
  EXPECT_EQ(&find_run(runs, "cube/apf/as_coded/w=0.5/1"), &runs[0]);  // though another begins so too
  EXPECT_EQ(&find_run(runs, "some/cube/apf+saw/as coded/d1ge57/3/12"), &runs[3]);
  EXPECT_EQ(&find_run(runs, "cube/apf+saw/as_coded/w=0.5/12"), &runs[3]);
  EXPECT_EQ(seed_of("cube/apf/as_coded/w=0.5/12"), 12U);
  EXPECT_EQ(&find_run(std::span{runs}.subspan(3), "cube/apf+"), &runs[3]);
}

TEST(StudyRunAlone, IsRefusedWhereNoneOrSeveralAreCalledSo) {
  const std::vector<StudyRun> runs = some_runs();
  const auto refusal = [&](std::string_view called) { return refusal_by([&] { find_run(runs, called); }); };
  EXPECT_THAT(refusal("cube/apf+saw/as_coded/w=0.5/2"),
              testing::AllOf(testing::HasSubstr("no run is called"),
                             testing::HasSubstr("did you mean cube/apf+saw/")));
  EXPECT_EQ(refusal("cube/apf+"),
            "2 runs begin with \"cube/apf+\": cube/apf+saw/as_coded/w=0.5/1, cube/apf+saw/as_coded/w=0.5/12");
}

TEST(StudyRunAlone, OneThatIsNotNearlyCalledSoIsToldHowNamesBegin) {
  EXPECT_EQ(refusal_by([] { find_run(some_runs(), "nowhere"); }),
            "no run is called \"nowhere\"; names begin with cube/, and --only cube/ tells some that do");
}

TEST(StudyOverrides, ThatNoRunTakesAreToldWithoutTheRun) {
  const MeasureRun refused = [](const Scenario&, const std::atomic<bool>*,
                                std::span<FrameSink* const>) -> std::vector<Measure> {
    throw InputError("--set exchange.kind: exchange: kind: unknown exchange");
  };
  const std::vector<StudyRun> runs{{{"some/key", {}, 1}, lone_vehicle, refused}};
  EXPECT_EQ(refusal_by([&] { make_runs(runs, {.jobs = 1, .overrides = half_a_hertz}); }),
            "--set exchange.kind: exchange: kind: unknown exchange");
}

/// To the bit, with NaNs that are alike.
std::vector<std::string> texts_of(const std::vector<Measure>& measures) {
  std::vector<std::string> texts;
  for (const Measure& m : measures)
    texts.push_back(fmt::format("{} {} {}", m.quantity, m.vehicle, number_text(m.value)));
  return texts;
}

TEST(StudyRunAlone, ComesToWhatIsStoredAndNothingElseIsMade) {
  const std::vector<StudyRun> runs = some_runs();
  Store store = Store::in_memory();
  const Overrides overrides{{"step_s", "0.1"}};
  const auto stored = make_runs(runs, {.jobs = 1, .store = &store, .overrides = overrides});
  ASSERT_TRUE(stored);
  ASSERT_NE(texts_of((*stored)[2]), texts_of((*stored)[3]));

  struct Counter final : FrameSink {
    void write(const Frame& frame) override {
      ++frames;
      strokes += frame.vehicles.front().strokes.size();
    }
    bool wants_thoughts() const override { return true; }
    int frames{};
    std::size_t strokes{};
  } counter;
  int shown = 0;
  const auto show = [&](const ShownRun& run) {
    ++shown;
    const std::array<FrameSink*, 1> sinks{&counter};
    EXPECT_EQ(run.name, "cube/apf+saw/as_coded/w=0.5/12");
    EXPECT_TRUE(store.contains(run.spec.key));
    EXPECT_EQ(run.scenario.step_s, 0.1);
    EXPECT_EQ(texts_of(run.make(sinks)), texts_of((*stored)[3]));
  };
  const StudyOptions options{.overrides = overrides, .only = "cube/apf+saw/as_coded/w=0.5/12", .show = show};
  EXPECT_FALSE(make_runs(runs, options));
  EXPECT_EQ(shown, 1);
  EXPECT_GT(counter.frames, 10);
  EXPECT_GT(counter.strokes, 0U);  // looking does not change what it comes to
}

TEST(RunIndex, LeadsFromACellToItsRunsAndTheirValues) {
  const std::vector<StudyRun> runs = some_runs();
  const StudyOptions options{
      .playback = [](const RunSpec& spec) { return spec.seed == 12 ? std::string("runs/a.html") : ""; }};
  std::vector<Cell> cells(2, {.place = "cube", .mode = "as coded", .params = {{"w", 0.5}}});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].method = i == 0 ? "apf" : "apf+saw";
    cells[i].runs = {runs[2 * i], runs[2 * i + 1]};
    cells[i].results = {{{"time_s", 0, 1.0}, {"time_s", 1, 2.0}, {"sum", -1, 5.0}}, {{"sum", -1, 1.0 / 3.0}}};
  }
  const RunIndex index{options, {&cells}};

  const Labels second = cells[1].labels();
  EXPECT_EQ(second, runs[2].spec.labels);
  EXPECT_EQ(index.runs_of(second).dump(), "[[2,3]]");
  EXPECT_EQ(index.run_of(second, 12).dump(), "[3]");
  EXPECT_EQ(index.values_of(second, "time_s").dump(), "[1.5,null]");
  EXPECT_EQ(index.values_of(second, "sum").dump(), "[5.0,0.333333]");
  EXPECT_TRUE(index.values_of(second, "success_ratio").is_null());
  EXPECT_TRUE(index.runs_of({{"case", "cube"}}).is_null());
  EXPECT_EQ(index.mark({{"value", 1}}, second, "sum").dump(),
            R"({"runs":[[2,3]],"value":1,"values":[5.0,0.333333],"values_label":"sum"})");
  EXPECT_EQ(index.line({}, cell_of(cell_row(cells[1], "sum")), "sum").dump(),
            R"({"$runs":[[2,3]],"$values":[5.0,0.333333],"$values_label":"sum"})");
  EXPECT_EQ(index.list().document().at(1).dump(),
            R"({"command":"fairway study some --only cube/apf+saw/as_coded/w=0.5/",)"
            R"("label":"cube apf+saw as_coded w=0.5","playbacks":{"1":"runs/a.html"},"seeds":[1,12]})");
}

std::vector<std::string> names_in(std::initializer_list<std::vector<Cell>> groups) {
  std::vector<std::string> names;
  for (const std::vector<Cell>& cells : groups) {
    for (const Cell& cell : cells) {
      for (const StudyRun& run : cell.runs) names.push_back(name_of(run.spec));
    }
  }
  return names;
}

TEST(RunNames, AreEachOfOneRunInEveryStudy) {
  const std::map<std::string, std::vector<std::string>> studies{
      {"cubes", names_in({cubes::tuning_cells(), cubes::comparison_cells(cubes::Code::as_coded, 5),
                          cubes::heading_cells(), cubes::comparison_cells(cubes::Code::corrected, 2),
                          cubes::replica_cells(cubes::Code::as_coded_starts, 2), cubes::timing_cells(2),
                          cubes::told_cells(2)})},
      {"transport",
       names_in({transport::published_cells(), transport::case_cells(), transport::field_cells(2)})},
      {"surface", names_in({surface::published_cells(), surface::varied_cells(2)})},
      {"uuv", names_in({uuv::published_cells(), uuv::varied_cells(2), uuv::gathering_cells(2),
                        uuv::silence_cells(2)})}};
  for (const auto& [study, names] : studies) {
    EXPECT_GT(names.size(), 40U) << study;
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << study;
    for (const std::string& name : names) EXPECT_EQ(name.find_first_of(" '"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace fairway
