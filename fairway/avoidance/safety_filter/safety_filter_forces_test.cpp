// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/hard_switching/testing/transport.hpp"
#include "fairway/avoidance/safety_filter/safety_filter.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/avoidance/wall_following/wall_following.hpp"

namespace fairway {
namespace {

using transport::Course;
using transport::Voyage;

/// Wall following whose sensors see nothing is the printed go-to-goal controller.
Avoider around_go_to_goal(WallFollowing::Params inner, SafetyFilter::Params params) {
  inner.sensor_range_m = 0.0;
  return Avoider{SafetyFilter{params}, Avoider{WallFollowing{inner}}};
}

/// Table 6.
WallFollowing::Params among_four() {
  return {.goal_gain_hz = 0.1,
          .goal_surge_kp_kgps = 20.0,
          .goal_surge_kd_kg = 50.0,
          .goal_sway_kp_kgps = 30.0,
          .goal_sway_kd_kg = 100.0};
}

/// The same gains on both axes, straight at the middle of an obstacle of 5 m.
Voyage straight_at_the_middle(double sidestep_ratio, bool coriolis = false) {
  Course course;
  course.obstacles = {transport::sphere(50, 50, 5)};
  course.plant.coriolis = coriolis;
  course.duration = 500.0;
  return transport::run(around_go_to_goal({.goal_sway_kp_kgps = 3.0, .goal_sway_kd_kg = 5.0},
                                          {.sidestep_ratio = sidestep_ratio}),
                        course);
}

TEST(SafetyFilterOfForces, ClearsOneObstacleByTheBarrierAndNoMore) {
  // the barrier is 20 + 3.2 + 0.5 = 23.7 m from the centre; unfiltered the way leads 16 m from it
  const Voyage run = transport::run(around_go_to_goal({}, {.margin_m = 0.5}), Course{});
  EXPECT_GE(run.clearance + 20.0, 23.7);
  EXPECT_LT(run.clearance + 20.0, 24.1);  // measured 24.00
  EXPECT_EQ(run.infeasible, 0);
  EXPECT_LE(run.greatest.maxCoeff(), 250.0 + 1e-9);  // what the inner controller asks for at the start
  EXPECT_GE(run.least.minCoeff(), -250.0);           // measured -211 N
  EXPECT_NEAR(run.arrival, 296.7, 1.0);              // 273 s with printed wall following
  EXPECT_NEAR(run.energy, 18.9e3, 0.2e3);            // 25.9 kJ with printed wall following
  EXPECT_NEAR(run.displacement(), 141.4, 0.5);
}

TEST(SafetyFilterOfForces, ClearsFourObstaclesByTheBarrierAndNoMore) {
  // 1 + 3.2 + 0.3 = 4.5 m from each centre
  const Voyage soft = transport::run(around_go_to_goal(among_four(), {.margin_m = 0.3}), Course::of_four({}));
  EXPECT_GE(soft.clearance + 1.0, 4.5);
  EXPECT_LT(soft.clearance + 1.0, 4.7);  // measured 4.68
  EXPECT_EQ(soft.infeasible, 0);
  EXPECT_NEAR(soft.arrival, 219.1, 1.0);     // 228 s with printed wall following
  EXPECT_NEAR(soft.energy, 1.82e3, 0.03e3);  // 2.80 kJ with printed wall following

  const SafetyFilter::Params stiff{.k1_hz = 2.0, .k2_hz = 2.0, .margin_m = 0.3, .authority_ratio = 1.0};
  const Voyage hard = transport::run(around_go_to_goal(among_four(), stiff), Course::of_four({}));
  EXPECT_NEAR(hard.clearance + 1.0, 4.5, 1e-3);  // measured 4.5003
  EXPECT_EQ(hard.infeasible, 0);
}

TEST(SafetyFilterOfForces, HeadingStraightAtTheMiddleEndsAtTheBarrierWithoutASidestep) {
  const Voyage run = straight_at_the_middle(0.0);
  EXPECT_LT(run.arrival, 0.0);
  EXPECT_NEAR(run.clearance, 3.7, 1e-3);  // measured 3.7000: radius 3.2 and margin 0.5
}

TEST(SafetyFilterOfForces, TheSidestepLeadsRoundWithAndWithoutCoriolisTerms) {
  for (const bool coriolis : {false, true}) {
    const Voyage run = straight_at_the_middle(0.2, coriolis);
    EXPECT_NEAR(run.arrival, 363.4, 2.0);
    EXPECT_NEAR(run.clearance, 3.7, 1e-3);
    EXPECT_EQ(run.infeasible, 0);
  }
}

TEST(SafetyFilterOfForces, TooStiffForTheForcesItCountsWhatCannotBeKept) {
  // gains of 2 / s let it come in too fast for 770 N
  const SafetyFilter::Params stiff{.k1_hz = 2.0, .k2_hz = 2.0, .authority_ratio = 1.0, .activation_m = 60.0};
  const Voyage run = transport::run(around_go_to_goal({}, stiff), Course{});
  EXPECT_GT(run.infeasible, 100);  // measured 172 decisions of 0.02 s
  EXPECT_LE(run.greatest.head<2>().maxCoeff(), 770.0 * (1 + 1e-9));
  EXPECT_GE(run.least.head<2>().minCoeff(), -770.0 * (1 + 1e-9));
  EXPECT_GT(run.clearance + 20.0, 23.2);  // measured 23.37: nothing is touched for all that
}

Command filtered(const Course& course, const transport::State& x, const OnboardModel& model) {
  Wrench wrench;
  wrench << 600.0, -50.0, 7.0, 8.0, 9.0, 123.0;
  Avoider avoider{SafetyFilter{{}}, Avoider{encounters::Always{{}, {.wrench = wrench}}}};
  return avoider.decide(course.situation(x, 0.0, model));
}

TEST(SafetyFilterOfForces, LeavesTheOtherAxesAsTheyWere) {
  transport::State x = transport::State::Zero();
  x << 24.0, 38.0, 0.4, 0.3, 0.1, 0.05;
  const Course course;
  const Command command = filtered(course, x, course.plant.onboard());
  EXPECT_EQ(command.mode, Mode::avoid);
  ASSERT_TRUE(command.wrench.has_value());
  EXPECT_LT((*command.wrench)[0], 500.0);
  EXPECT_EQ((*command.wrench)[2], 7.0);
  EXPECT_EQ((*command.wrench)[3], 8.0);
  EXPECT_EQ((*command.wrench)[4], 9.0);
  EXPECT_EQ((*command.wrench)[5], 123.0);
}

TEST(SafetyFilterOfForces, AnAxisWithoutActuatorsIsNotAsked) {
  transport::State x = transport::State::Zero();
  x << 24.0, 38.0, 0.4, 0.3, 0.1, 0.0;
  const Course course;
  OnboardModel model = course.plant.onboard();
  model.least[1] = model.greatest[1] = 0.0;
  const Command command = filtered(course, x, model);
  EXPECT_NEAR((*command.wrench)[1], 0.0, 1e-9);
  EXPECT_LT((*command.wrench)[0], 500.0);
}

/// Follows velocities with a proportional controller of surge and sway, clipped to the forces.
Wrench forces_after(const Command& command, const Course& course, const transport::State& x) {
  const OnboardModel model = course.plant.onboard();
  Wrench tau = Wrench::Zero();
  for (int i = 0; i < 2; ++i) {
    const double wanted = course.plant.damping * command.velocity[i] +
                          course.plant.mass / 1.5 * (command.velocity[i] - x[3 + i]);
    tau[i] = std::clamp(wanted, model.least[i], model.greatest[i]);
  }
  return tau;
}

TEST(SafetyFilterOfForces, VelocitiesOfAVehicleWithThrustersAreFilteredWithinItsForcesToo) {
  const Avoider avoider{SafetyFilter{{}}, Avoider{Direct{{}}}};
  const Voyage one = transport::run(avoider, Course{}, forces_after);
  EXPECT_GT(one.clearance, 3.7);  // measured 3.74, at 1 m/s
  EXPECT_NEAR(one.arrival, 170.6, 1.0);
  EXPECT_EQ(one.infeasible, 0);
  const Voyage four = transport::run(avoider, Course::of_four({}), forces_after);
  EXPECT_GT(four.clearance, 3.7);  // measured 3.99
  EXPECT_NEAR(four.arrival, 60.3, 1.0);
  EXPECT_EQ(four.infeasible, 0);
}

}  // namespace
}  // namespace fairway
