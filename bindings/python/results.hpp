// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include "bindings/python/measures.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/stored_results.hpp"

namespace fairway::python {

/// `fairway.Results`: stored runs, and the same as columns.
struct Results {
  StoredResults stored;
  py::dict labels;
  py::array seeds;
  MeasureColumns columns;
  py::dict failures;
  py::array wall_s;
  std::size_t made{};  ///< of them, by the call that gave these results
};

Results results_of(StoredResults stored, std::size_t made = 0);

/// Adds the class `Results`, and load_results().
void bind_results(py::module_& m);

}  // namespace fairway::python
