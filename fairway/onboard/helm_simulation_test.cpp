// SPDX-License-Identifier: Apache-2.0
// With perfect fixes of every instant a helm does what the simulation's vehicle does, to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fairway/onboard/helm.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

Scenario cube(const std::string& algorithm, std::int32_t steps_per_decision) {
  Scenario scenario = load_scenario(FAIRWAY_SOURCE_DIR "/scenarios/cube20_8.yaml");
  scenario.steps_per_decision = steps_per_decision;
  for (VehicleSpec& vehicle : scenario.vehicles)
    vehicle.avoider = Choice{.name = algorithm, .path = "avoider"};
  return scenario;
}

/// Beside a simulation, a helm for each of its vehicles. Their own fixes carry the velocity through the water
/// if they measure it.
class Helms {
 public:
  Helms(const Scenario& scenario, const Simulation& simulation, bool measure_water = true)
      : told_(scenario.vehicles.size()), measure_water_{measure_water} {
    for (const Agent& agent : simulation.agents()) {
      HelmSetup setup{.record_period = scenario.step_s,
                      .arrival = scenario.vehicles[number(agent.ship().id)].mission.back().arrival_m};
      for (const VehicleSpec& other : scenario.vehicles) {
        if (other.id == number(agent.ship().id)) continue;
        setup.team.push_back({.id = VehicleId{other.id},
                              .name = other.name,
                              .radius = other.radius_m,
                              .priority = other.priority,
                              .arrival = other.mission.back().arrival_m});
      }
      helms_.emplace_back(agent.pilot, std::move(setup), agent.avoider);
    }
  }

  /// Tells everyone what the instant shows, between look() and act(), and asks for orders.
  void update(const Simulation& simulation) {
    const std::span<const Agent> agents = simulation.agents();
    const double now = simulation.time();
    for (std::size_t i = 0; i < helms_.size(); ++i) {
      for (std::size_t k = 0; k < helms_.size(); ++k) {
        Fix fix{.time = now, .state = agents[k].estimate(), .position_sigma = agents[k].own.position_sigma};
        if (measure_water_)
          fix.through_water_b = fix.state.v_b - fix.state.q_nb.conjugate() * agents[k].estimated_current();
        const VehicleId id = agents[k].ship().id;
        const FixVerdict verdict =
            i == k ? helms_[i].own_fix(fix, now) : helms_[i].neighbour_fix(id, fix, now);
        ASSERT_EQ(verdict, FixVerdict::accepted) << i << " of " << k << " at " << now;
        if (i != k && told_[k]) helms_[i].neighbour_goal(id, told_[k]);
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

  /// Every helm's order, carried out by the simulation.
  void give_orders(Simulation& simulation) const {
    for (std::size_t i = 0; i < helms_.size(); ++i)
      simulation.order(i, helms_[i].order().command, helms_[i].order().request);
  }

  const Helm& operator[](std::size_t i) const { return helms_[i]; }

 private:
  std::vector<Helm> helms_;
  std::vector<std::optional<Vec3>> told_;
  bool measure_water_;
};

struct Case {
  const char* algorithm;
  std::int32_t steps_per_decision;
  double duration_s;
  const char* navigation = "perfect";
};

class HelmBesideASimulation : public testing::TestWithParam<Case> {};

TEST_P(HelmBesideASimulation, DecidesAndAsksTheSameToTheBit) {
  const auto [algorithm, steps, duration, navigation] = GetParam();
  Scenario scenario = cube(algorithm, steps);
  scenario.navigation.name = navigation;
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
      ASSERT_EQ(order.decided, deciding[i]) << agent.ship().name << " at " << now;
      ASSERT_EQ(order.command, agent.pilot.command()) << agent.ship().name << " at " << now;
      const BodyRequest request = agent.pilot.request(agent.own, agent.estimated_current());
      ASSERT_TRUE(order.request == request) << agent.ship().name << " at " << now;
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
                                         Case{"vo", 4, 200}, Case{"avoa", 4, 90},
                                         Case{"orca3d+trackable", 4, 200, "drifting"}));

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
      helms.give_orders(steered);
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

/// A vehicle that cannot stop, on its way across a current whose estimate on board has errors of so much.
Scenario crossing(double current_sigma_mps) {
  Scenario scenario = parse_scenario(
      "fairway: 1\nname: crossing\nduration_s: 400\nwater: {current_mps: [-0.1, -0.3, 0]}\nvehicles:\n"
      "  - model: remus100\n    avoider: direct\n    limits: {max_speed_mps: 1.5}\n"
      "    start: {position_m: [0, 0, 20], speed_mps: 1.5}\n"
      "    mission: [transit: {position_m: [400, 0, 20], speed_mps: 1.5, arrival_m: 5}]\n",
      "crossing");
  scenario.navigation = {.name = "drifting",
                         .params = {{"position_sigma_m", 0.0},
                                    {"depth_sigma_m", 0.0},
                                    {"velocity_sigma_mps", 0.0},
                                    {"heading_sigma_deg", 0.0},
                                    {"current_sigma_mps", current_sigma_mps}},
                         .path = "navigation"};
  return scenario;
}

/// The only vehicle's positions, until it arrives, steered by its own pilot or by a helm.
std::vector<Vec3> track_of(const Scenario& scenario, bool by_helm, bool measure_water = true) {
  Simulation simulation{scenario, builtin_catalogs()};
  Helms helms{scenario, simulation, measure_water};
  std::vector<Vec3> track;
  while (!simulation.is_done()) {
    simulation.look();
    helms.update(simulation);
    if (by_helm) helms.give_orders(simulation);
    simulation.act({});
    track.push_back(simulation.agents()[0].vehicle.state().p_n);
  }
  EXPECT_EQ(simulation.agents()[0].mission.phase(), Phase::arrived);
  return track;
}

/// The farthest that two tracks are apart at one instant [m].
double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    farthest = std::fmax(farthest, (a[i] - b[i]).norm());
  return farthest;
}

TEST(HelmInACurrent, AVehicleThatCannotStopMakesTheSimulationsTrackByItsEstimate) {
  const std::vector<Vec3> known = track_of(crossing(0.0), false);
  const std::vector<Vec3> biased = track_of(crossing(0.1), false);
  EXPECT_LT(apart(known, track_of(crossing(0.0), true)), 1e-9);  // measured 0, and so is the next
  EXPECT_LT(apart(biased, track_of(crossing(0.1), true)), 1e-9);
  EXPECT_GT(apart(known, biased), 20.0) << "otherwise the bias was not put to the test";  // 39.8

  // without the velocity through the water it is set down by the current
  EXPECT_GT(apart(known, track_of(crossing(0.0), true, false)), 20.0);  // 39.4
}

}  // namespace
}  // namespace fairway
