// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "bindings/python/measures.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/run.hpp"

namespace fairway::python {

/// `fairway.Results`: stored runs, and the same as columns.
struct Results {
  std::vector<RunRecord> records;
  py::dict labels;
  py::array seeds;
  MeasureColumns columns;
  py::dict failures;
  py::array wall_s;
  std::size_t made{};  ///< of them, by the call that gave these results
};

Results results_of(std::vector<RunRecord> records, std::size_t made = 0);

/// Adds the class `Results`, and load_results().
void bind_results(py::module_& m);

}  // namespace fairway::python
