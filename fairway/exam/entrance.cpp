// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/entrance.hpp"

#include <algorithm>

#include "fairway/scenario/block.hpp"

namespace fairway {

std::string algorithm_of(const CampaignAlgorithm& method) {
  const yaml::Tree tree = yaml::parse_tree(method.avoider, method.label);
  yaml::Reading reading;
  return yaml::read_choice({tree, "", reading}, "algorithm", yaml::Needed::yes).name;
}

std::string why_not(const Catalog& methods, std::string_view algorithm, const ExamFamily& family) {
  if (family.needs_space && methods.needs(algorithm, &AlgorithmInfo::planar))
    return "thinks in the plane, and the ways there lead up and down";
  if (family.needs_obstacles && methods.ignores(algorithm, &AlgorithmInfo::ignores_obstacles))
    return "ignores obstacles, and there are some";
  if (family.needs_movers && methods.ignores(algorithm, &AlgorithmInfo::ignores_movers))
    return "ignores whatever moves, and something does";
  return {};
}

bool concerns(ConditionOf of, const Scenario& scenario) {
  if (of == ConditionOf::all || scenario.vehicles.size() > 1) return true;
  const auto is_news = [](const ObstacleSpec& obstacle) { return obstacle.moves() || !obstacle.charted; };
  return of == ConditionOf::seen && std::ranges::any_of(scenario.obstacles, is_news);
}

}  // namespace fairway
