// SPDX-License-Identifier: Apache-2.0
// fairway_latency: plays a fleet that crosses a circle again and again, and measures how long each avoider
// takes from odometry to command: from before the message is written here until the answer with its stamp is
// read here, two trips through TCP included.
#include <geometry_msgs/TwistStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "ros/ros1/middleware.hpp"

namespace {

using namespace fairway;
using Steady = std::chrono::steady_clock;

constexpr double pi = 3.14159265358979323846;
constexpr double circle_m = 15.0;
constexpr double depth_m = 10.0;

struct Sent {
  ros::Time stamp;
  Steady::time_point at;
  std::size_t number{};  ///< of all that were sent
  bool is_answered{true};
};

/// Follows its commands at once; north-east-down throughout.
struct Played {
  ros::Publisher odometry, goal;
  ros::Subscriber command;
  bridge::BodyVelocity asked;
  double north{}, east{}, yaw{}, depth{depth_m};
  double goal_bearing{};
  std::array<Sent, 64> sent;
  std::size_t next{};

  void move(double period) {
    yaw += period * asked.yaw_rate_radps;
    north += period * (std::cos(yaw) * asked.surge_mps - std::sin(yaw) * asked.sway_mps);
    east += period * (std::sin(yaw) * asked.surge_mps + std::cos(yaw) * asked.sway_mps);
    depth += period * asked.heave_mps;
  }

  bridge::Triple goal_position() const {
    return {circle_m * std::cos(goal_bearing), circle_m * std::sin(goal_bearing), depth_m};
  }

  bool is_there() const {
    const auto [n, e, d] = goal_position();
    return std::hypot(n - north, e - east, d - depth) < 2.0;
  }

  bridge::Motion motion(double time) const {
    return {time,
            {north, east, depth},
            {std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)},
            {asked.surge_mps, asked.sway_mps, asked.heave_mps},
            {0, 0, asked.yaw_rate_radps}};
  }
};

class Latency {
 public:
  explicit Latency(const ros::NodeHandle& settings)
      : count_{static_cast<std::size_t>(settings.param("vehicles", 8))},
        rate_hz_{settings.param("rate_hz", 20.0)},
        messages_{static_cast<std::size_t>(settings.param("messages", 6000))},
        warm_up_{static_cast<std::size_t>(settings.param("warm_up", 800))},
        at_once_{settings.param("at_once", false)},
        fleet_(count_) {
    const std::string prefix = settings.param<std::string>("prefix", "robot");
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    for (std::size_t i = 0; i < count_; ++i) {
      Played& vehicle = fleet_[i];
      const std::string name = "/" + prefix + std::to_string(i);
      const double bearing = 2 * pi * static_cast<double>(i) / static_cast<double>(count_);
      vehicle.north = circle_m * std::cos(bearing);
      vehicle.east = circle_m * std::sin(bearing);
      vehicle.goal_bearing = bearing + pi;
      vehicle.yaw = vehicle.goal_bearing;
      vehicle.odometry = node_.advertise<nav_msgs::Odometry>(name + "/odometry", 10);
      vehicle.goal = node_.advertise<geometry_msgs::PoseStamped>(name + "/goal", 1, true);
      const boost::function<void(const geometry_msgs::TwistStampedConstPtr&)> on_command =
          [this, i](const geometry_msgs::TwistStampedConstPtr& command) { hear(i, *command); };
      vehicle.command = node_.subscribe<geometry_msgs::TwistStamped>(name + "/velocity_command", 10,
                                                                     on_command, ros::VoidConstPtr{}, hints);
    }
    latencies_.reserve(messages_ + count_);
  }

  /// False if it was ended before everything was measured.
  bool measure() {
    while (ros::ok() && !is_connected()) ros::WallDuration{0.05}.sleep();
    for (Played& vehicle : fleet_) tell_goal(vehicle);
    const auto period = std::chrono::duration<double>(1.0 / rate_hz_);
    const std::size_t groups = at_once_ ? 1 : count_;
    auto due = Steady::now();
    for (std::size_t turn = 0; ros::ok() && sent_ < warm_up_ + messages_; ++turn) {
      due += std::chrono::duration_cast<Steady::duration>(period / groups);
      wait_until(due);
      for (std::size_t i = turn % groups; i < count_; i += groups) send(fleet_[i]);
    }
    wait_until(Steady::now() + std::chrono::milliseconds(500));
    return ros::ok();
  }

  void print() {
    std::sort(latencies_.begin(), latencies_.end());
    const std::size_t n = latencies_.size();
    const auto at = [&](double share) {
      return n == 0 ? 0.0 : 1e3 * latencies_[static_cast<std::size_t>(share * static_cast<double>(n - 1))];
    };
    std::printf(
        "{\"vehicles\": %zu, \"rate_hz\": %g, \"at_once\": %s, \"count\": %zu, \"unanswered\": %zu, "
        "\"median_ms\": %.3f, \"p90_ms\": %.3f, \"p99_ms\": %.3f, \"worst_ms\": %.3f}\n",
        count_, rate_hz_, at_once_ ? "true" : "false", n, sent_ - warm_up_ - n, at(0.5), at(0.9), at(0.99),
        at(1.0));
  }

 private:
  bool is_connected() const {
    return std::all_of(fleet_.begin(), fleet_.end(), [this](const Played& vehicle) {
      return vehicle.odometry.getNumSubscribers() >= count_ && vehicle.command.getNumPublishers() >= 1;
    });
  }

  void tell_goal(Played& vehicle) {
    vehicle.goal.publish(
        ros1::Writer{bridge::Frame::ned}.goal(vehicle.goal_position(), ros::Time::now().toSec()));
  }

  void send(Played& vehicle) {
    vehicle.move(1.0 / rate_hz_);
    if (vehicle.is_there()) {
      vehicle.goal_bearing += pi;
      tell_goal(vehicle);
    }
    nav_msgs::Odometry odometry =
        ros1::Writer{bridge::Frame::ned}.odometry(vehicle.motion(ros::Time::now().toSec()), "vehicle");
    odometry.header.stamp = ros::Time::now();
    vehicle.sent[vehicle.next++ % vehicle.sent.size()] = {odometry.header.stamp, Steady::now(), sent_++,
                                                          false};
    vehicle.odometry.publish(odometry);
  }

  void hear(std::size_t index, const geometry_msgs::TwistStamped& command) {
    const auto now = Steady::now();
    Played& vehicle = fleet_[index];
    vehicle.asked = bridge::velocity_of(command.twist, bridge::Frame::ned);
    for (Sent& sent : vehicle.sent) {
      if (sent.is_answered || sent.stamp != command.header.stamp) continue;
      sent.is_answered = true;
      if (sent.number >= warm_up_) latencies_.push_back(std::chrono::duration<double>(now - sent.at).count());
    }
  }

  /// Answers are read as they come.
  void wait_until(Steady::time_point due) {
    for (auto now = Steady::now(); now < due; now = Steady::now()) {
      ros::getGlobalCallbackQueue()->callAvailable(
          ros::WallDuration{std::chrono::duration<double>(due - now).count()});
    }
  }

  ros::NodeHandle node_;
  std::size_t count_;
  double rate_hz_;
  std::size_t messages_, warm_up_;
  bool at_once_;
  std::vector<Played> fleet_;
  std::vector<double> latencies_;  // [s]
  std::size_t sent_{};
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "fairway_latency");
  Latency latency{ros::NodeHandle{"~"}};
  if (!latency.measure()) return 1;
  latency.print();
}
