// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/avoidance/velocity_obstacle/neighbourhood.hpp"
#include "fairway/avoidance/velocity_obstacle/testing/exhaustive_choice.hpp"

namespace fairway::velocity_obstacle {
namespace {

using encounters::OwnedSituation;

/// Crowds with room and without, and among rocks and quays; every mixture of limits.
OwnedSituation any_swarm(std::uint64_t i) {
  const Rng rng = Rng{12}.stream("swarm", i);
  const int count = static_cast<int>(i / 48 % 14);
  OwnedSituation e = i % 3 == 0   ? encounters::congested(count, rng)
                     : i % 3 == 1 ? encounters::crowd(count, rng)
                                  : encounters::harbour(count, rng);
  Limits& limits = e.situation.limits;
  if (i / 3 % 2 == 1) limits.max_acceleration = 0.5;
  if (i / 6 % 2 == 1) limits.max_turn_rate = 0.6;
  if (i / 12 % 2 == 1) limits.min_speed = 0.5;
  if (i / 24 % 2 == 1) limits.sternway = false;
  return e;
}

TEST(ChosenVelocity, HasTheBitsOfTheOneThatTriesEverything) {
  int as_wished = 0, clear = 0, infeasible = 0;
  for (std::uint64_t i = 0; i < 6000; ++i) {
    const OwnedSituation e = any_swarm(i);
    const Situation s = e;
    const Vec2 preferred = s.preferred_velocity().head<2>();
    const ReachableSet reachable(s.own, s.limits, 1.0);
    const Wish wish{preferred, preferred.normalized(), i % 5 == 0 ? 0.0 : 1e-3, 10.0};
    for (const Responsibility r : {Responsibility::all, Responsibility::shared, Responsibility::by_side}) {
      const Neighbourhood neighbourhood(s, {}, r);
      const ChosenVelocity expected = exhaustive_choice(neighbourhood.obstacles(), reachable, wish);
      const ChosenVelocity choice = choose(neighbourhood.obstacles(), reachable, wish);
      EXPECT_EQ(choice.velocity, expected.velocity) << i;
      EXPECT_EQ(choice.is_feasible, expected.is_feasible) << i;
      (!expected.is_feasible ? infeasible : expected.velocity == wish.velocity ? as_wished : clear) += 1;
    }
  }
  EXPECT_GT(as_wished, 2000);
  EXPECT_GT(clear, 4000);
  EXPECT_GT(infeasible, 4000);
}

}  // namespace
}  // namespace fairway::velocity_obstacle
