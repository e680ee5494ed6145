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

}  // namespace
}  // namespace fairway::pledge
