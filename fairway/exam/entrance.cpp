// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/entrance.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/experiment/campaign_forms.hpp"
#include "fairway/scenario/block.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/team.hpp"

namespace fairway {
namespace {

bool is_news(const ObstacleSpec& obstacle) { return obstacle.moves() || !obstacle.charted; }

/// Why not all that moves in a family is a group whose members have a method and hear each other by it.
std::string why_no_group(const Catalog& methods, std::string_view algorithm, const ExamFamily& family) {
  const std::optional<Range> sizes = team_sizes(methods, algorithm);
  for (const ExamGround& ground : family.grounds) {
    const Scenario scenario = first_test(family, ground, {});
    if (family.keep_named_avoiders || std::ranges::any_of(scenario.obstacles, is_news) ||
        !std::ranges::all_of(scenario.vehicles, &VehicleSpec::cooperative))
      return "avoids whoever speaks as it does, and not everything there speaks";
    const auto count = static_cast<double>(scenario.vehicles.size());
    if (sizes && (count < sizes->lo || count > sizes->hi))
      return fmt::format("is for groups of {:.0f} to {:.0f}, and {} has {:.0f}", sizes->lo, sizes->hi,
                         ground.name, count);
  }
  return {};
}

}  // namespace

Choice choice_of(const CampaignAlgorithm& method) {
  const yaml::Tree tree = yaml::parse_tree(method.avoider, method.label);
  yaml::Reading reading;
  return yaml::read_choice({tree, "", reading}, "algorithm", yaml::Needed::yes);
}

std::string algorithm_of(const CampaignAlgorithm& method) { return choice_of(method).name; }

void expect_known(const CampaignAlgorithm& method, const Catalog& methods) {
  yaml::ask_of(method.place, [&] { methods.params(algorithm_of(method)); });
}

std::string why_not(const Catalog& methods, std::string_view algorithm, const ExamFamily& family) {
  if (family.needs_space && methods.needs(algorithm, &AlgorithmInfo::planar))
    return "thinks in the plane, and the ways there lead up and down";
  if (family.needs_obstacles && methods.ignores(algorithm, &AlgorithmInfo::ignores_obstacles))
    return "ignores obstacles, and there are some";
  if (family.needs_way && methods.needs(algorithm, &AlgorithmInfo::needs_stopping))
    return "has to stop now and then, and not everybody there can";
  const bool ignores_movers = methods.ignores(algorithm, &AlgorithmInfo::ignores_movers);
  if (ignores_movers && methods.needs(algorithm, &AlgorithmInfo::needs_link))
    return why_no_group(methods, algorithm, family);
  if (family.needs_movers && ignores_movers) return "ignores whatever moves, and something does";
  return {};
}

std::string why_not_under(const Catalog& methods, std::string_view algorithm, const ExamFamily& family,
                          const ExamCondition& condition) {
  const auto is_silent = [&](const ExamGround& ground) {
    return first_test(family, ground, condition).exchange.name == "none";
  };
  if (methods.needs(algorithm, &AlgorithmInfo::needs_link) && std::ranges::any_of(family.grounds, is_silent))
    return "goes by the words of others, and nobody hears any";
  return {};
}

bool concerns(ConditionOf of, const Scenario& scenario) {
  if (of == ConditionOf::all || scenario.vehicles.size() > 1) return true;
  return of == ConditionOf::seen && std::ranges::any_of(scenario.obstacles, is_news);
}

Scenario first_test(const ExamFamily& family, const ExamGround& ground, const ExamCondition& condition) {
  Overrides overrides = family.set;
  overrides.insert(overrides.end(), condition.set.begin(), condition.set.end());
  return parse_scenario(ground.text, ground.file, overrides, family.test.first);
}

}  // namespace fairway
