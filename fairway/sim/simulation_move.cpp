// SPDX-License-Identifier: Apache-2.0
// How vehicles carry out what was decided, and move.
#include <span>

#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// What a request over ground is through the water.
BodyRequest through_water(const BodyRequest& over_ground, const Vec3& current_b) {
  return {.surge_mps = over_ground.surge_mps - current_b.x(),
          .sway_mps = over_ground.sway_mps - current_b.y(),
          .heave_mps = over_ground.heave_mps - current_b.z(),
          .yaw_rate_radps = over_ground.yaw_rate_radps,
          .through_water = true};
}

}  // namespace

void Simulation::control(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  const Command& command = agent.pilot.command();
  notice(index, why_impossible(command), tick_, hand);
  const ActuatorValues demand = demanded(index, hand);
  notice(index, why_impossible(demand), tick_, hand);
  agent.demand = demand;
  if (agent.has_failed(FailureKind::stops, time())) agent.demand.setZero();
}

ActuatorValues Simulation::demanded(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  const bool avoids = is_avoiding(agent.mission.phase());
  const Order* order = order_of(index);
  const bool steered_from_outside = avoids && order != nullptr && order->request;
  const Command& command = agent.pilot.command();
  if (command.wrench && !steered_from_outside) {
    if (const std::optional<ActuatorValues> pushed = agent.autopilot.push(*command.wrench)) {
      agent.pilot.end_hold();
      return *pushed;
    }
  }
  const BodyRequest request = steered_from_outside
                                  ? *order->request
                                  : agent.pilot.request(agent.own, agent.estimated_current(), avoids);
  notice(index, why_impossible(request), tick_, hand);

  // the vehicle's own controller works on velocities through the water
  const VehicleState& x = agent.vehicle.state();
  const bool flows = agent.current != Vec3::Zero();
  const Vec3 current_b = flows ? Vec3{x.q_nb.conjugate() * agent.current} : Vec3{Vec3::Zero()};
  return agent.autopilot.control(request.through_water ? request : through_water(request, current_b),
                                 x.v_b - current_b, x.omega_b, period_, x.q_nb);
}

void Simulation::move(std::size_t index, Hand& hand) {
  Agent& agent = agents_[index];
  Convoy& convoy = hand.convoy;
  convoy.members[convoy.count] = index;
  convoy.errands[convoy.count++] = {&agent.vehicle, &agent.demand,
                                    sea_.water_halfway(agent.vehicle.state(), time(), period_)};
  if (convoy.count == Convoy::most) move_together(hand);
}

void Simulation::move_together(Hand& hand) {
  Convoy& convoy = hand.convoy;
  Vehicle::step_many(std::span{convoy.errands}.first(convoy.count), period_);
  for (const std::size_t index : std::span{convoy.members}.first(convoy.count))
    notice(index, why_impossible(agents_[index].vehicle.state()), next(tick_), hand);
  convoy.count = 0;
}

}  // namespace fairway
