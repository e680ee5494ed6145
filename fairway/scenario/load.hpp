// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/scenario/scenario.hpp"

namespace fairway {

namespace yaml {
struct Tree;
}

/// `--set path=value`: "vehicles[0].avoider.time_horizon_s", "5". A path may name every vehicle at
/// once as "vehicles[*]…".
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Whether a path says who avoids, as `vehicles[*].avoider`, and not only a parameter of it.
inline bool names_avoider(std::string_view path) {
  return path.ends_with(".avoider") || path.ends_with(".avoider.algorithm");
}

/// Reads a scenario file. Distributions ({uniform: [lo, hi]}, {normal: [mean, deviation]}) become
/// numbers drawn from `seed`, each from a stream named by its path, so that adding one shifts no
/// other. `seed` overrides the file's. Throws InputError with file, line, column, path, what was
/// expected and the nearest known key. Names of models, algorithms and their parameters are checked
/// later, by the catalogs.
Scenario load_scenario(const std::string& file, const Overrides& overrides = {},
                       std::optional<std::uint64_t> seed = {});

/// The same from text; `file` is used in messages.
Scenario parse_scenario(std::string_view yaml, const std::string& file, const Overrides& overrides = {},
                        std::optional<std::uint64_t> seed = {});

/// A scenario's text, read once for all the seeds and settings that it is made for. A value, cheap to copy.
class ScenarioDocument {
 public:
  /// `file` is used in messages. Throws InputError for what is not YAML, or not a scenario's.
  ScenarioDocument(std::string_view yaml, const std::string& file);

  /// What parse_scenario() makes of the text. Safe to call from several threads.
  Scenario scenario(const Overrides& overrides = {}, std::optional<std::uint64_t> seed = {}) const;

 private:
  std::shared_ptr<const yaml::Tree> tree_;
};

/// The scenario as YAML that parse_scenario() reads back to the same bits.
std::string to_yaml(const Scenario& scenario);

/// The JSON schema (draft 2020-12) of scenario files, for editors.
std::string scenario_schema();

}  // namespace fairway
