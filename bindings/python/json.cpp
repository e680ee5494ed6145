// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/json.hpp"

#include <nlohmann/json.hpp>

namespace fairway::python {

namespace py = pybind11;

py::object shown(const nlohmann::json& json) {
  switch (json.type()) {
    case nlohmann::json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case nlohmann::json::value_t::number_integer:
    case nlohmann::json::value_t::number_unsigned:
      return py::int_(json.get<std::int64_t>());
    case nlohmann::json::value_t::number_float:
      return py::float_(json.get<double>());
    case nlohmann::json::value_t::string:
      return py::str(json.get<std::string>());
    case nlohmann::json::value_t::array: {
      py::list all;
      for (const nlohmann::json& item : json) all.append(shown(item));
      return all;
    }
    case nlohmann::json::value_t::object: {
      py::dict all;
      for (const auto& [key, item] : json.items()) all[py::str(key)] = shown(item);
      return all;
    }
    default:
      return py::none();
  }
}

}  // namespace fairway::python
