// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "fairway/avoidance/avoider.hpp"

namespace fairway::python {

/// Adds `decide_batch` to the class `Avoider`, and the class of what it answers. `avoider_of` gives a copy of
/// the avoider that an object holds.
void add_decide_batch(pybind11::module_& m, const pybind11::object& avoider_class,
                      std::function<Avoider(const pybind11::handle&)> avoider_of);

}  // namespace fairway::python
