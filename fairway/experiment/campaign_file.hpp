// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/scenario/load.hpp"

/// The campaign format as written, before it is expanded.
namespace fairway {

/// Where something is written, for errors about it.
struct WrittenPlace {
  Location where;
  std::string path;  ///< of the key: "algorithms[1]"
};

struct CampaignAlgorithm {
  std::string label;
  std::string avoider;  ///< YAML for `vehicles[*].avoider`
  WrittenPlace place{};
};

/// One path with the values that it takes, as YAML.
struct CampaignAxis {
  std::string path;
  std::vector<std::string> values;
};

struct CampaignScenarioFile {
  std::string path;  ///< as written
  Location where;
};

struct CampaignFile {
  std::int32_t version{};
  std::string name;
  std::string summary;
  std::vector<CampaignScenarioFile> scenarios;
  Overrides set;                              ///< laid over every scenario and algorithm
  std::vector<CampaignAlgorithm> algorithms;  ///< empty: as each scenario has them
  std::vector<CampaignAxis> grid;
  std::vector<Overrides> zip;  ///< rows that all set the same paths
  std::uint64_t first_seed{1};
  std::uint32_t seed_count{1};
  std::vector<std::string> quantities;
};

/// Throws InputError with file, line, column, path and the nearest known key.
CampaignFile parse_campaign_file(std::string_view yaml, const std::string& file);

/// The JSON schema (draft 2020-12) of campaign files, for editors.
std::string campaign_schema();

}  // namespace fairway
