// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/misfits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "fairway/core/math.hpp"
#include "fairway/sim/agent.hpp"
#include "fairway/sim/speakers.hpp"
#include "fairway/sim/team.hpp"

namespace fairway {
namespace {

/// What there is to meet, for all vehicles.
struct Ground {
  std::string uncharted, drifter;  ///< the first such obstacle, as a path; empty for none
  bool has_obstacles = false;
  bool has_others = false;
  bool is_silent = false;                                     ///< nobody tells anything
  double shallowest = Limits::none, deepest = -Limits::none;  ///< [m]
  double widest = 0.0, second_widest = 0.0;                   ///< radii of two vehicles' spheres [m]

  explicit Ground(const Scenario& scenario)
      : has_others{scenario.vehicles.size() > 1}, is_silent{scenario.exchange.name == "none"} {
    for (std::size_t i = 0; i < scenario.obstacles.size(); ++i) {
      const ObstacleSpec& obstacle = scenario.obstacles[i];
      const std::string path = "obstacles[" + std::to_string(i) + "]";
      if (obstacle.moves() && drifter.empty()) drifter = path;
      if (!obstacle.moves()) has_obstacles = true;
      if (!obstacle.moves() && !obstacle.charted && uncharted.empty()) uncharted = path;
      if (obstacle.kind == Obstacle::Kind::sphere) see(obstacle.position.z());
    }
    for (const VehicleSpec& vehicle : scenario.vehicles) {
      see(vehicle.position.z());
      second_widest = math::fmax(second_widest, std::min(widest, vehicle.radius_m));
      widest = math::fmax(widest, vehicle.radius_m);
      for (const Leg& leg : vehicle.mission)
        if (leg.kind == LegKind::transit) see(leg.position.z());
    }
  }

  /// The largest radius of another vehicle than one with the radius `own` [m].
  double widest_other(double own) const { return own < widest ? widest : second_widest; }

 private:
  void see(double depth) {
    shallowest = math::fmin(shallowest, depth);
    deepest = math::fmax(deepest, depth);
  }
};

/// What is amiss with the team in which a vehicle's method agrees, as a clause about it; empty for nothing.
std::string amiss_in_team(const VehicleSpec& spec, const Scenario& scenario, const Catalog& avoiders) {
  const std::optional<double> size = team_size(spec, scenario, avoiders);
  if (!size) return {};
  if (scenario.vehicles.size() < 2) return "agrees with others before it moves, and there are none";
  const std::string ids = fmt::format("the ids 0 to {} (team_count: {})", *size - 1.0, *size);
  if (spec.id >= *size)
    return fmt::format("agrees among {}, at most {}, and stays where it is with any other id", ids,
                       team_sizes(avoiders, spec.avoider->name)->hi);
  const auto is_in_it = [&](const VehicleSpec& other) {
    return other.id < *size && team_sizes(avoiders, other.avoider->name);
  };
  if (static_cast<double>(std::ranges::count_if(scenario.vehicles, is_in_it)) < *size)
    return fmt::format("waits for words of {}, and not all of these are there and say such", ids);
  return {};
}

/// Spheres that touch before the vehicle perceives the other, as a clause about its method; empty where it
/// perceives it sooner. A sonar sees as far as it has been told to, and not as far as `range_m`.
std::string amiss_in_range(const VehicleSpec& spec, const PerceptionSpec& perception, const Ground& ground) {
  const double touching = spec.radius_m + ground.widest_other(spec.radius_m);
  if (!ground.has_others || perception.kind.name != "perfect" || touching <= perception.range_m) return {};
  return fmt::format("perceives others within {:g} m (perception.range_m), and spheres touch at {:g} m",
                     perception.range_m, touching);
}

/// A leg slower than the vehicle can go, as a clause about its method; empty where there is none.
std::string amiss_in_speeds(const VehicleSpec& spec, const Limits& limits) {
  const auto is_too_slow = [&](const Leg& leg) { return leg.speed_mps < limits.min_speed; };
  const auto leg = std::ranges::find_if(spec.mission, is_too_slow);
  if (leg == spec.mission.end()) return {};
  return fmt::format("is to go {:.2g} m/s, and {} goes {:.2g} at least", leg->speed_mps, spec.model->name,
                     limits.min_speed);
}

/// That a method of velocities leaves no room for the inertia of a vehicle that goes sideways, as a clause
/// about it; empty where something is around it, or nothing is met, or the scenario says what is to be in
/// force.
std::string amiss_sideways(const VehicleSpec& spec, const Limits& limits, const Ground& ground,
                           const Catalogs& catalogs) {
  const auto needs = [&](bool AlgorithmInfo::*what) {
    return catalogs.avoiders.needs(spec.avoider->name, what);
  };
  const bool meets_something = ground.has_obstacles || !ground.drifter.empty();
  const bool is_alone = catalogs.avoiders.layers(spec.avoider->name).size() == 1;
  if (!limits.sway || spec.tracking != Tracking::automatic || !meets_something || !is_alone) return {};
  if (!needs(&AlgorithmInfo::needs_sway) || needs(&AlgorithmInfo::commands_forces) ||
      needs(&AlgorithmInfo::finds_way))
    return {};
  if (!onboard_model(make_vehicle(spec, catalogs.vehicles))) return {};
  return "leaves no room for the time that " + spec.model->name +
         " takes to follow, and something stands or drifts: " + spec.avoider->name +
         "+safety_filter+way_round does";
}

/// What is amiss with one vehicle, each thing as a clause about its method.
std::vector<std::string> amiss(const VehicleSpec& spec, const Limits& limits, const Scenario& scenario,
                               const Ground& ground, const Catalogs& catalogs) {
  const Catalog& avoiders = catalogs.avoiders;
  const std::string name = avoider_in_force(spec, limits, scenario.obstacles, avoiders);
  const auto all = [&](bool AlgorithmInfo::*what) { return avoiders.ignores(name, what); };
  const auto any = [&](bool AlgorithmInfo::*what) { return avoiders.needs(name, what); };
  const bool speaks = any(&AlgorithmInfo::needs_link);
  // where it foresees, it keeps clear of whatever there is
  const bool foresees = any(&AlgorithmInfo::follows) && !speaks && !limits.sway;
  const bool has_others = ground.has_others && !speaks;  // who speaks knows them by their words
  const bool is_blind = all(&AlgorithmInfo::ignores_obstacles),
             is_alone = all(&AlgorithmInfo::ignores_movers);

  std::vector<std::string> clauses;
  if (any(&AlgorithmInfo::needs_sway) && !limits.sway && !foresees)
    clauses.push_back("moves a point that goes any way at once, and " + spec.model->name +
                      " has to turn first");
  if (std::string clause = amiss_sideways(spec, limits, ground, catalogs); !clause.empty())
    clauses.push_back(std::move(clause));
  if (any(&AlgorithmInfo::needs_stopping) && limits.min_speed > 0.0)
    clauses.push_back("has to stop now and then, and " + spec.model->name + " cannot: it circles");
  if (std::string clause = amiss_in_speeds(spec, limits); !clause.empty())
    clauses.push_back(std::move(clause));
  if (!foresees && (is_blind != is_alone || speaks)) {
    if (is_blind && ground.has_obstacles) clauses.emplace_back("ignores obstacles, and there are some");
    if (is_alone && has_others) clauses.emplace_back("ignores whatever moves, and there are others");
    if (is_alone && !has_others && !ground.drifter.empty())
      clauses.push_back("ignores whatever moves, and " + ground.drifter + " drifts");
  }
  if (speaks && ground.is_silent)
    clauses.emplace_back("waits for the words of others, and the exchange is none");
  if (std::string clause = amiss_in_range(spec, scenario.perception, ground); !is_alone && !clause.empty())
    clauses.push_back(std::move(clause));
  if (std::string clause = amiss_in_team(spec, scenario, avoiders); !clause.empty())
    clauses.push_back(std::move(clause));
  if (speaks) {
    const VehicleSpec* stranger = is_alone ? first_stranger(spec, scenario, avoiders) : nullptr;
    if (stranger != nullptr)
      clauses.push_back("avoids nobody but those with whom it agrees, and " + stranger->name +
                        " does not speak its words");
    std::ranges::move(amiss_in_words(spec, scenario, avoiders), std::back_inserter(clauses));
  }
  const auto sees_no_more = [](const Catalog::Entry* layer) {
    return layer->info.needs_chart || layer->info.ignores_obstacles;
  };
  if (!foresees && !is_blind && std::ranges::all_of(avoiders.layers(name), sees_no_more) &&
      !ground.uncharted.empty())
    clauses.push_back("avoids only what is charted, and " + ground.uncharted + " is not");
  if (any(&AlgorithmInfo::planar) && ground.deepest - ground.shallowest > spec.radius_m)
    clauses.emplace_back("thinks in a horizontal plane, and not all that it meets is at one depth");
  for (std::string& clause : clauses) clause = name + " " + clause;
  return clauses;
}

}  // namespace

std::vector<std::string> misfits(const Scenario& scenario, const Catalogs& catalogs) {
  const Ground ground{scenario};
  const std::vector<Shared<Limits>> limits = limits_in_force(scenario, catalogs.vehicles);
  struct Trouble {
    std::string clause;
    std::string first;
    std::size_t count;
  };
  std::vector<Trouble> troubles;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const VehicleSpec& spec = scenario.vehicles[i];
    try {
      for (std::string& clause : amiss(spec, limits[i], scenario, ground, catalogs)) {
        const auto known = std::ranges::find(troubles, clause, &Trouble::clause);
        if (known != troubles.end()) {
          ++known->count;
        } else {
          troubles.push_back({std::move(clause), spec.name, 1});
        }
      }
    } catch (const InputError&) {
    }
  }
  std::vector<std::string> lines;
  for (const auto& [clause, first, count] : troubles) {
    std::string whom = first;
    if (count > 1) whom += " and " + std::to_string(count - 1) + (count == 2 ? " other" : " others");
    lines.push_back(whom + ": " + clause);
  }
  return lines;
}

}  // namespace fairway
