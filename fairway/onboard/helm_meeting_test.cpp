// SPDX-License-Identifier: Apache-2.0
// Two vehicles that meet head-on while what they are told is late, lost or wrong.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>

#include "fairway/core/rng.hpp"
#include "fairway/onboard/testing/fixes.hpp"

namespace fairway {
namespace {

using fixes::h;

/// What each tells the other at an instant, if anything: `from` is 0 or 1.
using Words = std::function<std::optional<Fix>(std::size_t from, const Fix& truth)>;

struct Meeting {
  OnboardPolicy policy;
  Words words = [](std::size_t, const Fix& truth) { return std::optional{truth}; };
  double dead_at = std::numeric_limits<double>::infinity();  ///< vehicle 1 stops and does nothing more [s]
};

struct Outcome {
  double separation = std::numeric_limits<double>::infinity();  ///< least, between centres [m]
  bool arrived{};                                               ///< vehicle 0
  double growth{};                                              ///< greatest, of 1 as 0 sees it [m]
};

/// Vehicles of 1.5 m, 60 m apart, each on its way to where the other is, half a metre aside; both at 0.5 m/s.
/// They follow what is asked at once.
Outcome outcome_of(const Meeting& meeting) {
  fixes::Parts setup = fixes::setup();
  setup.policy = meeting.policy;
  setup.ship.steering.edit().kind = SteeringKind::proportional;
  fixes::Parts other = setup;
  other.ship.id = VehicleId{1};
  other.team = {{.id = VehicleId{0}, .name = "zero", .radius = 1.5}};
  std::array<Helm, 2> helms{fixes::helm_of(setup), fixes::helm_of(other)};
  std::array<VehicleState, 2> states{VehicleState{.p_n = {0, 0, 10}}, VehicleState{.p_n = {60, 0.5, 10}}};
  states[1].q_nb = quaternion_of({.yaw = pi});
  helms[0].go_to({60, 0, 10}, 0.5);
  helms[1].go_to({0, 0.5, 10}, 0.5);

  Outcome outcome;
  for (int i = 0; i < 3000; ++i) {
    const double now = h * i;
    for (std::size_t k = 0; k < 2; ++k) {
      const Fix truth{.time = now, .state = states[k]};
      helms[k].own_fix(truth, now);
      const bool is_dead = k == 1 && now >= meeting.dead_at;
      const std::optional<Fix> told = is_dead ? std::nullopt : meeting.words(k, truth);
      if (told) helms[1 - k].neighbour_fix(VehicleId{static_cast<std::uint32_t>(k)}, *told, now);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const BodyRequest request = helms[k].update(now).request;
      VehicleState& x = states[k];
      const bool is_dead = k == 1 && now >= meeting.dead_at;
      x.v_b = is_dead ? Vec3::Zero() : Vec3{request.surge_mps, request.sway_mps, request.heave_mps};
      x.p_n += h * x.v_n();
      const double turn = is_dead ? 0.0 : request.yaw_rate_radps;
      x.q_nb = quaternion_of({.yaw = yaw_of(x.q_nb) + h * turn});
    }
    outcome.separation = std::fmin(outcome.separation, (states[0].p_n - states[1].p_n).norm());
    outcome.growth = std::fmax(outcome.growth, helms[0].report(now).neighbours[0].growth);
    outcome.arrived = helms[0].order().state == HelmState::arrived;
    if (outcome.arrived && helms[1].order().state == HelmState::arrived) break;
  }
  return outcome;
}

constexpr double clear = 2.9;  // [m], the spheres of 1.5 m but for what the vehicles lag behind their orders

TEST(MeetingHeadOn, WithAllMessagesTheSpheresDoNotTouch) {
  const Outcome outcome = outcome_of({});
  EXPECT_TRUE(outcome.arrived);
  EXPECT_GT(outcome.separation, clear);
  EXPECT_EQ(outcome.growth, 0.0);
}

TEST(MeetingHeadOn, ATenthOfTheMessagesLostTheSpheresDoNotTouch) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng{seed};
    const Outcome outcome = outcome_of({.words = [&](std::size_t, const Fix& truth) {
      return rng.uniform(0, 1) < 0.1 ? std::nullopt : std::optional{truth};
    }});
    EXPECT_TRUE(outcome.arrived);
    EXPECT_GT(outcome.separation, clear) << seed;
  }
}

/// Vehicle 1, or both, say nothing for twenty seconds. They would meet after 60 s.
Words silent_since(double since, bool both = false) {
  return [since, both](std::size_t from, const Fix& truth) {
    const bool is_silent = (both || from == 1) && truth.time > since && truth.time <= since + 20.0;
    return is_silent ? std::nullopt : std::optional{truth};
  };
}

TEST(MeetingHeadOn, OneThatIsSilentForTwentySecondsIsKeptClearOf) {
  for (const double since : {35.0, 45.0, 50.0, 55.0}) {
    const Outcome outcome = outcome_of({.words = silent_since(since)});
    EXPECT_TRUE(outcome.arrived);
    EXPECT_GT(outcome.separation, clear) << since;
    EXPECT_NEAR(outcome.growth, 0.25 * 19.0, 0.06) << since;
  }
}

TEST(MeetingHeadOn, TwoThatAreSilentKeepClearUnlessTheyForgetEachOther) {
  EXPECT_GT(outcome_of({.words = silent_since(45.0, true)}).separation, clear);

  OnboardPolicy forgetful;
  forgetful.neighbour_lost_s = 2.0;
  forgetful.neighbour_lost = LostPolicy::forget;
  EXPECT_LT(outcome_of({.policy = forgetful, .words = silent_since(45.0, true)}).separation, 1.0);
}

TEST(MeetingHeadOn, FixesThatJumpAreRefusedAndTheSpheresDoNotTouch) {
  // four of five say that it is far aside: as many as are not believed yet
  const auto jumping = [](std::size_t from, const Fix& truth) {
    Fix told = truth;
    if (from == 1 && std::lround(10.0 * truth.time) % 5 != 0) told.state.p_n.y() += 50.0;
    return std::optional{told};
  };
  const Outcome outcome = outcome_of({.words = jumping});
  EXPECT_TRUE(outcome.arrived);
  EXPECT_GT(outcome.separation, clear);

  OnboardPolicy credulous;
  credulous.jump_m = 1000.0;
  EXPECT_LT(outcome_of({.policy = credulous, .words = jumping}).separation, 2.7);
}

TEST(MeetingHeadOn, OneThatDiesInTheWayIsPassedWellClearWhenInflated) {
  OnboardPolicy policy;
  policy.neighbour_lost_s = 10.0;
  for (const double dead_at : {20.0, 30.0, 40.0, 50.0, 54.0}) {
    const Outcome outcome = outcome_of({.policy = policy, .dead_at = dead_at});
    EXPECT_GT(outcome.separation, 5.0) << dead_at;
    EXPECT_TRUE(outcome.arrived) << dead_at;
  }
}

TEST(MeetingHeadOn, OneThatDiesInTheWayIsWaitedForWhenTheOthersHold) {
  OnboardPolicy policy;
  policy.neighbour_lost_s = 10.0;
  policy.neighbour_lost = LostPolicy::hold;
  for (const double dead_at : {20.0, 30.0, 40.0, 50.0, 54.0}) {
    const Outcome outcome = outcome_of({.policy = policy, .dead_at = dead_at});
    EXPECT_GT(outcome.separation, 5.0) << dead_at;
    EXPECT_FALSE(outcome.arrived) << dead_at;
  }
}

TEST(MeetingHeadOn, OneThatDiesInTheWayIsRunOverWhenForgotten) {
  OnboardPolicy policy;
  policy.neighbour_lost_s = 10.0;
  policy.neighbour_lost = LostPolicy::forget;
  for (const double dead_at : {20.0, 30.0, 40.0}) {
    EXPECT_LT(outcome_of({.policy = policy, .dead_at = dead_at}).separation, 1.0) << dead_at;
  }
}

}  // namespace
}  // namespace fairway
