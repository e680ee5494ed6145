// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/experiment/campaign_file.hpp"
#include "fairway/tuning/parameter_space.hpp"

namespace fairway {

/// Scenarios, each under the same seeds in a row.
struct TuningSet {
  std::vector<CampaignScenarioFile> scenarios;
  Overrides set;  ///< laid over each of them
  std::uint64_t first_seed{1};
  std::uint32_t seed_count{1};

  std::size_t runs() const { return scenarios.size() * seed_count; }
};

/// What is tuned, on what, and on what it is judged.
struct TuningFile {
  std::string name;
  std::string summary;
  CampaignAlgorithm method;
  std::vector<TunedParameter> parameters;
  TuningSet train;
  TuningSet validation;
  TuningSet test;
};

inline constexpr std::uint32_t least_train_seeds = 5;  ///< before so many of them nobody is rejected

/// What a specification asks for.
struct TuningSpecification {
  std::vector<TuningFile> tunings;  ///< one for each method, in the order in which they are written
  bool is_list{};                   ///< of methods, so that each has a folder by its label
};

/// Reads a specification and looks the parameters up among each method's. Throws InputError with file, line,
/// column, path and the nearest known name: also where a run to judge by is one to train on.
TuningSpecification parse_tuning_file(std::string_view yaml, const std::string& file, const Catalog& methods);

}  // namespace fairway
