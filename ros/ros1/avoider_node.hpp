// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "ros/bridge/avoider_duty.hpp"
#include "ros/ros1/conversions.hpp"
#include "ros/ros1/master_watch.hpp"

namespace fairway::ros1 {

/// `fairway_avoider`: the avoider of one vehicle in a ROS graph. Topics and parameters are on
/// docs/ros_avoider.md.
class AvoiderNode final : bridge::AvoiderOutlet {
 public:
  /// In the program's namespace, which is the vehicle's. Throws std::runtime_error, in one line, for settings
  /// that cannot be used.
  explicit AvoiderNode(const bridge::AvoiderNodeSettings& settings);

  /// Until ROS is shut down.
  void run();

 private:
  void advertise();
  void subscribe();
  void hear_mate(std::size_t mate, std::uint32_t kept);
  void offer_services();
  template <class Message, class Listener>
  void hear(ros::NodeHandle& whose, const std::string& topic, std::uint32_t kept, Listener listener);
  template <class Service, class Answer>
  void offer(const std::string& name, Answer answer);
  ros::Time stamp_again(double time) const;

  void send_command(const BodyVelocity& velocity, double time) override;
  void send_record(const std::vector<std::uint8_t>& bytes) override;
  void send_status(const std::string& json) override;
  void send_diagnosis(const bridge::Diagnosis& diagnosis, double time) override;
  void send_marks(const std::vector<Mark>& marks, double time) override;
  void warn(const std::string& words) override;

  bridge::AvoiderNodeSettings settings_;
  bridge::AvoiderDuty duty_;
  ros::CallbackQueue queue_, mates_queue_;
  ros::NodeHandle own_, mates_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Publisher command_, diagnostics_, status_, record_, sketch_;
  std::string world_{"world"};               // of the own odometry, as soon as it is known
  std::atomic<std::uint64_t> own_stamp_{0};  // of the own odometry [ns]
};

}  // namespace fairway::ros1
