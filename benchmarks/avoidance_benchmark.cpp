// SPDX-License-Identifier: Apache-2.0
// What one decision costs. Every decision is drawn at random from frozen situations: repeated in order,
// the branch predictor would learn them; whole runs would differ between versions.
#include <benchmark/benchmark.h>

#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/orca2d/orca2d.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/pledge/evasion.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;
using Scene = OwnedSituation (*)(int, Rng);

std::vector<OwnedSituation> frozen(Scene scene, int neighbours) {
  // tracks of about 1 MB in all, so that the caches hold them
  const int count = std::max(16, (1 << 20) / static_cast<int>(sizeof(Track)) / std::max(neighbours, 1));
  std::vector<OwnedSituation> scenes;
  for (int i = 0; i < count; ++i)
    scenes.push_back(scene(neighbours, Rng{1}.stream("frozen", static_cast<std::uint64_t>(i))));
  return scenes;
}

template <class Decide>
void run(benchmark::State& bench, Scene scene, Decide decide) {
  const std::vector<OwnedSituation> scenes = frozen(scene, static_cast<int>(bench.range(0)));
  const std::vector<Situation> situations(scenes.begin(), scenes.end());

  double infeasible = 0.0;
  for (const Situation& s : situations) infeasible += decide(s).mode == Mode::infeasible ? 1.0 : 0.0;
  bench.counters["infeasible"] = infeasible / static_cast<double>(situations.size());

  Rng rng{2};
  for (auto _ : bench) {
    Command command = decide(situations[rng.index(situations.size())]);
    benchmark::DoNotOptimize(command);
  }
}

/// The algorithm alone.
void orca3d(benchmark::State& bench, Scene scene) {
  const Orca3d orca{{}};
  Rng rng{3};
  Context context{rng};
  NoMemory memory;
  run(bench, scene, [&](const Situation& s) { return orca.decide(s, memory, context); });
}

/// What a member of `pledge` does that lies in the way of neighbours who go straight on.
void evasion(benchmark::State& bench, Scene scene) {
  run(bench, scene, [](const Situation& s) {
    constexpr double turn = 5.0, foreseen = 30.0, tube = 1.0;  // [s], [s], [m]
    pledge::Evasion evasion{s, turn};
    for (const Track& other : s.tracks) {
      pledge::Reference way;
      way.add({s.time, other.position});
      way.add({s.time + foreseen, other.position + foreseen * other.velocity});
      evasion.avoid(way, s.own.radius + other.radius + tube);
    }
    return Command{.velocity = evasion.best().value_or(Vec3::Zero())};
  });
}

/// Through the public interface: input checked, limits kept.
void avoider(benchmark::State& bench, const char* name, Scene scene) {
  Avoider avoider = builtin_avoiders().make(name);
  run(bench, scene, [&](const Situation& s) { return avoider.decide(s); });
}

/// The same on a boat that must turn, whose envelope is known, in water that flows by `current` [m/s, NED].
void on_a_boat_in(benchmark::State& bench, const char* name, Scene scene, const Vec3& current) {
  static const Envelope boat = encounters::of_a_boat();
  Avoider avoider = builtin_avoiders().make(name);
  run(bench, scene, [&](Situation s) {
    s.envelope = &boat;
    s.limits.sway = false;
    s.current = current;
    return avoider.decide(s);
  });
}

void on_a_boat(benchmark::State& bench, const char* name, Scene scene) {
  on_a_boat_in(bench, name, scene, Vec3::Zero());
}

void in_a_current(benchmark::State& bench, const char* name, Scene scene) {
  on_a_boat_in(bench, name, scene, {0.1, 0.05, 0.0});
}

BENCHMARK_CAPTURE(evasion, congested, encounters::congested)->Arg(7)->Arg(31);
BENCHMARK_CAPTURE(orca3d, crowd, encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(orca3d, congested, encounters::congested)->Arg(7);
BENCHMARK_CAPTURE(avoider, orca3d_crowd, "orca3d", encounters::crowd)->Arg(7)->Arg(20)->Arg(100)->Arg(500);
BENCHMARK_CAPTURE(avoider, orca3d_congested, "orca3d", encounters::congested)
    ->Arg(7)
    ->Arg(20)
    ->Arg(100)
    ->Arg(500);
BENCHMARK_CAPTURE(avoider, apf_crowd, "apf", encounters::crowd)->Arg(7)->Arg(20)->Arg(100)->Arg(500);
BENCHMARK_CAPTURE(avoider, stop_and_wait_crowd, "orca3d+stop_and_wait", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(avoider, direct_crowd, "direct", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(avoider, hard_switching_crowd, "hard_switching", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(avoider, wall_following_crowd, "wall_following", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(avoider, avoa_crowd, "avoa", encounters::crowd)->Arg(12)->Arg(100);
BENCHMARK_CAPTURE(avoider, avoa_improved_crowd, "avoa_improved", encounters::crowd)->Arg(12)->Arg(100);
BENCHMARK_CAPTURE(avoider, filter_crowd, "direct+safety_filter", encounters::crowd)->Arg(7)->Arg(20);
BENCHMARK_CAPTURE(avoider, filter_congested, "direct+safety_filter", encounters::congested)->Arg(7)->Arg(20);
BENCHMARK_CAPTURE(avoider, vo_crowd, "vo", encounters::crowd)->Arg(7)->Arg(20)->Arg(50);
BENCHMARK_CAPTURE(avoider, vo_congested, "vo", encounters::congested)->Arg(7)->Arg(20)->Arg(50);
BENCHMARK_CAPTURE(avoider, rvo_crowd, "rvo", encounters::crowd)->Arg(7)->Arg(20)->Arg(50);
BENCHMARK_CAPTURE(avoider, rvo_congested, "rvo", encounters::congested)->Arg(7)->Arg(20)->Arg(50);
BENCHMARK_CAPTURE(avoider, bvc_crowd, "bvc", encounters::crowd)->Arg(7)->Arg(20)->Arg(50);
BENCHMARK_CAPTURE(avoider, bvc_congested, "bvc", encounters::congested)->Arg(7)->Arg(20)->Arg(50);
BENCHMARK_CAPTURE(avoider, hrvo_crowd, "hrvo", encounters::crowd)->Arg(7)->Arg(20)->Arg(50);
BENCHMARK_CAPTURE(avoider, hrvo_congested, "hrvo", encounters::congested)->Arg(7)->Arg(20)->Arg(50);

BENCHMARK_CAPTURE(on_a_boat, direct_crowd, "direct+trackable", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(on_a_boat, direct_congested, "direct+trackable", encounters::congested)->Arg(7);
BENCHMARK_CAPTURE(on_a_boat, orca2d_crowd, "orca2d+trackable", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(on_a_boat, orca2d_congested, "orca2d+trackable", encounters::congested)->Arg(7);
BENCHMARK_CAPTURE(on_a_boat, vo_crowd, "vo+trackable", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(on_a_boat, rvo_crowd, "rvo+trackable", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(on_a_boat, hrvo_crowd, "hrvo+trackable", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(on_a_boat, hrvo_congested, "hrvo+trackable", encounters::congested)->Arg(7);
BENCHMARK_CAPTURE(in_a_current, orca2d_crowd, "orca2d+trackable", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(in_a_current, orca2d_congested, "orca2d+trackable", encounters::congested)->Arg(7);
BENCHMARK_CAPTURE(in_a_current, hrvo_crowd, "hrvo+trackable", encounters::crowd)->Arg(7);
BENCHMARK_CAPTURE(in_a_current, hrvo_congested, "hrvo+trackable", encounters::congested)->Arg(7);

/// The same swarms in the horizontal plane.
template <Scene scene>
OwnedSituation flat(int neighbours, Rng rng) {
  OwnedSituation e = scene(neighbours, rng);
  Situation& s = e.situation;
  s.goal.position.z() = s.own.position.z();
  s.own.velocity.z() = 0.0;
  for (Track& t : e.tracks) {
    t.position.z() = s.own.position.z();
    t.velocity.z() = 0.0;
  }
  return e.sorted();
}

template <class Algorithm>
void in_plane(benchmark::State& bench, const Algorithm& algorithm, Scene scene) {
  Rng rng{3};
  Context context{rng};
  NoMemory memory;
  run(bench, scene, [&](const Situation& s) { return algorithm.decide(s, memory, context); });
}

BENCHMARK_CAPTURE(in_plane, orca2d_crowd, Orca2d{{}}, flat<encounters::crowd>)->Arg(7);
BENCHMARK_CAPTURE(in_plane, orca2d_congested, Orca2d{{}}, flat<encounters::congested>)->Arg(7);
BENCHMARK_CAPTURE(in_plane, orca3d_crowd, Orca3d{{}}, flat<encounters::crowd>)->Arg(7);
BENCHMARK_CAPTURE(in_plane, orca3d_congested, Orca3d{{}}, flat<encounters::congested>)->Arg(7);

}  // namespace
}  // namespace fairway
