// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/testing/random_obstacles.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

/// Among other vehicles at 50 m, with obstacles on every side of them.
OwnedSituation among_obstacles(const RandomObstacles& scene, std::uint64_t seed) {
  OwnedSituation e = encounters::crowd(6, Rng{seed});
  for (Obstacle obstacle : scene.all) {
    for (Vec3* p : {&obstacle.position, &obstacle.from, &obstacle.to}) p->z() += 45.0;
    e.obstacles.push_back(obstacle);
  }
  return e;
}

void keep_within(double farthest, OwnedSituation& e) {
  std::erase_if(e.obstacles, [&](const Obstacle& o) {
    return !(nearest_point(o, e.situation.own.position).distance <= farthest);
  });
}

TEST(FarthestObstacle, BeyondItNoneMattersToAnyMethodThatSaysSo) {
  const Catalog catalog = builtin_avoiders();
  int seen = 0;
  const auto check = [&](const std::string& name, const ParamValues& params) {
    const Avoider method = catalog.make(name, params);
    const double farthest = method.farthest_obstacle();
    if (farthest == std::numeric_limits<double>::infinity()) return;
    ++seen;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const RandomObstacles scene{40, 120.0, Rng{seed}};
      OwnedSituation e = among_obstacles(scene, seed);
      const Command among_all = Avoider{method}.decide(e);
      keep_within(farthest, e);
      EXPECT_LT(e.obstacles.size(), scene.all.size());
      EXPECT_EQ(Avoider{method}.decide(e), among_all) << name << ", " << seed;
    }
  };
  for (const Catalog::Entry& entry : catalog.entries())
    if (!entry.wraps) check(std::string{entry.info.name}, {});
  check("orca3d", {{"symmetry", std::string{"starboard"}}});
  check("orca3d+stop_and_wait", {{"crit_dist_m", 12.0}});
  EXPECT_GE(seen, 5);
}

TEST(FarthestObstacle, IsAsFarAsTheMethodLooks) {
  const Catalog catalog = builtin_avoiders();
  const double everywhere = std::numeric_limits<double>::infinity();
  EXPECT_EQ(catalog.make("orca3d+stop_and_wait", {{"crit_dist_m", 12.0}}).farthest_obstacle(), 12.0);
  EXPECT_EQ(catalog.make("direct").farthest_obstacle(), -everywhere);
  EXPECT_EQ(catalog.make("orca3d+trackable").farthest_obstacle(), everywhere) << "it foresees farther";
}

}  // namespace
}  // namespace fairway
