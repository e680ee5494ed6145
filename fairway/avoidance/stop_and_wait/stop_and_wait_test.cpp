// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

const Command waiting{.velocity = Vec3::Zero(), .mode = Mode::hold};

Avoider around_direct() { return Avoider{StopAndWait{{}}, Avoider{Direct{{}}}}; }

/// Own ship with `priority`, somebody of priority 5 and id 3 at `range`.
OwnedSituation meeting(int priority, double range = 5.0) {
  OwnedSituation e = encounters::open_water();
  e.situation.own.priority = priority;
  e.tracks = {encounters::track(3, {range, 0.0, 50.0}, Vec3::Zero())};
  e.tracks[0].priority = 5;
  return e;
}

TEST(StopAndWait, TheSmallerPriorityNumberMovesAndTheLargerWaits) {
  EXPECT_EQ(around_direct().decide(meeting(4)).mode, Mode::cruise);
  EXPECT_EQ(around_direct().decide(meeting(6)), waiting);
}

TEST(StopAndWait, EqualPrioritiesAreSettledByTheSmallerId) {
  OwnedSituation e = meeting(5);
  e.situation.own.id = VehicleId{2};
  EXPECT_EQ(around_direct().decide(e).mode, Mode::cruise);
  e.situation.own.id = VehicleId{4};
  EXPECT_EQ(around_direct().decide(e), waiting);
}

TEST(StopAndWait, OnlyThoseWithinRangeCount) {
  EXPECT_EQ(around_direct().decide(meeting(6, 6.0)), waiting);
  EXPECT_EQ(around_direct().decide(meeting(6, 6.001)).mode, Mode::cruise);
}

TEST(StopAndWait, OneOfHigherPriorityIsEnough) {
  OwnedSituation e = meeting(6, 5.0);
  e.tracks[0].priority = 9;
  e.tracks.push_back(encounters::track(1, {0.0, 5.5, 50.0}, Vec3::Zero()));
  EXPECT_EQ(around_direct().decide(e), waiting);
}

TEST(StopAndWait, OfEightInACubeOnlyTheFirstMoves) {
  for (int own = 0; own < 8; ++own) {
    const Command command = around_direct().decide(encounters::cube_centre(8, own, 20.0, 0.45));
    EXPECT_EQ(command.mode, own == 0 ? Mode::cruise : Mode::hold) << "vehicle " << own;
  }
}

/// Counts how often it was asked.
struct Counting {
  static constexpr AlgorithmInfo info{.name = "counting"};
  using Params = NoParams;
  struct Memory {
    int asked = 0;
  };
  Params params;
  Command decide(const Situation&, Memory& memory, Context&) const noexcept {
    return {.velocity = {0.01 * ++memory.asked, 0.0, 0.0}};
  }
};

TEST(StopAndWait, TheInnerAvoiderIsAskedWhileItWaits) {
  Avoider avoider{StopAndWait{{}}, Avoider{Counting{{}}}};
  for (int i = 0; i < 9; ++i) EXPECT_EQ(avoider.decide(meeting(6)), waiting);
  EXPECT_DOUBLE_EQ(avoider.decide(meeting(4)).velocity.x(), 0.1);
}

TEST(StopAndWait, OneRangeGoesToBothLayers) {
  Avoider avoider = builtin_avoiders().make("apf+stop_and_wait", {{"crit_dist_m", 4.0}});
  EXPECT_EQ(avoider.decide(meeting(6, 5.0)).mode, Mode::cruise);
  EXPECT_EQ(avoider.decide(meeting(6, 3.0)), waiting);
  EXPECT_EQ(avoider.decide(meeting(4, 3.0)).mode, Mode::avoid);
}

TEST(StopAndWait, TwoOfOneIdDoNotWaitForEachOtherForEver) {
  OwnedSituation e = meeting(5);
  e.situation.own.id = VehicleId{3};
  EXPECT_EQ(around_direct().decide(e).mode, Mode::cruise);
}

}  // namespace
}  // namespace fairway
