// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/node_settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "fairway/core/names.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/text.hpp"

namespace fairway {

template <>
struct EnumNames<bridge::Frame> {
  static constexpr std::array names{"enu", "ned"};
};

template <>
struct EnumNames<bridge::AvoiderInput> {
  static constexpr std::array names{"odometry", "team_record", "both"};
};

namespace bridge {
namespace {

/// A setting whose name does not end in a unit: text, or a number.
template <auto Member>
consteval auto unitless(std::string_view meaning, Range range = {0.0, 9007199254740991.0}) {
  using Traits = detail::member_of<decltype(Member)>;
  return Field<typename Traits::owner, typename Traits::value>{Member, detail::member_name<Member>(), "",
                                                               range, meaning};
}

// The structs with their defaults stand in a header of C++17, which knows no fields().
struct AvoiderParams : AvoiderNodeSettings {
  static consteval auto fields() {
    using S = AvoiderNodeSettings;
    return std::tuple{
        unitless<&S::scenario>("file of a scenario that has the vehicle and its team"),
        unitless<&S::vehicle>("whose avoider this is; the last part of the namespace unless given"),
        unitless<&S::seed>("of the method's random numbers"),
        field<&S::frame>("of all messages: enu or ned"),
        field<&S::input>("how it hears of the others: odometry, team_record or both"),
        field<&S::rate_hz>({0.1, 1000}, "it answers at least so often"),
        field<&S::record_rate_hz>({0, 100}, "how often it tells the team of itself; 0: never"),
        field<&S::speed_mps>({0.001, 100}, "towards goals, which say nothing of speed"),
        field<&S::advisory>("it only advises"),
        field<&S::lockstep>("it waits for everyone's navigation of one instant"),
        field<&S::draw>("publishes what the method draws"),
        field<&S::use_sim_time>("goes by /clock; ROS 2 alone"),
        field<&S::test_hooks>("for tests: a message can make it hang; ROS 1 alone"),
    };
  }
};

struct FleetParams : FleetNodeSettings {
  static consteval auto fields() {
    using S = FleetNodeSettings;
    return std::tuple{
        unitless<&S::scenario>("file of the scenario"),
        unitless<&S::seed>("of the run, instead of the scenario's"),
        field<&S::command_timeout_s>({1e-3, 1e6}, "a vehicle without a command for so long holds"),
        unitless<&S::record>("recording to write"),
        field<&S::autonomous>("the scenario's own avoiders steer"),
        field<&S::frame>("of all messages: enu or ned"),
        unitless<&S::speed>("seconds of the run per second; 0: as fast as it can", {0, 1e6}),
        field<&S::lockstep>("waits in every instant for all commands"),
        field<&S::lockstep_timeout_s>({1e-3, 1e6}, "but no longer, of wall time"),
        field<&S::marker_rate_hz>({0, 1000}, "of the picture, of wall time; 0: none"),
        unitless<&S::wait_for_subscribers>("begins when every odometry has so many"),
        field<&S::paused>("begins paused"),
        field<&S::until_done>("ends with the run"),
    };
  }
};

/// Sets a member as its field says. Throws InputError as set_param().
template <class Target>
void assign(Target& target, std::string_view name, Range range, const std::string& text) {
  if constexpr (std::same_as<Target, std::string>) {
    target = text;
  } else if constexpr (std::same_as<Target, std::uint64_t> ||
                       std::same_as<Target, std::optional<std::uint64_t>>) {
    std::uint64_t whole{};  // all of which a number with a fraction cannot tell apart
    const char* const end = text.data() + text.size();
    if (const auto [stop, error] = std::from_chars(text.data(), end, whole);
        error == std::errc{} && stop == end && !text.empty()) {
      target = whole;
      return;
    }
    double number{};
    detail::assign(number, name, range, parse_value(text));
    if (number != std::floor(number))
      throw InputError({}, std::string(name), "is " + text + "; expected a whole number");
    target = static_cast<std::uint64_t>(number);
  } else {
    detail::assign(target, name, range, parse_value(text));
  }
}

/// Whether there is such a setting, and then it is set.
template <Reflected P>
bool set(P& params, std::string_view name, const std::string& text) {
  bool known = false;
  for_each_field<P>([&](const auto& f) {
    if (f.name != name) return;
    known = true;
    assign(params.*(f.member), name, f.range, text);
  });
  return known;
}

template <Reflected P>
std::string listing() {
  std::string words;
  for_each_field<P>([&](const auto& f) {
    const std::string gap(f.name.size() < 22 ? 22 - f.name.size() : 1, ' ');
    words.append("  ").append(f.name).append(gap).append(f.meaning).append("\n");
  });
  return words;
}

}  // namespace

AvoiderNodeSettings avoider_node_settings(const Settings& settings, const std::string& vehicle) {
  AvoiderParams made;
  made.vehicle = vehicle;
  for (const std::string_view name : param_names<AvoiderParams>()) made.also_known.emplace_back(name);
  for (const auto& [name, text] : settings)
    if (!set(made, name, text)) made.settings.emplace_back(name, text);
  if (made.lockstep && made.input == AvoiderInput::team_record)
    throw std::runtime_error("lockstep: needs the others' odometry: input must be odometry or both");
  return made;
}

FleetNodeSettings fleet_node_settings(const Settings& settings) {
  constexpr std::string_view override_ = "override.";
  FleetParams made;
  for (const auto& [name, text] : settings) {
    if (name.starts_with(override_)) {
      made.overrides.emplace_back(name.substr(override_.size()), text);
    } else if (!set(made, name, text)) {
      throw InputError({}, name, "unknown setting" + suggestion(name, param_names<FleetParams>()));
    }
  }
  if (made.scenario.empty())
    throw std::runtime_error("scenario: expected the file of a scenario, as in scenario:=cube20_8.yaml");
  if (made.lockstep && made.autonomous)
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

std::string avoider_node_words() { return listing<AvoiderParams>(); }
std::string fleet_node_words() { return listing<FleetParams>(); }

}  // namespace bridge
}  // namespace fairway
