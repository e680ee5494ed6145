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
                     .vehicles = {},
                     .machine = std::string(fairway_machine)};
  for (const VehicleSpec& vehicle : scenario.vehicles)
    info.vehicles.push_back({VehicleId{vehicle.id}, vehicle.name, vehicle.model->name});
  return info;
}

namespace {

/// Where a method may be asked that this program has not.
std::string whereabouts(const std::string& program, std::string_view method) {
  if (program == python_program) {
    return "it was registered in Python: open the recording there, with fairway.explain(..., algorithms={\"" +
           std::string(method) + "\": ...}) or fairway.view(...)";
  }
  if (program == RecordingInfo{}.program) return "it is of a study alone, or of another version of fairway";
  return "use \"" + program + "\", which recorded it";
}

}  // namespace

void check_methods(const Recording& recording, const Scenario& scenario, const Catalogs& catalogs,
                   const std::string& file) {
  for (const VehicleSpec& vehicle : scenario.vehicles) {
    for (const std::string_view layer : layer_names(vehicle.avoider->name)) {
      if (catalogs.avoiders.has(layer)) continue;
      throw InputError(file + ": the algorithm \"" + std::string(layer) + "\" is not in this program; " +
                       whereabouts(recording.info().program, layer));
    }
  }
}

Scenario recorded_scenario(const Recording& recording, const std::string& file) {
  Scenario scenario = parse_scenario(recording.info().scenario_yaml, file + " (scenario)");
  if (scenario.vehicles.size() != recording.info().vehicles.size())
    throw InputError(file + ": its frames and its scenario have different vehicles");
  return scenario;
}

}  // namespace fairway
