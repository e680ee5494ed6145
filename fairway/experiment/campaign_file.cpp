// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/campaign_file.hpp"

#include <algorithm>
#include <span>

#include "fairway/core/names.hpp"
#include "fairway/experiment/campaign_forms.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/metrics/run_metrics.hpp"

namespace fairway {
namespace {

using yaml::Block;
using yaml::Needed;
using yaml::one_line;
using yaml::read_only;
using yaml::schema_text;
using yaml::Tree;
using yaml::Value;

std::int32_t read_version(const Value& value) {
  const auto version = value.whole<std::int32_t>();
  if (version != 1)
    value.refuse("is " + std::to_string(version) + "; this fairway reads campaigns of version 1");
  return version;
}

std::vector<CampaignAlgorithm> read_algorithms(const Value& value) {
  value.expect_list("algorithms");
  std::vector<CampaignAlgorithm> algorithms;
  for (std::size_t i = 0; i < value.tree().items.size(); ++i) {
    const Value entry = value.entry(i);
    CampaignAlgorithm algorithm = yaml::read_algorithm(entry);
    const auto same = [&](const CampaignAlgorithm& a) { return a.label == algorithm.label; };
    if (std::any_of(algorithms.begin(), algorithms.end(), same)) {
      entry.refuse("a second " + algorithm.label + "; give it a label of its own");
    }
    algorithms.push_back(std::move(algorithm));
  }
  if (algorithms.empty()) value.refuse("the list is empty; leave the key out to keep each scenario's own");
  return algorithms;
}

/// What a campaign sets by keys of its own cannot be set by a path too.
void check_path(const Value& map, std::size_t i) {
  const std::string& path = map.tree().keys[i];
  if (path == "seed") map.refuse_key(i, "is set by the key seeds");
  if (!can_be_label(path) || path == "case" || path == "method")
    map.refuse_key(i, "is no path in a scenario");
}

std::vector<CampaignAxis> read_grid(const Value& value) {
  value.expect_map("paths as for --set, each with a list of values");
  std::vector<CampaignAxis> grid;
  for (std::size_t i = 0; i < value.tree().items.size(); ++i) {
    check_path(value, i);
    const Value list = value.entry(i);
    if (!list.tree().is_list() || list.tree().items.empty()) list.expected("a list of values, as [6, 7, 10]");
    CampaignAxis axis{.path = value.tree().keys[i], .values = {}};
    for (std::size_t j = 0; j < list.tree().items.size(); ++j) {
      std::string text = one_line(list.tree().items[j]);
      if (std::find(axis.values.begin(), axis.values.end(), text) != axis.values.end()) {
        list.entry(j).refuse(text + " is given twice");
      }
      axis.values.push_back(std::move(text));
    }
    grid.push_back(std::move(axis));
  }
  return grid;
}

std::vector<Overrides> read_zip(const Value& value) {
  value.expect_list("mappings, each of paths to values");
  std::vector<Overrides> rows;
  for (std::size_t i = 0; i < value.tree().items.size(); ++i) {
    const Value row = value.entry(i);
    if (!row.tree().is_map() || row.tree().items.empty()) row.expected("a mapping of paths to values");
    Overrides settings;
    for (std::size_t j = 0; j < row.tree().items.size(); ++j) {
      check_path(row, j);
      settings.emplace_back(row.tree().keys[j], one_line(row.tree().items[j]));
    }
    // a table needs the same columns for every row
    const auto same_paths = [&](const Overrides& other) {
      return std::equal(other.begin(), other.end(), settings.begin(), settings.end(),
                        [](const auto& a, const auto& b) { return a.first == b.first; });
    };
    if (!rows.empty() && !same_paths(rows.front()))
      row.refuse("must set what the first row sets, in the same order");
    if (std::find(rows.begin(), rows.end(), settings) != rows.end()) row.refuse("is given twice");
    rows.push_back(std::move(settings));
  }
  return rows;
}

/// Names of quantities, or `all` alone.
std::vector<std::string> read_quantities(const Value& value) {
  static const std::vector<QuantityInfo> known = all_quantities();
  std::vector<std::string> names = yaml::list_of(yaml::name(), "names of quantities").read(value);
  if (names == std::vector<std::string>{"all"}) return names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::ranges::count(std::span{names}.first(i), names[i]) > 0)
      value.entry(i).refuse(yaml::shown(names[i]) + " is given twice");
    if (std::ranges::find(known, names[i], &QuantityInfo::name) != known.end()) continue;
    std::vector<std::string_view> all;
    for (const QuantityInfo& quantity : known) all.push_back(quantity.name);
    value.entry(i).refuse("no run measures " + yaml::shown(names[i]) + suggestion(names[i], all));
  }
  return names;
}

constexpr std::string_view algorithms_schema_text =
    R"({"type": "array", "minItems": 1, "items": {"anyOf": [{"type": "string", "minLength": 1},
        {"type": "object", "anyOf": [{"required": ["algorithm"]}, {"required": ["file"]}],
         "properties": {"algorithm": {"type": "string", "minLength": 1},
                        "file": {"type": "string", "minLength": 1},
                        "label": {"type": "string", "minLength": 1}}}]}})";
constexpr std::string_view grid_schema_text =
    R"({"type": "object", "additionalProperties": {"type": "array", "minItems": 1}})";
constexpr std::string_view zip_schema_text =
    R"({"type": "array", "items": {"type": "object", "minProperties": 1}})";

const Block<CampaignFile>& campaign_block() {
  static const Block<CampaignFile> seeds{
      key("first", &CampaignFile::first_seed, yaml::seed(), "Default 1."),
      key("count", &CampaignFile::seed_count, yaml::seed_count(), "How many in a row.", Needed::yes)};
  static const Block<CampaignFile> block{
      key("fairway_campaign", &CampaignFile::version,
          read_only<std::int32_t>(read_version, schema_text(R"({"const": 1})")), "The format's version, 1.",
          Needed::yes),
      key("name", &CampaignFile::name, yaml::title(), "Of the campaign.", Needed::yes),
      key("summary", &CampaignFile::summary, yaml::text(), "What it is meant to find out."),
      key("scenario", &CampaignFile::scenarios, yaml::scenario_files(),
          "One scenario or several, relative to this file. The label case is the file's name.", Needed::yes),
      key("set", &CampaignFile::set,
          yaml::settings("the keys seeds and algorithms", yaml::AvoiderParameters::taken),
          "Paths as for --set, laid over every scenario."),
      key("algorithms", &CampaignFile::algorithms,
          read_only<std::vector<CampaignAlgorithm>>(read_algorithms, schema_text(algorithms_schema_text)),
          "Replace every vehicle's avoider, one after the other. Default: as_written, each scenario's own."),
      key("grid", &CampaignFile::grid,
          read_only<std::vector<CampaignAxis>>(read_grid, schema_text(grid_schema_text)),
          "Paths as for --set, each with its values; every combination is run."),
      key("zip", &CampaignFile::zip,
          read_only<std::vector<Overrides>>(read_zip, schema_text(zip_schema_text)),
          "Settings that change together, one row after the other."),
      group("seeds", seeds, "The same for every cell, so that runs are compared in pairs. Default: 1 alone."),
      key("quantities", &CampaignFile::quantities,
          read_only<std::vector<std::string>>(read_quantities,
                                              yaml::list_of(yaml::name(), "names of quantities").schema),
          "Those to print; `fairway list metrics`. Default: all."),
  };
  return block;
}

}  // namespace

CampaignFile parse_campaign_file(std::string_view text, const std::string& file) {
  const Tree document = yaml::parse_tree(text, file);
  if (!document.is_map()) {
    throw InputError({file, 0, 0}, "",
                     "not a campaign: expected keys such as fairway_campaign, name and scenario");
  }
  if (const Tree* scenario = document.find("fairway");
      scenario != nullptr && document.find("fairway_campaign") == nullptr) {
    throw InputError(scenario->where.location(), "fairway",
                     "this is a scenario, not a campaign, which begins with fairway_campaign; fairway run " +
                         file + " runs it");
  }
  yaml::Reading reading{0};
  const Value root{document, "", reading};
  CampaignFile campaign;
  yaml::read_block(root, campaign_block(), campaign);

  // no path may be set twice, nor what the algorithms set
  for (const char* key : {"set", "grid", "zip"}) {
    const auto place = std::find(document.keys.begin(), document.keys.end(), key);
    if (place == document.keys.end()) continue;
    Value map = root.entry(static_cast<std::size_t>(place - document.keys.begin()));
    if (map.tree().items.empty()) continue;
    if (map.tree().is_list()) map = map.entry(0);
    for (std::size_t i = 0; i < map.tree().keys.size(); ++i) {
      const std::string& path = map.tree().keys[i];
      const bool avoider = names_avoider(path) || path.starts_with("defaults.avoider.");
      if (avoider && !campaign.algorithms.empty())
        map.refuse_key(i, "is set by the key algorithms; what they leave open is vehicles[*].avoider.KEY");
      if (map.path() == "set") continue;
      const auto in_set = [&](const auto& setting) { return setting.first == path; };
      if (std::any_of(campaign.set.begin(), campaign.set.end(), in_set))
        map.refuse_key(i, "is set by set too");
      const auto in_grid = [&](const CampaignAxis& axis) { return axis.path == path; };
      if (map.path().starts_with("zip") && std::any_of(campaign.grid.begin(), campaign.grid.end(), in_grid)) {
        map.refuse_key(i, "is set by grid too");
      }
    }
  }
  if (campaign.first_seed + (campaign.seed_count - 1) < campaign.first_seed) {
    throw InputError({file, 0, 0}, "seeds", "pass the largest seed there is");
  }
  return campaign;
}

std::string campaign_schema() {
  Tree schema = Tree::map(
      {{"$schema", Tree::quote("https://json-schema.org/draft/2020-12/schema")},
       {"title", Tree::quote("fairway campaign")},
       {"description", Tree::quote("Scenarios, algorithms and settings to run under the same seeds.")}});
  Tree body = yaml::schema_of(campaign_block());
  for (std::size_t i = 0; i < body.keys.size(); ++i) schema.set(body.keys[i], std::move(body.items[i]));
  return yaml::json_text(schema);
}

}  // namespace fairway
