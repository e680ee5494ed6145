// SPDX-License-Identifier: Apache-2.0
// The environments of Python, without Python.
#include "fairway/environment/fleet_environment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway::environment {
namespace {

class Environment {
 public:
  explicit Environment(const std::string& name, EnvironmentOptions options = {})
      : Environment{[file = std::string(FAIRWAY_SOURCE_DIR) + "/scenarios/" + name +
                            ".yaml"](std::uint64_t seed) { return load_scenario(file, {}, seed); },
                    std::move(options)} {}
  explicit Environment(const DrawScenario& draw, EnvironmentOptions options = {})
      : environment_{draw(1), draw, catalogs_, std::move(options)} {}

  FleetEnvironment* operator->() { return &environment_; }

  void step_to_goals() {
    actions_.resize(3 * environment_.learners().size());
    environment_.advise(actions_);
    environment_.step(actions_);
  }

 private:
  Catalogs catalogs_ = builtin_catalogs();
  FleetEnvironment environment_;
  std::vector<double> actions_;
};

/// One vehicle under way to the north, as `particulars` of a scenario's vehicle say, among `obstacles`.
DrawScenario north_bound(const std::string& particulars, const std::string& obstacles = "[]") {
  return [=](std::uint64_t seed) {
    return parse_scenario(
        "fairway: 1\nname: alone\nduration_s: 60\nvehicles: [{name: diver, model: kinematic, " + particulars +
            ", mission: [{transit: {position_m: [100, 0, 5], speed_mps: 0.5}}]}]\n" +
            "obstacles: " + obstacles + "\n",
        "alone", {}, seed);
  };
}

std::string refusal_of_advice(const std::string& method, const std::string& yaw_deg,
                              const std::string& obstacles = "[]") {
  Environment environment{north_bound(method +
                                          ", limits: {max_speed_mps: 0.5, max_turn_rate_degps: 5}, start: "
                                          "{position_m: [0, 0, 5], yaw_deg: " +
                                          yaw_deg + "}",
                                      obstacles)};
  environment->reset(1);
  std::vector<double> action(3);
  return refusal_by([&] { environment->advise(std::span{action}); });
}

TEST(FleetEnvironment, allocates_nothing_in_a_step_after_the_first) {
  for (const char* name : {"crossing", "swap_8", "cube20_8", "static_obstacles"}) {
    Environment environment{name};
    environment->reset(1);
    std::vector<double> actions(3 * environment->learners().size(), 0.5);
    std::vector<float> seen(environment->options().observation.size());
    environment->step(actions);
    environment->step(actions);
    const long before = allocation_count();
    for (int i = 0; i < 200; ++i) {
      ASSERT_FALSE(environment->is_over()) << name;
      environment->step(actions);
      for (std::size_t row = 0; row < environment->learners().size(); ++row) environment->observe(row, seen);
    }
    EXPECT_EQ(allocation_count(), before) << name;
  }
}

TEST(FleetEnvironment, begins_when_the_first_learner_is_under_way_or_at_the_very_beginning) {
  Environment deployed{"cube20_8"};
  deployed->reset(1);
  EXPECT_GT(deployed->time(), 10.0);
  EXPECT_EQ(deployed->learners().size(), 8U);
  for (const FleetEnvironment::Learner& learner : deployed->learners()) EXPECT_TRUE(learner.deciding);

  EnvironmentOptions options;
  options.skip_deployment = false;
  Environment whole{"cube20_8", options};
  whole->reset(1);
  EXPECT_EQ(whole->time(), 0.0);
  EXPECT_EQ(whole->learners().size(), 8U);
  for (const FleetEnvironment::Learner& learner : whole->learners()) EXPECT_FALSE(learner.deciding);
  for (const FleetEnvironment::Learner& learner : whole->learners())
    EXPECT_EQ(learner.phase, Phase::deploying);
}

TEST(FleetEnvironment, follows_its_advice_to_the_end) {
  Environment environment{"swap_8"};
  environment->reset(1);
  while (!environment->is_over()) environment.step_to_goals();
  EXPECT_TRUE(environment->terminated());
  EXPECT_FALSE(environment->truncated());
  EXPECT_EQ(environment->learners().size(), 8U);
  for (const FleetEnvironment::Learner& learner : environment->learners()) EXPECT_FALSE(learner.collided);
}

TEST(FleetEnvironment, gives_no_advice_that_leaves_out_a_turn_rate_or_a_heading) {
  EXPECT_EQ(
      refusal_of_advice("avoider: orca2d, tracking: auto", "90"),
      "the avoider of diver commands a turn rate, which no action says: take advised_commands() instead");
  EXPECT_EQ(refusal_of_advice("avoider: vo, tracking: raw", "180",
                              "[{sphere: {position_m: [8, 0, 5], radius_m: 2}}]"),
            "the avoider of diver commands a heading, which no action says: take advised_commands() instead");
}

TEST(FleetEnvironment, gives_advice_where_the_velocity_says_the_turn_rate_too) {
  EXPECT_EQ(refusal_of_advice("avoider: orca2d, tracking: auto", "0"), "accepted");
}

TEST(FleetEnvironment, scales_actions_by_the_speed_limit_that_is_in_force_in_the_episode) {
  Environment environment{
      north_bound("avoider: direct, tracking: raw, limits: {max_speed_mps: {uniform: [0.1, 0.4]}}, "
                  "start: {position_m: [0, 0, 5]}")};
  std::vector<double> limits;
  for (const std::uint64_t seed : {1, 2, 3}) {
    environment->reset(seed);
    limits.push_back(environment->situation(0)->limits.max_speed);
    EXPECT_EQ(environment->learners()[0].max_speed, limits.back());
    for (int i = 0; i < 400; ++i) environment->step(std::vector{0.5, 0.0, 0.0});
    EXPECT_NEAR(environment->vehicles()[0].vehicle.state().v_n().x(), 0.5 * limits.back(), 1e-3);
  }
  EXPECT_GT(std::abs(limits[1] - limits[0]), 0.01);
}

TEST(FleetEnvironment, advises_who_may_not_go_at_all_to_do_nothing) {
  const auto draw = [](std::uint64_t seed) {
    return load_scenario(std::string(FAIRWAY_SOURCE_DIR) + "/scenarios/crossing.yaml",
                         {{"vehicles[0].limits.max_speed_mps", "0"}}, seed);
  };
  const Catalogs catalogs = builtin_catalogs();
  FleetEnvironment environment{draw(1), draw, catalogs, {}};
  environment.reset(1);
  std::vector<double> actions(3 * environment.learners().size());
  environment.advise(std::span{actions});
  EXPECT_THAT(actions, testing::Each(testing::AllOf(testing::Ge(-1.0), testing::Le(1.0))));
  EXPECT_EQ(actions[0], 0.0);
}

TEST(FleetEnvironment, says_that_a_mover_has_come_upon_one_who_keeps_its_position) {
  Environment environment{[](std::uint64_t seed) {
    return parse_scenario(
        "fairway: 1\nname: moored\nduration_s: 60\nvehicles:\n"
        "  - {model: kinematic, avoider: direct, start: {position_m: [0, 0, 5]}, mission: "
        "[{transit: {position_m: [20, 0, 5], speed_mps: 0.5}}]}\n"
        "  - {model: kinematic, avoider: direct, start: {position_m: [10, 1, 5]}, mission: "
        "[{keep_position: {duration_s: 60}}]}\n",
        "moored", {}, seed);
  }};
  environment->reset(1);
  while (!environment->is_over()) environment.step_to_goals();
  EXPECT_TRUE(environment->terminated());
  EXPECT_TRUE(environment->learners()[0].collided);
  EXPECT_LE(environment->learners()[0].separation, 3.0);
  EXPECT_FALSE(environment->learners()[1].collided) << "it does not go";
}

TEST(FleetEnvironment, refuses_a_scenario_in_which_its_learner_is_never_under_way) {
  const auto draw = [](std::uint64_t seed) {
    return parse_scenario(
        "fairway: 1\nname: still\nsummary: nobody goes\nduration_s: 5\n"
        "vehicles: [{model: kinematic, avoider: direct, start: {position_m: [0, 0, 5]}, mission: "
        "[{keep_position: {duration_s: 60}}]}]\n",
        "still", {}, seed);
  };
  const Catalogs catalogs = builtin_catalogs();
  FleetEnvironment environment{draw(1), draw, catalogs, {}};
  EXPECT_THAT(
      [&] { environment.reset(1); },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("no learner of still is ever under way")));
}

TEST(Observation, of_headings_axes_is_turned_by_the_yaw) {
  const Vec3 east{0.0, 2.0, 1.0};
  const double to_the_east = 0.5 * pi;
  EXPECT_TRUE(to_axes(Axes::heading, to_the_east, east).isApprox(Vec3{2.0, 0.0, 1.0}));
  EXPECT_TRUE(from_axes(Axes::heading, to_the_east, Vec3{2.0, 0.0, 1.0}).isApprox(east));
  EXPECT_EQ(to_axes(Axes::ned, to_the_east, east), east);
}

TEST(Observation, keeps_the_nearest_obstacles_whatever_their_order) {
  std::vector<Obstacle> obstacles;
  for (const double north : {9.0, 3.0, 7.0, 5.0, 1.5})
    obstacles.push_back({.kind = Obstacle::Kind::sphere, .position = {north, 0, 0}, .radius = 1.0});
  const Ownship own;
  const ObservationShape shape{.tracks = 0, .obstacles = 3};
  std::vector<float> seen(shape.size());
  observe(shape, {.own = own, .goal = {}, .tracks = {}, .obstacles = obstacles}, seen);
  EXPECT_EQ(seen.size(), 24U);
  EXPECT_EQ(shape.names().size(), seen.size());
  EXPECT_FLOAT_EQ(seen[13], 0.5F);
  EXPECT_FLOAT_EQ(seen[17], 2.0F);
  EXPECT_FLOAT_EQ(seen[21], 4.0F);
}

TEST(Reward, nearness_falls_from_a_collision_to_nothing) {
  EXPECT_EQ(nearness(3.0, 100.0, 3.0, 6.0), 1.0);
  EXPECT_EQ(nearness(4.5, 100.0, 3.0, 6.0), 0.5);
  EXPECT_EQ(nearness(7.0, 100.0, 3.0, 6.0), 0.0);
  EXPECT_EQ(nearness(7.0, 0.0, 3.0, 6.0), 1.0);
  EXPECT_EQ(nearness(1.0, 100.0, 3.0, 0.0), 0.0);
}

}  // namespace
}  // namespace fairway::environment
