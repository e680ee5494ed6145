// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/avoider_node.hpp"

#include <cmath>
#include <iostream>
#include <limits>

#include "ros/bridge/watchdog.hpp"

namespace fairway::ros2 {
namespace {

constexpr std::chrono::milliseconds round_period{10};  // the loop comes round so often at least
constexpr std::int32_t lockstep_depth = 100;           // a fleet waits for the answer to each

std::uint8_t level_of(bridge::Diagnosis::Level level) { return static_cast<std::uint8_t>(level); }

}  // namespace

AvoiderNode::AvoiderNode(const bridge::AvoiderNodeSettings& settings, const GraphOptions& options)
    : settings_{settings},
      simulated_{settings.use_sim_time || settings.lockstep},
      simulated_now_{std::numeric_limits<double>::quiet_NaN()},
      duty_{settings, *this},
      graph_{options} {
  advertise();
  subscribe();
  graph_.announce();
}

void AvoiderNode::advertise() {
  command_ = graph_.advertise<TwistStamped>(settings_.advisory ? "advice" : "velocity_command");
  diagnostics_ = graph_.advertise<DiagnosticArray>("/diagnostics");
  status_ = graph_.advertise<String>("status");
  record_ = graph_.advertise<UInt8MultiArray>("team_record");
  if (settings_.draw) sketch_ = graph_.advertise<MarkerArray>("sketch");
}

void AvoiderNode::subscribe() {
  const Frame frame = settings_.frame;
  if (simulated_)
    graph_.subscribe<Clock>(
        "/clock", [this](const Clock& m) { simulated_now_ = seconds_of(m.clock); }, sensor_qos);
  const auto on_goal = [this, frame](const PoseStamped& m) {
    duty_.go_to(place_of(m.pose.position, frame), m.header.frame_id, seconds_of(m.header.stamp));
  };
  graph_.subscribe<PoseStamped>("goal", on_goal, either_qos);
  graph_.subscribe<Path>("path", [this, frame](const Path& m) {
    std::vector<Triple> places;
    for (const PoseStamped& pose : elements(m.poses)) places.push_back(place_of(pose.pose.position, frame));
    duty_.follow(places, m.header.frame_id, seconds_of(m.header.stamp));
  });
  graph_.subscribe<Bool>("keep_position", [this](const Bool& m) {
    if (m.data) duty_.keep_position();
  });
  graph_.subscribe<Bool>("stand_by", [this](const Bool& m) {
    if (m.data) duty_.stand_by();
  });
  for (std::size_t mate = 0; mate < duty_.host().team().size(); ++mate) hear_mate(mate);
  graph_.subscribe<Odometry>(
      "odometry",
      [this, frame](const Odometry& m) {
        const Motion motion = motion_of(m, frame);
        world_ = m.header.frame_id;
        if (const auto now = clock()) duty_.hear_own(motion, world_, *now);
      },
      settings_.lockstep ? Qos{true, false, lockstep_depth} : sensor_qos);
}

void AvoiderNode::hear_mate(std::size_t mate) {
  const Frame frame = settings_.frame;
  const std::string topics = "/" + bridge::topic_name(duty_.host().team()[mate]);
  if (settings_.input != bridge::AvoiderInput::team_record) {
    const auto on_goal = [this, mate, frame](const PoseStamped& m) {
      duty_.hear_mate_goal(mate, place_of(m.pose.position, frame), seconds_of(m.header.stamp));
    };
    graph_.subscribe<PoseStamped>(topics + "/goal", on_goal, either_qos);
    graph_.subscribe<Odometry>(
        topics + "/odometry",
        [this, mate, frame](const Odometry& m) {
          if (const auto now = clock()) duty_.hear_mate(mate, motion_of(m, frame), *now);
        },
        settings_.lockstep ? Qos{true, false, lockstep_depth} : sensor_qos);
  }
  if (settings_.input != bridge::AvoiderInput::odometry)
    graph_.subscribe<UInt8MultiArray>(topics + "/team_record", [this](const UInt8MultiArray& m) {
      const auto bytes = elements(m.data);
      if (const auto now = clock()) duty_.hear_record(bytes.data(), bytes.size(), *now);
    });
}

std::optional<double> AvoiderNode::clock() const {
  if (!simulated_)
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  const double now = simulated_now_;
  return std::isnan(now) ? std::nullopt : std::optional{now};
}

void AvoiderNode::run(const std::atomic<bool>& stop) {
  bridge::Watchdog watchdog{duty_.host().watchdog_period(), [this](double stood_still) {
                              if (const auto now = clock()) duty_.raise_alarm(stood_still, *now);
                            }};
  while (!stop) {
    graph_.wait(round_period);
    graph_.handle_all();
    watchdog.come_round();
    const auto now = clock();
    if (!now) continue;  // a simulation that has not begun
    duty_.settle(*now);
    duty_.come_round(*now);
  }
}

void AvoiderNode::send_command(const BodyVelocity& velocity, double time) {
  Memory memory;
  command_.publish(twist_of(velocity, time, settings_.frame, bridge::topic_name(duty_.vehicle()), memory));
}

void AvoiderNode::send_record(const std::vector<std::uint8_t>& bytes) {
  Memory memory;
  UInt8MultiArray record{};
  const auto room = memory.room(record.data, bytes.size());
  std::copy(bytes.begin(), bytes.end(), room.begin());
  record_.publish(record);
}

void AvoiderNode::send_status(const std::string& json) {
  Memory memory;
  status_.publish(String{memory.text(json)});
}

void AvoiderNode::send_diagnosis(const bridge::Diagnosis& diagnosis, double time) {
  Memory memory;
  DiagnosticArray array{};
  array.header.stamp = stamp_of(time);
  DiagnosticStatus& status = memory.room(array.status, 1)[0];
  status.level = level_of(diagnosis.level);
  status.name = memory.text("fairway: " + duty_.vehicle());
  status.message = memory.text(diagnosis.summary);
  status.hardware_id = memory.text(duty_.vehicle());
  const auto values = memory.room(status.values, diagnosis.values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = {memory.text(diagnosis.values[i].first), memory.text(diagnosis.values[i].second)};
  diagnostics_.publish(array);
}

void AvoiderNode::send_marks(const std::vector<Mark>& marks, double time) {
  Memory memory;
  sketch_.publish(markers_of(marks, time, settings_.frame, world_, duty_.vehicle(), memory));
}

void AvoiderNode::warn(const std::string& words) {
  std::cerr << "fairway_avoider_ros2 " << duty_.vehicle() << ": " << words << '\n';
}

}  // namespace fairway::ros2
