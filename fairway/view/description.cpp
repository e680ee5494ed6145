// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "fairway/comms/exchange.hpp"
#include "fairway/control/envelope.hpp"
#include "fairway/control/vehicle_limits.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/perception/lookout.hpp"
#include "fairway/perception/navigation.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {
namespace {

using nlohmann::json;

/// JSON has no infinity: a bound that is not there is null.
json bound(double value) { return std::isfinite(value) ? json(value) : json(); }

json value_json(const ParamValue& value) {
  return std::visit([](const auto& v) { return json(v); }, value);
}

json params_json(const std::vector<ParamInfo>& params) {
  json list = json::array();
  for (const ParamInfo& p : params) {
    json entry{{"name", p.name}, {"type", p.type}, {"default", value_json(p.value)}, {"meaning", p.meaning}};
    if (p.type == "number" || p.type == "integer") {
      entry["unit"] = p.unit;
      entry["range"] = {bound(p.range.lo), bound(p.range.hi)};
    }
    if (p.type == "choice") entry["choices"] = p.choices;
    if (p.type == "list") entry["items"] = params_json(p.items);
    list.push_back(std::move(entry));
  }
  return list;
}

json actuators_json(std::span<const ActuatorInfo> actuators) {
  json list = json::array();
  for (const ActuatorInfo& a : actuators) {
    list.push_back({{"name", a.name},
                    {"range", {bound(a.range.lo), bound(a.range.hi)}},
                    {"time_constant_s", a.time_constant_s},
                    {"meaning", a.meaning}});
  }
  return list;
}

/// The autopilot that a vehicle has by default; nothing where none drives it.
std::optional<Autopilot> autopilot_of(const Vehicle& vehicle) {
  try {
    return Autopilot{vehicle};
  } catch (const InputError&) {
    return {};
  }
}

/// The envelope under that autopilot, in steps of a scenario's default. Empty where none can be measured.
json envelope_json(const Vehicle& vehicle, const Autopilot& autopilot) {
  json list = json::array();
  const std::optional<Envelope> envelope =
      measured_envelope(vehicle, autopilot, narrowed({}, vehicle), Scenario{}.step_s);
  if (!envelope) return list;
  for_each_member<Envelope>([&](const auto& m) {
    list.push_back(
        {{"name", m.name_with_unit()}, {"value", json((*envelope).*m.at)}, {"meaning", m.meaning}});
  });
  return list;
}

/// Why a vehicle has no envelope, and who of the same source has one.
std::string without_autopilot(const Vehicle& vehicle, const VehicleCatalog& vehicles) {
  std::vector<std::string_view> names;
  for (const ActuatorInfo& actuator : vehicle.actuators()) names.push_back(actuator.name);
  std::string text =
      fmt::format("none, and so no envelope: it takes {}, which are neither thrusts nor velocities",
                  fmt::join(names, ", "));
  for (const VehicleCatalog::Entry& other : vehicles.entries())
    if (other.info.name != vehicle.info().name && other.info.source == vehicle.info().source &&
        autopilot_of(other.make({})))
      return fmt::format("{}; {} is the same vehicle with one", text, other.info.name);
  return text;
}

json vehicle_json(const VehicleCatalog::Entry& entry, const VehicleCatalog& vehicles) {
  const Vehicle vehicle = entry.make({});
  json document{{"kind", "vehicle"},
                {"name", entry.info.name},
                {"title", entry.info.title},
                {"source", entry.info.source},
                {"actuators", actuators_json(vehicle.actuators())},
                {"envelope", json::array()},
                {"parameters", params_json(entry.params)}};
  if (const std::optional<Autopilot> autopilot = autopilot_of(vehicle)) {
    document["envelope"] = envelope_json(vehicle, *autopilot);
  } else {
    document["autopilot"] = without_autopilot(vehicle, vehicles);
  }
  return document;
}

/// A kind of exchange, perception or navigation; `role` is its key in a scenario. Empty if none of `kinds` is
/// called so; all of them become known.
std::optional<json> described_kind(std::string_view role, const std::vector<KindInfo>& kinds,
                                   std::string_view name, std::vector<std::string_view>& known) {
  for (const KindInfo& kind : kinds) {
    known.push_back(kind.name);
    if (kind.name != name) continue;
    return json{{"kind", role},
                {"name", name},
                {"title", kind.title},
                {"source", kind.source},
                {"parameters", params_json(kind.params)}};
  }
  return {};
}

/// "sway, plane": what a method takes for granted.
std::string needs_text(const Catalog& catalog, const std::string& name) {
  const std::vector<std::string_view> words = catalog.needs_of(name);
  return words.empty() ? "nothing" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::optional<json> description(const std::string& name, const Catalogs& catalogs,
                                std::vector<std::string_view>& known) {
  if (name.find('+') != std::string::npos) {
    return json{{"kind", "algorithm"},
                {"name", name},
                {"ignores_obstacles", catalogs.avoiders.ignores(name, &AlgorithmInfo::ignores_obstacles)},
                {"ignores_movers", catalogs.avoiders.ignores(name, &AlgorithmInfo::ignores_movers)},
                {"needs", needs_text(catalogs.avoiders, name)},
                {"parameters", params_json(catalogs.avoiders.params(name))}};
  }
  for (const Catalog::Entry& entry : catalogs.avoiders.entries()) {
    known.push_back(entry.info.name);
    if (entry.info.name != name) continue;
    return json{{"kind", "algorithm"},
                {"name", name},
                {"title", entry.info.title},
                {"source", entry.info.source},
                {"planar", entry.info.planar},
                {"ignores_obstacles", entry.info.ignores_obstacles},
                {"ignores_movers", entry.info.ignores_movers},
                {"needs", needs_text(catalogs.avoiders, name)},
                {"wraps", entry.wraps},
                {"parameters", params_json(entry.params)}};
  }
  for (const VehicleCatalog::Entry& entry : catalogs.vehicles.entries()) {
    known.push_back(entry.info.name);
    if (entry.info.name == name) return vehicle_json(entry, catalogs.vehicles);
  }
  const std::vector<QuantityInfo> quantities = all_quantities();
  for (const QuantityInfo& quantity : quantities) {
    known.push_back(quantity.name);
    if (quantity.name == name) {
      return json{{"kind", "metric"},
                  {"name", name},
                  {"meaning", quantity.meaning},
                  {"per_vehicle", quantity.per_vehicle},
                  {"censored_by_time_limit", !quantity.complete_at_1.empty()}};
    }
  }
  if (auto kind = described_kind("exchange", exchange_kinds(), name, known)) return kind;
  if (auto kind = described_kind("perception", perception_kinds(), name, known)) return kind;
  return described_kind("navigation", navigation_kinds(), name, known);
}

}  // namespace fairway
