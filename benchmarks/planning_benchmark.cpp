// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "fairway/planning/rrt_star/plan.hpp"
#include "fairway/planning/teb/testing/courses.hpp"
#include "fairway/planning/testing/four_obstacles.hpp"

namespace fairway {
namespace {

/// A path among the four obstacles of rehman2021.
void path(benchmark::State& bench, PathSearch search, int iterations) {
  const PlanarMap map = four_obstacles::map();
  std::uint32_t seed = 0;
  for (auto _ : bench) {
    benchmark::DoNotOptimize(plan_path(map, {.start = four_obstacles::start,
                                             .goal = four_obstacles::goal,
                                             .search = search,
                                             .iterations_count = iterations,
                                             .seed = ++seed}));
  }
}
BENCHMARK_CAPTURE(path, rrt_star, PathSearch::rrt_star, 2000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(path, informed_rrt_star, PathSearch::informed_rrt_star, 2000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(path, bit_star, PathSearch::bit_star, 5000)->Unit(benchmark::kMillisecond);

/// Decisions of the timed elastic band on the way through a field of buoys, again and again.
void band(benchmark::State& bench, double speed, bool dynamic) {
  courses::Voyage fresh{.course = courses::cluttered(), .teb = {}};
  fresh.teb.params.max_vel_x_mps = speed;
  fresh.teb.params.include_dynamic_obstacles = dynamic;
  courses::Voyage voyage = fresh;
  for (auto _ : bench) {
    voyage.step();
    if (voyage.position.x() > 24.5) voyage = fresh;
  }
}
BENCHMARK_CAPTURE(band, slow, 0.4, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(band, slow_dynamic, 0.4, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(band, fast, 1.5, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(band, fast_dynamic, 1.5, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fairway
