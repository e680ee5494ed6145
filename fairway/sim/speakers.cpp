// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/speakers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>

#include "fairway/avoidance/pledge/bits.hpp"
#include "fairway/avoidance/pledge/words.hpp"

namespace fairway {
namespace {

constexpr std::array in_common{"datum_north_m", "datum_east_m", "tube_m"};

/// The value of a parameter of the vehicle's avoider; nothing where that has none of this name.
std::optional<double> value_of(const VehicleSpec& spec, const Catalog& avoiders, std::string_view name) {
  for (const auto& [said, value] : spec.avoider->params)
    if (said == name && std::holds_alternative<double>(value)) return std::get<double>(value);
  for (const ParamInfo& param : avoiders.params(spec.avoider->name))
    if (param.name == name) return std::get<double>(param.value);
  return {};
}

/// The first of all that have the same method, maybe itself.
const VehicleSpec& first_with_it(const VehicleSpec& spec, const Scenario& scenario) {
  return *std::ranges::find_if(
      scenario.vehicles, [&](const VehicleSpec& other) { return other.avoider->name == spec.avoider->name; });
}

/// Whether its method has the helm from its start on, and tells that.
bool tells_start(const VehicleSpec& spec) {
  return spec.mission.empty() || spec.mission.front().kind == LegKind::transit;
}

}  // namespace

std::vector<std::string> amiss_in_words(const VehicleSpec& spec, const Scenario& scenario,
                                        const Catalog& avoiders) {
  std::vector<std::string> clauses;
  const VehicleSpec& first = first_with_it(spec, scenario);
  for (const char* name : in_common) {
    const std::optional<double> own = value_of(spec, avoiders, name), other = value_of(first, avoiders, name);
    if (own && other && *own != *other)
      clauses.push_back(fmt::format(
          "has another {} ({:g}) than {} ({:g}), and all have to have the same for its claims to hold", name,
          *own, first.name, *other));
  }
  const std::optional<double> north = value_of(spec, avoiders, "datum_north_m"),
                              east = value_of(spec, avoiders, "datum_east_m");
  if (!north || !east) return clauses;
  const auto is_beyond = [&](const Vec3& place) { return !pledge::can_be_told(place, {*north, *east}); };
  const std::string reach =
      fmt::format("tells places within {:g} m of its datum, from the surface down to {:g} m, and ",
                  std::floor(-pledge::across.lowest), std::floor(pledge::depth.value(pledge::depth.last())));
  if (tells_start(spec) && is_beyond(spec.position))
    clauses.push_back(fmt::format("{}its start lies beyond: it stays there", reach));
  if (std::ranges::any_of(spec.mission, [&](const Leg& leg) {
        return (leg.kind == LegKind::transit || leg.kind == LegKind::go_to) && is_beyond(leg.position);
      }))
    clauses.push_back(fmt::format("{}a place of its mission lies beyond", reach));
  return clauses;
}

const VehicleSpec* first_stranger(const VehicleSpec& spec, const Scenario& scenario,
                                  const Catalog& avoiders) {
  const std::string_view own = avoiders.layers(spec.avoider->name).front()->info.name;
  const auto is_stranger = [&](const VehicleSpec& other) {
    return other.avoider->name != spec.avoider->name &&
           avoiders.layers(other.avoider->name).front()->info.name != own;
  };
  const auto found = std::ranges::find_if(scenario.vehicles, is_stranger);
  return found != scenario.vehicles.end() ? &*found : nullptr;
}

}  // namespace fairway
