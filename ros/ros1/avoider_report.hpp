// SPDX-License-Identifier: Apache-2.0
// What an avoider says of itself, as messages.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <string>

#include "ros/bridge/avoider_host.hpp"
#include "ros/bridge/frames.hpp"

namespace fairway::ros1 {

/// What the node itself has to tell beside its avoider.
struct AvoiderCircumstances {
  std::string vehicle;
  std::string algorithm;
  bridge::Frame frame{bridge::Frame::enu};
  double time{};  ///< [s]
  bool advisory{false};
  std::int64_t alarms{};  ///< of the watchdog
};

/// One status, named `fairway: <vehicle>`.
diagnostic_msgs::DiagnosticArray diagnostics_of(const bridge::Diagnosis& diagnosis,
                                                const AvoiderCircumstances& circumstances);

/// A line of JSON: state, mode, reason, the velocity in the graph's frame, and all values of the diagnosis.
std::string status_json(const bridge::Order& order, const bridge::Diagnosis& diagnosis,
                        const AvoiderCircumstances& circumstances);

}  // namespace fairway::ros1
