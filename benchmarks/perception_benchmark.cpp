// SPDX-License-Identifier: Apache-2.0
// What a ping and a step of the tracker cost, and what they are good for: OSPA and the figures of CLEAR MOT
// on targets that cross.
#include <benchmark/benchmark.h>

#include <map>
#include <vector>

#include "fairway/perception/sonar/contact_finder.hpp"
#include "fairway/perception/testing/ospa.hpp"
#include "fairway/perception/testing/quiet_sonar.hpp"
#include "fairway/perception/tracker/tracker.hpp"

namespace fairway {
namespace {

constexpr double ping_period = 1.0 / 15.0;

/// Balls of 1.5 m within the fan, each with a course of its own.
std::vector<Mover> targets(int count, Rng rng) {
  std::vector<Mover> all;
  for (int i = 0; i < count; ++i) {
    const double bearing = rng.uniform(-1.0, 1.0);
    const double course = rng.uniform(-pi, pi);
    all.push_back(ball(rng.uniform(10, 90) * Vec3{std::cos(bearing), std::sin(bearing), 0}, 1.5,
                       0.5 * Vec3{std::cos(course), std::sin(course), 0}));
  }
  return all;
}

void ping(benchmark::State& bench) {
  const auto movers = movers_round({}, targets(static_cast<int>(bench.range(0)), Rng{1}));
  Sonar sonar{{}};
  std::vector<Echo> echoes;
  Rng rng{2};
  Rng false_rng{3};
  double heard = 0.0;
  for (auto _ : bench) {
    sonar.ping({}, {.movers = movers}, rng, false_rng, echoes);
    heard += static_cast<double>(echoes.size());
  }
  bench.counters["echoes"] = benchmark::Counter(heard, benchmark::Counter::kAvgIterations);
}

void contacts(benchmark::State& bench) {
  const auto echoes = echoes_of({}, {}, targets(static_cast<int>(bench.range(0)), Rng{1}));
  ContactFinder finder{{}};
  std::vector<Contact> found;
  for (auto _ : bench) {
    finder.find(echoes, {}, {}, found);
    benchmark::DoNotOptimize(found.data());
  }
  bench.counters["contacts"] = static_cast<double>(found.size());
}

/// Every target gives a contact, and there are two false ones.
void track(benchmark::State& bench) {
  const int count = static_cast<int>(bench.range(0));
  const auto movers = targets(count, Rng{1});
  const Fan everywhere{.half_field = 4.0, .half_aperture = 2.0, .max_range = 1e9};
  Tracker tracker{{.max_tracks_count = 128}};
  Rng rng{2};
  std::vector<std::vector<Contact>> pings(64);
  for (auto& contacts : pings) {
    const auto seen = [&](const Vec3& at) {
      const Vec3 error = 0.2 * Vec3{rng.normal(), rng.normal(), rng.normal()};
      contacts.push_back({.position = at + error,
                          .covariance = 0.04 * Mat3::Identity(),
                          .radius = 1.5,
                          .radius_sigma = 0.2});
    };
    for (const Mover& mover : movers) seen(mover.position);
    for (int i = 0; i < 2; ++i) seen({rng.uniform(0, 100), rng.uniform(-100, 100), 0});
  }
  std::size_t i = 0;
  for (auto _ : bench) {
    tracker.update(static_cast<double>(i) * ping_period, pings[i % pings.size()], everywhere);
    ++i;
  }
  std::vector<Track> tracks;
  tracker.report(static_cast<double>(i) * ping_period, tracks);
  bench.counters["tracks"] = static_cast<double>(tracks.size());
}

/// What becomes of the targets in one run.
struct Score {
  double ospa{};      // mean [m]
  double targets{};   // those in view, summed over pings
  double missed{};    // of them without a track within 3 m
  double ghosts{};    // tracks without a target within 3 m
  double switches{};  // targets whose track changes its id
  double distance2{};
  double matches{};
};

/// Six balls of 1.5 m that cross each other's ways 20 m to 60 m ahead of a sonar at rest, for a minute.
void score(std::uint64_t seed, Score& sum, double runs) {
  const SonarParams params{.missed_ratio = 0.1, .false_echoes_count = 2.0};
  Rng rng{seed};
  std::vector<Mover> movers = movers_round({}, {});
  for (int i = 0; i < 6; ++i) {
    const Vec3 met{rng.uniform(20, 60), rng.uniform(-15, 15), 0};
    const double course = rng.uniform(-pi, pi);
    const Vec3 velocity = 0.5 * Vec3{std::cos(course), std::sin(course), 0};
    movers.push_back(ball(met - 30.0 * velocity, 1.5, velocity));
  }
  Sonar sonar{params};
  ContactFinder finder{params};
  Tracker tracker{{}};
  const Fan view = sonar.fan({});
  std::vector<Echo> echoes;
  std::vector<Contact> found;
  std::vector<Track> tracks;
  std::map<std::size_t, TrackId> id_of;
  Rng noise = rng.stream("noise");
  Rng falsehood = rng.stream("false");

  const int pings = 900;
  const int settled = 15;
  for (int i = 0; i < pings; ++i) {
    const double time = i * ping_period;
    sonar.ping({}, {.movers = movers}, noise, falsehood, echoes);
    finder.find(echoes, {}, {}, found);
    tracker.update(time, found, view);
    tracks.clear();
    tracker.report(time, tracks);

    std::vector<Vec3> truth;
    std::vector<Vec3> seen;
    std::vector<std::size_t> index;
    for (std::size_t k = 1; k < movers.size(); ++k) {
      if (view.covers(movers[k].position)) {
        truth.push_back(movers[k].position);
        index.push_back(k);
      }
    }
    std::erase_if(tracks, [&](const Track& track) { return !view.covers(track.position); });
    for (const Track& track : tracks) seen.push_back(track.position);
    if (i >= settled) {
      sum.ospa += ospa(truth, seen, 10.0) / (pings - settled) / runs;
      Assignment pairs{truth.size(), seen.size()};
      pairs.begin(truth.size(), seen.size());
      for (std::size_t a = 0; a < truth.size(); ++a) {
        for (std::size_t b = 0; b < seen.size(); ++b) {
          const double distance = (truth[a] - seen[b]).head<2>().norm();
          const auto known = id_of.find(index[a]);
          const bool kept = known != id_of.end() && known->second == tracks[b].id;
          if (distance < 3.0) pairs.offer(a, b, 3.0 - distance + (kept ? 10.0 : 0.0));
        }
      }
      const auto solved = pairs.solve();
      double matched = 0.0;
      for (std::size_t a = 0; a < truth.size(); ++a) {
        if (!solved[a]) continue;
        matched += 1.0;
        const Track& track = tracks[*solved[a]];
        const auto known = id_of.find(index[a]);
        if (known != id_of.end() && known->second != track.id) sum.switches += 1.0;
        id_of[index[a]] = track.id;
        sum.distance2 += (truth[a] - track.position).head<2>().squaredNorm();
      }
      sum.matches += matched;
      sum.targets += static_cast<double>(truth.size());
      sum.missed += static_cast<double>(truth.size()) - matched;
      sum.ghosts += static_cast<double>(seen.size()) - matched;
    }
    for (Mover& mover : movers) mover.position += ping_period * mover.velocity;
  }
}

void crossing_targets(benchmark::State& bench) {
  const int runs = 20;
  Score sum;
  for (auto _ : bench) {
    sum = {};
    for (int run = 0; run < runs; ++run) score(static_cast<std::uint64_t>(run), sum, runs);
  }
  bench.counters["ospa_m"] = sum.ospa;
  bench.counters["mota"] = 1.0 - (sum.missed + sum.ghosts + sum.switches) / sum.targets;
  bench.counters["motp_rms_m"] = std::sqrt(sum.distance2 / sum.matches);
  bench.counters["missed_ratio"] = sum.missed / sum.targets;
  bench.counters["ghost_ratio"] = sum.ghosts / sum.targets;
  bench.counters["switches_per_run"] = sum.switches / runs;
}

BENCHMARK(ping)->Arg(10)->Arg(50)->Unit(benchmark::kMicrosecond);
BENCHMARK(contacts)->Arg(10)->Arg(50)->Unit(benchmark::kMicrosecond);
BENCHMARK(track)->Arg(10)->Arg(50)->Unit(benchmark::kMicrosecond);
BENCHMARK(crossing_targets)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fairway
