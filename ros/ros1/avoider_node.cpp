// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_node.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <fairway_ros/GoTo.h>
#include <fairway_ros/Section.h>
#include <nav_msgs/Path.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <std_msgs/UInt8MultiArray.h>
#include <std_srvs/Trigger.h>

#include <algorithm>

#include "ros/bridge/watchdog.hpp"

namespace fairway::ros1 {
namespace {

constexpr double idle_s = 0.01;             // the loop comes round so often at least
constexpr std::uint32_t few = 10;           // messages that are kept
constexpr std::uint32_t of_lockstep = 100;  // a fleet waits for the answer to each

double clock_now() { return seconds_of(ros::Time::now()); }

}  // namespace

AvoiderNode::AvoiderNode(const bridge::AvoiderNodeSettings& settings)
    : settings_{settings}, duty_{settings, *this} {
  // What mates tell waits until it is needed: to wake up for each of it would double the work. In lockstep
  // each may be the last that is missing.
  own_.setCallbackQueue(&queue_);
  mates_.setCallbackQueue(settings_.lockstep ? &queue_ : &mates_queue_);
  advertise();
  offer_services();
  subscribe();
}

void AvoiderNode::advertise() {
  const char* command = settings_.advisory ? "advice" : "velocity_command";
  command_ = own_.advertise<geometry_msgs::TwistStamped>(command, few);
  diagnostics_ = own_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", few);
  status_ = own_.advertise<std_msgs::String>("status", few);
  record_ = own_.advertise<std_msgs::UInt8MultiArray>("team_record", few);
  if (settings_.draw) sketch_ = own_.advertise<visualization_msgs::MarkerArray>("sketch", 2);
}

template <class Service, class Answer>
void AvoiderNode::offer(const std::string& name, Answer answer) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> call = [answer](Request& request, Response& response) {
    answer(request, response);
    return true;
  };
  services_.push_back(own_.advertiseService(name, call));
}

void AvoiderNode::offer_services() {
  const Frame frame = settings_.frame;
  offer<fairway_ros::GoTo>("go_to", [this, frame](const auto& request, auto& response) {
    response.message = duty_.go_to(place_of(request.position, frame), "", 0.0, request.speed_mps);
    response.ok = response.message.empty();
  });
  offer<fairway_ros::Section>("section", [this, frame](const auto& request, auto& response) {
    response.message =
        duty_.follow_section(place_of(request.start, frame), place_of(request.end, frame), request.speed_mps);
    response.ok = response.message.empty();
  });
  offer<std_srvs::Trigger>("keep_position", [this](const auto&, auto& response) {
    duty_.keep_position();
    response.success = true;
    response.message = "keeping the position where it is";
  });
  offer<std_srvs::Trigger>("stand_by", [this](const auto&, auto& response) {
    duty_.stand_by();
    response.success = true;
    response.message = "standing by: the vehicle is left to others";
  });
}

template <class Message, class Listener>
void AvoiderNode::hear(ros::NodeHandle& whose, const std::string& topic, std::uint32_t kept,
                       Listener listener) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> listens =
      [listener](const boost::shared_ptr<const Message>& message) { listener(*message); };
  subscribers_.push_back(whose.subscribe<Message>(topic, kept, listens, ros::VoidConstPtr{},
                                                  ros::TransportHints().tcpNoDelay()));
}

void AvoiderNode::subscribe() {
  const Frame frame = settings_.frame;
  // an old odometry is of no use when a newer one is there, unless a fleet waits for the answer to each
  const std::uint32_t kept = settings_.lockstep ? of_lockstep : 1;
  hear<nav_msgs::Odometry>(own_, "odometry", kept, [this, frame](const auto& m) {
    world_ = m.header.frame_id;
    own_stamp_ = m.header.stamp.toNSec();
    duty_.hear_own(motion_of(m, frame), world_, clock_now());
  });
  hear<geometry_msgs::PoseStamped>(own_, "goal", few, [this, frame](const auto& m) {
    duty_.go_to(place_of(m.pose.position, frame), m.header.frame_id, seconds_of(m.header.stamp));
  });
  hear<nav_msgs::Path>(own_, "path", few, [this, frame](const auto& m) {
    std::vector<Triple> places;
    for (const auto& pose : m.poses) places.push_back(place_of(pose.pose.position, frame));
    duty_.follow(places, m.header.frame_id, seconds_of(m.header.stamp));
  });
  if (settings_.test_hooks) {
    hear<std_msgs::Float64>(own_, "test_hang", 1,
                            [](const auto& m) { ros::WallDuration{std::clamp(m.data, 0.0, 60.0)}.sleep(); });
  }
  for (std::size_t i = 0; i < duty_.host().team().size(); ++i) hear_mate(i, kept);
}

void AvoiderNode::hear_mate(std::size_t mate, std::uint32_t kept) {
  const Frame frame = settings_.frame;
  const std::string topics = "/" + bridge::topic_name(duty_.host().team()[mate]);
  if (settings_.input != bridge::AvoiderInput::team_record) {
    hear<nav_msgs::Odometry>(mates_, topics + "/odometry", kept, [this, mate, frame](const auto& m) {
      duty_.hear_mate(mate, motion_of(m, frame), clock_now());
    });
    hear<geometry_msgs::PoseStamped>(mates_, topics + "/goal", few, [this, mate, frame](const auto& m) {
      duty_.hear_mate_goal(mate, place_of(m.pose.position, frame), seconds_of(m.header.stamp));
    });
  }
  if (settings_.input != bridge::AvoiderInput::odometry) {
    hear<std_msgs::UInt8MultiArray>(mates_, topics + "/team_record", few, [this](const auto& m) {
      duty_.hear_record(m.data.data(), m.data.size(), clock_now());
    });
  }
}

void AvoiderNode::run() {
  std::vector<std::string> services;
  for (const ros::ServiceServer& service : services_) services.push_back(service.getService());
  const MasterWatch master{services};
  bridge::Watchdog watchdog{duty_.host().watchdog_period(),
                            [this](double stood_still) { duty_.raise_alarm(stood_still, clock_now()); }};
  while (ros::ok()) {
    queue_.callAvailable(ros::WallDuration{idle_s});
    mates_queue_.callAvailable();
    watchdog.come_round();
    duty_.settle(clock_now());
    duty_.come_round(clock_now());
  }
}

/// Seconds of the wall's clock have no nanoseconds: whoever waits for a stamp gets the one that came.
ros::Time AvoiderNode::stamp_again(double time) const {
  ros::Time own;
  own.fromNSec(own_stamp_);
  return seconds_of(own) == time ? own : stamp_of(time);
}

void AvoiderNode::send_command(const BodyVelocity& velocity, double time) {
  auto command = twist_of(velocity, time, settings_.frame, bridge::topic_name(duty_.vehicle()));
  command.header.stamp = stamp_again(time);
  command_.publish(command);
}

void AvoiderNode::send_record(const std::vector<std::uint8_t>& bytes) {
  std_msgs::UInt8MultiArray record;
  record.data = bytes;
  record_.publish(record);
}

void AvoiderNode::send_status(const std::string& json) {
  std_msgs::String status;
  status.data = json;
  status_.publish(status);
}

void AvoiderNode::send_diagnosis(const bridge::Diagnosis& diagnosis, double time) {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = stamp_of(time);
  diagnostic_msgs::DiagnosticStatus& status = array.status.emplace_back();
  status.level = static_cast<std::int8_t>(diagnosis.level);
  status.name = "fairway: " + duty_.vehicle();
  status.message = diagnosis.summary;
  status.hardware_id = duty_.vehicle();
  for (const auto& [key, value] : diagnosis.values) {
    status.values.emplace_back();
    status.values.back().key = key;
    status.values.back().value = value;
  }
  diagnostics_.publish(array);
}

void AvoiderNode::send_marks(const std::vector<Mark>& marks, double time) {
  sketch_.publish(markers_of(marks, time, settings_.frame, world_));
}

void AvoiderNode::warn(const std::string& words) { ROS_WARN_STREAM(words); }

}  // namespace fairway::ros1
