// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>

namespace fairway::python {

/// A document as dicts, lists, numbers, text and None.
pybind11::object shown(const nlohmann::json& json);

}  // namespace fairway::python
