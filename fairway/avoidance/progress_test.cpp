// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/progress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using Motion = std::function<Vec3(double)>;

constexpr double cruise = 0.5;  // [m/s]: places of 1.5 m, and 5 m to whoever matters, with a window of 30 s
const Goal far_north{.position = {1000, 0, 0}, .cruise_speed = cruise, .velocity = {}};

Motion standing(const Vec3& place) {
  return [place](double) { return place; };
}

/// Along the corners at cruising speed, then standing at the last.
Motion along(std::vector<Vec3> corners) {
  return [corners](double time) {
    double left = cruise * time;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Vec3 way = corners[i] - corners[i - 1];
      if (left <= way.norm()) return Vec3{corners[i - 1] + left * way.normalized()};
      left -= way.norm();
    }
    return corners.back();
  };
}

/// One vehicle that is watched, and others that it sees, ten times a second.
class Watched {
 public:
  explicit Watched(Motion own, std::vector<Motion> others = {})
      : own_{std::move(own)}, others_{std::move(others)}, trails_(others_.size()) {}

  ProgressReport at(double until) {
    for (; time_ <= until + 1e-9; time_ += 0.1) {
      watch.see(time_, own_(time_), goal, under_way);
      bystanders_.clear();
      for (std::size_t i = 0; i < others_.size(); ++i) {
        const Vec3 there = others_[i](time_);
        trails_[i].see(time_, there, watch.step(), 30.0);
        bystanders_.push_back({.id = TrackId{static_cast<std::uint32_t>(i)},
                               .gap = (there - own_(time_)).norm() - 2.0,
                               .rests_since = trails_[i].since(),
                               .may_clear_way = may_clear_way});
      }
      report_ = watch.judge(mode, bystanders_);
      if (report_.state != Headway::making) worst = report_.state;
    }
    return report_;
  }

  ProgressWatch watch{30.0};
  Goal goal = far_north;
  Mode mode{Mode::avoid};
  bool under_way{true};
  bool may_clear_way{true};
  std::optional<Headway> worst;  ///< the last that was no progress

 private:
  Motion own_;
  std::vector<Motion> others_;
  std::vector<Trail> trails_;
  std::vector<Bystander> bystanders_;
  ProgressReport report_;
  double time_{};
};

TEST(Progress, IsMadeByWhoeverIsFasterThanATenthOfItsCruisingSpeed) {
  for (const double speed : {0.5, 0.1, 0.06}) {
    Watched vehicle{[=](double t) { return Vec3{speed * t, 0, 0}; }};
    vehicle.at(600);
    EXPECT_FALSE(vehicle.worst) << speed;
  }
  Watched vehicle{[](double t) { return Vec3{0.04 * t, 0, 0}; }};
  for (double time = 31; time < 600; time += 1) EXPECT_EQ(vehicle.at(time).state, Headway::trapped) << time;
}

TEST(Progress, EndsWhereAVehicleStandsAndIsMissedAWindowLater) {
  Watched vehicle{along({{0, 0, 0}, {20, 0, 0}})};  // it stands from 40 s on
  EXPECT_EQ(vehicle.at(66).state, Headway::making);
  const ProgressReport report = vehicle.at(71);
  EXPECT_EQ(report.state, Headway::trapped);
  EXPECT_FALSE(report.with);
  // the last place that was new began at most 1.5 m, 3 s, before
  EXPECT_GE(report.last_progress, 37.0);
  EXPECT_LE(report.last_progress, 40.1);
}

TEST(Progress, IsNotGoingToAndFroNorRoundAndRound) {
  const auto to_and_fro = [](double t) { return Vec3{4.0 * std::sin(2 * std::numbers::pi * t / 35), 0, 0}; };
  Watched swinging{to_and_fro};
  EXPECT_EQ(swinging.at(120).state, Headway::trapped);
  EXPECT_LE(swinging.at(600).last_progress, 35.0);

  const auto round = [](double radius) {
    return [=](double t) {
      return Vec3{radius * std::cos(cruise / radius * t), radius * std::sin(cruise / radius * t), 0};
    };
  };
  Watched circling{round(3.0)};  // 38 s
  EXPECT_EQ(circling.at(300).state, Headway::trapped);
  Watched touring{round(6.0)};  // 75 s: more than a window and a half, which is what it cannot tell
  touring.at(300);
  EXPECT_FALSE(touring.worst);
}

TEST(Progress, IsMadeOnTheWayOutOfABlindAlley) {
  // 30 m in, 30 m back and round it, away from the goal for 90 m
  Watched vehicle{along({{0, 0, 0}, {30, 0, 0}, {-30, 0, 0}, {-30, 20, 0}, {100, 20, 0}})};
  vehicle.at(500);
  EXPECT_FALSE(vehicle.worst);
}

TEST(Progress, WaitsForSomebodyWhoCrosses) {
  // 0.1 m/s, and within reach, 7 m between centres, from 30 to 170 s
  Watched vehicle{standing({0, 0, 0}), {[](double t) { return Vec3{3, 0.1 * t - 10, 0}; }}};
  EXPECT_EQ(vehicle.at(29).state, Headway::making);
  const ProgressReport report = vehicle.at(100);
  EXPECT_EQ(report.state, Headway::waiting);
  EXPECT_EQ(report.with, TrackId{0});
  EXPECT_EQ(vehicle.at(200).state, Headway::trapped) << "it has gone, and the vehicle still stands";
}

TEST(Progress, IsDeadlockedAmongThoseWhoStandTooSinceTheLastOfThemCameToRest) {
  Watched vehicle{standing({-3, 0, 0}),
                  {standing({3, 0, 0}), standing({0, 2, 0}), along({{0, -13, 0}, {0, -3, 0}})}};
  EXPECT_EQ(vehicle.at(45).state, Headway::waiting);
  const ProgressReport report = vehicle.at(100);
  EXPECT_EQ(report.state, Headway::deadlocked);
  EXPECT_EQ(report.with, TrackId{1}) << "the nearest";
  EXPECT_EQ(report.last_progress, 0.0);
  EXPECT_GE(report.since, 17.0);  // 10 m at 0.5 m/s, its last new place at most 3 s before
  EXPECT_LE(report.since, 20.1);
}

TEST(Progress, CountsOnNobodyWhoStaysWhereItIs) {
  Watched vehicle{standing({0, 0, 0}), {standing({4, 0, 0})}};
  vehicle.may_clear_way = false;
  EXPECT_EQ(vehicle.at(100).state, Headway::trapped);
}

TEST(Progress, IsNotMissedWhereNoneIsMeant) {
  Watched told{standing({0, 0, 0})};
  told.under_way = false;
  EXPECT_EQ(told.at(100).state, Headway::holding);
  EXPECT_EQ(told.at(200).last_progress, told.at(200).since);
  told.under_way = true;  // its window begins now
  EXPECT_EQ(told.at(229).state, Headway::making);
  EXPECT_EQ(told.at(232).state, Headway::trapped);

  Watched slow{standing({0, 0, 0})};
  slow.goal.cruise_speed = 0.0;
  EXPECT_EQ(slow.at(100).state, Headway::holding);
}

TEST(Progress, OfAMethodThatHoldsOnPurposeIsWaitingUnlessThoseNearStandToo) {
  Watched alone{standing({0, 0, 0})};
  alone.mode = Mode::hold;
  EXPECT_EQ(alone.at(100).state, Headway::waiting);
  EXPECT_FALSE(alone.at(100).with);
  Watched pair{standing({0, 0, 0}), {standing({4, 0, 0})}};
  pair.mode = Mode::hold;
  EXPECT_EQ(pair.at(100).state, Headway::deadlocked);
}

TEST(Progress, IsNotMadeByAnotherGoal) {
  Watched vehicle{standing({0, 0, 0})};
  for (int i = 1; i <= 100; ++i) {
    vehicle.goal.position = {1000.0 / i, 1, 0};
    vehicle.at(i);
  }
  EXPECT_EQ(vehicle.at(101).state, Headway::trapped);
}

TEST(Progress, HasWordsForWhoeverMakesNone) {
  EXPECT_TRUE(note_of(Headway::making).empty() && note_of(Headway::holding).empty());
  for (const Headway stuck : {Headway::waiting, Headway::deadlocked, Headway::trapped})
    EXPECT_TRUE(note_of(stuck).starts_with("no progress: "));
}

TEST(Trail, IsTheSameWithAnyRoom) {
  Rng rng{18};
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
  Trail few{2}, usual{Trail::usual_places}, all;
  int news = 0;
  for (int i = 0; i < 20'000; ++i) {  // to and fro at up to four times the cruising speed, and at rest
    if (rng.index(40) == 0) velocity = -velocity;
    if (rng.index(40) == 0) velocity = {rng.uniform(-1.4, 1.4), rng.uniform(-1.4, 1.4), 0};
    if (rng.index(100) == 0) velocity = Vec3::Zero();
    place += 0.5 * velocity;
    Trail copy = few;
    const bool is_new = all.see(0.5 * i, place, 1.5, 30.0);
    ASSERT_EQ(few.see(0.5 * i, place, 1.5, 30.0), is_new) << i;
    ASSERT_EQ(copy.see(0.5 * i, place, 1.5, 30.0), is_new) << i;
    ASSERT_EQ(usual.see(0.5 * i, place, 1.5, 30.0), is_new) << i;
    ASSERT_EQ(usual.since(), all.since()) << i;
    news += is_new ? 1 : 0;
  }
  EXPECT_GT(news, 1000);
  EXPECT_LT(news, 19'000);
}

TEST(Trail, OfMoreThan32PlacesTheOldestIsForgottenEvenWhereItIsLeftForTheNewest) {
  constexpr double window = 1e6;
  Trail trail{Trail::usual_places};
  double time = 0.0;
  const auto sees = [&](int place) { return trail.see(time++, {10.0 * place, 0, 0}, 1.5, window); };
  for (int place = 0; place < 32; ++place) EXPECT_TRUE(sees(place)) << place;
  EXPECT_FALSE(sees(0));
  EXPECT_TRUE(sees(32));
  EXPECT_TRUE(sees(0));
  EXPECT_FALSE(sees(2));
}

TEST(Trail, UsualRoomIsEnoughAtCruisingSpeed) {
  Trail trail{Trail::usual_places};
  const long before = allocation_count();
  for (int i = 0; i < 20'000; ++i) trail.see(0.05 * i, {0.5 * 0.05 * i, 0, 0}, 1.5, 30.0);
  EXPECT_EQ(allocation_count(), before);
}

TEST(Trail, ForgetsAllWithoutMemory) {
  Trail trail{Trail::usual_places}, fresh;
  for (int i = 0; i < 100; ++i) trail.see(i, {1.0 * i, 0, 0}, 1.5, 30.0);
  const long before = allocation_count();
  trail.forget();
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(trail.since(), fresh.since());
  for (int i = 0; i < 200; ++i) {  // back where it was, and round
    const Vec3 place{20.0 * std::cos(0.1 * i), 20.0 * std::sin(0.1 * i), 0};
    ASSERT_EQ(trail.see(100.0 + i, place, 1.5, 30.0), fresh.see(100.0 + i, place, 1.5, 30.0)) << i;
  }
}

TEST(Progress, WatchingAllocatesNothing) {
  ProgressWatch watch;
  const std::array<Bystander, 2> bystanders{};
  const auto before = allocation_count();
  for (int i = 0; i < 10'000; ++i) {
    watch.see(0.1 * i, {std::sin(0.01 * i), 0.002 * i, 0}, far_north, true);
    watch.judge(Mode::avoid, bystanders);
  }
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace fairway
