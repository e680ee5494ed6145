// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "fairway/core/crew.hpp"

namespace fairway {
namespace {

/// To share out a part of nothing for each of range(0) threads, and to wait until all are done.
void crew_call(benchmark::State& bench) {
  const auto hands = static_cast<std::size_t>(bench.range(0));
  Crew crew{hands};
  for (auto _ : bench)
    crew.go_through(hands, [](std::size_t part, std::size_t /*hand*/) { benchmark::DoNotOptimize(part); });
}
BENCHMARK(crew_call)->Arg(2)->Arg(4)->UseRealTime();

}  // namespace
}  // namespace fairway
