// SPDX-License-Identifier: Apache-2.0
#include <pybind11/numpy.h>

#include "bindings/python/bindings.hpp"

PYBIND11_MODULE(_core, m) {
  using namespace fairway::python;
  m.attr("__version__") = FAIRWAY_VERSION;
  // numpy is found now, by one thread: two that first need it at once would wait for each other for ever, one
  // holding pybind11's static variable, the other the interpreter's lock
  (void)pybind11::dtype::of<double>();
  bind_errors(m);
  bind_situations(m);
  bind_avoiders(m);
  bind_vehicles(m);
  bind_scenarios(m);
  bind_recordings(m);
  bind_runs(m);
  bind_results(m);
  bind_sweeps(m);
  bind_explanations(m);
  bind_studies(m);
  bind_environments(m);
}
