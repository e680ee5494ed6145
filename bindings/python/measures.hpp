// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <vector>

#include "fairway/metrics/measure.hpp"

namespace fairway::python {

/// {"min_separation_m": 5.1, ...}: what was measured of the fleet.
pybind11::dict fleet_dict(std::span<const Measure> measures);

/// [{"name": "robot0", "navigation_time_s": 80.1, ...}, ...]: of each vehicle.
pybind11::list vehicle_dicts(std::span<const Measure> measures, std::span<const std::string> names);

/// The measures of many runs as columns: {quantity: array}, of runs for the fleet, of runs x vehicles for
/// what each vehicle has. NaN where a run has no such number.
struct MeasureColumns {
  pybind11::dict fleet;
  pybind11::dict vehicles;
};
MeasureColumns measure_columns(std::span<const std::vector<Measure>> runs);

}  // namespace fairway::python
