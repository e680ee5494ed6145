// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/avoa.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;

/// A Zarco at the origin, northbound at 1.2 of at most 1.5 m/s for a goal 25 m ahead, every 0.2 s.
OwnedSituation zarco() {
  OwnedSituation e = encounters::open_water(1.2);
  e.situation.period = 0.2;
  e.situation.own.position = {0, 0, 0};
  e.situation.own.radius = 0.75;
  e.situation.goal.position = {25, 0, 0};
  e.situation.limits.max_turn_rate = 0.3751;
  return e;
}

Obstacle buoy(double north, double east) {
  return {.kind = Obstacle::Kind::sphere, .position = {north, east, 0}, .radius = 0.3};
}

double course(const Command& command) { return std::atan2(command.velocity.y(), command.velocity.x()); }

TEST(Avoa, WithNothingNearGoesExactlyWhereItWasGoing) {
  OwnedSituation e = zarco();
  const Command expected{.velocity = {1.2, 0.0, 0.0}, .mode = Mode::cruise};
  EXPECT_EQ(decide<Avoa>(e), expected);
  e.obstacles = {buoy(20.0, 0.0)};  // beyond the window at any speed of the picture
  EXPECT_EQ(decide<Avoa>(e), expected);
}

TEST(Avoa, WithTheGoalAbeamTurnsAsFastAsItsThrustersAllow) {
  OwnedSituation e = zarco();
  e.situation.own.yaw = -0.5;
  const Command command = decide<Avoa>(e, {.search = VelocitySearch::exhaustive});
  EXPECT_EQ(command.mode, Mode::cruise);
  const double theta = course(command) + 0.5;
  EXPECT_GT(theta, 0.2);
  EXPECT_LE(command.velocity.norm() + 3.0 * 0.5 * theta, 1.5 + 1e-12);
}

TEST(Avoa, WhereTheEnvelopeIsKnownNoThrusterForbidsWhatIsDesired) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = zarco();
  e.situation.goal.position = {0, 25, 0};
  e.obstacles = {buoy(-4.0, 0.0)};  // forbids going astern
  EXPECT_LT(std::abs(course(decide<Avoa>(e))), 0.3);
  e.situation.envelope = &boat;
  EXPECT_LT((decide<Avoa>(e).velocity - Vec3(0.0, 1.2, 0.0)).norm(), 1e-12);
  e.obstacles = {buoy(0.0, 4.0)};  // what an obstacle forbids it does not ask for
  EXPECT_LT(std::abs(course(decide<Avoa>(e))), 0.5);
}

TEST(Avoa, WhereTheEnvelopeIsKnownItDoesNotCreepUpToWhatStands) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = zarco();
  e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {14.0, 0.0, 0.0}, .radius = 6.0}};
  const auto passes_at = [&] {
    const Vec3 v = decide<Avoa>(e, {.search = VelocitySearch::exhaustive}).velocity;
    return 14.0 * std::abs(v.y()) / v.norm();
  };
  const double touches = 6.0 + 0.75 + 0.25;
  EXPECT_LT(passes_at(), touches);
  e.situation.envelope = &boat;
  EXPECT_GT(passes_at(), touches);
  e.tracks = {encounters::track(1, e.obstacles[0].position, {0, 0, 0}, 6.0)};  // may be gone by then
  e.obstacles = {};
  EXPECT_LT(passes_at(), touches);
}

TEST(Avoa, WhereTheEnvelopeIsKnownItDoesNotGoOnAwayFromItsGoalAheadOfADrifter) {
  const Envelope boat = encounters::of_a_boat();
  OwnedSituation e = zarco();
  e.situation.goal.position = {-25, 10, 0};
  e.tracks = {encounters::track(1, {-6.0, 2.4, 0.0}, {0.3, 0.0, 0.0}, 0.75)};
  const auto towards_goal = [&] {
    const Vec3 v = decide<Avoa>(e, {.search = VelocitySearch::exhaustive}).velocity;
    return v.dot(Vec3(-25, 10, 0)) / v.norm();
  };
  EXPECT_LT(towards_goal(), 0.0);
  e.situation.envelope = &boat;
  EXPECT_GT(towards_goal(), 0.0);
}

TEST(Avoa, AnObstacleAsternIsNoReasonToTurn) {
  OwnedSituation e = zarco();
  e.obstacles = {buoy(-4.0, 0.0)};
  const Command command = decide<Avoa>(e);
  EXPECT_EQ(command.mode, Mode::avoid);  // it forbids going astern
  EXPECT_LT((command.velocity - Vec3(1.2, 0.0, 0.0)).norm(), 1e-12);
}

TEST(Avoa, ABuoyAheadIsLeftOnTheSideOnWhichItLies) {
  for (const double east : {-0.3, 0.3}) {
    OwnedSituation e = zarco();
    e.obstacles = {buoy(7.0, east)};
    for (const VelocitySearch search : {VelocitySearch::swarm, VelocitySearch::exhaustive}) {
      const Command command = decide<Avoa>(e, {.search = search});
      EXPECT_EQ(command.mode, Mode::avoid);
      EXPECT_LT(course(command) * east, 0.0);
    }
  }
}

TEST(Avoa, AnswersAVelocityThatKeepsClearForTheWindow) {
  Rng rng{4};
  int answered = 0, avoiding = 0;
  for (int i = 0; i < 200; ++i) {
    OwnedSituation e = zarco();
    for (int k = 0; k < 6; ++k) e.obstacles.push_back(buoy(rng.uniform(2, 12), rng.uniform(-6, 6)));
    e.tracks = {encounters::track(1, {rng.uniform(3, 12), rng.uniform(-8, 8), 0},
                                  {rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6), 0}, 0.75)};
    const Command command = decide<Avoa>(e);
    if (command.mode == Mode::infeasible) continue;
    ++answered;
    avoiding += command.mode == Mode::avoid ? 1 : 0;
    for (double t = 0.0; t < 40.0; t += 0.25) {
      const double time = 0.2 * t;
      const Vec3 own = time * command.velocity;
      // half a cell, 0.021 m/s, is what the picture may be wrong by
      const double doubt = 0.0213 * time;
      for (const Obstacle& o : e.obstacles) EXPECT_GT((o.position - own).norm(), 1.3 - doubt);
      const Track& t1 = e.tracks[0];
      EXPECT_GT((t1.position + time * t1.velocity - own).norm(), 1.75 - doubt);
    }
  }
  EXPECT_GT(answered, 150);
  EXPECT_GT(avoiding, 100);
}

TEST(Avoa, PrefersWhatIsFartherFromDanger) {
  OwnedSituation e = zarco();
  e.obstacles = {buoy(7.0, 1.35)};  // 1.3 m is clear, barely
  const auto how = [](double weight) {
    return Avoa::Params{.search = VelocitySearch::exhaustive, .danger_weight_ratio = weight};
  };
  EXPECT_LT((decide<Avoa>(e, how(0.0)).velocity - Vec3(1.2, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_LT(course(decide<Avoa>(e, how(0.4))), -0.02);
}

TEST(Avoa, WhereNoVelocityIsLeftItStops) {
  OwnedSituation e = zarco();
  for (int i = 0; i < 24; ++i) {
    const double bearing = i * pi / 12.0;
    e.tracks.push_back(encounters::track(static_cast<std::uint32_t>(i + 1),
                                         2.5 * Vec3{std::cos(bearing), std::sin(bearing), 0},
                                         -0.5 * Vec3{std::cos(bearing), std::sin(bearing), 0}));
  }
  const Command command = decide<Avoa>(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_EQ(command.velocity, Vec3(0.0, 0.0, 0.0));
}

TEST(Avoa, AnObstacleOverTheVesselIsLeft) {
  OwnedSituation e = zarco();
  e.obstacles = {buoy(0.5, 0.0)};
  const Command command = decide<Avoa>(e);
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_LE(command.velocity.x(), 0.0);

  // exactly over it, it counts as lying south, as nearest_point() says; of tracks the smaller id goes north
  e.obstacles = {buoy(0.0, 0.0)};
  EXPECT_LT((decide<Avoa>(e).velocity - Vec3(1.2, 0.0, 0.0)).norm(), 1e-12);
  e.obstacles.clear();
  e.tracks = {encounters::track(1, {0, 0, 0}, {0, 0, 0})};
  EXPECT_LT((decide<Avoa>(e).velocity - Vec3(1.2, 0.0, 0.0)).norm(), 1e-12);
  e.situation.own.id = VehicleId{2};
  EXPECT_LE(decide<Avoa>(e).velocity.x(), 0.0);
}

TEST(Avoa, BetweenOverlappingTracksOnOppositeSidesThereIsOnlyTheWayAcross) {
  OwnedSituation e = zarco();
  e.tracks = {encounters::track(1, {1, 0, 0}, {0, 0, 0}), encounters::track(2, {-1, 0, 0}, {0, 0, 0})};
  const Command command = decide<Avoa>(e);
  EXPECT_EQ(command.mode, Mode::avoid);
  EXPECT_LT(std::abs(command.velocity.x()), 0.02);  // half a cell
  EXPECT_GT(std::abs(command.velocity.y()), 0.19);
}

TEST(Avoa, SlowerThanTheLeastSpeedOnlyIfDesired) {
  OwnedSituation e = zarco();
  e.obstacles = {buoy(4.0, 0.0), buoy(3.5, 2.0), buoy(3.5, -2.0)};
  const Avoa::Params slow{.search = VelocitySearch::exhaustive, .least_speed_mps = 0.0};
  EXPECT_LT(decide<Avoa>(e, slow).velocity.norm(), 0.2);
  EXPECT_GE(decide<Avoa>(e, {.search = VelocitySearch::exhaustive}).velocity.norm(), 0.2 - 1e-12);

  e.situation.goal.velocity = Vec3{0.05, 0.0, 0.0};  // none of it is reached within the window
  EXPECT_LT((decide<Avoa>(e).velocity - Vec3(0.05, 0.0, 0.0)).norm(), 1e-12);
  e.situation.goal.velocity = Vec3::Zero();
  EXPECT_EQ(decide<Avoa>(e).velocity, Vec3(0.0, 0.0, 0.0));
}

TEST(Avoa, WhoMayNotMoveSaysSo) {
  OwnedSituation e = zarco();
  for (const double limit : {0.0, 1e-9}) {
    e.situation.limits.max_speed = limit;
    const Command command = decide<Avoa>(e);
    EXPECT_EQ(command.mode, Mode::infeasible);
    EXPECT_EQ(command.velocity, Vec3(0.0, 0.0, 0.0));
  }
}

TEST(Avoa, WhereNoLimitIsSetItsOwnHold) {
  OwnedSituation e = zarco();
  e.situation.limits = {};
  e.situation.goal.cruise_speed = 5.0;
  const Command command = decide<Avoa>(e, {.search = VelocitySearch::exhaustive});
  EXPECT_EQ(command.mode, Mode::cruise);
  EXPECT_LT((command.velocity - Vec3(1.5, 0.0, 0.0)).norm(), 1e-12);

  // and a limit that is beyond all sense is cut
  e.situation.limits.max_speed = 1e300;
  e.obstacles = {buoy(7.0, 0.3)};
  EXPECT_TRUE(is_finite(decide<Avoa>(e)));
}

TEST(Avoa, GridsAreOfTwoToFourHundredAndOne) {
  Avoa::Params params;
  for (const double refused : {1.0, 402.0}) {
    EXPECT_THROW(set_param(params, "grid_count", refused), InputError);
  }
  OwnedSituation e = zarco();
  e.obstacles = {buoy(7.0, 0.3)};
  for (const int side : {2, 3, 100, 401}) {
    for (const VelocitySearch search : {VelocitySearch::swarm, VelocitySearch::exhaustive}) {
      EXPECT_TRUE(is_finite(decide<Avoa>(e, {.search = search, .grid_count = side}))) << side;
    }
  }
}

TEST(Avoa, DrawsItsThreePicturesInThePapersColours) {
  OwnedSituation e = zarco();
  e.situation.own.yaw = 0.1;
  e.obstacles = {buoy(7.0, 0.3)};
  Drawing drawing;
  const Command command = decide<Avoa>(e, {.thruster_speed_mps = 100.0}, &drawing);

  const std::span<const Stroke> pictures = drawing.strokes().first(3);
  const std::array meanings{"protective zones", "cost of danger", "metric"};
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_EQ(pictures[i].kind, Stroke::Kind::image);
    EXPECT_EQ(pictures[i].meaning, meanings[i]);
    EXPECT_EQ(pictures[i].side, 101);
    EXPECT_EQ(pictures[i].size, 1.5);
    EXPECT_EQ(pictures[i].yaw, 0.1);
  }
  const auto pixel = [&](std::size_t picture, int row, int column) {
    return pictures[picture].rgb.at(static_cast<std::size_t>(row * 101 + column));
  };

  // astern is cyan; 0.75 m/s to starboard half saturated, at 90 degrees of hue; ahead is forbidden, and the
  // corner
  EXPECT_EQ(pixel(0, 100, 50), 0x00FFFFU);
  EXPECT_EQ(pixel(0, 50, 75), 0xBFFF80U);
  EXPECT_EQ(pixel(0, 5, 50), 0U);
  EXPECT_EQ(pixel(0, 0, 0), 0U);
  // no danger astern, full danger in the zone
  EXPECT_EQ(pixel(1, 100, 50), 0xFFFFFFU);
  EXPECT_EQ(pixel(1, 5, 50), 0U);
  EXPECT_EQ(std::ranges::count(pictures[2].rgb, 0xFFFFFFU), 1);

  EXPECT_EQ(std::ranges::count(drawing.strokes(), std::string("particle"), &Stroke::meaning), 30);
  EXPECT_EQ(std::ranges::count(drawing.strokes(), std::string("desired"), &Stroke::meaning), 1);
  EXPECT_EQ(drawing.strokes().back().meaning, "chosen");
  EXPECT_EQ(drawing.strokes().back().points, std::vector<Vec3>{command.velocity});
}

}  // namespace
}  // namespace fairway
