// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/ability.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/safety_filter/safety_filter.hpp"
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::Always;
using encounters::OwnedSituation;

/// It neither stops, nor goes astern or sideways.
constexpr Limits torpedo{.max_speed = 1.5, .min_speed = 1.0, .sternway = false, .sway = false};
/// Likewise, but it stops, and so turns on the spot.
constexpr Limits tricycle{.sternway = false, .sway = false};

TEST(Shortfall, OfAVehicleThatCanDoAnythingIsNone) {
  for (const Vec3& v : {Vec3{0, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    EXPECT_EQ(shortfall({}, {.velocity = v, .astern = true, .heading = 0.0}, 0.0), Shortfall::none);
    EXPECT_EQ(shortfall({}, {.velocity = v, .turn_rate = 0.1}, 2.0), Shortfall::none);
  }
  EXPECT_EQ(shortfall({}, {.mode = Mode::hold}, 0.0), Shortfall::none);
}

TEST(Shortfall, WhoCannotStopIsCommandedTooSlowlyBelowItsLeastSpeed) {
  EXPECT_EQ(shortfall(torpedo, {.velocity = {1.0, 0, 0}}, 0.0), Shortfall::none);
  EXPECT_EQ(shortfall(torpedo, {.velocity = {0.99, 0, 0}}, 0.0), Shortfall::too_slow);
  EXPECT_EQ(shortfall(torpedo, {}, 0.0), Shortfall::too_slow);
  EXPECT_EQ(shortfall(torpedo, {.velocity = {0, 0, 1.4}}, 0.0), Shortfall::too_slow) << "straight down";
  EXPECT_EQ(shortfall(torpedo, {.velocity = {1.2, 0, 0}, .mode = Mode::hold}, 0.0), Shortfall::too_slow);
  EXPECT_EQ(shortfall(tricycle, {}, 0.0), Shortfall::none);
}

TEST(Shortfall, AbaftTheBeamIsAsternForWhoGoesOnWhileItTurns) {
  const auto at = [](double off_the_bow, double yaw) {
    return Vec3{1.5 * std::cos(yaw + off_the_bow), 1.5 * std::sin(yaw + off_the_bow), 0.0};
  };
  for (const double yaw : {0.0, 2.0, -3.0}) {
    for (const double side : {-1.0, 1.0}) {
      EXPECT_EQ(shortfall(torpedo, {.velocity = at(side * radians(89.0), yaw)}, yaw), Shortfall::none);
      EXPECT_EQ(shortfall(torpedo, {.velocity = at(side * radians(91.0), yaw)}, yaw), Shortfall::astern);
      EXPECT_EQ(shortfall(tricycle, {.velocity = at(side * radians(179.0), yaw)}, yaw), Shortfall::none)
          << "it turns on the spot, and goes";
    }
  }
}

TEST(Shortfall, WithAHeadingToKeepThereIsNoTurnThatHelps) {
  const Vec3 north{1.2, 0, 0};
  EXPECT_EQ(shortfall(tricycle, {.velocity = north, .heading = 3.0}, 0.0), Shortfall::astern);
  EXPECT_EQ(shortfall(tricycle, {.velocity = north, .heading = 1.0}, 0.0), Shortfall::sideways);
  EXPECT_EQ(shortfall(tricycle, {.velocity = north, .heading = 0.1}, 3.0), Shortfall::none);
  EXPECT_EQ(shortfall(tricycle, {.velocity = north, .turn_rate = 0.1}, 3.0), Shortfall::astern);
  EXPECT_EQ(shortfall(tricycle, {.velocity = north, .turn_rate = 0.1}, -1.0), Shortfall::sideways);
  EXPECT_EQ(shortfall(tricycle, {.velocity = north, .turn_rate = 0.1}, -0.1), Shortfall::none);
  EXPECT_EQ(shortfall(tricycle, {.velocity = north, .astern = true}, 3.0), Shortfall::astern)
      << "it would be steered stern first";
}

TEST(Shortfall, HasWordsForEveryKindButNone) {
  EXPECT_TRUE(words_of(Shortfall::none).empty());
  for (const Shortfall kind : {Shortfall::too_slow, Shortfall::astern, Shortfall::sideways})
    EXPECT_FALSE(words_of(kind).empty()) << enum_name(kind);
}

OwnedSituation torpedo_ahead() {
  OwnedSituation e = encounters::open_water();
  e.situation.own.velocity = {1.2, 0, 0};
  e.situation.limits = torpedo;
  return e;
}

Command answer(const Command& command, const OwnedSituation& e) {
  return Avoider{Always{{}, command}}.decide(e);
}

TEST(AnAvoider, SaysWhatIsBeyondTheVehicle) {
  const Command told =
      answer({.velocity = {-1.5, 0, 0}, .mode = Mode::avoid, .astern = true}, torpedo_ahead());
  EXPECT_EQ(told.note, words_of(Shortfall::astern));
  EXPECT_EQ(told.mode, Mode::infeasible);
  EXPECT_FALSE(told.astern) << "nobody steers it stern first";
  EXPECT_EQ(told.velocity, Vec3(-1.5, 0, 0)) << "said, not changed";

  EXPECT_EQ(answer({.velocity = {-1.5, 0, 0}}, torpedo_ahead()).mode, Mode::cruise) << "nobody was avoided";
  EXPECT_EQ(answer({.velocity = {1.5, 0, 0}, .mode = Mode::avoid}, torpedo_ahead()).note, "");
}

TEST(AnAvoider, LeavesTheWordsOfTheMethod) {
  const Command command{.mode = Mode::infeasible, .note = "no way was found"};
  EXPECT_EQ(answer(command, torpedo_ahead()).note, "no way was found");
}

TEST(AnAvoider, SaysThatAVehicleWhichCannotStopCirclesInsteadOfWaiting) {
  OwnedSituation e = torpedo_ahead();
  e.situation.own.priority = 5;
  e.tracks = {encounters::track(1, {4, 0, 50}, {0, 0, 0})};
  const Command waiting = Avoider{StopAndWait{}, Avoider{Always{{}, {.velocity = {1.2, 0, 0}}}}}.decide(e);
  EXPECT_EQ(waiting.mode, Mode::hold);
  EXPECT_EQ(waiting.note, words_of(Shortfall::too_slow));
}

TEST(AnAvoider, ForgetsWhatWasSaidOfACommandThatAWrapperChanged) {
  OwnedSituation e = torpedo_ahead();
  e.tracks = {encounters::track(1, {-12, 0.5, 50}, {0, 0, 0})};
  const Command inner{.velocity = {-1.5, 0, 0}, .mode = Mode::avoid};
  ASSERT_EQ(answer(inner, e).note, words_of(Shortfall::astern));
  const SafetyFilter filter{{.k1_hz = 0.02, .k2_hz = 0.02}};
  const Command filtered = Avoider{filter, Avoider{Always{{}, inner}}}.decide(e);
  ASSERT_EQ(shortfall(torpedo, filtered, 0.0), Shortfall::none) << filtered.velocity.transpose();
  EXPECT_NE(filtered.note, words_of(Shortfall::astern));
}

}  // namespace
}  // namespace fairway
