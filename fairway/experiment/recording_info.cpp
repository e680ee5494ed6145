// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/recording_info.hpp"

#include "fairway/experiment/version.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {

RecordingInfo recording_info(const Scenario& scenario) {
  RecordingInfo info{.version = std::string(fairway_version),
                     .scenario_name = scenario.name,
                     .scenario_yaml = to_yaml(scenario),
                     .seed = scenario.seed,
                     .period = scenario.step_s,
                     .vehicles = {}};
  for (const VehicleSpec& vehicle : scenario.vehicles)
    info.vehicles.push_back({VehicleId{vehicle.id}, vehicle.name, vehicle.model.name});
  return info;
}

Scenario recorded_scenario(const Recording& recording, const std::string& file) {
  Scenario scenario = parse_scenario(recording.info().scenario_yaml, file + " (scenario)");
  if (scenario.vehicles.size() != recording.info().vehicles.size())
    throw InputError(file + ": its frames and its scenario have different vehicles");
  return scenario;
}

}  // namespace fairway
