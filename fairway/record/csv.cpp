// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/csv.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>

#include "fairway/core/text.hpp"
#include "fairway/record/quantities.hpp"

namespace fairway {

namespace {

// as RFC 4180 has it
std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

void export_csv(const Recording& recording, std::ostream& out) {
  std::size_t actuators = 0;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    for (const VehicleFrame& v : recording.frame(i).vehicles)
      actuators = std::max(actuators, v.actuators.size());
  }

  std::string line = "tick,time_s,vehicle";
  for (const Quantity& quantity : quantities()) line.append(",").append(quantity.name);
  for (std::size_t k = 0; k < actuators; ++k) line += ",actuator_" + std::to_string(k);
  out << line << '\n';

  for (std::size_t i = 0; i < recording.size(); ++i) {
    const Frame frame = recording.frame(i);
    const std::string instant = std::to_string(count(frame.tick)) + ',' + number_text(frame.time) + ',';
    for (std::size_t v = 0; v < frame.vehicles.size(); ++v) {
      const VehicleFrame& vehicle = frame.vehicles[v];
      line = instant + quoted(recording.info().vehicles[v].name);
      for (const Quantity& quantity : quantities()) line.append(",").append(quantity.text(vehicle));
      for (const double a : vehicle.actuators) line.append(",").append(number_text(a));
      line.append(actuators - vehicle.actuators.size(), ',');
      out << line << '\n';
    }
  }
}

}  // namespace fairway
