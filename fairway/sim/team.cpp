// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/team.hpp"

#include <algorithm>

namespace fairway {
namespace {

constexpr const char* team_count = "team_count";

}  // namespace

std::optional<Range> team_sizes(const Catalog& avoiders, std::string_view name) {
  if (!avoiders.needs(name, &AlgorithmInfo::needs_link)) return {};
  for (const ParamInfo& param : avoiders.params(name))
    if (param.name == team_count) return param.range;
  return {};
}

ParamValues avoider_params(const VehicleSpec& spec, const Scenario& scenario, const Catalog& avoiders) {
  const std::optional<Range> sizes = team_sizes(avoiders, spec.avoider->name);
  if (!sizes) return spec.avoider->params;
  double count = sizes->lo;
  for (const VehicleSpec& other : scenario.vehicles) {
    if (count < other.id + 1.0 && team_sizes(avoiders, other.avoider->name)) count = other.id + 1.0;
    if (count >= sizes->hi) break;
  }
  return merged({{team_count, std::min(count, sizes->hi)}}, spec.avoider->params);
}

std::optional<double> team_size(const VehicleSpec& spec, const Scenario& scenario, const Catalog& avoiders) {
  if (!team_sizes(avoiders, spec.avoider->name)) return {};
  const ParamValues params = avoider_params(spec, scenario, avoiders);
  return std::get<double>(std::ranges::find(params, team_count, &ParamValues::value_type::first)->second);
}

}  // namespace fairway
