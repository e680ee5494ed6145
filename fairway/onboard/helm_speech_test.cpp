// SPDX-License-Identifier: Apache-2.0
// A method that speaks, on board.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "fairway/onboard/testing/fixes.hpp"

namespace fairway {
namespace {

using fixes::h;

/// Two that swap places by `pledge`, and tell each other nothing but its words.
class Swap {
 public:
  Swap() {
    for (std::size_t i = 0; i < 2; ++i) {
      fixes::Parts setup = fixes::setup();
      setup.ship.id = id(i);
      setup.team = {{.id = id(1 - i), .name = "other", .radius = 1.5}};
      helms_.push_back(fixes::helm_of(setup, "pledge", {{"team_count", 2.0}}));
    }
    states_[0].p_n = {0, 0, 10};
    states_[1].p_n = {40, 0.5, 10};
    states_[1].q_nb = quaternion_of({.yaw = pi});
    helms_[0].go_to({40, 0, 10}, 0.5);
    helms_[1].go_to({0, 0.5, 10}, 0.5);
  }

  void step() {
    for (std::size_t i = 0; i < 2; ++i) helms_[i].own_fix({.time = now_, .state = states_[i]}, now_);
    for (std::size_t i = 0; i < 2; ++i) {
      VehicleState& x = states_[i];
      const BodyRequest request = helms_[i].update(now_).request;
      x.v_b = {request.surge_mps, request.sway_mps, request.heave_mps};
      x.p_n += h * x.v_n();
      x.q_nb = quaternion_of({.yaw = yaw_of(x.q_nb) + h * request.yaw_rate_radps});
      if (now_ >= next_[i]) speak(i);
    }
    least_ = std::fmin(least_, (states_[0].p_n - states_[1].p_n).norm());
    now_ += h;
  }

  bool has_arrived(std::size_t i) const { return helms_[i].order().state == HelmState::arrived; }
  void go_on_until(double time) {
    while (now_ < time && !(has_arrived(0) && has_arrived(1))) step();
  }

  Helm& helm(std::size_t i) { return helms_[i]; }
  const Vec3& place(std::size_t i) const { return states_[i].p_n; }
  double now() const { return now_; }
  double least() const { return least_; }
  int said() const { return said_; }
  bool deaf{};  ///< nothing that is said arrives

 private:
  static VehicleId id(std::size_t i) { return VehicleId{static_cast<std::uint32_t>(i)}; }

  void speak(std::size_t i) {
    constexpr double cycle = 4.0;
    next_[i] += cycle;
    helms_[i].turns(next_[i], cycle);
    const Speech words = helms_[i].own_speech();
    if (words.empty()) return;
    ++said_;
    if (!deaf) helms_[1 - i].speech(id(i), words.view(), now_, now_);
  }

  std::vector<Helm> helms_;
  std::array<VehicleState, 2> states_{};
  std::array<double, 2> next_{0.0, 2.0};
  double now_{};
  double least_{std::numeric_limits<double>::infinity()};
  int said_{};
};

TEST(HelmSpeech, TwoAgreeByTheirWordsAloneAndSwapPlaces) {
  Swap swap;
  swap.go_on_until(400.0);
  EXPECT_TRUE(swap.has_arrived(0));
  EXPECT_TRUE(swap.has_arrived(1));
  EXPECT_GT(swap.least(), 3.0) << "the radii together";
  const int said = swap.said();
  for (int i = 0; i < 200; ++i) swap.step();
  EXPECT_GT(swap.said(), said) << "who has arrived goes on speaking";
}

TEST(HelmSpeech, WhoHearsNobodyStaysWhereItIs) {
  Swap swap;
  swap.deaf = true;
  while (swap.now() < 200.0) swap.step();
  EXPECT_GT(swap.said(), 50);
  EXPECT_GT(swap.least(), 39.0);
}

TEST(HelmSpeech, AnotherGoalIsAgreedOnAndReached) {
  const Vec3 elsewhere{0, 30, 10};
  for (const double when : {1.0, 20.0, 40.0, 300.0}) {
    Swap swap;
    while (swap.now() < when) swap.step();
    ASSERT_TRUE(swap.helm(0).go_to(elsewhere, 0.5));
    swap.step();
    swap.go_on_until(when + 600.0);
    EXPECT_TRUE(swap.has_arrived(0)) << when;
    EXPECT_LT((swap.place(0) - elsewhere).norm(), 2.0) << when;
    EXPECT_TRUE(swap.has_arrived(1)) << when;
    EXPECT_GT(swap.least(), 3.0) << when;
  }
}

TEST(HelmSpeech, AGoalThatCannotBeToldIsSaid) {
  Swap swap;
  while (swap.now() < 300.0) swap.step();
  ASSERT_TRUE(swap.helm(0).go_to({400, 0, 10}, 0.5));
  for (int i = 0; i < 20; ++i) swap.step();
  EXPECT_EQ(swap.helm(0).order().command.note, "its goal is too far from the datum for its words");
}

TEST(HelmSpeech, WhoIsKeptOnItsWaySaysSoAndNobodyRunsIntoIt) {
  for (const double when : {5.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 50.0}) {
    Swap swap;
    while (swap.now() < when) swap.step();
    swap.helm(0).keep_position();
    while (swap.now() < when + 300.0) swap.step();
    EXPECT_EQ(swap.helm(0).order().state, HelmState::keeping);
    EXPECT_GT(swap.least(), 3.0) << when;
    const bool lies_on_goal = (swap.place(0) - Vec3{0, 0.5, 10}).norm() < 5.0;
    EXPECT_TRUE(swap.has_arrived(1) || lies_on_goal) << when << ": nobody waits for who is kept";
    ASSERT_TRUE(swap.helm(0).go_to({40, 0, 10}, 0.5));
    swap.step();
    swap.go_on_until(when + 900.0);
    EXPECT_TRUE(swap.has_arrived(0)) << when;
    EXPECT_GT(swap.least(), 3.0) << when;
  }
}

TEST(HelmSpeech, WhoIsKeptOutsideItsDepthsIsLedBackWhateverItsMethodSays) {
  for (const double depth : {1.0, 30.0}) {
    fixes::Parts setup = fixes::setup();
    setup.ship.limits.edit().min_depth = 2.0;
    setup.ship.limits.edit().max_depth = 20.0;
    Helm helm = fixes::helm_of(setup, "delay_check");
    helm.keep_position();
    for (int i = 0; i < 20; ++i) {
      helm.own_fix(fixes::north(h * i, {1e-6 * i, 0, depth}, 0.0), h * i);
      helm.update(h * i);
    }
    EXPECT_EQ(helm.order().state, HelmState::keeping);
    EXPECT_NEAR(helm.order().request.heave_mps, depth < 10.0 ? 0.3 : -0.3, 1e-9) << depth;
  }
}

TEST(HelmSpeech, WhatIsNoSpeechOfTheTeamIsRefused) {
  fixes::Parts setup = fixes::setup();
  setup.team = {{.id = VehicleId{1}, .name = "other"}};
  Helm helm = fixes::helm_of(setup);
  const std::array<std::uint8_t, 26> bytes{};
  EXPECT_TRUE(helm.speech(VehicleId{1}, std::span{bytes}.first(25), 0.0, 0.0));
  EXPECT_FALSE(helm.speech(VehicleId{1}, bytes, 0.0, 0.0));
  EXPECT_FALSE(helm.speech(VehicleId{9}, std::span{bytes}.first(3), 0.0, 0.0));
  EXPECT_FALSE(helm.speech(VehicleId{1}, std::span{bytes}.first(3), 1e12, 0.0)) << "of a time to come";
  EXPECT_EQ(helm.report(0.0).records_refused, 3);
  EXPECT_TRUE(helm.own_speech().empty()) << "its method has nothing to say";
}

}  // namespace
}  // namespace fairway
