// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/csv.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/record_text.hpp"

namespace fairway {

namespace {

// as RFC 4180 has it
std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string instant_of(const Frame& frame) {
  return std::to_string(count(frame.tick)) + ',' + number_text(frame.time) + ',';
}

void expect_perception(const Recording& recording) {
  if (recording.info().perception) return;
  throw InputError("what was perceived is not recorded; record with fairway run --perception");
}

/// Calls `rows` with the first fields of a row and the vehicle, for every vehicle of every frame.
template <class Rows>
void for_each_perceiver(const Recording& recording, Rows rows) {
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const Frame frame = recording.frame(i);
    for (std::size_t v = 0; v < frame.vehicles.size(); ++v) {
      rows(instant_of(frame) + quoted(recording.info().vehicles[v].name), frame.vehicles[v]);
    }
  }
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
    const std::string instant = instant_of(frame);
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

void export_tracks_csv(const Recording& recording, std::ostream& out) {
  expect_perception(recording);
  std::string line = "tick,time_s,vehicle";
  for (const std::string& column : record_columns<Track>()) line.append(",").append(column);
  out << line << '\n';
  for_each_perceiver(recording, [&](const std::string& begin, const VehicleFrame& vehicle) {
    for (const Track& track : vehicle.tracks) {
      line = begin;
      for (const std::string& text : record_texts(track)) line.append(",").append(text);
      out << line << '\n';
    }
  });
}

void export_echoes_csv(const Recording& recording, std::ostream& out) {
  expect_perception(recording);
  out << "tick,time_s,vehicle,range_m,bearing_rad\n";
  for_each_perceiver(recording, [&](const std::string& begin, const VehicleFrame& vehicle) {
    for (const auto& [range, bearing] : vehicle.echoes) {
      out << begin << ',' << number_text(range) << ',' << number_text(bearing) << '\n';
    }
  });
}

}  // namespace fairway
