// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/bvc/bvc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;

TEST(Bvc, IsNoFasterThanTakesItToTheEdgeOfItsCell) {
  // 8 m apart, spheres of 1 m: a gap of 6 m, half of which is own ship's, in 6 s
  const Command command = decide<Bvc>(encounters::head_on(8.0), {.time_horizon_s = 6.0});
  EXPECT_LT((command.velocity - Vec3(0.5, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(command.mode, Mode::avoid);
}

TEST(Bvc, HasAllOfTheGapToWhoDoesNotReact) {
  OwnedSituation e = encounters::head_on(8.0);
  e.tracks[0].reacts = false;
  const Command command = decide<Bvc>(e, {.time_horizon_s = 12.0});
  EXPECT_LT((command.velocity - Vec3(0.5, 0.0, 0.0)).norm(), 1e-12);
}

TEST(Bvc, TurnsToStarboardWhereItCannotGoOn) {
  const Command command = decide<Bvc>(encounters::head_on(2.0));
  EXPECT_LT((command.velocity - Vec3(0.0, 1.0, 0.0)).norm(), 1e-12);
  EXPECT_LT(decide<Bvc>(encounters::head_on(2.0), {.deadlock_ratio = 0.0}).velocity.norm(), 1e-12);
}

TEST(Bvc, OutsideItsCellItGoesBackAsFastAsItTakes) {
  // spheres that overlap by 0.2 m: back by half of that within 2 s
  const Command command = decide<Bvc>(encounters::head_on(1.8));
  EXPECT_LE(command.velocity.x(), -0.05 + 1e-12);
  EXPECT_EQ(command.mode, Mode::avoid);
}

TEST(Bvc, SaysThatItIsFartherOutThanItCanBeBackInTime) {
  OwnedSituation e = encounters::head_on(1.0);
  e.situation.limits.max_speed = 0.1;
  EXPECT_EQ(decide<Bvc>(e).mode, Mode::infeasible);
}

/// Points that do what they are told, somewhere in a cube of 30 m, each to the place of another.
TEST(Bvc, NoTwoOfManyEverTouch) {
  constexpr double period = 0.5;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng = Rng{seed}.stream("crowd");
    std::vector<Vec3> places, goals;
    while (places.size() < 8) {
      const auto within = [&] { return rng.uniform(0.0, 30.0); };
      const Vec3 place{within(), within(), within()};
      if (std::ranges::all_of(places, [&](const Vec3& p) { return (p - place).norm() > 2.5; }))
        places.push_back(place);
    }
    for (std::size_t i = 0; i < places.size(); ++i) goals.push_back(places[(i + 3) % places.size()]);
    for (int step = 0; step < 400; ++step) {
      std::vector<Vec3> velocities;
      for (std::size_t i = 0; i < places.size(); ++i) {
        OwnedSituation e = encounters::open_water();
        e.situation.period = period;
        e.situation.own.id = VehicleId{static_cast<std::uint32_t>(i)};
        e.situation.own.position = places[i];
        e.situation.goal.position = goals[i];
        for (std::size_t j = 0; j < places.size(); ++j)
          if (j != i)
            e.tracks.push_back(encounters::track(static_cast<std::uint32_t>(j), places[j], Vec3::Zero()));
        velocities.push_back(decide<Bvc>(e).velocity);
      }
      for (std::size_t i = 0; i < places.size(); ++i) places[i] += period * velocities[i];
      for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          ASSERT_GE((places[i] - places[j]).norm(), 2.0 - 1e-9) << "seed " << seed << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace fairway
