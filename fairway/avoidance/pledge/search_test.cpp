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

/// Two streams at one depth that run into each other, four behind each other in each, whose last ones lie
/// where the first ones of the others end.
std::array<Member, most_members> streams(Rng& rng) {
  std::array<Member, most_members> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double behind = 9.0 * static_cast<double>(i % 4), ahead = i < 4 ? 1.0 : -1.0;
    all[i] = crossing({ahead * (rng.normal() - 20.0 - behind), rng.uniform(-4, 4), 5},
                      {ahead * (60.0 - behind), rng.uniform(-4, 4), 5});
    all[i].radius = 2.0;
  }
  return all;
}

TEST(PledgeSearch, StreamsThatMeetHeadOnGoAtOnceAsWhoDivesOnTheSpotIsInNobodysWay) {
  Rng rng{20011};
  for (int draw = 0; draw < 20; ++draw) {
    const std::array<Member, most_members> members = streams(rng);
    Search search{members, Members{}.set(), {}, {.tubes = {.radius = 1.0, .told = 0.1}}, 0,
                  {},      {.aim = 20.0}};
    while (!search.go_on(1000, {})) continue;
    ASSERT_TRUE(search.found_all()) << draw;
    const Plan& plan = search.best();
    Clearance scene{members, plan.participants, {.radius = 1.0, .told = 0.1}, 0.0};
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Reference way = reference_of(members[i], plan, plan.codes[i]);
      EXPECT_TRUE(scene.accepts(i, way)) << draw << ": " << i;
      scene.place(i, way);
    }
  }
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

TEST(PledgeSearch, OfSeveralNobodyGoesALongWayRoundAtTheFirstAttempt) {
  const std::vector<Vec3> corners{{-1, -25, 0}, {1, -25, 0}, {1, 25, 0}, {-1, 25, 0}};
  const std::array walls{Obstacle{.kind = Obstacle::Kind::polygon, .vertices = corners}};
  const Chart chart{walls};
  const std::array<Member, most_members> members{crossing({-10, 0, 5}, {10, 0, 5}),
                                                 crossing({-10, 8, 5}, {10, 8, 5})};
  const auto finds = [&](const Members& asked, std::size_t attempt) {
    const std::array<Reference, most_members> others{Reference{}, Reference{members[1].anchor}};
    Search search{members, asked, others, {.tubes = {.radius = 1.0, .told = 0.1}}, attempt, chart};
    while (!search.go_on(1000, chart)) continue;
    return search.found();
  };
  EXPECT_FALSE(finds(0b11, 0));
  EXPECT_TRUE(finds(0b11, 1)) << "there is no other way";
  EXPECT_TRUE(finds(0b01, 0)) << "it has nobody to wait for";
}

}  // namespace
}  // namespace fairway::pledge
