// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/team.hpp"

#include <algorithm>

namespace fairway {
namespace {

constexpr std::string_view team_count = "team_count";

}  // namespace

std::optional<Range> team_sizes(const Catalog& avoiders, std::string_view name) {
  if (!avoiders.needs(name, &AlgorithmInfo::needs_link)) return {};
  for (const ParamInfo& param : avoiders.params(name))
    if (param.name == team_count) return param.range;
  return {};
}

ParamValues avoider_params(const VehicleSpec& spec, const Scenario& scenario, const Catalog& avoiders) {
  ParamValues params = spec.avoider.params;
  const std::optional<Range> sizes = team_sizes(avoiders, spec.avoider.name);
  if (!sizes || std::ranges::find(params, team_count, &ParamValues::value_type::first) != params.end())
    return params;
  double count = sizes->lo;
  for (const VehicleSpec& other : scenario.vehicles) {
    if (count < other.id + 1.0 && team_sizes(avoiders, other.avoider.name)) count = other.id + 1.0;
    if (count >= sizes->hi) break;
  }
  params.emplace_back(team_count, std::min(count, sizes->hi));
  return params;
}

}  // namespace fairway
