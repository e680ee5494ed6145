// SPDX-License-Identifier: Apache-2.0
// What each file of the module adds to it, in the order that types need each other.
#pragma once

#include <pybind11/pybind11.h>

namespace fairway::python {

namespace py = pybind11;

void bind_errors(py::module_& m);        // InputError
void bind_situations(py::module_& m);    // Situation, Track, Obstacle, Command ...
void bind_avoiders(py::module_& m);      // Avoider, algorithms()
void bind_vehicles(py::module_& m);      // Vehicle, vehicles()
void bind_scenarios(py::module_& m);     // Scenario
void bind_recordings(py::module_& m);    // Recording
void bind_runs(py::module_& m);          // run(), run_batch()
void bind_results(py::module_& m);       // Results, load_results()
void bind_sweeps(py::module_& m);        // sweep(), compare()
void bind_explanations(py::module_& m);  // explain(), view()
void bind_studies(py::module_& m);       // study(), studies()
void bind_environments(py::module_& m);  // FleetEnvironment, FleetEnvironments

}  // namespace fairway::python
