// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/obedience.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "fairway/core/envelope.hpp"

namespace fairway::pledge {
namespace {

constexpr double cruise = 0.5, asked_turn = 0.3,
                 wave = 2.0 * std::numbers::pi / 4.0;  // [m/s], [rad/s], [rad/s]
const Envelope able{.ahead = 1.0,
                    .up = 0.3,
                    .down = 0.3,
                    .acceleration = 0.1,
                    .deceleration = 0.1,
                    .surge_lag = 2.0,
                    .turn_acceleration = 0.5,
                    .turn_lag = 1.0,
                    .turn_rates = {0.5, 0.5, 0.5, 0.5}};

/// What a hull does at a time [s]: the speeds ahead through the water and down [m/s], and the turn rate
/// [rad/s].
struct Motion {
  double surge{}, turn{}, heave{};
};

/// When a hull is found not to obey that moves so in the first minute, asked to go at a speed, to turn and to
/// dive [s]; after the minute if it is not.
double lacking_after(const std::function<Motion(double)>& motion, double speed, double turn,
                     const Envelope* envelope = &able, double dive = 0.0) {
  Obedience obedience;
  Situation s;
  s.period = 0.05;
  s.current = {0.2, 0.1, 0.0};
  s.goal.cruise_speed = cruise;
  s.envelope = envelope;
  for (s.time = 0.0; s.time < 60.0; s.time += s.period) {
    const Motion does = motion(s.time);
    s.own.velocity = s.current + Vec3{does.surge, 0.0, does.heave};
    s.own.yaw_rate = does.turn;
    obedience.look(s);
    if (obedience.is_lacking()) break;
    obedience.ask(s, {.velocity = s.current + Vec3{speed, 0.0, dive}, .turn_rate = turn});
  }
  return s.time;
}

TEST(Obedience, WhoDoesWhatItCanObeys) {
  const auto sets_out = [](double t) {
    return Motion{std::fmin(0.1 * t, cruise), asked_turn * (1.0 - std::exp(-t))};
  };
  EXPECT_GE(lacking_after(sets_out, cruise, asked_turn), 60.0);
  const auto at_its_most = [](double) { return Motion{1.0, 0.5}; };
  EXPECT_GE(lacking_after(at_its_most, 3.0, 2.0), 60.0) << "nobody does more than it can";
}

TEST(Obedience, ADeadThrusterIsFoundOutWhileTheHullRunsOn) {
  const auto runs_on = [](double t) { return Motion{cruise * std::exp(-t / 4.0), 0.0}; };
  EXPECT_LT(lacking_after(runs_on, cruise, 0.0), 4.0);
  EXPECT_GE(lacking_after(runs_on, 0.0, 0.0), 60.0) << "who is asked to stop does";
}

TEST(Obedience, WhoNoLongerDivesIsFoundOutThoughItGoesAheadAsItShould) {
  const auto levels_out = [](double t) { return Motion{cruise, 0.0, 0.3 * std::exp(-t / 2.0)}; };
  EXPECT_LT(lacking_after(levels_out, cruise, 0.0, &able, 0.3), 4.0);
  const auto dives = [](double t) { return Motion{cruise, 0.0, 0.3 * (1.0 - std::exp(-t / 2.0))}; };
  EXPECT_GE(lacking_after(dives, cruise, 0.0, &able, 0.3), 60.0);
  Envelope floats = able;
  floats.up = floats.down = 0.0;
  const auto rides_a_swell = [](double t) { return Motion{cruise, 0.0, 0.4 * std::sin(0.5 * t)}; };
  EXPECT_GE(lacking_after(rides_a_swell, cruise, 0.0, &floats), 60.0) << "it cannot be told to heave";
}

TEST(Obedience, AStuckHelmIsFoundOutOnceItShouldTurn) {
  const auto straight_on = [](double) { return Motion{cruise, 0.0}; };
  EXPECT_LT(lacking_after(straight_on, cruise, asked_turn), 4.0);
  EXPECT_GE(lacking_after(straight_on, cruise, 0.0), 60.0) << "nobody can know yet";
  const auto circle = [](double) { return Motion{cruise, 0.2}; };
  EXPECT_LT(lacking_after(circle, cruise, -0.1), 4.0);
}

TEST(Obedience, WavesAreLeftOut) {
  const auto to_and_fro = [](double t) {
    return Motion{cruise + 0.25 * std::sin(wave * t), 0.2 * std::cos(wave * t), 0.25 * std::sin(wave * t)};
  };
  EXPECT_GE(lacking_after(to_and_fro, cruise, 0.0), 60.0);
}

TEST(Obedience, WithoutAnEnvelopeNobodyKnowsWhatItShouldDo) {
  const auto rests = [](double) { return Motion{}; };
  EXPECT_GE(lacking_after(rests, cruise, asked_turn, nullptr), 60.0);
  EXPECT_LT(lacking_after(rests, cruise, asked_turn), 10.0);
}

}  // namespace
}  // namespace fairway::pledge
