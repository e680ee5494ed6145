// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/sim_node.hpp"

#include <cmath>
#include <iostream>

namespace fairway::ros2 {
namespace {

constexpr const char* world = "world";
constexpr std::int32_t fleet_depth =
    100;  // a second or more, of what a listener on a busy machine may be behind
constexpr Qos fleet_qos{true, false, fleet_depth};
constexpr std::chrono::milliseconds goal_patience{200};

}  // namespace

SimNode::SimNode(const bridge::FleetNodeSettings& settings, const GraphOptions& options)
    : duty_{settings}, marks_{duty_.fleet()}, graph_{options}, ports_(duty_.fleet().size()) {
  advertise();
  subscribe();
  graph_.announce();
}

void SimNode::advertise() {
  clock_ = graph_.advertise<Clock>("/clock");
  transforms_ = graph_.advertise<TFMessage>("/tf", fleet_qos);
  markers_ = graph_.advertise<MarkerArray>("/fairway/markers");
  state_ = graph_.advertise<String>("/fairway/state", latched_qos);
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    Port& port = ports_[i];
    port.name = duty_.fleet().vehicle(i).topic;
    port.odometry = graph_.advertise<Odometry>("/" + port.name + "/odometry", fleet_qos);
    port.truth = graph_.advertise<Odometry>("/" + port.name + "/ground_truth", fleet_qos);
    port.goal = graph_.advertise<PoseStamped>("/" + port.name + "/goal", latched_qos);
  }
}

void SimNode::subscribe() {
  const auto when = [this](const std::string& topic, auto act) {
    graph_.subscribe<Bool>("/fairway/" + topic, [act](const Bool& m) {
      if (m.data) act();
    });
  };
  when("pause", [this] { duty_.pause(); });
  when("resume", [this] { duty_.resume(); });
  when("step", [this] { duty_.step_once(); });
  if (duty_.settings().autonomous) return;
  for (std::size_t i = 0; i < ports_.size(); ++i)
    graph_.subscribe<TwistStamped>(
        "/" + ports_[i].name + "/velocity_command",
        [this, i](const TwistStamped& m) {
          const Time& stamp = m.header.stamp;
          duty_.command(i, body_velocity_of(m, duty_.settings().frame),
                        std::int64_t{stamp.sec} * 1000000000 + stamp.nanosec);
        },
        fleet_qos);
}

int SimNode::run(const std::atomic<bool>& stop) {
  stop_ = &stop;
  return duty_.run(*this);
}

void SimNode::show_clock(double time) { clock_.publish(Clock{stamp_of(time)}); }

void SimNode::show_goal(std::size_t vehicle, const Triple& goal, double time) {
  Memory memory;
  ports_[vehicle].goal.publish(goal_of(goal, time, duty_.settings().frame, world, memory));
}

void SimNode::deliver_goals() {
  for (const Port& port : ports_) port.goal.wait_until_delivered(goal_patience);
}

void SimNode::show_navigation() {
  Memory memory;
  for (std::size_t i = 0; i < ports_.size(); ++i)
    ports_[i].odometry.publish(odometry_of(duty_.fleet().vehicle(i).estimate, duty_.settings().frame, world,
                                           ports_[i].name, memory));
}

void SimNode::show_truth() {
  const Frame frame = duty_.settings().frame;
  Memory memory;
  TFMessage transforms{};
  const auto room = memory.room(transforms.transforms, ports_.size());
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const Motion& truth = duty_.fleet().vehicle(i).truth;
    ports_[i].truth.publish(odometry_of(truth, frame, world, ports_[i].name, memory));
    room[i] = transform_of(truth, frame, world, ports_[i].name, memory);
  }
  transforms_.publish(transforms);
  marks_.see(duty_.fleet());
}

void SimNode::show_state(const std::string& json) {
  Memory memory;
  state_.publish(String{memory.text(json)});
}

void SimNode::show_picture() {
  if (markers_.listeners() == 0) return;
  Memory memory;
  markers_.publish(markers_of(marks_.draw(duty_.fleet()), duty_.fleet().time(), duty_.settings().frame, world,
                              "fairway", memory));
}

std::size_t SimNode::listeners(std::size_t vehicle) { return ports_[vehicle].odometry.listeners(); }

bool SimNode::is_steered(std::size_t vehicle) {
  return graph_.sources("/" + ports_[vehicle].name + "/velocity_command") > 0;
}

void SimNode::handle(double longest) {
  if (longest > 0.0)
    graph_.wait(std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(longest)));
  graph_.handle_all();
}

bool SimNode::goes_on() { return !*stop_; }

void SimNode::warn(const std::string& words) { std::cerr << "fairway_sim_ros2: " << words << '\n'; }

}  // namespace fairway::ros2
