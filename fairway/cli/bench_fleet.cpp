// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/bench_fleet.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// What a step of one fleet has cost.
struct FleetCost {
  std::size_t vehicles{};
  double ns{};            ///< a vehicle and step
  double processor_ns{};  ///< likewise, of the processor: of all threads, and not while others run
  double bytes{};         ///< a vehicle
  std::array<double, stage_count> stage_ns{};
};

/// Kinematic vehicles under orca3d on a lattice of 11 m, each disturbed by up to 2 m and on its way to a
/// place of its own, 1 km off: so that about ten are within 15 m of each, and those are others every few
/// seconds.
Scenario lattice(std::size_t count) {
  Scenario scenario{.name = "fleet", .step_s = 0.05, .duration_s = 1e6, .stop_when_done = false};
  scenario.perception.range_m = 15.0;
  std::size_t side = 1;
  while (side * side * side < count) ++side;
  Rng rng{1};
  const auto jitter = [&] { return rng.uniform(-2.0, 2.0); };
  VehicleSpec vehicle{
      .model = Choice{.name = "kinematic"},
      .avoider = Choice{.name = "orca3d", .params = {{"crit_dist_m", 15.0}, {"max_neighbours_count", 10.0}}},
      .radius_m = 1.0};
  vehicle.limits.max_speed = 0.5;
  scenario.vehicles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector<std::size_t, 3> cell{i % side, i / side % side, i / (side * side)};
    const Vec3 start = 11.0 * cell.cast<double>() + Vec3{jitter(), jitter(), jitter()};
    const double angle = rng.uniform(-pi, pi);
    vehicle.id = static_cast<std::uint32_t>(i);
    vehicle.name = "v" + std::to_string(i);
    vehicle.position = start;
    vehicle.yaw = angle;
    vehicle.priority = static_cast<std::int32_t>(i);
    vehicle.mission = {{.kind = LegKind::transit,
                        .position = start + 1000.0 * Vec3{math::cos(angle), math::sin(angle), 0.0},
                        .speed_mps = 0.5}};
    scenario.vehicles.push_back(vehicle);
  }
  return scenario;
}

/// Bytes of the heap in use.
double heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Steps for `budget_s` at least, and ten times; the first ten seconds of the run, again and again, for then
/// those of a small fleet have left each other. A quarter as many go on with a clock for each stage: among
/// few a clock takes as long as a stage does.
FleetCost cost_of(std::size_t count, const Catalogs& catalogs, double budget_s, std::size_t threads) {
  constexpr int warm_up = 3, most_steps = 200;
  const int between_looks = std::clamp(1000 / static_cast<int>(count), 1, 100);  // at the clock
  const double n = static_cast<double>(count);
  const double before = heap_in_use();
  const Scenario scenario = lattice(count);
  FleetCost cost{.vehicles = count};
  std::int64_t steps = 0, staged = 0;
  double total = 0.0, processor = 0.0;
  while (steps < 10 || total < budget_s) {
    Simulation simulation{scenario, catalogs};
    RunMetrics metrics = metrics_for(scenario, catalogs.vehicles);
    const std::array<FrameSink*, 1> sinks{&metrics};
    simulation.share_out(threads);
    for (int i = 0; i < warm_up; ++i) simulation.step(sinks);
    cost.bytes = (heap_in_use() - before) / n;

    const Clock::time_point begin = Clock::now();
    const std::clock_t processor_begin = std::clock();
    const auto gone = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    int gone_on = 0;
    while (gone_on < most_steps && (steps + gone_on < 10 || total + gone() < budget_s)) {
      for (int i = 0; i < between_looks; ++i) simulation.step(sinks);
      gone_on += between_looks;
    }
    total += gone();
    processor += static_cast<double>(std::clock() - processor_begin) / CLOCKS_PER_SEC;
    steps += gone_on;

    simulation.time_stages();
    for (int i = 0; i < gone_on; i += 4, ++staged) simulation.step(sinks);
    const auto seconds = simulation.stage_times().seconds();
    for (std::size_t k = 0; k < seconds.size(); ++k) cost.stage_ns[k] += seconds[k];
  }
  const double ns_of_second = 1e9 / (n * static_cast<double>(steps));
  for (double& stage : cost.stage_ns) stage *= 1e9 / (n * static_cast<double>(staged));
  cost.ns = ns_of_second * total;
  cost.processor_ns = ns_of_second * processor;
  return cost;
}

nlohmann::json json_of(const FleetCost& cost) {
  nlohmann::json stages;
  for (std::size_t k = 0; k < cost.stage_ns.size(); ++k)
    stages[EnumNames<Stage>::names[k]] = cost.stage_ns[k];
  return {{"vehicles", cost.vehicles},
          {"ns_per_vehicle_step", cost.ns},
          {"processor_ns_per_vehicle_step", cost.processor_ns},
          {"bytes_per_vehicle", cost.bytes},
          {"stages_ns", stages}};
}

void print(const FleetCost& cost, double growth) {
  std::cout << fmt::format("{:>8} {:>9.0f} {:>9.0f} {:>7.2f} {:>9.0f} ", cost.vehicles, cost.ns,
                           cost.processor_ns, growth, cost.bytes);
  for (const double ns : cost.stage_ns) std::cout << fmt::format(" {:>8.0f}", ns);
  std::cout << std::endl;
}

}  // namespace

int bench_fleets(const std::vector<std::size_t>& counts, double budget_s, std::size_t threads, bool as_json,
                 const Catalogs& catalogs) {
  if (!as_json) {
    std::cout << "ns per vehicle and step, kinematic under orca3d, at most 10 neighbours within 15 m\n";
    std::cout << fmt::format("{:>8} {:>9} {:>9} {:>7} {:>9} ", "vehicles", "ns", "processor", "growth",
                             "bytes");
    for (const std::string_view stage : EnumNames<Stage>::names) std::cout << fmt::format(" {:>8}", stage);
    std::cout << "\n";
  }
  nlohmann::json document{{"fleet", nlohmann::json::array()}};
  std::optional<double> first;
  for (const std::size_t count : counts) {
    const FleetCost cost = cost_of(count, catalogs, budget_s, threads);
    if (!first) first = cost.ns;
    document["fleet"].push_back(json_of(cost));
    if (!as_json) print(cost, cost.ns / *first);
  }
  if (as_json) std::cout << document.dump(2) << "\n";
  return ok;
}

}  // namespace fairway::cli
