// SPDX-License-Identifier: Apache-2.0
// What an instant costs on board among seven neighbours: everyone's fix judged, a decision made, an order
// given.
#include <benchmark/benchmark.h>

#include <cmath>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/onboard/helm.hpp"

namespace fairway {
namespace {

constexpr std::uint32_t neighbours = 7;

Helm helm_of(const char* algorithm) {
  Particulars ship{.id = VehicleId{0}, .name = "own", .radius = 1.5};
  ship.limits.edit().max_speed = 0.5;
  HelmSetup setup;
  for (std::uint32_t i = 1; i <= neighbours; ++i) {
    setup.team.push_back(
        {.id = VehicleId{i}, .name = "other", .radius = 1.5, .priority = static_cast<std::int32_t>(i)});
  }
  Helm helm{{ship, 0.05}, setup, builtin_avoiders().make(algorithm)};
  helm.go_to({1e6, 0, 10}, 0.5);
  return helm;
}

Fix fix_of(std::uint32_t id, double time) {
  const double angle = 0.9 * id;
  const double range = id == 0 ? 0.0 : 8.0 + 2.0 * id;
  return {.time = time,
          .state = {.p_n = {0.5 * time + range * std::cos(angle), range * std::sin(angle), 10},
                    .v_b = {0.5, 0, 0}}};
}

void instant(benchmark::State& bench, const char* algorithm) {
  Helm helm = helm_of(algorithm);
  std::int64_t tick = 0;
  for (auto _ : bench) {
    const double now = 0.05 * static_cast<double>(++tick);
    helm.own_fix(fix_of(0, now), now);
    for (std::uint32_t i = 1; i <= neighbours; ++i) helm.neighbour_fix(VehicleId{i}, fix_of(i, now), now);
    benchmark::DoNotOptimize(helm.update(now).request);
  }
  if (helm.report(0.05 * static_cast<double>(tick)).decisions != tick)
    bench.SkipWithError("it did not decide each time");
}

/// The last instant again, with no new fix: nothing is due but steering.
void steering(benchmark::State& bench) {
  Helm helm = helm_of("orca3d");
  for (std::uint32_t i = 1; i <= neighbours; ++i) helm.neighbour_fix(VehicleId{i}, fix_of(i, 0.0), 0.0);
  helm.own_fix(fix_of(0, 0.0), 0.0);
  helm.update(0.0);
  for (auto _ : bench) benchmark::DoNotOptimize(helm.update(0.0).request);
}

void record(benchmark::State& bench) {
  Helm helm = helm_of("orca3d");
  helm.own_fix(fix_of(0, 1.0), 1.0);
  for (auto _ : bench) benchmark::DoNotOptimize(helm.own_record(1.0));
}

BENCHMARK_CAPTURE(instant, direct, "direct");
BENCHMARK_CAPTURE(instant, orca3d, "orca3d");
BENCHMARK_CAPTURE(instant, orca3d_stop_and_wait, "orca3d+stop_and_wait");
BENCHMARK_CAPTURE(instant, vo, "vo");
BENCHMARK(steering);
BENCHMARK(record);

}  // namespace
}  // namespace fairway
