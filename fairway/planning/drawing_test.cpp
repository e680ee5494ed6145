// SPDX-License-Identifier: Apache-2.0
// What planners draw, over all of them.
#include "fairway/avoidance/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/planning/builtin.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

/// Two charted buoys and one that is on no chart lie in the way, and somebody crosses it.
OwnedSituation busy_waters() {
  OwnedSituation e;
  e.situation = {.period = 0.2,
                 .own = {.position = {0, 0, 2}, .radius = 0.75},
                 .goal = {.position = {30, 0, 2}, .cruise_speed = 0.4},
                 .limits = {.max_speed = 0.5, .max_acceleration = 0.2, .max_turn_rate = 0.5}};
  e.tracks = {encounters::track(1, {14, 9, 2}, {0, -0.3, 0}, 0.5)};
  for (const auto& [n, charted] : {std::pair{8.0, true}, {16.0, false}, {22.0, true}}) {
    e.obstacles.push_back(
        {.kind = Obstacle::Kind::sphere, .position = {n, 0.3, 2}, .radius = 1.0, .charted = charted});
  }
  return e;
}

class PlannersDraw : public testing::TestWithParam<std::string> {
 protected:
  static Avoider planner() {
    Catalog catalog;
    add_planners(catalog);
    return catalog.make(GetParam(), {}, Rng{3});
  }
};

TEST_P(PlannersDraw, SomethingAtEveryDecisionAndLookingChangesNoCommand) {
  OwnedSituation e = busy_waters();
  Avoider alone = planner(), looked_at = planner();
  Drawing drawing;
  for (int step = 0; step < 150; ++step) {
    drawing.clear();
    const Command command = alone.decide(e);
    ASSERT_EQ(looked_at.decide(e, &drawing), command) << step;
    ASSERT_FALSE(drawing.strokes().empty()) << step;
    for (const Stroke& stroke : drawing.strokes()) {
      ASSERT_TRUE(std::ranges::all_of(stroke.points, [](const Vec3& p) { return is_finite(p); }))
          << stroke.meaning;
    }
    carry_out(e, command);
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheCatalog, PlannersDraw, testing::Values("rrt_star", "blend", "teb"),
                         [](const auto& instance) { return instance.param; });

TEST(BlendDraws, ItsPlanAndHowItGoesRoundWhatItDidNotKnow) {
  OwnedSituation e = busy_waters();
  Catalog catalog;
  add_planners(catalog);
  Avoider blend = catalog.make("blend", {{"replan", false}}, Rng{3});
  std::set<std::string> following, going_round;
  for (int step = 0; step < 400; ++step) {
    // the buoy that is on no chart is seen from 6 m
    OwnedSituation seen = e;
    std::erase_if(seen.obstacles, [&](const Obstacle& o) {
      return !o.charted && (o.position - e.situation.own.position).norm() > 6.0;
    });
    Drawing drawing;
    carry_out(e, blend.decide(seen, &drawing));
    std::set<std::string> meanings;
    for (const Stroke& stroke : drawing.strokes()) meanings.insert(stroke.meaning);
    (meanings.contains("search tree") ? following : going_round).merge(meanings);
  }
  for (const char* meaning : {"search tree", "path", "trajectory"})
    EXPECT_TRUE(following.contains(meaning)) << meaning;
  for (const char* meaning :
       {"path", "trajectory", "going round to here", "way between the movers", "allowed by a barrier"})
    EXPECT_TRUE(going_round.contains(meaning)) << meaning;
  EXPECT_FALSE(following.contains("going round to here"));
}

}  // namespace
}  // namespace fairway
