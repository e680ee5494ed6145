// SPDX-License-Identifier: Apache-2.0
// With perfect fixes of every instant a helm does what the simulation's vehicle does, to the bit.
#include <gtest/gtest.h>

#include "fairway/onboard/helm.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

Scenario cube(const std::string& algorithm, std::int32_t steps_per_decision) {
  Scenario scenario = load_scenario(FAIRWAY_SOURCE_DIR "/scenarios/cube20_8.yaml");
  scenario.steps_per_decision = steps_per_decision;
  for (VehicleSpec& vehicle : scenario.vehicles) vehicle.avoider = {.name = algorithm, .path = "avoider"};
  return scenario;
}

/// Beside a simulation, a helm for each of its vehicles.
class Helms {
 public:
  Helms(const Scenario& scenario, const Simulation& simulation) : told_(scenario.vehicles.size()) {
    for (const Agent& agent : simulation.agents()) {
      HelmSetup setup{.id = agent.id,
                      .name = agent.name,
                      .radius = agent.radius,
                      .priority = agent.own_priority,
                      .period = scenario.steps_per_decision * scenario.step_s,
                      .record_period = scenario.step_s,
                      .arrival = scenario.vehicles[number(agent.id)].mission.back().arrival_m,
                      .limits = agent.limits,
                      .steering = agent.steering,
                      .model = agent.model};
      for (const VehicleSpec& other : scenario.vehicles) {
        if (other.id == number(agent.id)) continue;
        setup.team.push_back({.id = VehicleId{other.id},
                              .name = other.name,
                              .radius = other.radius_m,
                              .priority = other.priority,
                              .arrival = other.mission.back().arrival_m});
      }
      helms_.emplace_back(std::move(setup), agent.avoider);
    }
  }

  /// Tells everyone what the instant shows, between look() and act(), and asks for orders.
  void update(const Simulation& simulation) {
    const std::span<const Agent> agents = simulation.agents();
    const double now = simulation.time();
    for (std::size_t i = 0; i < helms_.size(); ++i) {
      for (std::size_t k = 0; k < helms_.size(); ++k) {
        const Fix fix{.time = now, .state = agents[k].estimate};
        const FixVerdict verdict =
            i == k ? helms_[i].own_fix(fix, now) : helms_[i].neighbour_fix(agents[k].id, fix, now);
        ASSERT_EQ(verdict, FixVerdict::accepted) << i << " of " << k << " at " << now;
        if (i != k && told_[k]) helms_[i].neighbour_goal(agents[k].id, told_[k]);
      }
      const Leg* leg = agents[i].mission.leg();
      if (agents[i].mission.phase() == Phase::waiting) helms_[i].keep_position();
      if (is_avoiding(agents[i].mission.phase())) {
        ASSERT_TRUE(helms_[i].go_to(leg->position, leg->speed_mps));
      }
      helms_[i].update(now);
    }
    // a goal is told with the message of the next instant
    for (std::size_t i = 0; i < helms_.size(); ++i) {
      if (is_avoiding(agents[i].mission.phase())) told_[i] = agents[i].mission.leg()->position;
    }
  }

  const Helm& operator[](std::size_t i) const { return helms_[i]; }

 private:
  std::vector<Helm> helms_;
  std::vector<std::optional<Vec3>> told_;
};

bool same(const BodyRequest& a, const BodyRequest& b) {
  return a.surge_mps == b.surge_mps && a.sway_mps == b.sway_mps && a.heave_mps == b.heave_mps &&
         a.yaw_rate_radps == b.yaw_rate_radps;
}

struct Case {
  const char* algorithm;
  std::int32_t steps_per_decision;
  double duration_s;
};

class HelmBesideASimulation : public testing::TestWithParam<Case> {};

TEST_P(HelmBesideASimulation, DecidesAndAsksTheSameToTheBit) {
  const auto [algorithm, steps, duration] = GetParam();
  const Scenario scenario = cube(algorithm, steps);
  Simulation simulation{scenario, builtin_catalogs()};
  Helms helms{scenario, simulation};
  std::int64_t decisions = 0;
  std::int64_t avoided = 0;
  std::int64_t held = 0;
  while (!simulation.is_done() && simulation.time() < duration) {
    simulation.look();
    ASSERT_NO_FATAL_FAILURE(helms.update(simulation));
    std::array<bool, 8> deciding{};
    for (std::size_t i = 0; i < 8; ++i) deciding[i] = simulation.is_deciding(i);
    const double now = simulation.time();
    simulation.act({});
    for (std::size_t i = 0; i < 8; ++i) {
      const Agent& agent = simulation.agents()[i];
      const HelmOrder& order = helms[i].order();
      if (!is_avoiding(agent.mission.phase()) && agent.mission.phase() != Phase::arrived) continue;
      ASSERT_EQ(order.decided, deciding[i]) << agent.name << " at " << now;
      ASSERT_EQ(order.command, agent.command) << agent.name << " at " << now;
      const BodyRequest request = agent.holding ? keep_position(agent.hold, agent.own)
                                                : steer(agent.steering, agent.command, agent.own.yaw);
      ASSERT_TRUE(same(order.request, request)) << agent.name << " at " << now;
      decisions += order.decided ? 1 : 0;
      avoided += order.decided && order.command.mode == Mode::avoid ? 1 : 0;
      held += order.command.mode == Mode::hold ? 1 : 0;
    }
  }
  EXPECT_GT(decisions, 8 * 300 / steps);
  EXPECT_GT(avoided + held, decisions / 10) << "otherwise nothing was put to the test";
}

INSTANTIATE_TEST_SUITE_P(Cube, HelmBesideASimulation,
                         testing::Values(Case{"apf", 1, 600}, Case{"orca3d", 1, 600}, Case{"orca3d", 4, 600},
                                         Case{"orca3d", 20, 600}, Case{"orca3d+stop_and_wait", 1, 600},
                                         Case{"apf+stop_and_wait", 5, 600}, Case{"vo", 1, 90},
                                         Case{"vo", 4, 200}, Case{"avoa", 4, 90}));

TEST(HelmInsteadOfAvoiders, AFleetSteeredByHelmsGoesWhereTheSimulationGoesToTheBit) {
  for (const char* algorithm : {"orca3d", "orca3d+stop_and_wait"}) {
    const Scenario scenario = cube(algorithm, 2);
    Simulation plain{scenario, builtin_catalogs()};
    Simulation steered{scenario, builtin_catalogs()};
    Helms helms{scenario, steered};
    while (!plain.is_done()) {
      plain.step({});
      steered.look();
      ASSERT_NO_FATAL_FAILURE(helms.update(steered));
      for (std::size_t i = 0; i < 8; ++i) steered.order(i, helms[i].order().request);
      steered.act({});
      for (std::size_t i = 0; i < 8; ++i) {
        const VehicleState& a = plain.agents()[i].vehicle.state();
        const VehicleState& b = steered.agents()[i].vehicle.state();
        ASSERT_EQ(a.p_n, b.p_n) << algorithm << ", vehicle " << i << " at " << plain.time();
        ASSERT_EQ(a.q_nb.coeffs(), b.q_nb.coeffs())
            << algorithm << ", vehicle " << i << " at " << plain.time();
      }
    }
    EXPECT_TRUE(steered.is_done());
    for (const Agent& agent : steered.agents()) EXPECT_EQ(agent.mission.phase(), Phase::arrived);
  }
}

}  // namespace
}  // namespace fairway
