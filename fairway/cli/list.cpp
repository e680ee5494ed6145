// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/comms/exchange.hpp"
#include "fairway/metrics/run_metrics.hpp"
#include "fairway/perception/lookout.hpp"
#include "fairway/perception/navigation.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::cli {
namespace {

struct Item {
  std::string name, title;
};

std::vector<Item> algorithms(const Catalog& catalog) {
  std::vector<Item> items;
  for (const Catalog::Entry& entry : catalog.entries()) {
    const std::string note = entry.wraps ? "; wraps another: orca3d+" + std::string(entry.info.name) : "";
    std::string title = std::string(entry.info.title) + note;
    if (const std::string_view ignorance = ignorance_of(entry.info); !ignorance.empty() && !entry.wraps)
      title += "; " + std::string(ignorance);
    std::string needs;
    for (const std::string_view word : catalog.needs_of(entry.info.name))
      needs += (needs.empty() ? "; needs " : ", ") + std::string(word);
    items.push_back({std::string(entry.info.name), title + needs});
  }
  return items;
}

std::vector<Item> vehicles(const VehicleCatalog& catalog) {
  std::vector<Item> items;
  for (const VehicleCatalog::Entry& entry : catalog.entries()) {
    items.push_back({std::string(entry.info.name), std::string(entry.info.title)});
  }
  return items;
}

std::vector<Item> scenarios(const std::string& directory) {
  std::vector<Item> items;
  std::error_code error;
  for (const auto& file : std::filesystem::directory_iterator(directory, error)) {
    if (file.path().extension() != ".yaml") continue;
    items.push_back({file.path().string(), load_scenario(file.path().string()).summary});
  }
  if (error) throw InputError(directory + ": cannot be read as a folder of scenarios");
  std::ranges::sort(items, {}, &Item::name);
  return items;
}

std::vector<Item> studies() {
  std::vector<Item> items;
  for (const Study& study : builtin_studies())
    items.push_back({std::string(study.name), std::string(study.title)});
  return items;
}

std::vector<Item> items_of(const std::vector<KindInfo>& kinds) {
  std::vector<Item> items;
  for (const KindInfo& kind : kinds) items.push_back({std::string(kind.name), std::string(kind.title)});
  return items;
}

std::vector<Item> metrics() {
  std::vector<Item> items;
  for (const QuantityInfo& quantity : all_quantities()) {
    items.push_back({std::string(quantity.name),
                     std::string(quantity.per_vehicle ? "per vehicle: " : "fleet: ") +
                         std::string(quantity.meaning) +
                         (quantity.complete_at_1.empty() ? "" : "; censored by the time limit")});
  }
  return items;
}

/// Everything that can be listed, by its name, in the order of a scenario.
using Lists = std::vector<std::pair<std::string, std::function<std::vector<Item>()>>>;
Lists lists(const Catalogs& catalogs, const std::string& directory) {
  return {{"algorithms", [&catalogs] { return algorithms(catalogs.avoiders); }},
          {"vehicles", [&catalogs] { return vehicles(catalogs.vehicles); }},
          {"exchanges", [] { return items_of(exchange_kinds()); }},
          {"perceptions", [] { return items_of(perception_kinds()); }},
          {"navigations", [] { return items_of(navigation_kinds()); }},
          {"scenarios", [directory] { return scenarios(directory); }},
          {"studies", studies},
          {"metrics", metrics}};
}

}  // namespace

void add_list(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "list",
      "What there is: algorithms, vehicles, exchanges, perceptions, navigations, scenarios, studies, "
      "metrics");
  verb->footer("Example: fairway list algorithms");
  auto kind = std::make_shared<std::string>();
  auto directory = std::make_shared<std::string>(shipped("scenarios"));
  auto json = std::make_shared<bool>(false);
  std::vector<std::string> kinds;
  for (const auto& [name, items] : lists(program.catalogs, *directory)) kinds.push_back(name);
  verb->add_option("kind", *kind, "one of them; all without it")->check(CLI::IsMember(kinds));
  verb->add_option("--dir", *directory, "where scenarios are looked for")
      ->check(not_empty())
      ->capture_default_str();
  verb->add_flag("--json", *json, "print JSON");
  program.on(*verb, [=, &program] {
    nlohmann::json document;
    for (const auto& [name, items] : lists(program.catalogs, *directory)) {
      if (!kind->empty() && *kind != name) continue;
      if (kind->empty() && name == "scenarios" && !std::filesystem::is_directory(*directory)) continue;
      if (!*json) std::cout << name << "\n";
      document[name] = nlohmann::json::array();
      for (const Item& item : items()) {
        if (!*json) std::cout << fmt::format("  {:<22} {}\n", item.name, item.title);
        document[name].push_back({{"name", item.name}, {"title", item.title}});
      }
    }
    if (*json) std::cout << document.dump(2) << "\n";
    return ok;
  });
}

}  // namespace fairway::cli
