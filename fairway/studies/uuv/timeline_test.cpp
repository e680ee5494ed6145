// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/timeline.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fairway/experiment/compare.hpp"
#include "fairway/studies/disc.hpp"

namespace fairway::uuv {
namespace {

/// Two vehicles of radius 1 m with 10 m/s wanted, one to go 100 m north and the other 100 m south, written
/// down once a second.
class Encountering {
 public:
  Encountering() : timeline_{scenario()} {
    vehicles_[0].goal = {100.0, 0.0, 0.0};
    vehicles_[1].goal = {0.0, 0.0, 0.0};
    for (VehicleFrame& vehicle : vehicles_) {
      vehicle.goal_speed = 10.0;
      vehicle.phase = Phase::under_way;
    }
  }

  /// The first vehicle at `n`, `e` with that velocity; the other at `other_n`, 3 m to the west.
  Encountering& at(double n, double e, double v_n, double v_e, double other_n) {
    vehicles_[0].state.p_n = {n, e, 0.0};
    vehicles_[0].state.v_b = {v_n, v_e, 0.0};
    vehicles_[1].state.p_n = {other_n, -3.0, 0.0};
    vehicles_[1].state.v_b = {-10.0, 0.0, 0.0};
    timeline_.write(
        {.tick = Tick{tick_}, .time = static_cast<double>(tick_), .period = 1.0, .vehicles = vehicles_});
    ++tick_;
    return *this;
  }

  Encountering& arrived() {
    vehicles_[0].phase = Phase::arrived;
    return at(100.0, 0.0, 0.0, 0.0, 0.0);
  }

  Events events() const { return timeline_.events(0); }

  double fleet(std::string_view quantity) const {
    std::vector<Measure> measures;
    timeline_.report(measures);
    return run_value(measures, quantity);
  }

 private:
  static Scenario scenario() {
    Scenario scenario;
    scenario.vehicles.resize(2);
    scenario.obstacles = {disc({50.0, 30.0, 0.0}, 2.0, {0.0, -5.0, 0.0})};
    return scenario;
  }

  Timeline timeline_;
  std::array<VehicleFrame, 2> vehicles_{};
  std::int64_t tick_{};
};

/// Full speed, slower and to the right, past the other, back.
Encountering dodging() {
  Encountering run;
  run.at(0, 0, 10, 0, 100).at(10, 0, 10, 0, 90);
  run.at(20, 0, 8, 0, 80);       // slower
  run.at(28, 0, 6, 3, 70);       // and aside: 27 degrees
  run.at(34, 3, 5, 2, 60);       // slowest
  run.at(40, 6, 9, 0.2, 42);     // passes
  run.at(50, 6, 10, -0.2, 30);   // turns back: at 6.8 degrees to the goal
  run.at(60, 5, 10, -1.25, 20);  // at the goal again
  return run.at(80, 2.5, 10, -1.25, 10).arrived();
}

TEST(Timeline, FindsEachMomentOfAnAvoidance) {
  const Events events = dodging().events();
  EXPECT_EQ(events.slow_down, 2.0);
  EXPECT_EQ(events.aside, 3.0);
  EXPECT_EQ(events.slowest, 4.0);
  EXPECT_NEAR(events.least_speed, std::hypot(5.0, 2.0), 1e-12);
  EXPECT_EQ(events.pass, 5.0);
  EXPECT_EQ(events.turn_back, 5.0);
  EXPECT_EQ(events.resume, 7.0);
  EXPECT_EQ(events.arrive, 9.0);
}

TEST(Timeline, WhoHasTheOtherToPortKeepsRight) {
  EXPECT_TRUE(dodging().events().keeps_right);
  Encountering other_side;
  other_side.at(0, -6, 10, 0, 60).at(10, -6, 10, 0, 30).at(20, -6, 10, 0, 20).arrived();
  EXPECT_FALSE(other_side.events().keeps_right);
}

TEST(Timeline, GapsAreBetweenSpheres) {
  const Encountering run = dodging();
  // nearest at 5 s: 2 m and 9 m apart; the ship, at (50, 0) at 6 s, is 6 m from the vehicle
  EXPECT_NEAR(run.fleet("vehicle_gap_m"), std::hypot(2.0, 9.0) - 2.0, 1e-12);
  EXPECT_NEAR(run.fleet("ship_gap_m"), 6.0 - 3.0, 1e-12);
  EXPECT_EQ(run.fleet("contact_count"), 0.0);
}

TEST(Timeline, SpheresThatMeetAreAContact) {
  Encountering run;
  run.at(0, 0, 10, 0, 100).at(10, -1.5, 10, 0, 11);
  EXPECT_LT(run.fleet("vehicle_gap_m"), 0.0);
  EXPECT_EQ(run.fleet("contact_count"), 1.0);
}

TEST(Timeline, WhoNeverAvoidsHasNothingToResume) {
  Encountering run;
  run.at(0, 0, 10, 0, 100).at(10, 0, 10, 0, 90).at(20, 0, 10, 0, 80).arrived();
  EXPECT_FALSE(run.events().slow_down);
  EXPECT_FALSE(run.events().aside);
  EXPECT_FALSE(run.events().resume);
  EXPECT_EQ(run.events().arrive, 3.0);
}

TEST(Timeline, WhoDoesNotArriveHasNoArrival) {
  Encountering run;
  run.at(0, 0, 10, 0, 100).at(10, 0, 5, 0, 90);
  EXPECT_FALSE(run.events().arrive);
  EXPECT_FALSE(run.events().resume);
  EXPECT_TRUE(std::isnan(run.fleet("arrive_time_s")));
}

TEST(Timeline, SpeedingUpFromRestIsNotSlowingDown) {
  Encountering run;
  run.at(0, 0, 0, 0, 100).at(1, 0, 2, 0, 90).at(4, 0, 4, 0, 80).at(8, 0, 10, 0, 70).arrived();
  EXPECT_FALSE(run.events().slow_down);
}

}  // namespace
}  // namespace fairway::uuv
