// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/cli/bench_fleet.hpp"
#include "fairway/cli/numbers.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/word_list.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Median of several repetitions of `work`, each of `count` operations: seconds per operation.
double seconds_per_operation(double budget_s, std::int64_t count, const std::function<void()>& work) {
  std::vector<double> samples;
  const auto begin = Clock::now();
  do {
    const auto from = Clock::now();
    work();
    samples.push_back(std::chrono::duration<double>(Clock::now() - from).count() /
                      static_cast<double>(count));
  } while (samples.size() < 3 || std::chrono::duration<double>(Clock::now() - begin).count() < budget_s);
  std::ranges::nth_element(samples, samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2));
  return samples[samples.size() / 2];
}

using Scene = encounters::OwnedSituation (*)(int, Rng);

/// One decision among `neighbours`, drawn at random from frozen situations [ns].
double decision_ns(const std::string& algorithm, const Catalog& catalog, Scene scene, int neighbours,
                   double budget_s) {
  std::vector<encounters::OwnedSituation> scenes;
  for (std::uint64_t i = 0; i < 1024; ++i) scenes.push_back(scene(neighbours, Rng{1}.stream("frozen", i)));
  const std::vector<Situation> situations(scenes.begin(), scenes.end());
  Avoider avoider = catalog.make(algorithm);
  Rng rng{2};
  constexpr std::int64_t batch = 20000;
  double checksum = 0.0;
  const double seconds = seconds_per_operation(budget_s, batch, [&] {
    for (std::int64_t i = 0; i < batch; ++i)
      checksum += avoider.decide(situations[rng.index(situations.size())]).velocity.x();
  });
  if (checksum == 0.123456789) std::cerr << checksum;  // the optimiser must not see that nobody reads it
  return 1e9 * seconds;
}

/// Eight vehicles that cross a ball of 20 m to the opposite point, for ever.
Scenario crossing(const std::string& model, const std::string& algorithm) {
  Scenario scenario{.name = "bench", .step_s = 0.05, .duration_s = 1e6, .stop_when_done = false};
  for (std::uint32_t i = 0; i < 8; ++i) {
    const double angle = 2 * pi * i / 8.0;
    const Vec3 start{20 * math::cos(angle), 20 * math::sin(angle), 10.0 + (i % 2)};
    VehicleSpec vehicle{.id = i,
                        .name = "v" + std::to_string(i),
                        .model = Choice{.name = model},
                        .avoider = Choice{.name = algorithm},
                        .position = start,
                        .yaw = angle + pi,
                        .radius_m = 1.0,
                        .priority = static_cast<std::int32_t>(i)};
    vehicle.limits.max_speed = 0.5;
    for (int lap = 0; lap < 1000; ++lap) {
      const double side = lap % 2 == 0 ? -1.0 : 1.0;
      vehicle.mission.push_back({.kind = LegKind::transit,
                                 .position = {side * start.x(), side * start.y(), start.z()},
                                 .speed_mps = 0.5,
                                 .arrival_m = 2.0});
    }
    scenario.vehicles.push_back(std::move(vehicle));
  }
  return scenario;
}

/// Vehicle-steps per second on one core.
double steps_per_second(const std::string& model, const Catalogs& catalogs, double budget_s) {
  Simulation simulation{crossing(model, "orca3d"), catalogs};
  constexpr std::int64_t batch = 2000;
  const double seconds = seconds_per_operation(budget_s, batch * 8, [&] {
    for (std::int64_t i = 0; i < batch; ++i) simulation.step({});
  });
  return 1.0 / seconds;
}

int bench(const std::vector<std::string>& algorithms, double budget_s, bool as_json,
          const Catalogs& catalogs) {
  nlohmann::json document;
  const auto decide = [&](const std::string& algorithm, const char* kind, Scene scene) {
    const double ns = decision_ns(algorithm, catalogs.avoiders, scene, 7, budget_s);
    document["decision_ns"][algorithm][kind] = ns;
    if (!as_json)
      std::cout << fmt::format("{:<24} {:<10} {:>10.0f} ns per decision among 7\n", algorithm, kind, ns);
  };
  for (const std::string& algorithm : algorithms) {
    decide(algorithm, "typical", encounters::crowd);
    decide(algorithm, "congested", encounters::congested);
  }
  for (const char* model : {"sparus2", "kinematic"}) {
    const double rate = steps_per_second(model, catalogs, budget_s);
    document["vehicle_steps_per_second"][model] = rate;
    if (!as_json)
      std::cout << fmt::format("{:<24} {:<10} {:>10.0f} vehicle-steps per second and core, 8 under orca3d\n",
                               model, "", rate);
  }
  if (as_json) std::cout << document.dump(2) << "\n";
  return ok;
}

}  // namespace

void add_bench(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("bench", "Time of a decision, and vehicle-steps per second, on this machine");
  verb->footer("Example: fairway bench --seconds 2\n         fairway bench --fleet 8,64,1000");
  auto budget = std::make_shared<double>(0.5);
  auto algorithms = std::make_shared<std::vector<std::string>>(
      std::vector<std::string>{"orca3d", "apf", "orca3d+stop_and_wait"});
  auto fleets = std::make_shared<std::vector<std::string>>();
  auto threads = std::make_shared<std::size_t>(1);
  auto as_json = std::make_shared<bool>(false);
  CLI::Option* algorithm =
      verb->add_option("--algorithm", *algorithms, "whose decisions are timed")->capture_default_str();
  verb->add_option("--seconds", *budget, "per figure; each is the median of its repetitions")
      ->capture_default_str()
      ->transform(finite_number(0.01, 60.0));
  CLI::Option* fleet =
      add_word_list(*verb, "--fleet", *fleets,
                    "instead: what a step of fleets of so many vehicles costs, by stage, under orca3d",
                    whole_number<std::size_t>(1, 1'000'000));
  fleet->type_name("UINT")->excludes(algorithm);
  verb->add_option("--threads", *threads, "that share a step of a fleet")
      ->capture_default_str()
      ->transform(whole_number<std::size_t>(1, max_jobs))
      ->needs(fleet);
  verb->add_flag("--json", *as_json, "print JSON");
  program.on(*verb, [=, &program] {
    std::vector<std::size_t> counts;
    for (const std::string& count : *fleets) counts.push_back(std::stoul(count));
    if (!counts.empty()) return bench_fleets(counts, *budget, *threads, *as_json, program.catalogs);
    return bench(*algorithms, *budget, *as_json, program.catalogs);
  });
}

}  // namespace fairway::cli
