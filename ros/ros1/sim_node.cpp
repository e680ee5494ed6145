// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/sim_node.hpp"

#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "ros/ros1/conversions.hpp"

namespace fairway::ros1 {
namespace {

using bridge::FleetVehicle;

constexpr const char* world = "world";
constexpr double tending_period_s = 0.1;  // of the state, and of the clock while it stands still
constexpr double goal_head_start_s = 0.02;
constexpr double lag_forgiven_s = 0.25;  // behind by more, the clock begins anew

double seconds_between(const ros::SteadyTime& from, const ros::SteadyTime& to) { return (to - from).toSec(); }

const char* words_of(bridge::Alert alert) {
  switch (alert) {
    case bridge::Alert::clear:
      return "clear";
    case bridge::Alert::detected:
      return "detected";
    case bridge::Alert::collided:
      break;
  }
  return "collided";
}

}  // namespace

SimNode::SimNode(SimSettings settings)
    : settings_{std::move(settings)},
      fleet_{settings_.fleet},
      marks_{fleet_, settings_.frame, world},
      ports_(fleet_.size()),
      paused_{settings_.paused} {
  node_.setCallbackQueue(&queue_);
  advertise();
}

void SimNode::advertise() {
  clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
  transforms_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  markers_ = node_.advertise<visualization_msgs::MarkerArray>("/fairway/markers", 2);
  state_ = node_.advertise<std_msgs::String>("/fairway/state", 10, true);
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    Port& port = ports_[i];
    const std::string name = "/" + fleet_.vehicle(i).topic;
    port.odometry = node_.advertise<nav_msgs::Odometry>(name + "/odometry", 100);
    port.truth = node_.advertise<nav_msgs::Odometry>(name + "/ground_truth", 100);
    port.goal = node_.advertise<geometry_msgs::PoseStamped>(name + "/goal", 10, true);
    if (settings_.fleet.autonomous) continue;
    const auto listen = [this, i](const geometry_msgs::TwistStampedConstPtr& twist) {
      on_command(i, *twist);
    };
    port.command = node_.subscribe<geometry_msgs::TwistStamped>(name + "/velocity_command", 100, listen,
                                                                nullptr, ros::TransportHints().tcpNoDelay());
  }
  offer_service("pause", &SimNode::pause);
  offer_service("resume", &SimNode::resume);
  offer_service("step", &SimNode::step_once);
  // a new master has forgotten that time is the simulation's
  const auto set_time = [] { ros::param::set("/use_sim_time", true); };
  set_time();
  std::vector<std::string> services;
  for (const ros::ServiceServer& service : services_) services.push_back(service.getService());
  watch_ = std::make_unique<MasterWatch>(services, set_time);
}

void SimNode::offer_service(const std::string& name, bool (SimNode::*answer)(std_srvs::Trigger::Response&)) {
  using Trigger = std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> call =
      [this, answer](Trigger::Request&, Trigger::Response& response) { return (this->*answer)(response); };
  services_.push_back(node_.advertiseService("/fairway/" + name, call));
}

bool SimNode::pause(std_srvs::Trigger::Response& response) {
  paused_ = true;
  response.success = 1U;
  response.message = "paused";
  return true;
}

bool SimNode::resume(std_srvs::Trigger::Response& response) {
  paused_ = false;
  response.success = static_cast<std::uint8_t>(!fleet_.is_done());
  response.message = fleet_.is_done() ? "the run is over" : "resumed";
  return true;
}

bool SimNode::step_once(std_srvs::Trigger::Response& response) {
  const bool can = paused_ && !fleet_.is_done();
  if (can) ++steps_;
  response.success = static_cast<std::uint8_t>(can);
  response.message = fleet_.is_done() ? "the run is over" : can ? "stepped" : "it is not paused";
  return true;
}

void SimNode::on_command(std::size_t index, const geometry_msgs::TwistStamped& twist) {
  const ros::Time& stamp = twist.header.stamp;
  const double age = std::abs(seconds_of(stamp) - fleet_.time());
  const bool is_of_now =
      settings_.lockstep ? stamp == now_ : stamp.isZero() || age <= settings_.fleet.command_timeout_s;
  const bridge::BodyVelocity velocity = body_velocity_of(twist, settings_.frame);
  const bool is_finite = std::isfinite(velocity.surge_mps) && std::isfinite(velocity.sway_mps) &&
                         std::isfinite(velocity.heave_mps) && std::isfinite(velocity.yaw_rate_radps);
  if (!is_of_now || !is_finite) {
    ++refused_;
    return;
  }
  if (fleet_.command(index, velocity)) ports_[index].answered = stamp;
}

/// What comes in is handled for so long.
void SimNode::spin(double seconds) {
  const Steady end = Steady::now() + ros::WallDuration(std::fmax(seconds, 0.0));
  do {
    const double rest = std::fmin(seconds_between(Steady::now(), end), tending_period_s);
    queue_.callAvailable(ros::WallDuration(std::fmax(rest, 0.0)));
    tend();
  } while (ros::ok() && Steady::now() < end);
}

/// The state and the picture, at their own pace whatever the run does.
void SimNode::tend() {
  const Steady now = Steady::now();
  if (seconds_between(tended_, now) >= tending_period_s) {
    tended_ = now;
    rosgraph_msgs::Clock clock;
    clock.clock = now_;
    clock_.publish(clock);
    show_state();
  }
  const bool is_due =
      settings_.marker_rate_hz > 0.0 && seconds_between(drawn_, now) >= 1.0 / settings_.marker_rate_hz;
  if (!is_due || markers_.getNumSubscribers() == 0) return;
  drawn_ = now;
  markers_.publish(marks_.draw(fleet_));
}

void SimNode::await_subscribers() {
  const auto has_all = [this](const Port& port) {
    const bool is_steered = settings_.fleet.autonomous || port.command.getNumPublishers() > 0;
    return port.odometry.getNumSubscribers() >= settings_.wait_for_subscribers && is_steered;
  };
  while (ros::ok() && settings_.wait_for_subscribers > 0 &&
         !std::all_of(ports_.begin(), ports_.end(), has_all))
    spin(0.05);
}

bool SimNode::show_goals() {
  bool is_new = false;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const std::optional<Triple>& goal = fleet_.vehicle(i).goal_n;
    Port& port = ports_[i];
    if (goal && goal != port.shown_goal) {
      port.goal.publish(goal_of(*goal, fleet_.time(), settings_.frame, world));
      is_new = true;
    }
    port.shown_goal = goal;
  }
  return is_new;
}

void SimNode::show_instant() {
  now_ = stamp_of(fleet_.time());
  marks_.see(fleet_);
  rosgraph_msgs::Clock clock;
  clock.clock = now_;
  clock_.publish(clock);

  // a goal and the odometry travel by different connections: who answers this very instant should know both
  if (show_goals() && settings_.lockstep) ros::WallDuration(goal_head_start_s).sleep();

  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const FleetVehicle& vehicle = fleet_.vehicle(i);
    ports_[i].odometry.publish(odometry_of(vehicle.estimate, settings_.frame, world, vehicle.topic));
  }
  tf2_msgs::TFMessage transforms;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const FleetVehicle& vehicle = fleet_.vehicle(i);
    ports_[i].truth.publish(odometry_of(vehicle.truth, settings_.frame, world, vehicle.topic));
    transforms.transforms.push_back(transform_of(vehicle.truth, settings_.frame, world, vehicle.topic));
  }
  transforms_.publish(transforms);

  std::string telling = std::to_string(fleet_.collisions());
  for (std::size_t i = 0; i < ports_.size(); ++i)
    telling += fleet_.vehicle(i).phase + (fleet_.vehicle(i).holding ? "!" : "");
  if (std::exchange(shown_, telling) != telling) show_state();
}

bool SimNode::all_answered() const {
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    if (fleet_.vehicle(i).wants_command && ports_[i].answered != now_) return false;
  }
  return true;
}

std::string SimNode::missing() const {
  std::string names;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    if (fleet_.vehicle(i).wants_command && ports_[i].answered != now_)
      names += (names.empty() ? "" : ", ") + fleet_.vehicle(i).name;
  }
  return names;
}

void SimNode::await_permission() {
  if (!paused_) return;
  while (ros::ok() && paused_ && steps_ == 0) spin(0.05);
  if (steps_ > 0) --steps_;
  anchor_ = Steady::now();
  anchor_time_ = fleet_.time();
}

void SimNode::await_commands() {
  const Steady end = Steady::now() + ros::WallDuration(settings_.lockstep_timeout_s);
  while (ros::ok() && !all_answered()) {
    const double rest = seconds_between(Steady::now(), end);
    if (rest <= 0.0) {
      if (missed_++ == 0)
        ROS_WARN_STREAM("no command of " << missing() << " at " << fleet_.time() << " s; the run goes on");
      return;
    }
    queue_.callAvailable(ros::WallDuration(std::fmin(rest, tending_period_s)));
    tend();
  }
}

/// Until the wall clock has come as far as the next instant.
void SimNode::await_clock() {
  if (settings_.speed <= 0.0) {
    spin(0.0);
    return;
  }
  const double due = (fleet_.time() + fleet_.step_period() - anchor_time_) / settings_.speed;
  const double rest = due - seconds_between(anchor_, Steady::now());
  spin(rest);
  if (rest < -lag_forgiven_s) {
    behind_s_ -= rest;
    anchor_ = Steady::now();
    anchor_time_ = fleet_.time() + fleet_.step_period();
  }
}

void SimNode::await_turn() {
  await_permission();
  if (settings_.lockstep) await_commands();
  await_clock();
}

std::string SimNode::state_json() const {
  nlohmann::json vehicles = nlohmann::json::array();
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const FleetVehicle& vehicle = fleet_.vehicle(i);
    vehicles.push_back({{"name", vehicle.name},
                        {"phase", vehicle.phase},
                        {"wants_command", vehicle.wants_command},
                        {"holding", vehicle.holding},
                        {"alert", words_of(vehicle.alert)}});
  }
  return nlohmann::json{{"scenario", fleet_.name()},
                        {"time_s", fleet_.time()},
                        {"wall_s", seconds_between(begin_, Steady::now())},
                        {"behind_s", behind_s_},
                        {"frame", settings_.frame == Frame::enu ? "enu" : "ned"},
                        {"paused", paused_},
                        {"done", fleet_.is_done()},
                        {"collisions", fleet_.collisions()},
                        {"missed_count", missed_},
                        {"refused_count", refused_},
                        {"vehicles", vehicles}}
      .dump();
}

void SimNode::show_state() {
  std_msgs::String state;
  state.data = state_json();
  state_.publish(state);
}

int SimNode::run() {
  begin_ = Steady::now();
  now_ = stamp_of(fleet_.time());
  await_subscribers();
  begin_ = anchor_ = Steady::now();
  anchor_time_ = fleet_.time();
  while (ros::ok() && !fleet_.is_done()) {
    show_instant();
    await_turn();
    if (ros::ok()) fleet_.step();
  }
  const double wall_s = seconds_between(begin_, Steady::now());
  fleet_.finish();
  if (!fleet_.is_done()) {
    std::cerr << "fairway_sim: interrupted at " << fleet_.time() << " s\n";
    return 130;
  }
  show_instant();
  show_state();
  std::cout << fleet_.summary(wall_s) << std::flush;
  do spin(0.3);
  while (ros::ok() && !settings_.until_done);
  return fleet_.expectations_kept() ? 0 : 1;
}

}  // namespace fairway::ros1
