// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/program.hpp"
#include "fairway/comms/exchange.hpp"
#include "fairway/control/envelope.hpp"
#include "fairway/control/vehicle_limits.hpp"
#include "fairway/core/text.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/perception/lookout.hpp"
#include "fairway/perception/navigation.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::cli {
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

/// The envelope under the autopilot that the vehicle has by default, in steps of a scenario's default. Empty
/// where no autopilot drives it.
json envelope_json(const Vehicle& vehicle) {
  json list = json::array();
  const auto envelope = [&]() -> std::optional<Envelope> {
    try {
      return measured_envelope(vehicle, Autopilot{vehicle}, narrowed({}, vehicle), Scenario{}.step_s);
    } catch (const InputError&) {
      return {};
    }
  }();
  if (!envelope) return list;
  for_each_member<Envelope>([&](const auto& m) {
    list.push_back(
        {{"name", m.name_with_unit()}, {"value", json((*envelope).*m.at)}, {"meaning", m.meaning}});
  });
  return list;
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

json describe(const std::string& name, const Catalogs& catalogs) {
  std::vector<std::string_view> known;
  if (name.find('+') != std::string::npos) {
    return {{"kind", "algorithm"},
            {"name", name},
            {"ignores_obstacles", catalogs.avoiders.ignores(name, &AlgorithmInfo::ignores_obstacles)},
            {"ignores_movers", catalogs.avoiders.ignores(name, &AlgorithmInfo::ignores_movers)},
            {"needs", needs_text(catalogs.avoiders, name)},
            {"parameters", params_json(catalogs.avoiders.params(name))}};
  }
  for (const Catalog::Entry& entry : catalogs.avoiders.entries()) {
    known.push_back(entry.info.name);
    if (entry.info.name != name) continue;
    return {{"kind", "algorithm"},
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
    if (entry.info.name != name) continue;
    const Vehicle vehicle = entry.make({});
    return {{"kind", "vehicle"},
            {"name", name},
            {"title", entry.info.title},
            {"source", entry.info.source},
            {"actuators", actuators_json(vehicle.actuators())},
            {"envelope", envelope_json(vehicle)},
            {"parameters", params_json(entry.params)}};
  }
  for (const Study& study : builtin_studies()) {
    known.push_back(study.name);
    if (study.name == name) {
      return {{"kind", "study"}, {"name", name}, {"title", study.title}, {"source", study.source}};
    }
  }
  const std::vector<QuantityInfo> quantities = all_quantities();
  for (const QuantityInfo& quantity : quantities) {
    known.push_back(quantity.name);
    if (quantity.name == name) {
      return {{"kind", "metric"},
              {"name", name},
              {"meaning", quantity.meaning},
              {"per_vehicle", quantity.per_vehicle},
              {"censored_by_time_limit", !quantity.complete_at_1.empty()}};
    }
  }
  if (const auto kind = described_kind("exchange", exchange_kinds(), name, known)) return *kind;
  if (const auto kind = described_kind("perception", perception_kinds(), name, known)) return *kind;
  if (const auto kind = described_kind("navigation", navigation_kinds(), name, known)) return *kind;
  throw InputError("nothing is called \"" + name + "\"" + suggestion(name, known));
}

std::string text_of(const json& value) {
  if (value.is_null()) return "none";
  if (value.is_number()) return number_text(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// To three digits; a list in brackets.
std::string rounded(const json& value) {
  if (!value.is_array()) return fmt::format("{:.3g}", value.get<double>());
  return fmt::format("[{:.3g}]", fmt::join(value.get<std::vector<double>>(), ", "));
}

void print_entry(const json& entry, const std::string& list = {}) {
  const std::string name = list + entry["name"].get<std::string>();
  std::string range;
  if (entry.contains("range"))
    range = fmt::format("[{}, {}]", text_of(entry["range"][0]), text_of(entry["range"][1]));
  if (entry.contains("choices")) range = entry["choices"].dump();
  if (entry.contains("items")) range = "list";
  const std::string value = entry.contains("default") ? text_of(entry["default"]) : "";
  std::cout << fmt::format("  {:<32} {:<12} {:<24} {}\n", name, value, range,
                           entry["meaning"].get<std::string>());
  if (!entry.contains("items")) return;
  for (const json& item : entry["items"]) print_entry(item, name + "[i].");
}

void print_table(const json& entries, std::string_view title) {
  if (entries.empty()) return;
  std::cout << title << "\n";
  for (const json& entry : entries) print_entry(entry);
}

void print(const json& document) {
  for (const auto& [key, value] : document.items()) {
    if (value.is_array()) continue;
    std::cout << fmt::format("{:<18} {}\n", key, text_of(value));
  }
  print_table(document.value("actuators", json::array()), "actuators (name, limits, meaning)");
  const json envelope = document.value("envelope", json::array());
  if (!envelope.empty())
    std::cout << "envelope in still water, without limits of a mission (name, value, meaning)\n";
  for (const json& entry : envelope)
    std::cout << fmt::format("  {:<26} {:<28} {}\n", entry["name"].get<std::string>(),
                             rounded(entry["value"]), entry["meaning"].get<std::string>());
  print_table(document.value("parameters", json::array()), "parameters (name, default, range, meaning)");
}

}  // namespace

void add_describe(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "describe", "An algorithm, vehicle, study, metric or kind of exchange: source, parameters");
  verb->footer("Example: fairway describe orca3d+stop_and_wait");
  auto name = std::make_shared<std::string>();
  auto as_json = std::make_shared<bool>(false);
  verb->add_option("name", *name, "as `fairway list` shows it")->required();
  verb->add_flag("--json", *as_json, "print JSON");
  program.on(*verb, [=, &program] {
    const json document = describe(*name, program.catalogs);
    if (*as_json) {
      std::cout << document.dump(2) << "\n";
    } else {
      print(document);
    }
    return ok;
  });
}

}  // namespace fairway::cli
