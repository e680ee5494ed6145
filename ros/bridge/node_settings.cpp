// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/node_settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "fairway/core/names.hpp"

namespace fairway::bridge {
namespace {

using Name = const std::string&;
using Text = const std::string&;

double number_in(Name name, Text text, double least, double most) {
  double number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !(number >= least && number <= most)) {
    std::array<char, 64> range{};
    const auto middle = std::to_chars(range.data(), range.data() + 24, least).ptr;
    const std::string from{range.data(), middle};
    const auto last = std::to_chars(range.data(), range.data() + 24, most).ptr;
    throw std::runtime_error(name + ": '" + text + "': expected a number from " + from + " to " +
                             std::string{range.data(), last});
  }
  return number;
}

std::uint64_t count_in(Name name, Text text) {
  std::uint64_t number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::runtime_error(name + ": '" + text + "': expected a whole number from 0 on");
  return number;
}

bool truth_in(Name name, Text text) {
  if (text == "true" || text == "false") return text == "true";
  throw std::runtime_error(name + ": '" + text + "': expected true or false");
}

AvoiderInput input_in(Name name, Text text) {
  if (text == "odometry") return AvoiderInput::odometry;
  if (text == "team_record") return AvoiderInput::team_record;
  if (text == "both") return AvoiderInput::both;
  throw std::runtime_error(name + ": '" + text + "': expected odometry, team_record or both");
}

template <class Into>
struct Known {
  const char* name;
  const char* meaning;
  void (*set)(Into&, Name, Text);
};

using A = AvoiderNodeSettings;
constexpr std::array avoider_settings_known{
    Known<A>{"scenario", "file of a scenario that has the vehicle and its team",
             [](A& s, Name, Text t) { s.host.scenario = t; }},
    Known<A>{"vehicle", "whose avoider this is; the last part of the namespace unless given",
             [](A& s, Name, Text t) { s.host.vehicle = t; }},
    Known<A>{"seed", "of the method's random numbers",
             [](A& s, Name n, Text t) { s.host.seed = count_in(n, t); }},
    Known<A>{"frame", "of all messages: enu or ned", [](A& s, Name, Text t) { s.frame = frame_of(t); }},
    Known<A>{"input", "how it hears of the others: odometry, team_record or both",
             [](A& s, Name n, Text t) { s.input = input_in(n, t); }},
    Known<A>{"rate_hz", "it answers at least so often",
             [](A& s, Name n, Text t) { s.rate_hz = number_in(n, t, 0.1, 1000); }},
    Known<A>{"record_rate_hz", "how often it tells the team of itself; 0: never",
             [](A& s, Name n, Text t) { s.record_rate_hz = number_in(n, t, 0, 100); }},
    Known<A>{"speed_mps", "towards goals, which say nothing of speed",
             [](A& s, Name n, Text t) { s.speed_mps = number_in(n, t, 0.001, 100); }},
    Known<A>{"advisory", "it only advises", [](A& s, Name n, Text t) { s.advisory = truth_in(n, t); }},
    Known<A>{"lockstep", "it waits for everyone's navigation of one instant",
             [](A& s, Name n, Text t) { s.lockstep = truth_in(n, t); }},
    Known<A>{"draw", "publishes what the method draws",
             [](A& s, Name n, Text t) { s.draw = truth_in(n, t); }},
    Known<A>{"use_sim_time", "goes by /clock", [](A& s, Name n, Text t) { s.use_sim_time = truth_in(n, t); }},
};

using F = FleetNodeSettings;
constexpr std::array fleet_settings_known{
    Known<F>{"scenario", "file of the scenario", [](F& s, Name, Text t) { s.fleet.scenario = t; }},
    Known<F>{"seed", "of the run, instead of the scenario's",
             [](F& s, Name n, Text t) { s.fleet.seed = count_in(n, t); }},
    Known<F>{"command_timeout_s", "a vehicle without a command for so long holds",
             [](F& s, Name n, Text t) { s.fleet.command_timeout_s = number_in(n, t, 1e-3, 1e6); }},
    Known<F>{"record", "recording to write", [](F& s, Name, Text t) { s.fleet.record = t; }},
    Known<F>{"autonomous", "the scenario's own avoiders steer",
             [](F& s, Name n, Text t) { s.fleet.autonomous = truth_in(n, t); }},
    Known<F>{"frame", "of all messages: enu or ned", [](F& s, Name, Text t) { s.frame = frame_of(t); }},
    Known<F>{"speed", "seconds of the run per second; 0: as fast as it can",
             [](F& s, Name n, Text t) { s.speed = number_in(n, t, 0.0, 1e6); }},
    Known<F>{"lockstep", "waits in every instant for all commands",
             [](F& s, Name n, Text t) { s.lockstep = truth_in(n, t); }},
    Known<F>{"lockstep_timeout_s", "but no longer, of wall time",
             [](F& s, Name n, Text t) { s.lockstep_timeout_s = number_in(n, t, 1e-3, 1e6); }},
    Known<F>{"marker_rate_hz", "of the picture, of wall time; 0: none",
             [](F& s, Name n, Text t) { s.marker_rate_hz = number_in(n, t, 0.0, 1000.0); }},
    Known<F>{"wait_for_subscribers", "begins when every odometry has so many",
             [](F& s, Name n, Text t) { s.wait_for_subscribers = count_in(n, t); }},
    Known<F>{"paused", "begins paused", [](F& s, Name n, Text t) { s.paused = truth_in(n, t); }},
    Known<F>{"until_done", "ends with the run", [](F& s, Name n, Text t) { s.until_done = truth_in(n, t); }},
};

template <class Into, std::size_t n>
bool set_known(const std::array<Known<Into>, n>& known, Into& settings, Name name, Text text) {
  for (const Known<Into>& one : known) {
    if (name != one.name) continue;
    one.set(settings, name, text);
    return true;
  }
  return false;
}

template <class Into, std::size_t n>
std::string listing(const std::array<Known<Into>, n>& known) {
  std::string words;
  for (const Known<Into>& one : known) {
    const std::string name = one.name;
    words += "  " + name + std::string(name.size() < 22 ? 22 - name.size() : 1, ' ') + one.meaning + "\n";
  }
  return words;
}

}  // namespace

AvoiderNodeSettings avoider_node_settings(const Settings& settings, const std::string& vehicle) {
  AvoiderNodeSettings made;
  made.host.vehicle = vehicle;
  for (const auto& known : avoider_settings_known) made.host.also_known.emplace_back(known.name);
  for (const auto& [name, text] : settings)
    if (!set_known(avoider_settings_known, made, name, text)) made.host.settings.emplace_back(name, text);
  if (made.lockstep && made.input == AvoiderInput::team_record)
    throw std::runtime_error("lockstep: needs the others' odometry: input must be odometry or both");
  return made;
}

FleetNodeSettings fleet_node_settings(const Settings& settings) {
  constexpr std::string_view override_ = "override.";
  FleetNodeSettings made;
  for (const auto& [name, text] : settings) {
    if (name.starts_with(override_)) {
      made.fleet.overrides.emplace_back(name.substr(override_.size()), text);
    } else if (!set_known(fleet_settings_known, made, name, text)) {
      std::vector<std::string_view> names;
      for (const auto& one : fleet_settings_known) names.emplace_back(one.name);
      throw std::runtime_error(name + ": unknown setting" + suggestion(name, names));
    }
  }
  if (made.fleet.scenario.empty())
    throw std::runtime_error("scenario: expected the file of a scenario, as in scenario:=cube20_8.yaml");
  if (made.lockstep && made.fleet.autonomous)
    throw std::runtime_error("lockstep: an autonomous fleet waits for no command; expected one of the two");
  return made;
}

std::string topic_name(const std::string& vehicle) {
  std::string name = vehicle;
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_plain(c); }, '_');
  return name;
}

std::string avoider_node_words() { return listing(avoider_settings_known); }
std::string fleet_node_words() { return listing(fleet_settings_known); }

}  // namespace fairway::bridge
