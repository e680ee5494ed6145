// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/load.hpp"

#include "fairway/scenario/overrides.hpp"
#include "fairway/scenario/parts.hpp"

namespace fairway {

ScenarioDocument::ScenarioDocument(std::string_view text, const std::string& file) {
  yaml::Tree document = yaml::parse_tree(text, file);
  if (!document.is_map())
    throw InputError({file}, "", "not a scenario: expected keys such as fairway, name and vehicles");
  if (const yaml::Tree* campaign = document.find("fairway_campaign")) {
    throw InputError(campaign->where.location(), "fairway_campaign",
                     "this is a campaign, not a scenario; fairway sweep " + file + " --out RESULTS runs it");
  }
  tree_ = std::make_shared<const yaml::Tree>(std::move(document));
}

Scenario ScenarioDocument::scenario(const Overrides& overrides, std::optional<std::uint64_t> seed) const {
  yaml::Tree document = *tree_;
  yaml::apply(document, overrides, seed);

  // the seed decides what the distributions become, so it is read before anything else
  yaml::Reading reading{yaml::seed_of(document, seed)};
  if (const yaml::Tree* missions = document.find("missions")) {
    for (std::size_t i = 0; i < missions->keys.size(); ++i)
      reading.missions.emplace(missions->keys[i], &missions->items[i]);
  }

  Scenario scenario;
  yaml::read_block(yaml::Value{document, "", reading}, yaml::scenario_block(), scenario);
  if (seed) scenario.seed = *seed;
  yaml::check_vehicles({*document.find("vehicles"), "vehicles", reading}, scenario);
  return scenario;
}

Scenario parse_scenario(std::string_view text, const std::string& file, const Overrides& overrides,
                        std::optional<std::uint64_t> seed) {
  return ScenarioDocument{text, file}.scenario(overrides, seed);
}

Scenario load_scenario(const std::string& file, const Overrides& overrides,
                       std::optional<std::uint64_t> seed) {
  const std::optional<std::string> text = yaml::document_in(file);
  if (!text) throw InputError({file}, "", "cannot be read");
  return parse_scenario(*text, file, overrides, seed);
}

std::string to_yaml(const Scenario& scenario) {
  return yaml_text(yaml::write_block(yaml::scenario_block(), scenario).value_or(yaml::Tree::map()));
}

}  // namespace fairway
