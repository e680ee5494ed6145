// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/bindings.hpp"

PYBIND11_MODULE(_core, m) {
  using namespace fairway::python;
  m.attr("__version__") = FAIRWAY_VERSION;
  bind_errors(m);
  bind_situations(m);
  bind_avoiders(m);
  bind_vehicles(m);
  bind_scenarios(m);
  bind_recordings(m);
  bind_runs(m);
  bind_studies(m);
  bind_environments(m);
}
