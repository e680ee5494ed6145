// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_settings.hpp"

#include <array>
#include <charconv>
#include <stdexcept>

#include "ros/ros1/parameters.hpp"

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

/// As `--set` would have it; lists are names with spaces between them.
std::string text_of(const std::string& name, XmlRpcValue value) {
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
      for (int i = 0; i < value.size(); ++i) words += (i > 0 ? " " : "") + text_of(name, value[i]);
      return words;
    }
    default:
      throw std::runtime_error("~" + name + ": expected a number, a truth value, text or a list of them");
  }
}

/// All of a tree of parameters, `params/time_horizon_s` as `params.time_horizon_s`.
void flatten(const std::string& name, XmlRpcValue value, Settings& flat) {
  if (value.getType() != XmlRpcValue::TypeStruct) {
    flat.emplace_back(name, text_of(name, value));
    return;
  }
  if (name == "team") {  // a parameter is a value or a folder: as a folder, its names are the team
    std::string mates;
    for (auto& [mate, settings] : value) mates += (mates.empty() ? "" : " ") + mate;
    flat.emplace_back(name, mates);
  }
  for (auto& [inner, inner_value] : value) flatten(name + "." + inner, inner_value, flat);
}

AvoiderInput input_in(const std::string& name, const XmlRpcValue& value) {
  const std::string text = words_in(name, value);
  if (text == "odometry") return AvoiderInput::odometry;
  if (text == "team_record") return AvoiderInput::team_record;
  if (text == "both") return AvoiderInput::both;
  throw std::runtime_error("~" + name + ": '" + text + "': expected odometry, team_record or both");
}

struct AvoiderParameter {
  const char* name;
  void (*set)(AvoiderSettings&, const std::string& name, const XmlRpcValue& value);
};

using A = AvoiderSettings;
using Word = const std::string&;
using Given = const XmlRpcValue&;
constexpr std::array avoider_parameters{
    AvoiderParameter{"scenario", [](A& s, Word n, Given v) { s.host.scenario = words_in(n, v); }},
    AvoiderParameter{"vehicle", [](A& s, Word n, Given v) { s.host.vehicle = words_in(n, v); }},
    AvoiderParameter{"seed", [](A& s, Word n, Given v) { s.host.seed = count_in(n, v); }},
    AvoiderParameter{"frame", [](A& s, Word n, Given v) { s.frame = bridge::frame_of(words_in(n, v)); }},
    AvoiderParameter{"input", [](A& s, Word n, Given v) { s.input = input_in(n, v); }},
    AvoiderParameter{"rate_hz", [](A& s, Word n, Given v) { s.rate_hz = number_in(n, v, 0.1, 1000); }},
    AvoiderParameter{"record_rate_hz",
                     [](A& s, Word n, Given v) { s.record_rate_hz = number_in(n, v, 0, 100); }},
    AvoiderParameter{"speed_mps", [](A& s, Word n, Given v) { s.speed_mps = number_in(n, v, 0.001, 100); }},
    AvoiderParameter{"advisory", [](A& s, Word n, Given v) { s.advisory = truth_in(n, v); }},
    AvoiderParameter{"lockstep", [](A& s, Word n, Given v) { s.lockstep = truth_in(n, v); }},
    AvoiderParameter{"draw", [](A& s, Word n, Given v) { s.draw = truth_in(n, v); }},
    AvoiderParameter{"test_hooks", [](A& s, Word n, Given v) { s.test_hooks = truth_in(n, v); }},
};

/// Whether the parameter is the node's own, and then it is set.
bool set_own(AvoiderSettings& settings, const std::string& name, const XmlRpcValue& value) {
  for (const AvoiderParameter& parameter : avoider_parameters) {
    if (name != parameter.name) continue;
    parameter.set(settings, name, value);
    return true;
  }
  return false;
}

}  // namespace

AvoiderSettings read_avoider_settings(const XmlRpcValue& parameters, const std::string& vehicle) {
  AvoiderSettings settings;
  settings.host.vehicle = vehicle;
  for (const AvoiderParameter& own : avoider_parameters) settings.host.also_known.emplace_back(own.name);

  XmlRpcValue given = parameters;
  if (given.getType() == XmlRpcValue::TypeStruct) {
    for (auto& [name, value] : given) {
      if (!set_own(settings, name, value)) flatten(name, value, settings.host.settings);
    }
  }
  if (settings.lockstep && settings.input == AvoiderInput::team_record)
    throw std::runtime_error("~lockstep needs the others' odometry: ~input: expected odometry or both");
  return settings;
}

}  // namespace fairway::ros1
