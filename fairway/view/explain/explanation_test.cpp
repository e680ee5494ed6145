// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/explanation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/avoidance/label.hpp"
#include "fairway/record/word_messages.hpp"
#include "fairway/view/explain/headline.hpp"
#include "fairway/view/explain/testing/recorded_run.hpp"

namespace fairway {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// `auv` heads north at 0.5 m/s for a goal 40 m away and meets `other` 20 m ahead, coming straight at it.
class HeadOn : public ::testing::Test {
 protected:
  HeadOn() {
    scenario.name = "met";
    scenario.vehicles = {{.id = 0, .name = "auv"}, {.id = 1, .name = "other"}};
    for (VehicleSpec& vehicle : scenario.vehicles) {
      vehicle.avoider = Choice{.name = "orca3d", .params = {{"time_horizon_s", 7.0}}};
    }
  }

  FoundDecision answered(const Command& command, const Drawing& drawing = {}) const {
    const Situation s{.time = 10,
                      .period = 0.1,
                      .own = {.velocity = {0.5, 0, 0}, .priority = 0, .position_sigma = position_sigma},
                      .goal = {.position = {40, 0, 0}, .cruise_speed = 0.5},
                      .limits = limits,
                      .tracks = tracks};
    FoundDecision found{.tick = Tick{100}, .time = 10, .phase = Phase::under_way};
    found.decision.emplace(s, command);
    found.decision->tick = Tick{100};
    found.decision->strokes.assign(drawing.strokes().begin(), drawing.strokes().end());
    return found;
  }

  Explanation explained(const Command& command, const Drawing& drawing = {}) const {
    return explain(scenario, answered(command, drawing), builtin_avoiders());
  }

  Scenario scenario;
  Limits limits{.max_speed = 0.5};
  double position_sigma{};
  std::vector<Track> tracks{
      {.id = TrackId{1}, .position = {20, 0, 0}, .velocity = {-0.5, 0, 0}, .priority = 1}};
};

ExplanationSection section_of(const Explanation& explanation, const std::string& title) {
  const auto found = std::ranges::find(explanation.sections, title, &ExplanationSection::title);
  if (found == explanation.sections.end()) throw std::out_of_range(title);
  return *found;
}

TEST_F(HeadOn, IsToldByTheHalfSpaceInTheWay) {
  Drawing drawing;
  drawing.half_space({0, 0.1, 0}, {0, 1, 0}, "allowed by vehicle 1");
  const Explanation told = explained({.velocity = {0.4, 0.3, 0}, .mode = Mode::avoid}, drawing);
  EXPECT_EQ(
      told.headline,
      "auv turns 37 deg to starboard: the velocity it prefers is outside the only half-space of allowed "
      "velocities.");
  const ExplanationTable table = section_of(told, "Half-spaces of allowed velocities").table;
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "allowed by other");
  EXPECT_EQ(std::get<std::string>(section_of(told, "What it drew").table.rows[0][1]), "allowed by other");
  EXPECT_NEAR(std::get<double>(table.rows[0][1]), -0.1, 1e-12);
  EXPECT_EQ(std::get<std::string>(table.rows[0][3]), "in the way");
  EXPECT_THAT(section_of(told, "Command").lines, Contains("At its limits: the speed limit of 0.500 m/s."));
}

TEST_F(HeadOn, CallsWhoeverWasDrawnAsItsNeighboursAreCalled) {
  EXPECT_EQ(named_meaning(scenario, "waits for vehicle 1"), "waits for other");
  for (const std::uint32_t id : {7U, first_tracker_id + 5, first_drifter_id + 2}) {
    const Label label{"allowed by", TrackId{id}};
    EXPECT_EQ(named_meaning(scenario, label), "allowed by " + track_name(scenario, TrackId{id}));
  }
  EXPECT_EQ(named_meaning(scenario, "band of another class 1"), "band of another class 1");
  EXPECT_EQ(named_meaning(scenario, "velocity of a vehicle x"), "velocity of a vehicle x");
}

TEST_F(HeadOn, IsToldByTheApproachWhereNothingWasDrawn) {
  EXPECT_EQ(explained({.velocity = {0.2, 0, 0}, .mode = Mode::avoid}).headline,
            "auv slows down by 0.30 m/s to 0.20 m/s; the preferred velocity leads to 0.0 m from other in "
            "20.0 s, both radii are 2.0 m.");
}

TEST_F(HeadOn, IsToldByTheWordsOfTheMethodFirst) {
  EXPECT_EQ(explained({.mode = Mode::infeasible, .note = "no way was found"}).headline,
            "auv finds no safe velocity and stops: no way was found.");
}

TEST_F(HeadOn, SaysThatItMakesNoProgressAndWithWhom) {
  FoundDecision found = answered({.mode = Mode::avoid});
  found.progress = {.state = Headway::deadlocked, .last_progress = 3.25, .since = 4.0, .with = TrackId{1}};
  const Explanation told = explain(scenario, found, builtin_avoiders());
  EXPECT_THAT(told.headline,
              ::testing::EndsWith(". It has made no progress since 3.25 s: deadlocked with other."));
  EXPECT_EQ(
      exact_json(scenario, found, told)["progress"],
      (nlohmann::json{{"state", "deadlocked"}, {"last_progress_s", 3.25}, {"since_s", 4.0}, {"with", 1}}));
  found.progress.state = Headway::holding;
  EXPECT_THAT(explain(scenario, found, builtin_avoiders()).headline, Not(HasSubstr("progress")));
}

TEST_F(HeadOn, SaysWhatOfTheSituationCannotBeDecidedOn) {
  tracks[0].radius = -1.0;
  const Explanation told =
      explained({.mode = Mode::infeasible, .note = "a track has a number that is not finite, or no radius"});
  EXPECT_THAT(told.headline, HasSubstr(": a track has a number that is not finite, or no radius."));
  EXPECT_THAT(section_of(told, "Command").lines,
              Contains("It says: a track has a number that is not finite, or no radius."));
}

TEST_F(HeadOn, SaysHowUnsureOfItsPlaceItIs) {
  const auto own_lines = [&] { return section_of(explained({}), "Own state, as believed on board").lines; };
  EXPECT_THAT(own_lines(), Not(Contains(HasSubstr("deviation"))));
  position_sigma = 0.5;
  EXPECT_THAT(own_lines(), Contains("Its navigation states a standard deviation of 0.50 m."));
}

TEST_F(HeadOn, SaysWhatIsBeyondTheVehicle) {
  limits = {.max_speed = 1.5, .min_speed = 0.4, .sternway = false, .sway = false};
  const FoundDecision found = answered({.velocity = {-1.5, 0, 0}, .mode = Mode::infeasible});
  const Explanation told = explain(scenario, found, builtin_avoiders());
  EXPECT_THAT(section_of(told, "Command").lines,
              Contains("Beyond the vehicle: commanded astern, which the vehicle cannot go: it has to turn "
                       "round first."));
  EXPECT_THAT(section_of(told, "Own state, as believed on board").lines,
              Contains("The vehicle cannot go slower than 0.400 m/s, go astern, go sideways."));
  const nlohmann::json document = exact_json(scenario, found, told);
  EXPECT_EQ(document["decision"]["shortfall"], "astern");
  EXPECT_EQ(document["decision"]["limits"]["min_speed_mps"], 0.4);
  EXPECT_EQ(document["decision"]["limits"]["sternway"], false);

  const Explanation as_it_can = explained({.velocity = {0.5, 0, 0}});
  EXPECT_THAT(section_of(as_it_can, "Command").lines, Not(Contains(StartsWith("Beyond"))));
}

TEST_F(HeadOn, SaysForWhomItMayWait) {
  tracks.insert(tracks.begin(), {.id = TrackId{9}, .position = {0, -8, 0}, .priority = 5});
  tracks.back().priority = -1;
  EXPECT_EQ(explained({.mode = Mode::hold}).headline,
            "auv waits on purpose; the nearest that has the right of way is other, 20.0 m away, dead ahead.");
}

TEST_F(HeadOn, HasATableOfNeighbours) {
  const Explanation told = explained({.velocity = {0.5, 0, 0}});
  EXPECT_THAT(told.headline, StartsWith("auv keeps to the velocity it prefers; "));
  const ExplanationTable table = section_of(told, "Neighbours").table;
  ASSERT_EQ(table.rows.size(), 1u);
  const auto value = [&](const std::string& column) {
    const auto at = std::ranges::find(table.columns, column) - table.columns.begin();
    return std::get<double>(table.rows[0].at(static_cast<std::size_t>(at)));
  };
  EXPECT_EQ(value("range_m"), 20.0);
  EXPECT_EQ(value("closing_mps"), 1.0);
  EXPECT_EQ(value("cpa_m"), 0.0);
  EXPECT_EQ(value("cpa_s"), 20.0);
  EXPECT_EQ(value("radii_m"), 2.0);
}

TEST_F(HeadOn, NamesTheMethodAndItsParametersInForce) {
  const ExplanationSection method = section_of(explained({}), "Method: orca3d");
  EXPECT_THAT(method.lines, Contains(AllOf(HasSubstr("orca3d: "), HasSubstr("Source: "))));
  bool seen = false;
  for (const auto& row : method.table.rows) {
    if (std::get<std::string>(row[0]) != "time_horizon_s") continue;
    EXPECT_EQ(std::get<double>(row[1]), 7.0);
    seen = true;
  }
  EXPECT_TRUE(seen);
}

TEST_F(HeadOn, SaysWhetherTheCommandIsTheRecordedOne) {
  FoundDecision found = answered({});
  const auto lines = [&] {
    return section_of(explain(scenario, found, builtin_avoiders()), "How it was found").lines;
  };
  EXPECT_THAT(lines(), Contains("The command found is the recorded command, to the bit."));
  found.difference = {"command_n_mps", "1", "2"};
  EXPECT_THAT(lines(), Contains("NOT the recorded command: command_n_mps was recorded as 1, now it is 2."));
}

TEST_F(HeadOn, GivesEveryNumberExactly) {
  const double odd = 0.1 + 0.2;
  tracks[0].position.y() = odd;
  const FoundDecision found = answered({.velocity = {odd, 0, 0}, .mode = Mode::avoid});
  const Explanation told = explain(scenario, found, builtin_avoiders());
  const nlohmann::json document = nlohmann::json::parse(exact_json(scenario, found, told).dump());
  EXPECT_EQ(document["decision"]["command"]["velocity_mps"][0].get<double>(), odd);
  EXPECT_EQ(document["decision"]["neighbours"][0]["position_m"][1].get<double>(), odd);
  EXPECT_EQ(document["decision"]["neighbours"][0]["name"], "other");
  EXPECT_TRUE(document["decision"]["limits"]["max_climb_rate_mps"].is_null());
  EXPECT_TRUE(document["recorded_command_to_the_bit"]);
}

TEST_F(HeadOn, GivesThePageWhatItReads) {
  const Explanation told = explained({.velocity = {0.4, 0.3, 0}, .mode = Mode::avoid});
  const nlohmann::json page = page_json(told);
  EXPECT_EQ(page["vehicle"], 0);
  EXPECT_EQ(page["headline"], told.headline);
  ASSERT_EQ(page["sections"].size(), told.sections.size());
  int rows = 0;
  for (const auto& section : page["sections"]) {
    EXPECT_TRUE(section["title"].is_string() && section["lines"].is_array());
    if (section["table"].is_null()) continue;
    for (const auto& row : section["table"]["rows"]) {
      EXPECT_EQ(row.size(), section["table"]["columns"].size());
      ++rows;
    }
  }
  EXPECT_GT(rows, 1);
}

TEST(Explanation, SaysWhoSteersWhereNoAvoiderIsAsked) {
  const Scenario scenario = testing::scenario_of("survey_mission", {{"duration_s", "100"}});
  const Recording recording = testing::recorded(scenario);
  const auto found = find_decision(recording, scenario, builtin_catalogs(), {0, 40});
  ASSERT_TRUE(found);
  const Explanation told = explain(scenario, *found, builtin_avoiders());
  EXPECT_EQ(told.headline, "surveyor asks no avoider: guidance steers it straight to (0.0, 0.0, 8.0) m.");
  EXPECT_TRUE(exact_json(scenario, *found, told)["decision"].is_null());
}

TEST(Explanation, SaysWhatAVehicleThatSpeaksHasSaidAndHeard) {
  const Scenario scenario =
      testing::scenario_of("pledge_cube", {{"duration_s", "65"}, {"exchange.loss_ratio", "0"}});
  const Recording recording = testing::recorded(scenario, 4);
  ASSERT_FALSE(recording.words().empty());
  const std::size_t last = recording.size() - 1;
  const auto found = find_decision(recording, scenario, builtin_catalogs(), {3, last});
  ASSERT_TRUE(found && found->words && found->words->said);
  const double time = recording.frame(last).time;

  // the last of its own words in the recording
  const SpokenWord* said = nullptr;
  for (const SpokenWord& word : recording.words())
    if (word.from == 3 && word.sent <= time) said = &word;
  ASSERT_NE(said, nullptr);
  EXPECT_EQ(found->words->said->speech, said->speech);
  EXPECT_EQ(found->words->said->age, time - said->sent);

  // of every other one that was said a turn ago at the latest
  ASSERT_EQ(found->words->heard.size(), 7u);
  for (const FoundWord& heard : found->words->heard) {
    EXPECT_NE(heard.from, 3u);
    EXPECT_LE(heard.age, 4.0);
    EXPECT_TRUE(std::ranges::any_of(recording.words(), [&](const SpokenWord& word) {
      return word.from == heard.from && word.sent == time - heard.age && word.speech == heard.speech;
    }));
    EXPECT_THAT(heard.text, Not(HasSubstr("not a word")));
  }

  const Explanation told = explain(scenario, *found, builtin_avoiders());
  const ExplanationSection words = section_of(told, "Words");
  EXPECT_THAT(words.lines[0], StartsWith("Said last, "));
  EXPECT_EQ(words.table.rows.size(), 7u);
  const auto json = exact_json(scenario, *found, told)["words"];
  EXPECT_EQ(json["said"]["bytes"], hexadecimal(said->speech));
  EXPECT_EQ(json["heard"].size(), 7u);
}

TEST(Explanation, OfAVehicleThatSaysNothingOfItsOwnHasNoWords) {
  const Scenario scenario = testing::scenario_of("head_on", {{"duration_s", "2"}});
  const Recording recording = testing::recorded(scenario);
  const auto found = find_decision(recording, scenario, builtin_catalogs(), {0, 10});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->words);
  EXPECT_TRUE(exact_json(scenario, *found, explain(scenario, *found, builtin_avoiders()))["words"].is_null());
}

TEST(Explanation, CallsTracksByWhatTheyAre) {
  Scenario scenario;
  scenario.vehicles = {{.id = 4, .name = "auv"}};
  EXPECT_EQ(track_name(scenario, TrackId{4}), "auv");
  EXPECT_EQ(track_name(scenario, TrackId{0x4000'0002U}), "track 2");
  EXPECT_EQ(track_name(scenario, TrackId{0x8000'0003U}), "drifting obstacle 3");
}

TEST(Explanation, SaysAllOfADeviation) {
  EXPECT_EQ(
      deviation_words({.size = 0.4, .speed = -0.1, .climb = 0.2, .turn = radians(-12.0)}, {0.3, 0.1, -0.2}),
      "turns 12 deg to port, slows down by 0.10 m/s to 0.37 m/s and goes 0.20 m/s more upwards");
  EXPECT_EQ(deviation_words({.size = 0.5, .speed = -0.5}, Vec3::Zero()), "stops");
  EXPECT_EQ(
      deviation_words({.size = 1.4, .speed = -0.6, .turn = radians(-96.0), .astern = true}, {-0.6, 0, 0}),
      "goes astern at 0.60 m/s");
  EXPECT_EQ(deviation_words({.size = 0.3, .climb = -0.05, .turn = radians(45.0)}, {-0.02, 0, 0.16}),
            "goes 0.05 m/s more downwards");
  EXPECT_EQ(deviation_words({.size = 2e-3, .speed = -2e-3}, {0.4, 0, 0}),
            "hardly leaves the velocity it prefers, by 0.002 m/s");
  EXPECT_EQ(deviation_words({.size = 1e-16}, {0.4, 0, 0}), "keeps to the velocity it prefers");
}

TEST(Explanation, SaysBearingsAsAHelmsmanWould) {
  EXPECT_EQ(bearing_words(radians(34.0)), "34 deg to starboard");
  EXPECT_EQ(bearing_words(radians(-120.0)), "120 deg to port");
  EXPECT_EQ(bearing_words(0.001), "dead ahead");
  EXPECT_EQ(bearing_words(-pi), "dead astern");
}

}  // namespace
}  // namespace fairway
