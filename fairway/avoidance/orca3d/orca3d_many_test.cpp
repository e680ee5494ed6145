// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <vector>

#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

/// Runs of vehicles that are alike, and among them whoever is not, or is shown what cannot be used.
struct Fleet {
  std::vector<Avoider> avoiders;
  std::vector<OwnedSituation> owned;
};

OwnedSituation scene_of(Rng rng) {
  const int count = static_cast<int>(rng.index(12));
  switch (rng.index(6)) {
    case 0:
      return encounters::harbour(count, rng);
    case 1:
      return encounters::crowd(70, rng);  // more than a kernel has room for
    case 2:
    case 3:
      return encounters::crowd(count, rng);
    default:
      return encounters::congested(count, rng);
  }
}

Fleet drawn_fleet(std::uint64_t index) {
  Rng rng = Rng{1}.stream("fleet", index);
  Fleet fleet;
  for (std::uint64_t i = 0, count = 1 + rng.index(20); i < count; ++i) {
    OwnedSituation e = scene_of(rng.stream("scene", i));
    if (rng.index(10) == 0) e.situation.period = 0.2;
    if (rng.index(10) == 0) e.situation.own.velocity.x() = std::numeric_limits<double>::quiet_NaN();
    if (rng.index(10) == 0) e.situation.limits.max_speed = Limits::none;
    fleet.owned.push_back(e);
    switch (rng.index(12)) {
      case 0:
        fleet.avoiders.emplace_back(Direct{});
        break;
      case 1:
        fleet.avoiders.emplace_back(Orca3d{{.time_horizon_s = 10.0}});
        break;
      case 2:
        fleet.avoiders.emplace_back(Orca3d{{.symmetry = Symmetry::drawn}}, Rng{i});
        break;
      default:
        fleet.avoiders.emplace_back(Orca3d{{.max_neighbours_count = index % 2 == 0 ? 10 : 500}});
    }
  }
  return fleet;
}

TEST(Orca3dMany, EachDecidesAsItDoesAloneAndNothingAllocates) {
  int avoiding = 0, infeasible = 0;
  for (std::uint64_t index = 0; index < 600; ++index) {
    Fleet fleet = drawn_fleet(index);
    const std::vector<Situation> situations(fleet.owned.begin(), fleet.owned.end());
    std::vector<Command> commands(situations.size());
    std::vector<Avoider*> avoiders;
    for (Avoider& avoider : fleet.avoiders) avoiders.push_back(&avoider);

    const long before = allocation_count();
    Avoider::decide_many(avoiders, situations, commands);
    EXPECT_EQ(allocation_count(), before);

    for (std::size_t i = 0; i < situations.size(); ++i) {
      const Command alone = fleet.avoiders[i].decide(situations[i]);
      EXPECT_EQ(commands[i], alone) << "fleet " << index << ", vehicle " << i;
      for (Eigen::Index c = 0; c < 3; ++c)  // zeros too have a sign
        EXPECT_EQ(std::signbit(commands[i].velocity[c]), std::signbit(alone.velocity[c]));
      avoiding += alone.mode == Mode::avoid ? 1 : 0;
      infeasible += alone.mode == Mode::infeasible ? 1 : 0;
    }
  }
  EXPECT_GT(avoiding, 2000);
  EXPECT_GT(infeasible, 500);
}

}  // namespace
}  // namespace fairway
