// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ros/bridge/avoider_duty.hpp"
#include "ros/bridge/fleet_duty.hpp"
#include "ros/bridge/messages.hpp"

namespace fairway::bridge {

/// An avoider whose commands are handed to a fleet.
class WiredAvoider final : public AvoiderOutlet {
 public:
  explicit WiredAvoider(const AvoiderNodeSettings& settings) : duty{settings, *this} {}

  void send_command(const BodyVelocity& velocity, double time) override {
    ++commands;
    last = velocity;
    if (fleet != nullptr) fleet->command(index, velocity, nanoseconds_of(time));
  }
  void send_record(const std::vector<std::uint8_t>&) override { ++records; }
  void send_speech(const std::vector<std::uint8_t>& bytes) override { said.push_back(bytes); }
  void send_status(const std::string& json) override { status = json; }
  void send_diagnosis(const Diagnosis& diagnosis, double) override { summary = diagnosis.summary; }
  void send_marks(const std::vector<Mark>&, double) override {}
  void warn(const std::string& words) override { warnings += words + "\n"; }

  AvoiderDuty duty;
  FleetDuty* fleet{};
  std::size_t index{};
  int commands{};
  BodyVelocity last{};
  int records{};
  std::vector<std::vector<std::uint8_t>> said;
  std::string status, summary, warnings;
};

}  // namespace fairway::bridge
