// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoider.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(AvoiderMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  EXPECT_EQ(refusal_by([] { Avoider{Orca3d{{.time_horizon_s = -3}}}; }),
            "time_horizon_s: is -3; expected a number in [0.01, 10000]");
  EXPECT_EQ(refusal_by([] { Avoider{Orca3d{{.time_horizon_s = nan}}}; }),
            "time_horizon_s: is nan; expected a number in [0.01, 10000]");
  EXPECT_EQ(refusal_by([] { Avoider{Orca3d{{.time_horizon_s = 10}}}; }), "accepted");
}

TEST(AvoiderMadeInCpp, RefusesThoseOfAWrapperAndOfWhatItWraps) {
  EXPECT_THAT(refusal_by([] {
                Avoider{StopAndWait{{.crit_dist_m = -1}}, Avoider{Direct{}}};
              }),
              testing::StartsWith("crit_dist_m: is -1; expected a number in ["));
  EXPECT_THAT(refusal_by([] {
                Avoider{StopAndWait{}, Avoider{Orca3d{{.time_horizon_s = 0}}}};
              }),
              testing::StartsWith("time_horizon_s: is 0; expected"));
  EXPECT_EQ(refusal_by([] { Avoider{StopAndWait{}, Avoider{Direct{}}}; }), "accepted");
}

TEST(AvoiderMadeInCpp, EveryMethodOfTheCatalogAcceptsItsOwnDefaults) {
  const Catalog catalog = builtin_avoiders();
  for (const Catalog::Entry& entry : catalog.entries())
    EXPECT_EQ(refusal_by([&] { (void)catalog.make(entry.info.name); }), "accepted") << entry.info.name;
}

TEST(ACatalog, RefusesANameThatIsTaken) {
  Catalog catalog = builtin_avoiders();
  EXPECT_EQ(refusal_by([&] { catalog.add<Orca3d>(); }),
            "the algorithm \"orca3d\" is there already: choose another name");
  EXPECT_EQ(refusal_by([&] {
              AlgorithmInfo info = Direct::info;
              info.name = "saw";
              catalog.add({.info = info, .params = {}, .make = {}, .make_around = {}});
            }),
            "the algorithm \"saw\" is there already: choose another name");
  EXPECT_TRUE(catalog.has("orca3d"));
  EXPECT_TRUE(catalog.has("saw"));
  EXPECT_FALSE(catalog.has("orca3d+saw"));
}

/// The envelope of a boat with one number of it replaced.
template <auto member>
const Envelope* spoilt(std::remove_cvref_t<decltype(Envelope{}.*member)> value) {
  static Envelope envelope = encounters::of_a_boat();
  envelope.*member = value;
  return &envelope;
}

TEST(AnUnusableSituation, IsAnsweredWithANoteThatSaysWhatIsUnusable) {
  using Spoiler = std::function<void(encounters::OwnedSituation&)>;
  const std::vector<std::pair<Spoiler, std::string_view>> spoilers{
      {[](auto& e) { e.situation.period = 0.0; }, "the period is not a positive number"},
      {[](auto& e) { e.situation.period = -1.0; }, "the period is not a positive number"},
      {[](auto& e) { e.situation.period = nan; }, "the period is not a positive number"},
      {[](auto& e) { e.situation.period = infinity; }, "the period is not a positive number"},
      {[](auto& e) { e.situation.own.position.z() = nan; }, "the own position is not finite"},
      {[](auto& e) { e.situation.own.velocity.x() = infinity; }, "the own velocity is not finite"},
      {[](auto& e) { e.situation.own.yaw = nan; }, "the own yaw or its rate is not finite"},
      {[](auto& e) { e.situation.own.yaw_rate = nan; }, "the own yaw or its rate is not finite"},
      {[](auto& e) { e.situation.own.radius = -0.1; }, "the own radius is not a length"},
      {[](auto& e) { e.situation.own.radius = infinity; }, "the own radius is not a length"},
      {[](auto& e) { e.situation.own.position_sigma = nan; },
       "the deviation of the own position is not a length"},
      {[](auto& e) { e.situation.own.position_sigma = -5.0; },
       "the deviation of the own position is not a length"},
      {[](auto& e) { e.situation.time = nan; }, "the time is not finite"},
      {[](auto& e) { e.situation.goal.arrival = nan; }, "the goal's arrival is not a length"},
      {[](auto& e) { e.situation.limits.max_turn_rate = nan; }, "the limit of turning is not a turn rate"},
      {[](auto& e) { e.situation.limits.max_acceleration = nan; }, "the limit of acceleration is not one"},
      {[](auto& e) { e.situation.goal.position.y() = nan; }, "the goal's position is not finite"},
      {[](auto& e) {
         e.situation.goal.velocity = Vec3{0, nan, 0};
       },
       "the goal's velocity is not finite"},
      {[](auto& e) { e.situation.goal.cruise_speed = -1.0; }, "the cruise speed is not a speed"},
      {[](auto& e) { e.situation.limits.max_speed = -1.0; }, "the speed limit is not a speed"},
      {[](auto& e) { e.situation.limits.max_speed = nan; }, "the speed limit is not a speed"},
      {[](auto& e) { e.situation.limits.max_climb_rate = nan; }, "the limit of climbing is not a speed"},
      {[](auto& e) {
         e.situation.limits.min_depth = 2.0;
         e.situation.limits.max_depth = 1.0;
       },
       "the ceiling is not above the floor"},
      {[](auto& e) { e.situation.limits.max_depth = nan; }, "the ceiling is not above the floor"},
      {[](auto& e) { e.situation.limits.min_speed = -0.5; }, "the least speed is not a speed"},
      {[](auto& e) { e.tracks[1].position.x() = nan; },
       "a track has a number that is not finite, or no radius"},
      {[](auto& e) { e.tracks[0].velocity.x() = nan; },
       "a track has a number that is not finite, or no radius"},
      {[](auto& e) { e.tracks[2].radius = -1.0; }, "a track has a number that is not finite, or no radius"},
      {[](auto& e) { e.tracks[2].position_covariance(0, 1) = nan; },
       "a track has a number that is not finite, or no radius"},
      {[](auto& e) {
         e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {nan, 0, 0}}};
       },
       "an obstacle has a number that is not finite, or no extent"},
      {[](auto& e) {
         e.obstacles = {{.kind = Obstacle::Kind::segment, .to = {0, nan, 0}}};
       },
       "an obstacle has a number that is not finite, or no extent"},
      {[](auto& e) { e.obstacles = {{.kind = Obstacle::Kind::polygon}}; },
       "an obstacle has a number that is not finite, or no extent"},
      {[](auto& e) { e.situation.envelope = spoilt<&Envelope::deceleration>(0.0); },
       "an envelope's acceleration and deceleration have to be above zero"},
      {[](auto& e) { e.situation.envelope = spoilt<&Envelope::turn_rates>({}); },
       "an envelope has to have a turn acceleration and turn rates above zero"},
      {[](auto& e) { e.situation.envelope = spoilt<&Envelope::surge_lag>(nan); },
       "a number of the envelope is not finite, or below zero where it cannot be"},
  };
  Avoider avoider{Orca3d{}};
  const Command usable = avoider.decide(encounters::crowd(5, Rng{1}));
  EXPECT_EQ(usable.note, "");
  for (std::size_t i = 0; i < spoilers.size(); ++i) {
    encounters::OwnedSituation e = encounters::crowd(5, Rng{1});
    spoilers[i].first(e);
    EXPECT_EQ(avoider.decide(e), (Command{.mode = Mode::infeasible, .note = spoilers[i].second}))
        << "spoiler " << i;
    EXPECT_FALSE(is_usable(e)) << "spoiler " << i;
  }
}

TEST(AnAnswer, ThatIsNotFiniteIsReplacedWithANote) {
  Avoider avoider{encounters::Always{{}, {.velocity = {nan, 0, 0}}}};
  EXPECT_EQ(avoider.decide(encounters::crowd(5, Rng{1})),
            (Command{.mode = Mode::infeasible, .note = "the method's answer is not finite"}));
}

TEST(AnAnswer, IsNoFasterThanAnythingGoesWhereNoLimitIsSet) {
  encounters::OwnedSituation e = encounters::crowd(5, Rng{1});
  e.situation.limits.max_speed = Limits::none;
  Avoider avoider{encounters::Always{{}, {.velocity = {0.0, 2e6, 0.0}}}};
  EXPECT_NEAR(avoider.decide(e).velocity.y(), 1000.0, 1e-9);
  e.situation.limits.max_speed = 5000.0;
  EXPECT_NEAR(avoider.decide(e).velocity.y(), 5000.0, 1e-9) << "who sets a limit means it";
}

}  // namespace
}  // namespace fairway
