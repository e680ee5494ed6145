// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/headway.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fairway/avoidance/pledge/search.hpp"
#include "fairway/avoidance/pledge/testing/fleet.hpp"

namespace fairway::pledge {
namespace {

Reference straight(double begins, const Vec3& from, double ends, const Vec3& to) {
  Reference way;
  way.add({begins, from});
  way.add({ends, to});
  return way;
}

TEST(Headway, OfWhoFollowsIsHowLongItTakesToWhereTheOtherMayLie) {
  // 10 m behind at 0.5 m/s, and 4 m are needed
  const Reference ahead = straight(0, {10, 0, 5}, 100, {60, 0, 5});
  const Reference behind = straight(0, {0, 0, 5}, 100, {50, 0, 5});
  EXPECT_NEAR(headway_of(ahead, behind, 4.0, {.aim = 30.0}), 12.0, 0.1);
  EXPECT_EQ(headway_of(ahead, behind, 4.0, {.aim = 8.0}), 8.0) << "no more than is asked";
  EXPECT_EQ(headway_of(behind, ahead, 4.0, {.aim = 30.0}), 30.0) << "who is ahead goes away";
}

TEST(Headway, CountsWithTheWaterThatSetsTheStoppedOneOff) {
  // passes 5 m beside, and 4 m are needed: 1 m at 0.1 m/s
  const Reference one = straight(0, {0, 0, 5}, 100, {50, 0, 5});
  const Reference other = straight(0, {50, 5, 5}, 100, {0, 5, 5});
  EXPECT_EQ(headway_of(one, other, 4.0, {.aim = 30.0}), 30.0);
  EXPECT_NEAR(headway_of(one, other, 4.0, {.aim = 30.0, .drift = {0, 0.1, 0}}), 10.0, 0.1);
}

TEST(Headway, InACurrentTwiceAsMuchIsWanted) {
  EXPECT_EQ(headway_in(Vec3::Zero(), 20.0).aim, 20.0);
  EXPECT_EQ(headway_in({0.1, 0, 0}, 20.0).aim, 40.0);
  EXPECT_EQ(headway_in({0.1, 0, 0}, 0.0).aim, 0.0) << "who wants none wants none";
  EXPECT_EQ(headway_in({0, 0.1, 0}, 20.0).drift, Vec3(0, 0.1, 0));
}

TEST(Headway, IsTowardsThoseAloneWhoAreNamed) {
  // the third follows the first by 6 m at 0.5 m/s, where 4 m are needed; the second is far from both
  const Member member{.radius = 1.5};
  Clearance scene{{member, member, member}, 0b111, {.radius = 0.9, .told = 0.1}, 0.0};
  scene.place(0, straight(0, {10, 0, 5}, 100, {60, 0, 5}));
  scene.place(1, straight(0, {10, 50, 5}, 100, {60, 50, 5}));
  scene.place(2, straight(0, {4, 0, 5}, 100, {54, 0, 5}));
  const Headway wanted{.aim = 20.0};
  const Members first_two{0b011}, third{0b100};
  EXPECT_EQ(headway_of(scene, first_two, first_two, wanted), 20.0);
  EXPECT_NEAR(headway_of(scene, first_two, third, wanted), 4.0, 0.1);
  EXPECT_NEAR(headway_of(scene, third, first_two, wanted), 4.0, 0.1);
  EXPECT_EQ(headway_of(1, scene.reference(1), scene, third, wanted), 20.0);
}

TEST(Headway, IsWhatSamplesOfWhereOneStopsAndTheOtherComesSay) {
  Rng rng{20260};
  for (int draw = 0; draw < 20; ++draw) {
    const auto place = [&] { return Vec3{rng.uniform(-8, 8), rng.uniform(-8, 8), rng.uniform(0, 8)}; };
    Reference a = straight(0, place(), 20, place()), b = straight(5, place(), 25, place());
    a.add({45, place()});
    b.add({50, place()});
    const Vec3 drift{rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), 0};
    double least = 15.0;
    for (double t = 0.0; t <= 45.0; t += 0.05)
      for (double after = 0.0; after < least; after += 0.1)
        if ((b.at(t + after) - a.at(t) - after * drift).norm() <= 3.0) least = after;
    EXPECT_NEAR(headway_of(a, b, 3.0, {.aim = 15.0, .drift = drift}), least, 0.25) << draw;
  }
}

/// The plan for eight that cross a cube, by what is wanted.
struct Found {
  double headway{}, time{};
};
Found found(std::uint64_t seed, double aim) {
  Rng rng = Rng{seed}.stream("fleet");
  const std::vector<Member> all = cube(rng);
  std::array<Member, most_members> members;
  std::ranges::copy(all, members.begin());
  const Tubes tubes{.radius = 1.0, .told = 0.1};
  Search search{members, Members{}.set(), {}, {.tubes = tubes}, 0, {}, {.aim = aim}};
  while (!search.go_on(1000, {})) continue;
  EXPECT_TRUE(search.found_all());
  Clearance scene{members, Members{}.set(), tubes, 0.0};
  Found it;
  for (std::size_t i = 0; i < most_members; ++i) {
    const Reference way = reference_of(members[i], search.best(), search.best().codes[i]);
    EXPECT_TRUE(scene.accepts(i, way)) << "what is wanted takes nothing away from what has to be";
    scene.place(i, way);
    it.time += way.end() / 8.0;
  }
  it.headway = headway_of(scene, Members{}.set(), Members{}.set(), {.aim = 20.0});
  return it;
}

TEST(PledgeSearch, FindsPlansByWhichWhoStopsIsInNobodysWayForAWhile) {
  double without = 0.0, with = 0.0, longer = 0.0;
  constexpr int seeds = 5;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Found quickest = found(seed, 0.0), wide = found(seed, 20.0);
    without += quickest.headway / seeds;
    with += wide.headway / seeds;
    longer += (wide.time - quickest.time) / seeds;
    EXPECT_GT(wide.headway, quickest.headway) << seed;
  }
  EXPECT_LT(without, 5.0);
  EXPECT_GT(with, 10.0);
  EXPECT_LT(longer, 8.0);
}

}  // namespace
}  // namespace fairway::pledge
