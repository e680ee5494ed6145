// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/outlook.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "fairway/avoidance/avoa_improved/testing/unicycle.hpp"

namespace fairway::avoa_improved {
namespace {

constexpr double radius = 0.75;
constexpr double margin = 0.25;
constexpr double hold = 0.8;
constexpr VesselResponse helm{.turn_gain = 1.0,
                              .max_turn_rate = 0.3751,
                              .max_turn_acceleration = 0.5,
                              .max_acceleration = 0.5,
                              .response = 0.5};
constexpr Foresight foresight{
    .turn_aware = true, .window = 8.0, .hold = hold, .near = 4.0, .margin = margin, .danger = 0.3};

struct Scene {
  Unicycle boat;
  std::vector<Capsule> fixed;
  std::vector<Capsule> moving;

  Outlook outlook(const Foresight& f = foresight) const {
    const OwnMotion own{boat.position, boat.yaw, boat.yaw_rate, boat.speed, boat.current};
    return {helm, f, own, radius, 1.5, fixed, moving};
  }
};

Command command_of(const Unicycle& boat, double speed, double heading) {
  const Vec2 velocity = speed * Vec2{std::cos(heading), std::sin(heading)};
  Command command{.velocity = {velocity.x(), velocity.y(), 0.0}};
  if (speed > 0.0) return command;
  command.velocity = speed * Vec3{std::cos(boat.yaw), std::sin(boat.yaw), 0.0};
  command.turn_rate = helm.turn_rate(wrap_angle(heading - boat.yaw));
  return command;
}

double room(const Capsule& solid, const Vec2& own, double t) {
  return (own - solid.from - t * solid.velocity).norm() - solid.radius - radius;
}

Scene any_scene(Rng rng) {
  Scene scene;
  scene.boat.yaw = rng.uniform(-3, 3);
  scene.boat.yaw_rate = rng.uniform(-0.37, 0.37);
  scene.boat.speed = rng.uniform(-0.3, 1.5);
  scene.boat.current = {rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)};
  for (int i = 0; i < 6; ++i) {
    const double bearing = rng.uniform(-pi, pi);
    const Vec2 p = rng.uniform(1.6, 9.0) * Vec2{std::cos(bearing), std::sin(bearing)};
    if (i % 2 == 0) {
      scene.fixed.push_back({p, p, 0.3});
    } else {
      scene.moving.push_back({p, p, 0.5, {rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6)}});
    }
  }
  return scene;
}

TEST(AvoaImprovedOutlook, ForeseesTheMotionOfTheVessel) {
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Rng rng = Rng{9}.stream("motion", i);
    Scene scene = any_scene(rng.stream("scene"));
    const double speed = i % 4 == 0 ? -0.3 : rng.uniform(0.05, 1.5);
    const double heading = rng.uniform(-pi, pi);
    Outlook outlook = scene.outlook();
    const auto path = outlook.path({speed, heading, 0, speed});
    ASSERT_EQ(path.size(), 40U);
    for (const Vec2& p : path) {
      scene.boat.sail(command_of(scene.boat, speed, heading), Outlook::step);
      worst = std::fmax(worst, (scene.boat.position - p).norm());
    }
  }
  EXPECT_LT(worst, 0.35);  // measured 0.25 m after 8 s and 12 m: turn rates gather way without a limit here
}

TEST(AvoaImprovedOutlook, LooksNoFartherThanToWhereItIsTooSevere) {
  int ended = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Rng rng = Rng{11}.stream("severe", i);
    const Scene scene = any_scene(rng.stream("scene"));
    const Manoeuvre m{rng.uniform(0.0, 1.5), rng.uniform(-pi, pi), 0, 1.0};
    const double bound = rng.uniform(0.0, 3.0);
    const Prospect whole = scene.outlook().to_the_end_of(m);
    const Prospect part = scene.outlook().to_the_end_of(m, bound);
    ASSERT_EQ(part.severity < bound, whole.severity < bound) << i;
    if (whole.severity >= bound) {
      ended += part.severity < whole.severity ? 1 : 0;
      continue;
    }
    EXPECT_EQ(part.severity, whole.severity) << i;
    EXPECT_EQ(part.danger, whole.danger) << i;
    EXPECT_EQ(part.is_clear, whole.is_clear) << i;
  }
  EXPECT_GT(ended, 20) << "most that are too severe are so before the end";
}

TEST(AvoaImprovedOutlook, GivesEveryCommandAwayThatHits) {
  int hits = 0;
  int clear = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    Rng rng = Rng{10}.stream("hits", i);
    Scene scene = any_scene(rng.stream("scene"));
    const double speed = rng.uniform(0.0, 1.5);
    const double heading = scene.boat.yaw + rng.uniform(-2.2, 2.2);  // not astern, where sides are a toss-up
    const bool is_clear = scene.outlook().to_the_end_of({speed, heading, 0, speed}).is_clear;
    EXPECT_EQ(scene.outlook().of({speed, heading, 0, speed}, 1.0).is_clear, is_clear);

    // by sailing: the command to the end against what moves, and until it is to be stopped against the rest
    double least_fixed = 1e9;
    double least_moving = 1e9;
    Unicycle stops = scene.boat;
    for (int k = 1; k <= 800; ++k) {
      const double t = 0.01 * k;
      scene.boat.sail(command_of(scene.boat, speed, heading), 0.01);
      for (const Capsule& s : scene.moving)
        least_moving = std::fmin(least_moving, room(s, scene.boat.position, t));
      if (std::abs(stops.speed) < 0.02 && t > hold) continue;
      stops.sail(command_of(stops, t <= hold ? speed : 0.0, heading), 0.01);
      for (const Capsule& s : scene.fixed) least_fixed = std::fmin(least_fixed, room(s, stops.position, 0.0));
    }
    const double least = std::fmin(least_fixed, least_moving);
    hits += least < 0.0 ? 1 : 0;
    clear += is_clear ? 1 : 0;
    EXPECT_FALSE(is_clear && least < 0.0) << i << ": " << least;
    EXPECT_FALSE(!is_clear && least > margin + 0.25) << i << ": " << least;
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(clear, 100);
}

TEST(AvoaImprovedOutlook, ABuoyBesideTheTurnIsSeenOnlyByWhoIsAwareOfTheTurn) {
  Scene scene;
  scene.boat.speed = 1.2;
  scene.fixed = {{{3.6, 0.0}, {3.6, 0.0}, 0.3}};
  Foresight at_once = foresight;
  at_once.turn_aware = false;
  at_once.hold = at_once.window;
  const Manoeuvre abeam{1.2, pi / 2, 0, 1.2};
  EXPECT_TRUE(scene.outlook(at_once).to_the_end_of(abeam).is_clear);
  scene.fixed = {{{2.0, 0.3}, {2.0, 0.3}, 0.3}};
  EXPECT_TRUE(scene.outlook(at_once).to_the_end_of(abeam).is_clear);
  EXPECT_FALSE(scene.outlook().to_the_end_of(abeam).is_clear);
}

TEST(AvoaImprovedOutlook, WhoIsTooNearAlreadyMayGoAwayButNotNearer) {
  Scene scene;
  scene.fixed = {{{1.15, 0.0}, {1.15, 0.0}, 0.3}};  // 0.1 m off, of a margin of 0.25 m
  EXPECT_FALSE(scene.outlook().to_the_end_of({0.3, 0.0, 0, 0.3}).is_clear);
  EXPECT_TRUE(scene.outlook().to_the_end_of({-0.3, 0.0, 0, -0.3}).is_clear);
}

TEST(AvoaImprovedOutlook, DangerGrowsWithNearnessAndFallsWithTime) {
  const auto danger = [](double north, double east) {
    Scene scene;
    scene.boat.speed = 1.0;
    scene.fixed = {{{north, east}, {north, east}, 0.3}};
    return scene.outlook().to_the_end_of({1.0, 0.0, 0, 1.0}).danger;
  };
  EXPECT_GT(danger(1.5, 1.35), danger(1.5, 1.5));
  EXPECT_GT(danger(1.5, 1.35), danger(2.5, 1.35));
  EXPECT_EQ(danger(1.5, 1.61), 0.0);  // 0.75 + 0.3 + 0.25 + 0.3 = 1.6 m
}

}  // namespace
}  // namespace fairway::avoa_improved
