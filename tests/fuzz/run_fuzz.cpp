// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "fairway/cli/runner.hpp"
#include "fairway/cli/testing/program_of.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"
#include "tests/fuzz/random_scenario.hpp"

namespace fairway {
namespace {

/// How many scenarios that can be simulated are run: FAIRWAY_FUZZ_RUNS, else few enough for every day.
std::uint64_t wanted_runs() {
  const char* given = std::getenv("FAIRWAY_FUZZ_RUNS");  // NOLINT(concurrency-mt-unsafe)
  return given == nullptr ? 300 : std::strtoull(given, nullptr, 10);
}

/// The number of the first one that is tried: FAIRWAY_FUZZ_FIRST, else 0.
std::uint64_t first_number() {
  const char* given = std::getenv("FAIRWAY_FUZZ_FIRST");  // NOLINT(concurrency-mt-unsafe)
  return given == nullptr ? 0 : std::strtoull(given, nullptr, 10);
}

/// Looks for anything in a frame that is not finite.
struct FiniteFrames final : FrameSink {
  std::int64_t seen{};
  std::string broken;

  void write(const Frame& frame) override {
    ++seen;
    for (const VehicleFrame& v : frame.vehicles) {
      const bool actuated = std::ranges::all_of(v.actuators, [](double a) { return std::isfinite(a); });
      const bool tracked = std::ranges::all_of(
          v.tracks, [](const Track& t) { return is_finite(t.position) && is_finite(t.velocity); });
      const bool whole = is_finite(v.state) && is_finite(v.command) && is_finite(v.goal) &&
                         std::isfinite(v.power) && v.wrench.allFinite() && actuated && tracked;
      if (!whole && broken.empty())
        broken = "vehicle " + std::to_string(number(v.id)) + " at " + std::to_string(frame.time);
    }
  }
};

/// The scenario of this number where it can be simulated.
std::optional<Scenario> accepted(const std::string& yaml, const Catalogs& catalogs) {
  try {
    Scenario scenario = parse_scenario(yaml, "fuzz");
    const Simulation simulation{scenario, catalogs};
    return scenario;
  } catch (const InputError&) {
    return {};
  }
}

/// No expectation of a run that broke is kept, and what is done with runs refuses it.
void expect_no_result(const Scenario& scenario, const Catalogs& catalogs) {
  const cli::RunOutcome outcome = cli::run_scenario(scenario, {}, cli::program_of(catalogs));
  ASSERT_TRUE(outcome.divergence);
  EXPECT_TRUE(outcome.measures.empty());
  for (const cli::Judgement& judgement : cli::judge(scenario, outcome.measures)) EXPECT_FALSE(judgement.kept);
}

TEST(RunFuzzTest, EveryRunThatIsAcceptedIsWholeOrSaysThatItBroke) {
  const Catalogs catalogs = builtin_catalogs();
  const std::uint64_t wanted = wanted_runs();
  std::uint64_t runs = 0, diverged = 0;
  std::uint64_t number = first_number();
  for (; runs < wanted && number < first_number() + 20 * wanted; ++number) {
    const std::string yaml = RandomScenario{number, catalogs}.yaml();
    SCOPED_TRACE("scenario " + std::to_string(number) + ":\n" + yaml);
    const std::optional<Scenario> scenario = accepted(yaml, catalogs);
    if (!scenario) continue;
    ++runs;

    Simulation simulation{*scenario, catalogs};
    FiniteFrames frames;
    const std::array<FrameSink*, 1> sinks{&frames};
    while (!simulation.is_done()) simulation.step(sinks);
    ASSERT_EQ(frames.broken, "");
    if (!simulation.divergence()) continue;
    ++diverged;
    std::cout << number << ": "
              << text_of(*simulation.divergence(), scenario->vehicles[simulation.divergence()->vehicle].name)
              << "\n"
              << yaml;
    EXPECT_LE(frames.seen, count(simulation.divergence()->tick));
    expect_no_result(*scenario, catalogs);
  }
  std::cout << runs << " runs of " << number - first_number() << " scenarios, " << diverged << " diverged\n";
  EXPECT_EQ(runs, wanted) << "the generator is too wild: hardly anything is accepted";
  EXPECT_LE(100 * diverged, runs) << "what cannot be simulated should have been refused";
}

}  // namespace
}  // namespace fairway
