// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/found_decision.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "fairway/view/explain/testing/recorded_run.hpp"

namespace fairway {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::recorded;
using testing::scenario_of;
using ::testing::ThrowsMessage;

/// The frames at which a vehicle's avoider is in charge.
std::vector<std::size_t> avoiding_frames(const Recording& recording, std::size_t vehicle) {
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (is_avoiding(recording.frame(i).vehicles[vehicle].phase)) frames.push_back(i);
  }
  return frames;
}

/// `count` of them, spread over all.
std::vector<std::size_t> sample(const std::vector<std::size_t>& all, std::size_t count) {
  if (all.size() <= count) return all;
  std::vector<std::size_t> some;
  for (std::size_t k = 0; k < count; ++k) some.push_back(all[(k * (all.size() - 1)) / (count - 1)]);
  return some;
}

/// The middle of those in which a vehicle avoids someone.
std::size_t avoiding_frame(const Recording& recording, std::size_t vehicle) {
  std::vector<std::size_t> frames = avoiding_frames(recording, vehicle);
  std::erase_if(frames, [&](std::size_t i) {
    return recording.frame(i).vehicles[vehicle].command.mode != Mode::avoid;
  });
  if (frames.empty()) throw std::logic_error("it never avoids");
  return frames[frames.size() / 2];
}

struct Case {
  std::string scenario;
  std::string duration_s;
  std::string avoider;  // instead of the scenario's, if not empty
  std::size_t asked = 4;

  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.scenario << (c.avoider.empty() ? "" : "_" + c.avoider);
  }
};

class AnyInstant : public ::testing::TestWithParam<Case> {};

TEST_P(AnyInstant, ReproducesTheRecordedCommandToTheBit) {
  const Case& c = GetParam();
  Overrides overrides{{"duration_s", c.duration_s}};
  if (!c.avoider.empty()) overrides.emplace_back("vehicles[*].avoider", c.avoider);
  const Scenario scenario = scenario_of(c.scenario, overrides);
  const Recording recording = recorded(scenario);
  std::size_t asked = 0;
  for (std::size_t vehicle = 0; vehicle < std::min<std::size_t>(2, scenario.vehicles.size()); ++vehicle) {
    for (const std::size_t frame : sample(avoiding_frames(recording, vehicle), c.asked)) {
      const auto found = find_decision(recording, scenario, builtin_catalogs(), {vehicle, frame});
      ASSERT_TRUE(found && found->decision) << "vehicle " << vehicle << ", frame " << frame;
      EXPECT_FALSE(found->difference) << found->difference->quantity;
      const VehicleFrame now{.command = found->decision->command()};
      const VehicleFrame then{.command = recording.frame(frame).vehicles[vehicle].command};
      EXPECT_FALSE(first_difference(now, then));
      EXPECT_EQ(found->matched, frame + 1);
      const std::int64_t age = count(found->tick) - count(found->decision->tick);
      EXPECT_TRUE(age >= 0 && age < scenario.steps_per_decision) << age;
      ++asked;
    }
  }
  EXPECT_GE(asked, std::min<std::size_t>(3, c.asked));
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryMethod, AnyInstant,
    ::testing::Values(
        Case{"head_on", "4", "", 1000},  // all of them
        Case{"uuv_head_on", "6", "", 1000}, Case{"head_on", "40", "direct"}, Case{"cube20_8", "80", ""},
        Case{"cube20_4_apf", "80", ""}, Case{"cube20_4_apf_saw", "80", ""}, Case{"priority_wait", "50", ""},
        Case{"otter_in_waves", "30", ""}, Case{"acoustic_pair", "60", ""}, Case{"sonar_crossing", "60", ""},
        Case{"uuv_head_on", "20", "vo"}, Case{"uuv_head_on", "20", "hrvo"},
        Case{"surface_head_on", "12", "orca2d"}, Case{"surface_head_on", "12", ""},
        Case{"surface_cluttered", "4", "", 3}, Case{"surface_crossing_teb", "6", "", 3},
        Case{"transport_planned", "20", "", 3}, Case{"transport_unknown_obstacle", "40", "", 3},
        Case{"transport_wall_following", "80", ""}, Case{"transport_hard_switching", "80", ""},
        Case{"transport_pair", "30", ""}, Case{"survey_mission", "300", ""}, Case{"crossing", "60", ""},
        Case{"overtaking", "80", ""}, Case{"swap_8", "40", ""}, Case{"random_crossing", "40", ""},
        Case{"remus_crossing", "60", ""}, Case{"current_drift", "60", ""}, Case{"static_obstacles", "60", ""},
        Case{"uuv_multi_obstacle", "20", ""}, Case{"surface_u_wall", "10", ""},
        Case{"transport_four_obstacles", "40", ""}),
    [](const auto& chosen) {
      std::string name = chosen.param.scenario + "_" + chosen.param.avoider + "_" + chosen.param.duration_s;
      std::ranges::replace_if(
          name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
      return name;
    });

TEST(FoundDecision, KeepsWhatItWasMadeOfAndWhatWasDrawn) {
  const Scenario scenario = scenario_of("head_on", {{"duration_s", "60"}});
  const Recording recording = recorded(scenario);
  const std::size_t frame = avoiding_frame(recording, 1);
  const auto found = find_decision(recording, scenario, builtin_catalogs(), {1, frame});
  ASSERT_TRUE(found && found->decision);
  const Situation& s = found->decision->situation();
  const VehicleFrame& own = recording.frame(frame).vehicles[1];
  EXPECT_EQ(s.own.position, own.state.p_n);
  EXPECT_EQ(s.time, recording.frame(frame).time);
  ASSERT_EQ(s.tracks.size(), 1u);
  EXPECT_EQ(s.tracks[0].position, recording.frame(frame).vehicles[0].state.p_n);
  EXPECT_FALSE(found->decision->strokes.empty());
  EXPECT_EQ(found->leg->kind, LegKind::transit);
}

TEST(FoundDecision, IsFoundBetweenTheFramesOfAThinnedRecording) {
  const Scenario scenario = scenario_of("surface_head_on", {{"duration_s", "10"}});
  ASSERT_EQ(scenario.steps_per_decision, 4);
  const Recording recording = recorded(scenario, 7);
  std::set<std::int64_t> ages;
  for (const std::size_t frame : {3, 4, 5, 6}) {
    const auto found = find_decision(recording, scenario, builtin_catalogs(), {0, frame});
    ASSERT_TRUE(found && found->decision);
    EXPECT_FALSE(found->difference);
    EXPECT_EQ(count(found->tick), 7 * static_cast<std::int64_t>(frame));
    EXPECT_EQ(count(found->decision->tick) % 4, 0);
    ages.insert(count(found->tick) - count(found->decision->tick));
  }
  EXPECT_EQ(ages, (std::set<std::int64_t>{0, 1, 2, 3}));
}

TEST(FoundDecision, IsNoneWhereNoAvoiderIsAsked) {
  const Scenario scenario = scenario_of("survey_mission", {{"duration_s", "200"}});
  const Recording recording = recorded(scenario);
  const auto found = find_decision(recording, scenario, builtin_catalogs(), {0, 40});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->decision);
  EXPECT_FALSE(found->difference);
  EXPECT_EQ(found->phase, Phase::deploying);
  EXPECT_EQ(found->leg->kind, LegKind::go_to);
}

TEST(FoundDecision, PassesOnWhatSurroundsItWithThoughts) {
  struct Counter final : FrameSink {
    std::vector<double> times;
    std::vector<double> drawn;
    void write(const Frame& frame) override {
      times.push_back(frame.time);
      if (!frame.vehicles[0].strokes.empty()) drawn.push_back(frame.time);
    }
  } counter;
  const Scenario scenario = scenario_of("head_on", {{"duration_s", "60"}});
  const Recording recording = recorded(scenario);
  const std::size_t middle = avoiding_frame(recording, 0);
  const double time = recording.frame(middle).time;
  const auto found =
      find_decision(recording, scenario, builtin_catalogs(), {0, middle}, {1.0, 0.5, &counter});
  ASSERT_TRUE(found && found->decision);
  ASSERT_EQ(counter.times.size(), middle + 1 + static_cast<std::size_t>(std::lround(0.5 / scenario.step_s)));
  ASSERT_FALSE(counter.drawn.empty());
  EXPECT_NEAR(counter.drawn.front(), time - 1.0, scenario.step_s);
  EXPECT_EQ(counter.drawn.back(), counter.times.back());
}

TEST(FoundDecision, OfAnotherRunIsRefusedWithTheTickAtWhichItParts) {
  const Scenario scenario = scenario_of("head_on", {{"duration_s", "5"}});
  const Recording recording = recorded(scenario, 1, [](const Frame& frame, auto& vehicles) {
    if (count(frame.tick) == 30) vehicles[1].state.p_n.x() += 1e-9;
  });
  const auto before = find_decision(recording, scenario, builtin_catalogs(), {0, 29});
  ASSERT_TRUE(before && before->decision);
  EXPECT_FALSE(before->difference);
  EXPECT_THAT(
      [&] {
        (void)find_decision(recording, scenario, builtin_catalogs(), {0, 50});
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("another run"), HasSubstr("tick 30"), HasSubstr("x_m"))));
}

TEST(FoundDecision, ThatIsNotTheRecordedOneSaysWhatDiffers) {
  const Scenario scenario = scenario_of("head_on", {{"duration_s", "5"}});
  const Recording recording = recorded(scenario, 1, [](const Frame& frame, auto& vehicles) {
    if (count(frame.tick) == 30) vehicles[1].command.velocity.y() += 1e-16;
  });
  const auto found = find_decision(recording, scenario, builtin_catalogs(), {1, 30});
  ASSERT_TRUE(found && found->decision && found->difference);
  EXPECT_EQ(found->difference->quantity, "command_e_mps");
  EXPECT_THROW((void)find_decision(recording, scenario, builtin_catalogs(), {0, 30}), InputError);
  EXPECT_THROW((void)find_decision(recording, scenario, builtin_catalogs(), {1, 31}), InputError);
}

TEST(FoundDecision, CanBeStopped) {
  const Scenario scenario = scenario_of("head_on", {{"duration_s", "5"}});
  const Recording recording = recorded(scenario);
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(find_decision(recording, scenario, builtin_catalogs(), {0, 50}, {}, &stop));
}

}  // namespace
}  // namespace fairway
