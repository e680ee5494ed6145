// SPDX-License-Identifier: Apache-2.0
// What a step of RVO2-3D costs, `RVOSimulator::doStep`, on the lattice of `fairway bench --fleet`: the peer's
// lines in docs/benchmarks.md, which says how this is compiled. RVO2-3D is somebody else's, and is fetched by
// whoever wants to compare: no target of CMake builds this.
#include <RVO.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace {

/// As many agents as in `lattice()` of fairway/cli/bench_fleet.cpp, at the same places and under way
/// likewise: ten neighbours at most within 15 m, spheres of 1 m, 0.5 m/s.
void place(std::size_t count, RVO::RVOSimulator& simulator) {
  constexpr float time_horizon_s = 5.0F;
  simulator.setTimeStep(0.05F);
  simulator.setAgentDefaults(15.0F, 10, time_horizon_s, 1.0F, 0.5F);
  std::size_t side = 1;
  while (side * side * side < count) ++side;
  fairway::Rng rng{1};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t cell[3] = {i % side, i / side % side, i / (side * side)};
    float at[3];
    for (int k = 0; k < 3; ++k)
      at[k] = static_cast<float>(11.0 * static_cast<double>(cell[k]) + rng.uniform(-2.0, 2.0));
    const double angle = rng.uniform(-fairway::pi, fairway::pi);
    const RVO::Vector3 velocity(static_cast<float>(0.5 * std::cos(angle)),
                                static_cast<float>(0.5 * std::sin(angle)), 0.0F);
    const std::size_t agent = simulator.addAgent(RVO::Vector3(at[0], at[1], at[2]));
    simulator.setAgentVelocity(agent, velocity);
    simulator.setAgentPrefVelocity(agent, velocity);
  }
}

/// Processor time of an agent's share of a step [ns], in steps for `budget_s` at least: the first ten seconds
/// again and again, after three steps to warm up, as `fairway bench --fleet` does.
double cost_of(std::size_t count, double budget_s) {
  const long between_looks = std::clamp(1000 / static_cast<long>(count), 1L, 100L);  // at the clock
  double total_s = 0.0;
  long steps = 0;
  while (steps < 10 || total_s < budget_s) {
    RVO::RVOSimulator simulator;
    place(count, simulator);
    for (int i = 0; i < 3; ++i) simulator.doStep();
    const std::clock_t begin = std::clock();
    const auto gone_s = [&] { return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC; };
    for (long gone = 0; gone < 200 && (steps < 10 || total_s + gone_s() < budget_s); gone += between_looks)
      for (long i = 0; i < between_looks; ++i, ++steps) simulator.doStep();
    total_s += gone_s();
  }
  return 1e9 * total_s / (static_cast<double>(count) * static_cast<double>(steps));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: rvo2_driver SECONDS COUNT...\n", stderr);
    return 2;
  }
  for (int i = 2; i < argc; ++i) {
    const std::size_t count = std::strtoul(argv[i], nullptr, 10);
    if (count == 0) continue;
    std::printf("%8zu %6.0f ns a vehicle and step\n", count, cost_of(count, std::atof(argv[1])));
  }
}
