// SPDX-License-Identifier: Apache-2.0
// What of each vehicle is kept of an instant, and shown to whoever looks at the run.
#include <algorithm>
#include <span>

#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

/// The wrench of the actuators at their present state; zero where they do not push.
Wrench wrench_of(const Vehicle& vehicle) {
  const Propulsion* propulsion = vehicle.propulsion();
  const Eigen::VectorXd& actuators = vehicle.actuator_state();
  if (propulsion == nullptr || actuators.size() == 0) return Wrench::Zero();
  Wrench tau = propulsion->effectiveness.col(0) * actuators[0];
  for (Eigen::Index i = 1; i < actuators.size(); ++i) tau += propulsion->effectiveness.col(i) * actuators[i];
  return tau;
}

}  // namespace

void Simulation::record(std::size_t index, Hand& /*hand*/) {
  if (!watched_) return;
  const Agent& agent = agents_[index];
  const Leg* leg = agent.mission.leg();
  const Eigen::VectorXd& actuators = agent.vehicle.actuator_state();
  VehicleFrame& frame = frame_[index];
  frame.id = agent.ship().id;
  frame.state = agent.vehicle.state();
  frame.command = agent.pilot.command();
  frame.phase = agent.mission.phase();
  frame.goal = leg != nullptr ? leg->position : agent.own.position;
  frame.goal_speed = leg != nullptr ? leg->speed_mps : 0.0;
  frame.actuators = {actuators.data(), static_cast<std::size_t>(actuators.size())};
  frame.power = agent.vehicle.power();
  frame.wrench = wrench_of(agent.vehicle);
  frame.tracks = keeping_ ? std::span<const Track>{kept_[index].tracks} : std::span<const Track>{};
  frame.echoes = agent.lookout.echoes();
  frame.strokes = drawings_.empty() ? std::span<const Stroke>{} : drawings_[index].strokes();
}

/// What methods have said at this tick, where any of them has something to say.
void Simulation::collect_words() {
  words_.clear();
  if (std::ranges::none_of(hands_, &Hand::anyone_speaks)) return;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Message& said = mailbox_[i];
    if (said.told && !said.speech.empty() && exchange_.has_spoken(i, tick_))
      words_.push_back({static_cast<std::uint32_t>(i), time(), said.speech});
  }
}

void Simulation::show(std::span<FrameSink* const> sinks) {
  if (!watched_) return;
  flights_.clear();
  if (showing_) exchange_.add_under_way(flights_);
  collect_words();
  const Frame frame{tick_, time(), period_, frame_, flights_, words_, crew_.get()};
  if (timing_stages_) hands_[0].stages.begin();
  for (FrameSink* sink : sinks) sink->write(frame);
  if (timing_stages_) hands_[0].stages.finish(Stage::record);
}

}  // namespace fairway
