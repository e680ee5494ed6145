// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "fairway/world/sea/sea.hpp"

namespace fairway {
namespace {

/// The water at one vehicle at one instant, `depth` below a sea of range(0) waves.
void water_at(benchmark::State& bench, double depth) {
  WaterSpec spec;
  const auto count = static_cast<std::int32_t>(bench.range(0));
  if (count > 0) {
    spec.waves.spectrum = SpectrumSpec{
        .significant_height_m = 0.5, .peak_period_s = 4.0, .spreading_count = 2, .components_count = count};
  }
  const Sea sea{spec, Rng{1}};
  double time = 0.0;
  for (auto _ : bench) {
    benchmark::DoNotOptimize(sea.water_at({1.0, 2.0, depth}, time));
    time += 0.05;
  }
}
BENCHMARK_CAPTURE(water_at, surface, 0.0)->Arg(0)->Arg(1)->Arg(10)->Arg(50)->Arg(200);
BENCHMARK_CAPTURE(water_at, below, 3.0)->Arg(10)->Arg(50)->Arg(200);

/// A step of a current that wanders.
void current_step(benchmark::State& bench) {
  GaussMarkovCurrent current{{.mean_speed_mps = 0.3, .deviation_mps = 0.1, .direction_deviation_rad = 0.1},
                             Rng{1}};
  for (auto _ : bench) {
    current.advance(0.05);
    benchmark::DoNotOptimize(current);
  }
}
BENCHMARK(current_step);

}  // namespace
}  // namespace fairway
