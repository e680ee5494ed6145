// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

// Calls that most tests with JSON make, here so that a compiler makes them of their templates once, while it
// precompiles. Nobody calls what is here.
namespace fairway::precompiled {

inline nlohmann::json parsed(const std::string& text) { return nlohmann::json::parse(text); }

inline bool is_read(const nlohmann::json& value) {
  return value.at("text").get<std::string>() == value.dump() && value.contains("number") &&
         value.at("number").get<double>() > 0 && value.at("count").get<std::size_t>() == value.size() &&
         value == nlohmann::json::array() && value["text"] == "text" && value["count"] == 1;
}

}  // namespace fairway::precompiled
