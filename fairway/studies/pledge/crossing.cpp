// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/pledge/crossing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/core/rng.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/studies/cubes/cube_case.hpp"

namespace fairway::pledges {
namespace {

constexpr std::array failures{FailureKind::silent, FailureKind::stops, FailureKind::leaves};
constexpr std::array drifts_m{0.25, 0.5};
constexpr double beyond_tube_m = 1.0;  // a drift, of a tube that is as wide
constexpr double losses_in_a_row = 4.0;
constexpr double latest_failure = 60.0;   // after a vehicle set out [s]
constexpr double collision_radius = 1.5;  // half of what counts as a collision [m]
constexpr std::array rock_counts{3, 6};

/// How near the straight way between two places comes to a third [m].
double distance_to_way(const Vec3& from, const Vec3& to, const Vec3& place) {
  const Obstacle way{.kind = Obstacle::Kind::segment, .from = from, .to = to};
  return nearest_point(way, place).distance;
}

/// Charted rocks of 1 to 2.5 m in the cube, none of them on a way from the origin to where the crossing
/// begins, nor where it begins or ends.
void add_rocks(Scenario& scenario, int count, Rng chance) {
  const auto is_free = [&](const ObstacleSpec& rock) {
    return std::ranges::all_of(scenario.vehicles, [&](const VehicleSpec& vehicle) {
      return std::ranges::all_of(vehicle.mission, [&](const Leg& leg) {
        const bool avoids = leg.kind == LegKind::transit;
        const double off = rock.radius + (avoids ? 6.0 : 3.5);
        return leg.kind == LegKind::rendezvous ||
               distance_to_way(avoids ? leg.position : vehicle.position, leg.position, rock.position) > off;
      });
    });
  };
  while (count > 0) {
    const auto across = [&] { return chance.uniform(-9.0, 9.0); };
    const Vec3 place{across(), across(), chance.uniform(2.0, 18.0)};
    const ObstacleSpec rock{
        .kind = Obstacle::Kind::sphere, .position = place, .radius = chance.uniform(1.0, 2.5)};
    if (!is_free(rock)) continue;
    scenario.obstacles.push_back(rock);
    --count;
  }
}

/// Slots of eight that come round so often: of modems that are so slow.
Choice modem_of(const Condition& condition) {
  const double bit_rate = condition.cycle_s < 4.0 ? 1600.0 : condition.cycle_s < 9.0 ? 550.0 : 428.0;
  return {.name = "acoustic",
          .params = {{"update_rate_hz", 1.0},
                     {"loss_ratio", condition.loss_ratio},
                     {"loss_run_count", condition.loss_run_count},
                     {"bit_rate_bps", bit_rate}},
          .path = "exchange"};
}

Cell cell_of(const Condition& condition, const Method& method, int seeds) {
  Cell cell = planned_cell(
      "pledge", condition.place(), method.name, condition.name(), seeds,
      [condition, &method](std::uint64_t seed) { return crossing_scenario(condition, method, seed); });
  return cell;
}

void add_pledge(std::vector<Cell>& cells, const Method& pledge, int seeds) {
  for (const double cycle : cycles_s) {
    for (const double loss : loss_ratios) {
      for (const double current : currents_mps) {
        cells.push_back(cell_of({cycle, loss, current}, pledge, seeds));
        for (const FailureKind failure : failures)
          cells.push_back(cell_of({cycle, loss, current, failure}, pledge, seeds));
        for (const double drift : drifts_m)
          cells.push_back(cell_of({cycle, loss, current, FailureKind::none, drift}, pledge, seeds));
      }
    }
    cells.push_back(cell_of({.cycle_s = cycle, .agreed_beforehand = false}, pledge, seeds));
    for (const double loss : {0.1, 0.5})
      cells.push_back(
          cell_of({.cycle_s = cycle, .loss_ratio = loss, .loss_run_count = losses_in_a_row}, pledge, seeds));
  }
  for (const int rocks : rock_counts)
    cells.push_back(cell_of({.cycle_s = 3.2, .loss_ratio = 0.1, .rock_count = rocks}, pledge, seeds));
  cells.push_back(
      cell_of({.cycle_s = 3.2, .loss_ratio = 0.1, .drift_sigma_m = beyond_tube_m}, pledge, seeds));
}

void add_other(std::vector<Cell>& cells, const Method& method, int seeds) {
  for (const double cycle : {3.2, 10.0}) {
    for (const double loss : {0.0, 0.5}) {
      for (const double current : {0.0, 0.2}) cells.push_back(cell_of({cycle, loss, current}, method, seeds));
    }
  }
  for (const FailureKind failure : failures)
    cells.push_back(cell_of({.cycle_s = 3.2, .loss_ratio = 0.1, .failure = failure}, method, seeds));
}

}  // namespace

std::string Condition::place() const {
  std::string text = fmt::format("{} s, loss {}", cycle_s, loss_ratio);
  if (loss_run_count > 0.0) text += fmt::format(" in runs of {}", loss_run_count);
  return text;
}

std::string Condition::name() const {
  std::string text = fmt::format("current {}", current_mps);
  if (failure != FailureKind::none)
    text += fmt::format(", {}", EnumNames<FailureKind>::names[static_cast<std::size_t>(failure)]);
  if (drift_sigma_m > 0.0) text += fmt::format(", drift {}", drift_sigma_m);
  if (!agreed_beforehand) text += ", agreed late";
  if (rock_count > 0) text += fmt::format(", {} rocks", rock_count);
  return text;
}

std::span<const Method> methods() {
  static const std::vector<Method> all{
      {"pledge", "pledge", {}},
      {"delay_check", "delay_check", {}},
      {"bvc", "bvc", {}},
      {"orca3d", "orca3d", {}},
      {"orca3d_40s", "orca3d", {{"time_horizon_s", 40.0}}},
      {"orca3d+inflate", "orca3d+inflate", {}},
      {"orca3d+saw", "orca3d+stop_and_wait", {}},
      {"direct", "direct", {}},
  };
  return all;
}

Scenario crossing_scenario(const Condition& condition, const Method& method, std::uint64_t seed) {
  const auto cube = std::ranges::find(cubes::comparison_cases(), "cube20_8", &cubes::CubeCase::name);
  const bool is_orca = cubes::is_orca(method.algorithm);
  const auto orca3d = std::ranges::find(methods(), "orca3d", &Method::name);
  const Method& base = is_orca ? method : *orca3d;
  Scenario scenario =
      cubes::cube_scenario(*cube, base, cubes::Code::corrected, cubes::comparison_tuning(*cube, base), seed);
  scenario.name = fmt::format("pledge {} {} {}", method.name, condition.place(), condition.name());
  scenario.summary = "eight AUVs cross a cube, and something goes wrong";
  scenario.duration_s = 1800.0;
  scenario.exchange = modem_of(condition);
  scenario.water.current_n = Vec3{condition.current_mps, 0.0, 0.0};
  if (condition.drift_sigma_m > 0.0)
    scenario.navigation = {
        .name = "drifting", .params = {{"position_sigma_m", condition.drift_sigma_m}}, .path = "navigation"};
  for (VehicleSpec& vehicle : scenario.vehicles) {
    if (is_orca) continue;
    vehicle.avoider =
        Choice{.name = std::string(method.algorithm), .params = method.params, .path = "avoider"};
    if (method.algorithm != "bvc") vehicle.radius_m = collision_radius;
    for (Leg& leg : vehicle.mission) leg.agreed = condition.agreed_beforehand;
  }
  if (condition.rock_count > 0) add_rocks(scenario, condition.rock_count, Rng{seed}.stream("rocks"));
  Rng chance = Rng{seed}.stream("failure");
  const double under_way = chance.uniform(0.0, latest_failure);
  scenario.vehicles[chance.index(scenario.vehicles.size())].failure = {
      condition.failure, condition.failure == FailureKind::none ? 0.0 : under_way};
  return scenario;
}

std::vector<Cell> crossing_cells(int seeds) {
  std::vector<Cell> cells;
  const std::span<const Method> all = methods();
  add_pledge(cells, all.front(), seeds);
  const int fewer = (seeds + 4) / 5;
  for (const Method& method : all.subspan(1, all.size() - 2)) add_other(cells, method, fewer);
  for (const double current : currents_mps)
    cells.push_back(cell_of({.cycle_s = 3.2, .current_mps = current}, all.back(), fewer));
  return cells;
}

const Cell& straight_cell(const std::vector<Cell>& cells, const Cell& cell) {
  const std::string_view current = std::string_view{cell.mode}.substr(0, cell.mode.find(','));
  return find_cell(cells, Condition{.cycle_s = 3.2}.place(), methods().back().name, current);
}

}  // namespace fairway::pledges
