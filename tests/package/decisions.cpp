// SPDX-License-Identifier: Apache-2.0
// One line for each decision of every method in scenes whose numbers are the same bits on every machine: no
// sine, no root of three is in them. `decisions > here.txt`, the same there, and the two are compared.
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"

using namespace fairway;

namespace {

Vec3 in_box(Rng& rng, double half) {
  const double north = rng.uniform(-half, half), east = rng.uniform(-half, half);
  return {north, east, rng.uniform(-half, half)};
}

struct Scene {
  explicit Scene(std::uint64_t serial) {
    Rng rng = Rng{42}.stream("scene", serial);
    const Vec3 own{0, 0, 50};
    situation = {.period = 0.1,
                 .own = {.position = own, .velocity = in_box(rng, 0.5), .yaw = rng.uniform(-3.0, 3.0)},
                 .goal = {.position = own + in_box(rng, 30.0), .cruise_speed = 1.0},
                 .limits = {.max_speed = 1.5}};
    const std::uint64_t count = serial % 20;
    const double half = serial % 2 == 0 ? 15.0 : 4.0;
    for (std::uint32_t id = 1; id <= count; ++id) {
      Track track{.id = TrackId{id},
                  .position = own + in_box(rng, half),
                  .velocity = in_box(rng, 0.6),
                  .priority = static_cast<std::int32_t>(id)};
      track.position_covariance = Mat3::Identity() * rng.uniform(0.0, 0.5);
      tracks.push_back(track);
    }
    obstacle = {.kind = Obstacle::Kind::sphere, .position = own + in_box(rng, 10.0), .radius = 1.0};
  }

  void sort() {
    std::ranges::sort(tracks, {}, [&](const Track& t) {
      return std::pair{(t.position - situation.own.position).squaredNorm(), number(t.id)};
    });
    situation.tracks = tracks;
    situation.obstacles = {&obstacle, 1};
  }

  Situation situation;
  std::vector<Track> tracks;
  Obstacle obstacle;
};

}  // namespace

int main() {
  std::vector<std::string> names;
  const Catalog catalog = builtin_avoiders();
  for (const Catalog::Entry& entry : catalog.entries()) names.emplace_back(entry.info.name);
  for (const char* name : {"orca3d+stop_and_wait", "orca3d+safety_filter", "orca3d+inflate"})
    names.emplace_back(name);

  for (const std::string& name : names) {
    for (std::uint64_t serial = 0; serial < 100; ++serial) {
      Scene scene{serial};
      Avoider avoider = catalog.make(name, {}, Rng{7});
      for (int step = 0; step < 5; ++step) {
        scene.sort();
        const Command command = avoider.decide(scene.situation);
        const Vec3& v = command.velocity;
        std::printf("%s %d %d %s %.17g %.17g %.17g\n", name.c_str(), static_cast<int>(serial), step,
                    enum_name(command.mode), v.x(), v.y(), v.z());

        // what comes next does not depend on what was answered, so that one difference is not counted twice
        scene.situation.time += scene.situation.period;
        for (Track& track : scene.tracks) track.position += scene.situation.period * track.velocity;
      }
    }
  }
}
