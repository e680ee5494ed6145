// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/parameters.hpp"

#include <array>
#include <charconv>
#include <sstream>
#include <stdexcept>

namespace fairway::ros1 {
namespace {

using bridge::Settings;
using XmlRpc::XmlRpcValue;

template <class Number>
std::string shortest(Number number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

/// As `--set` would have it; a list's items with `between` between them.
std::string text_of(const std::string& name, XmlRpcValue value, const std::string& between) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return shortest(static_cast<int>(value));
    case XmlRpcValue::TypeDouble:
      return shortest(static_cast<double>(value));
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    case XmlRpcValue::TypeArray: {
      std::string words;
      for (int i = 0; i < value.size(); ++i)
        words += (i > 0 ? between : "") + text_of(name, value[i], between);
      return words;
    }
    default:
      throw std::runtime_error(name + ": expected a number, a truth value, text or a list of them");
  }
}

void add_overrides(const std::string& name, const XmlRpcValue& value, Settings& settings) {
  std::istringstream parts{text_of(name, value, ";")};
  for (std::string part; std::getline(parts, part, ';');) {
    if (part.empty()) continue;
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error(name + ": '" + part + "': expected path=value, several as a list");
    settings.emplace_back("override." + part.substr(0, equals), part.substr(equals + 1));
  }
}

void flatten(const std::string& name, const XmlRpcValue& given, Settings& settings) {
  if (name == "overrides") return add_overrides(name, given, settings);
  XmlRpcValue value = given;  // whose members are read by what is not const
  if (value.getType() != XmlRpcValue::TypeStruct) {
    settings.emplace_back(name, text_of(name, value, " "));
    return;
  }
  if (name == "team") {  // a parameter is a value or a folder: as a folder, its names are the team
    std::string mates;
    for (auto& [mate, of_mate] : value) mates += (mates.empty() ? "" : " ") + mate;
    settings.emplace_back(name, mates);
  }
  for (auto& [inner, inner_value] : value)
    flatten(name.empty() ? inner : name + "." + inner, inner_value, settings);
}

}  // namespace

Settings settings_of(const XmlRpcValue& parameters) {
  Settings settings;
  if (parameters.getType() == XmlRpcValue::TypeStruct) flatten("", parameters, settings);
  return settings;
}

}  // namespace fairway::ros1
