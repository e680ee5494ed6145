// SPDX-License-Identifier: Apache-2.0
// In a plane, ORCA in space is ORCA: against an independent one in two dimensions, in long double.
#include <gtest/gtest.h>

#include "fairway/avoidance/orca2d/testing/plane_reference.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

namespace fairway {
namespace {

using plane_reference::Answer;
using plane_reference::Line;
using plane_reference::Program;
using plane_reference::Vector;

TEST(Orca3dInAPlane, IsOrcaInTwoDimensions) {
  double largest = 0.0;
  int infeasible = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const Rng rng = Rng{7}.stream("plane", i);
    const int count = 1 + static_cast<int>(i % 9);
    encounters::OwnedSituation e =
        i % 2 == 0 ? encounters::swarm(count, 2.2, 6.0, rng) : encounters::congested(count, rng);
    Situation& s = e.situation;
    s.own.velocity.z() = 0.0;
    s.goal.position.z() = s.own.position.z();
    std::vector<Line> lines;
    const Vector own = s.own.velocity.head<2>().cast<long double>();
    for (Track& t : e.tracks) {
      t.position.z() = s.own.position.z();
      t.velocity.z() = 0.0;
      lines.push_back(plane_reference::half_plane((t.position - s.own.position).head<2>().cast<long double>(),
                                                  own - t.velocity.head<2>().cast<long double>(), own, 2.0L,
                                                  5.0L, s.period));
    }
    const Answer expected =
        Program{lines, 0, s.preferred_velocity().head<2>().cast<long double>(), s.limits.max_speed}.solve();

    const Command command = encounters::decide<Orca3d>(e);

    EXPECT_EQ(command.velocity.z(), 0.0);
    EXPECT_EQ(command.mode, expected.violation > 0 ? Mode::infeasible : Mode::avoid) << "case " << i;
    const Vector velocity = command.velocity.head<2>().cast<long double>();
    largest = std::fmax(largest, static_cast<double>((velocity - expected.velocity).norm()));
    infeasible += expected.violation > 0 ? 1 : 0;
  }
  EXPECT_LT(largest, 1e-9 * 1.5);  // measured 2e-13
  EXPECT_GT(infeasible, 400);
}

}  // namespace
}  // namespace fairway
