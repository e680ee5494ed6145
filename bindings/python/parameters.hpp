// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "fairway/core/params.hpp"

namespace fairway::python {

/// Adds the class `Parameter`.
void bind_parameter(pybind11::module_& m);

/// A tuple of `Parameter`.
pybind11::tuple parameters(const std::vector<ParamInfo>& params);

/// Throws InputError unless `given` is -1 < count; 0 = as many as the machine has cores.
unsigned jobs_of(int given);

}  // namespace fairway::python
