// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "fairway/avoidance/pledge/testing/fleet.hpp"

namespace fairway::pledge {
namespace {

/// Eight at the corners of a cube of 20 m, each bound for the opposite one, whose spheres are so wide that
/// not all of them can go at once.
std::array<Member, most_members> wide_cube(Rng& rng) {
  std::array<Member, most_members> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec3 corner{(i & 1U) != 0 ? 10.0 : -10.0, (i & 2U) != 0 ? 10.0 : -10.0, (i & 4U) != 0 ? 20.0 : 0.0};
    const Vec3 centre{0.0, 0.0, 10.0}, out = corner - centre;
    all[i] = crossing(centre + rng.uniform(0.75, 1.0) * out, centre - out);
    all[i].radius = 3.0;
  }
  return all;
}

TEST(PledgeSearch, LetsThoseGoWhoLieAtEachOthersDestinationsWhereNotAllCan) {
  Rng rng{20010};
  int some = 0;
  for (int draw = 0; draw < 100; ++draw) {
    Search search{wide_cube(rng), Members{}.set(), {}, {.tubes = {.radius = 1.0, .told = 0.1}}, 0, {}};
    while (!search.go_on(1000, {})) continue;
    EXPECT_TRUE(search.found()) << draw;
    some += search.found_all() ? 0 : 1;
  }
  EXPECT_GT(some, 50) << "so narrow it is";
}

/// A member that goes from one side of the origin to the other, from 100 s on, beside another that is on its
/// way.
struct BesideAnother {
  static constexpr Epoch start{.tenths = 1000};
  Member member = crossing({-10, 0, 5}, {10, 0, 5});
  Reference other;

  explicit BesideAnother(const std::array<Knot, 2>& way) {
    for (const Knot& knot : way) other.add(knot);
  }
  Search search(const Epoch& from, const Chart& chart = {}) const {
    Search search{{member, member},
                  0b0001,
                  {Reference{}, other},
                  {.tubes = {.radius = 1.0, .told = 0.1}},
                  0,
                  chart,
                  {},
                  from};
    while (!search.go_on(1000, chart)) continue;
    return search;
  }
};

TEST(PledgeSearch, KeepsClearOfWhoIsOnItsWayAndKnowsWhenThatHolds) {
  const BesideAnother scene{{{{0.0, {0, -61, 5}}, {244.0, {0, 61, 5}}}}};
  const Search search = scene.search(BesideAnother::start);
  ASSERT_TRUE(search.found());
  const Plan& plan = search.best();
  const Reference way = reference_of(scene.member, plan, plan.codes[0]);
  EXPECT_GE(least_distance(way, scene.other, plan.start()), 5.1);
  EXPECT_TRUE(search.holds_from(BesideAnother::start, {}));
  int meets = 0;
  for (int seconds = -60; seconds < 60; ++seconds)
    meets += search.holds_from({.tenths = 1000 + 10 * seconds}, {}) ? 0 : 1;
  EXPECT_GT(meets, 0) << "if it departs at another time it meets the other";
}

TEST(PledgeSearch, BesideWhoIsOnItsWayNobodyGoesALongWayRound) {
  const std::vector<Vec3> corners{{-1, -16, 0}, {1, -16, 0}, {1, 16, 0}, {-1, 16, 0}};
  const std::array walls{Obstacle{.kind = Obstacle::Kind::polygon, .vertices = corners}};
  const BesideAnother scene{{{{0.0, {300, 0, 5}}, {110.0, {350, 0, 5}}}}};
  EXPECT_TRUE(scene.search(Search::at_zero, Chart{walls}).found());
  EXPECT_FALSE(scene.search(BesideAnother::start, Chart{walls}).found());
}

}  // namespace
}  // namespace fairway::pledge
