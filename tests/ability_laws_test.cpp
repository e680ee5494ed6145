// SPDX-License-Identifier: Apache-2.0
// What the whole catalog owes a vehicle that can neither stop nor go astern or sideways.
#include "fairway/avoidance/ability.hpp"
#include "tests/laws.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

std::vector<std::string> everybody() {
  std::vector<std::string> names;
  const Catalog catalog = laws::catalog();
  for (const Catalog::Entry& entry : catalog.entries()) {
    names.emplace_back(entry.info.name);
    if (entry.wraps) names.push_back("orca3d+" + names.back());
  }
  return names;
}

/// A REMUS 100, to three digits (fairway/control/vehicle_limits_test.cpp).
constexpr Limits remus{
    .max_speed = 1.5, .max_climb_rate = 0.3, .min_speed = 0.962, .sternway = false, .sway = false};

/// A swarm in the plane round a vehicle under way; every second one cannot turn at once.
OwnedSituation scene(std::uint64_t i) {
  Rng rng = Rng{11}.stream("torpedo", i);
  const int count = static_cast<int>(i % 12);
  OwnedSituation e = i % 3 == 0 ? encounters::congested(count, rng) : encounters::crowd(count, rng);
  Situation& s = e.situation;
  s.limits = remus;
  if (i % 2 == 0) s.limits.max_turn_rate = 0.08;
  s.own.velocity =
      rng.uniform(remus.min_speed, remus.max_speed) * Vec3{std::cos(s.own.yaw), std::sin(s.own.yaw), 0};
  s.goal.position.z() = s.own.position.z();
  s.goal.cruise_speed = 1.5;
  for (Track& t : e.tracks) {
    t.position.z() = s.own.position.z();
    t.velocity.z() = 0.0;
  }
  return e.sorted();
}

/// Calls `law(avoider, situation)` in 300 swarms; 30 for a planner.
template <class Law>
void everywhere(const std::string& method, Law law) {
  const Catalog catalog = laws::catalog();
  const bool is_slow = catalog.find(method.substr(0, method.find('+'))).info.allocates;
  // teb's own largest speed is below the vehicle's least one
  const ParamValues params = method == "teb" ? ParamValues{{"max_vel_x_mps", 1.5}} : ParamValues{};
  for (std::uint64_t i = 0; i < (is_slow ? 30 : 300); ++i) {
    SCOPED_TRACE("swarm " + std::to_string(i));
    law(catalog.make(method, params, Rng{7}), scene(i));
  }
}

class OfATorpedo : public testing::TestWithParam<std::string> {};
class OfATorpedoRespected : public testing::TestWithParam<std::string> {};

TEST_P(OfATorpedo, WhatItCannotCarryOutIsNeverSilent) {
  everywhere(GetParam(), [](Avoider avoider, const Situation& s) {
    for (int step = 0; step < 2; ++step) {
      const Command command = avoider.decide(s);
      EXPECT_FALSE(command.astern);
      if (shortfall(s.limits, command, s.own.yaw) == Shortfall::none) continue;
      EXPECT_FALSE(command.note.empty());
      EXPECT_NE(command.mode, Mode::avoid) << command.note;
    }
  });
}

TEST_P(OfATorpedoRespected, WhoeverChoosesAmongVelocitiesChoosesOneThatItCanMake) {
  int chosen = 0;
  everywhere(GetParam(), [&](Avoider avoider, const Situation& s) {
    const Command command = avoider.decide(s);
    if (command.mode == Mode::cruise || command.velocity.isZero(0.0)) return;
    EXPECT_EQ(enum_name(shortfall(s.limits, command, s.own.yaw)), enum_name(Shortfall::none))
        << command.velocity.transpose();
    ++chosen;
  });
  EXPECT_GT(chosen, 10);
}

INSTANTIATE_TEST_SUITE_P(Catalog, OfATorpedo, testing::ValuesIn(everybody()), laws::test_name);
INSTANTIATE_TEST_SUITE_P(Catalog, OfATorpedoRespected,
                         testing::Values("vo", "rvo", "hrvo", "avoa", "avoa_improved", "teb"),
                         laws::test_name);

}  // namespace
}  // namespace fairway
