// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/csv.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>

#include "fairway/core/csv_field.hpp"
#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/record_text.hpp"

namespace fairway {

namespace {

std::string instant_of(const Frame& frame) {
  return std::to_string(count(frame.tick)) + ',' + number_text(frame.time) + ',';
}

/// A row of each record that a vehicle perceived, for every vehicle of every frame.
template <RecordType R>
void export_perceived(const Recording& recording, std::span<const R> VehicleFrame::*list, std::ostream& out) {
  if (!recording.info().perception)
    throw InputError("what was perceived is not recorded; record with fairway run --perception");
  const auto write = [&out](std::string line, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) line.append(",").append(text);
    out << line << '\n';
  };
  write("tick,time_s,vehicle", record_columns<R>());
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const Frame frame = recording.frame(i);
    for (std::size_t v = 0; v < frame.vehicles.size(); ++v) {
      const std::string begin = instant_of(frame) + csv_field(recording.info().vehicles[v].name);
      for (const R& record : frame.vehicles[v].*list) write(begin, record_texts(record));
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
      line = instant + csv_field(recording.info().vehicles[v].name);
      for (const Quantity& quantity : quantities()) line.append(",").append(quantity.of(vehicle));
      for (const double a : vehicle.actuators) line.append(",").append(number_text(a));
      line.append(actuators - vehicle.actuators.size(), ',');
      out << line << '\n';
    }
  }
}

void export_tracks_csv(const Recording& recording, std::ostream& out) {
  export_perceived(recording, &VehicleFrame::tracks, out);
}

void export_echoes_csv(const Recording& recording, std::ostream& out) {
  export_perceived(recording, &VehicleFrame::echoes, out);
}

}  // namespace fairway
