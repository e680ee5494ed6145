// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/sim_settings.hpp"

#include <array>
#include <stdexcept>

#include "fairway/core/names.hpp"
#include "ros/ros1/parameters.hpp"

namespace fairway::ros1 {
namespace {

using bridge::FleetNodeSettings;
using XmlRpc::XmlRpcValue;

bridge::Settings overrides_in(const std::string& name, const XmlRpcValue& value) {
  bridge::Settings overrides;
  for (const std::string& text : list_in(name, value)) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error("~" + name + ": '" + text + "': expected path=value, several as a list");
    overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return overrides;
}

struct SimParameter {
  const char* name;
  void (*set)(FleetNodeSettings&, const std::string& name, const XmlRpcValue& value);
};

using S = FleetNodeSettings;
using Name = const std::string&;
using Value = const XmlRpcValue&;
constexpr std::array sim_parameters{
    SimParameter{"scenario", [](S& s, Name n, Value v) { s.fleet.scenario = words_in(n, v); }},
    SimParameter{"overrides", [](S& s, Name n, Value v) { s.fleet.overrides = overrides_in(n, v); }},
    SimParameter{"seed", [](S& s, Name n, Value v) { s.fleet.seed = count_in(n, v); }},
    SimParameter{"command_timeout_s",
                 [](S& s, Name n, Value v) { s.fleet.command_timeout_s = number_in(n, v, 1e-3, 1e6); }},
    SimParameter{"record", [](S& s, Name n, Value v) { s.fleet.record = words_in(n, v); }},
    SimParameter{"autonomous", [](S& s, Name n, Value v) { s.fleet.autonomous = truth_in(n, v); }},
    SimParameter{"frame", [](S& s, Name n, Value v) { s.frame = bridge::frame_of(words_in(n, v)); }},
    SimParameter{"speed", [](S& s, Name n, Value v) { s.speed = number_in(n, v, 0.0, 1e6); }},
    SimParameter{"lockstep", [](S& s, Name n, Value v) { s.lockstep = truth_in(n, v); }},
    SimParameter{"lockstep_timeout_s",
                 [](S& s, Name n, Value v) { s.lockstep_timeout_s = number_in(n, v, 1e-3, 1e6); }},
    SimParameter{"marker_rate_hz",
                 [](S& s, Name n, Value v) { s.marker_rate_hz = number_in(n, v, 0.0, 1000.0); }},
    SimParameter{"wait_for_subscribers",
                 [](S& s, Name n, Value v) { s.wait_for_subscribers = count_in(n, v); }},
    SimParameter{"paused", [](S& s, Name n, Value v) { s.paused = truth_in(n, v); }},
    SimParameter{"until_done", [](S& s, Name n, Value v) { s.until_done = truth_in(n, v); }},
};

void set_parameter(FleetNodeSettings& settings, const std::string& name, const XmlRpcValue& value) {
  std::vector<std::string_view> known;
  for (const SimParameter& parameter : sim_parameters) {
    if (name == parameter.name) return parameter.set(settings, name, value);
    known.emplace_back(parameter.name);
  }
  throw std::runtime_error("~" + name + ": unknown parameter" + suggestion(name, known));
}

}  // namespace

bridge::FleetNodeSettings read_sim_settings(const XmlRpcValue& parameters) {
  bridge::FleetNodeSettings settings;
  XmlRpcValue given = parameters;
  if (given.getType() == XmlRpcValue::TypeStruct) {
    for (auto& [name, value] : given) set_parameter(settings, name, value);
  }
  if (settings.fleet.scenario.empty())
    throw std::runtime_error("~scenario: expected the file of a scenario, as in _scenario:=cube20_8.yaml");
  if (settings.lockstep && settings.fleet.autonomous)
    throw std::runtime_error("~lockstep: an autonomous fleet waits for no command; expected one of the two");
  return settings;
}

}  // namespace fairway::ros1
