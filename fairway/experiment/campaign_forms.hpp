// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/experiment/campaign_file.hpp"
#include "fairway/scenario/block.hpp"

/// What files about many runs have in common: the forms of their values.
namespace fairway::yaml {

/// Of a value that is never written.
template <class T>
Form<T> read_only(std::function<T(const Value&)> read, const Tree& schema) {
  return {.read = std::move(read), .write = [](const T&) { return std::optional<Tree>{}; }, .schema = schema};
}

/// A JSON schema that stands in the source as text.
Tree schema_text(std::string_view json);

/// A value as YAML on one line, fit for `--set` and for a table.
std::string one_line(const Tree& tree, bool nested = false);

/// The path of a scenario, or a list of such.
Form<std::vector<CampaignScenarioFile>> scenario_files();

/// `apf`, or a mapping of `algorithm`, parameters and, unless it is the name, `label`; or `{file:
/// tuned.yaml}` in which such a mapping stands.
CampaignAlgorithm read_algorithm(const Value& value);

/// Calls `ask`, which asks a catalog for what is written at `place`: an InputError of it then says where.
template <class Ask>
void ask_of(const WrittenPlace& place, const Ask& ask) {
  try {
    ask();
  } catch (const InputError& error) {
    throw InputError(place.where, place.path, error.what());
  }
}

/// Whether settings may have parameters of who avoids, as `vehicles[*].avoider.time_horizon_s`.
enum class AvoiderParameters { taken, refused };

/// `{exchange: none, step_s: 0.1}`: paths as for --set, each with what it is set to. The seed and who avoids
/// are refused, being set by `others`.
Form<Overrides> settings(std::string_view others, AvoiderParameters parameters);

/// A name that fits into a table and a comment: of one line, without control characters.
Form<std::string> title();

/// How many seeds in a row.
Form<std::uint32_t> seed_count();

}  // namespace fairway::yaml
