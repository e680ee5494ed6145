// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace fairway::python {

/// Adds run_batch() and `Batch`.
void bind_batch(pybind11::module_& m);

}  // namespace fairway::python
