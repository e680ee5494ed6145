// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_report.hpp"

#include <nlohmann/json.hpp>

#include "ros/ros1/conversions.hpp"

namespace fairway::ros1 {
namespace {

diagnostic_msgs::KeyValue key_value(const std::string& key, const std::string& value) {
  diagnostic_msgs::KeyValue pair;
  pair.key = key;
  pair.value = value;
  return pair;
}

std::uint8_t level_of(bridge::Diagnosis::Level level) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  switch (level) {
    case bridge::Diagnosis::Level::ok:
      return Status::OK;
    case bridge::Diagnosis::Level::warning:
      return Status::WARN;
    case bridge::Diagnosis::Level::error:
      return Status::ERROR;
    case bridge::Diagnosis::Level::stale:
      break;
  }
  return Status::STALE;
}

}  // namespace

diagnostic_msgs::DiagnosticArray diagnostics_of(const bridge::Diagnosis& diagnosis,
                                                const AvoiderCircumstances& circumstances) {
  diagnostic_msgs::DiagnosticStatus status;
  status.level = level_of(diagnosis.level);
  status.name = "fairway: " + circumstances.vehicle;
  status.message = diagnosis.summary;
  status.hardware_id = circumstances.vehicle;
  status.values = {key_value("algorithm", circumstances.algorithm),
                   key_value("advisory", circumstances.advisory ? "true" : "false"),
                   key_value("watchdog_count", std::to_string(circumstances.alarms))};
  for (const auto& [key, value] : diagnosis.values) status.values.push_back(key_value(key, value));

  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = stamp_of(circumstances.time);
  array.status = {status};
  return array;
}

std::string status_json(const bridge::Order& order, const bridge::Diagnosis& diagnosis,
                        const AvoiderCircumstances& circumstances) {
  const bridge::Frame frame = circumstances.frame;
  const bridge::Triple linear =
      bridge::body_in(frame, {order.request.surge_mps, order.request.sway_mps, order.request.heave_mps});
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [key, value] : diagnosis.values) values[key] = value;
  const nlohmann::json status{
      {"vehicle", circumstances.vehicle},
      {"algorithm", circumstances.algorithm},
      {"time_s", circumstances.time},
      {"advisory", circumstances.advisory},
      {"in_charge", order.in_charge},
      {"state", order.state},
      {"mode", order.mode},
      {"reason", order.reason},
      {"summary", diagnosis.summary},
      {"velocity_mps", bridge::world_in(frame, order.velocity_n)},
      {"command_mps", linear},
      {"yaw_rate_radps", bridge::body_in(frame, {0, 0, order.request.yaw_rate_radps})[2]},
      {"watchdog_count", circumstances.alarms},
      {"values", values},
  };
  return status.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace fairway::ros1
