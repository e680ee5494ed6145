// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/orca2d/orca2d.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/orca2d/testing/flat_scenes.hpp"
#include "fairway/avoidance/orca2d/testing/plane_reference.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"

namespace fairway {
namespace {

using encounters::decide;
using encounters::OwnedSituation;

TEST(Orca2d, GoesWhereItWasGoingWhenAWallIsOutOfRange) {
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {20.5, -9, 0}, .to = {20.5, 9, 0}}};
  EXPECT_EQ(decide<Orca2d>(e), (Command{.velocity = {1.0, 0.0, 0.0}, .mode = Mode::cruise}));
}

TEST(Orca2d, DepthIsNeitherReadNorWritten) {
  OwnedSituation e = encounters::head_on(8.0);
  const Command flat = decide<Orca2d>(e);
  e.tracks[0].position.z() = 90.0;
  e.tracks[0].velocity.z() = -1.0;
  e.situation.own.velocity.z() = 0.5;
  EXPECT_EQ(decide<Orca2d>(e), flat);
  EXPECT_EQ(flat.velocity.z(), 0.0);
}

TEST(Orca2d, AWallThatCannotBeReachedWithinTheHorizonAsksForNothing) {
  // 1.5 m/s for 5 s and the radius of 1 m are 8.5 m
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {8.6, -9, 0}, .to = {8.6, 9, 0}}};
  EXPECT_EQ(decide<Orca2d>(e).mode, Mode::cruise);
  EXPECT_EQ(decide<Orca2d>(e, {.obstacle_time_horizon_s = 5.1}).mode, Mode::avoid);
}

TEST(Orca2d, AWallIsKeptWhateverANeighbourAsks) {
  // the wall allows no more than 0.1 m/s to starboard; who presses from port asks for far more
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {-50, 1.5, 0}, .to = {50, 1.5, 0}}};
  e.tracks = {encounters::track(1, {0.0, -1.5, 50.0}, Vec3::Zero())};
  const Command command = decide<Orca2d>(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_NEAR(command.velocity.y(), 0.1, 1e-12);
}

TEST(Orca2d, WallsThatContradictEachOtherAreViolatedLeast) {
  // own radius 1 between walls 0.7 m to port and 0.9 m to starboard: to the middle
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {-50, 0.9, 0}, .to = {50, 0.9, 0}},
                 {.kind = Obstacle::Kind::segment, .from = {-50, -0.7, 0}, .to = {50, -0.7, 0}}};
  const Command command = decide<Orca2d>(e);
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_LT((command.velocity - Vec3(std::sqrt(1.25), 1.0, 0.0)).norm(), 0.2);
  EXPECT_NEAR(command.velocity.y(), 1.0, 1e-12);
}

TEST(Orca2d, APolygonIsSolidWhicheverWayItsVerticesRun) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    flat_scenes::Waters waters = flat_scenes::waters(i);
    const Command expected = decide<Orca2d>(waters.encounter);
    for (std::vector<Vec3>& outline : waters.outlines) std::ranges::reverse(outline);
    EXPECT_LT((decide<Orca2d>(waters.encounter).velocity - expected.velocity).norm(), 1e-12) << i;
  }
}

TEST(Orca2d, ARepeatedVertexChangesNothing) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Rng rng = Rng{4}.stream("repeat", i);
    flat_scenes::Waters waters = flat_scenes::waters(i);
    const Command expected = decide<Orca2d>(waters.encounter);
    for (std::size_t k = 0; k < waters.outlines.size(); ++k) {
      std::vector<Vec3>& outline = waters.outlines[k];
      const auto at = outline.begin() + static_cast<std::ptrdiff_t>(rng.index(outline.size()));
      outline.insert(at, Vec3{*at});
      outline.push_back(outline.front());
      waters.encounter.obstacles[k].vertices = outline;
    }
    EXPECT_EQ(decide<Orca2d>(waters.encounter), expected) << i;
  }
}

/// The half-planes that a decision shows.
struct Shown {
  std::vector<plane_reference::Line> lines;
  std::size_t hard_count = 0;

  explicit Shown(const Drawing& drawing) {
    for (const Stroke& stroke : drawing.strokes()) {
      if (stroke.kind != Stroke::Kind::half_space) continue;
      const plane_reference::Vector n = stroke.points[1].head<2>().cast<long double>();
      lines.push_back({n, n.dot(stroke.points[0].head<2>().cast<long double>())});
      hard_count += stroke.meaning == "allowed by an obstacle" ? 1 : 0;
    }
  }
};

TEST(Orca2d, TakesTheBestVelocityOfItsHalfPlanes) {
  double largest = 0.0;
  int infeasible = 0, with_walls = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const flat_scenes::Waters waters = flat_scenes::waters(i, static_cast<int>(i % 7));
    const Situation s = waters.encounter;
    Drawing drawing;
    const Command command = decide<Orca2d>(s, {}, &drawing);
    const Shown shown{drawing};
    const plane_reference::Answer expected =
        plane_reference::Program{shown.lines, shown.hard_count,
                                 s.preferred_velocity().head<2>().cast<long double>(), s.limits.max_speed}
            .solve();
    if (shown.lines.empty()) continue;
    EXPECT_EQ(command.mode == Mode::infeasible, expected.violation > 1e-10L) << i;
    largest = std::fmax(
        largest,
        static_cast<double>((command.velocity.head<2>().cast<long double>() - expected.velocity).norm()));
    infeasible += command.mode == Mode::infeasible ? 1 : 0;
    with_walls += shown.hard_count > 1 ? 1 : 0;
  }
  EXPECT_LT(largest, 1e-9 * 1.5);  // measured 4e-13
  EXPECT_GT(infeasible, 300);
  EXPECT_GT(with_walls, 1000);
}

TEST(Orca2d, WithoutWallsItIsOrcaInSpaceWithEverythingInAPlane) {
  double largest = 0.0;
  int infeasible = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    OwnedSituation e = flat_scenes::swarm(i, static_cast<int>(i % 12));
    const bool has_discs = i % 4 == 3;
    Rng rng = Rng{6}.stream("discs", i);
    for (int k = 0; has_discs && k < 3; ++k) {
      const Vec3 at = e.situation.own.position + rng.uniform(2.5, 9.0) * flat_scenes::bearing(rng);
      e.obstacles.push_back(
          {.kind = Obstacle::Kind::sphere, .position = at, .radius = rng.uniform(0.1, 1.4)});
    }
    const Command expected = encounters::decide<Orca3d>(e);
    // in space a disc is no harder than a neighbour
    if (has_discs && expected.mode == Mode::infeasible) continue;
    const Command command = decide<Orca2d>(e);
    EXPECT_EQ(command.mode, expected.mode) << i;
    largest = std::fmax(largest, (command.velocity - expected.velocity).norm());
    infeasible += command.mode == Mode::infeasible ? 1 : 0;
  }
  EXPECT_LT(largest, 1e-9 * 1.5);  // measured 3e-13
  EXPECT_GT(infeasible, 500);
}

TEST(Orca2d, AgreesWithOrcaInLongDouble) {
  double largest = 0.0;
  int infeasible = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    OwnedSituation e = flat_scenes::swarm(i, 1 + static_cast<int>(i % 9));
    const Situation s = e;
    const auto flat = [](const Vec3& a) { return plane_reference::Vector{a.head<2>().cast<long double>()}; };
    std::vector<plane_reference::Line> lines;
    for (const Track& t : s.tracks) {
      lines.push_back(plane_reference::half_plane(flat(t.position - s.own.position),
                                                  flat(s.own.velocity - t.velocity), flat(s.own.velocity),
                                                  2.0L, 5.0L, s.period));
    }
    const plane_reference::Answer expected =
        plane_reference::Program{lines, 0, flat(s.preferred_velocity()), s.limits.max_speed}.solve();
    const Command command = decide<Orca2d>(s);
    EXPECT_EQ(command.mode == Mode::infeasible, expected.violation > 1e-10L) << i;
    largest = std::fmax(largest, static_cast<double>((flat(command.velocity) - expected.velocity).norm()));
    infeasible += command.mode == Mode::infeasible ? 1 : 0;
  }
  EXPECT_LT(largest, 1e-9 * 1.5);  // measured 3e-13
  EXPECT_GT(infeasible, 500);
}

TEST(Orca2d, WorksInRawNorthings) {
  // positions are good to 1e-9 m at 4.6e6 m; in a congested scene that is magnified
  double alone = 0.0, among_others = 0.0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto change = [&](int count) {
      const flat_scenes::Waters here = flat_scenes::waters(i, count);
      const flat_scenes::Waters there = flat_scenes::waters(i, count, {4.6e6, 5e5, 0.0});
      return (decide<Orca2d>(here.encounter).velocity - decide<Orca2d>(there.encounter).velocity).norm();
    };
    alone = std::fmax(alone, change(0));
    among_others = std::fmax(among_others, change(4));
  }
  EXPECT_LT(alone, 1e-7);         // measured 1e-8
  EXPECT_LT(among_others, 1e-6);  // measured 2e-8
}

TEST(Orca2d, ExactCoincidencesAreAnswered) {
  // own ship on every point of a grid on which all corners lie, at rest or along its lines
  const std::vector<Vec3> step{{0, -2, 0}, {2, -2, 0}, {2, 2, 0}, {1, 2, 0}, {1, 0, 0}, {0, 0, 0}};
  for (int i = 0; i < 9 * 9 * 9 * 2; ++i) {
    const auto digit = [&](int place) { return static_cast<double>(i / place % 9); };
    OwnedSituation e = encounters::open_water();
    Ownship& own = e.situation.own;
    own.position = {0.5 * digit(1) - 1.0, 0.75 * digit(9) - 3.0, 0.0};
    own.velocity = {std::fmod(digit(81), 3.0) - 1.0, std::floor(digit(81) / 3.0) - 1.0, 0.0};
    own.radius = i < 729 ? 0.0 : 1.0;
    e.obstacles = {{.kind = Obstacle::Kind::polygon, .vertices = step},
                   {.kind = Obstacle::Kind::segment, .from = {-1, -1, 0}, .to = {-1, 1, 0}},
                   {.kind = Obstacle::Kind::segment, .from = {3, 0, 0}, .to = {3, 0, 0}}};
    const Vec3 v = decide<Orca2d>(e).velocity;
    EXPECT_TRUE(is_finite(v)) << i;
    EXPECT_LE(v.norm(), 1.5 * (1 + 1e-12)) << i;
  }
}

// A vessel that does as it is told never comes closer than its radius to what it saw, however it is sent at
// it.
TEST(Orca2d, NeverCutsThroughAWall) {
  double closest = 1e9;
  int stopped_by_it = 0;
  for (std::uint64_t run = 0; run < 500; ++run) {
    flat_scenes::Waters waters = flat_scenes::waters(run, run % 2 == 0 ? 0 : 4);  // others may press it there
    OwnedSituation& e = waters.encounter;
    Ownship& own = e.situation.own;
    const auto clearance = [&] {
      double nearest = 1e9;
      for (const Obstacle& o : e.obstacles)
        nearest = std::fmin(nearest, nearest_point(o, own.position).distance - own.radius);
      return nearest;
    };
    if (clearance() < 0.0) continue;
    double nearest = 1e9;
    for (int step = 0; step < 200; ++step) {
      own.velocity = decide<Orca2d>(e).velocity;
      for (int part = 0; part < 4; ++part) {
        own.position += 0.25 * e.situation.period * own.velocity;
        nearest = std::fmin(nearest, clearance());
      }
    }
    closest = std::fmin(closest, nearest);
    stopped_by_it += nearest < 1e-2 ? 1 : 0;
  }
  EXPECT_GT(closest, -1e-9);  // measured -4e-16
  EXPECT_GT(stopped_by_it, 150);
}

TEST(Orca2d, WhereWallsContradictEachOtherTheNeighboursCountStill) {
  // own radius 1 between walls 0.9 m to either side; somebody at rest 3 m ahead, who is passed
  // by velocities beyond a tangent: of those along the walls none leads ahead
  OwnedSituation e = encounters::open_water();
  e.obstacles = {{.kind = Obstacle::Kind::segment, .from = {-50, 0.9, 0}, .to = {50, 0.9, 0}},
                 {.kind = Obstacle::Kind::segment, .from = {-50, -0.9, 0}, .to = {50, -0.9, 0}}};
  EXPECT_NEAR(decide<Orca2d>(e).velocity.x(), 1.0, 1e-9);
  e.tracks = {encounters::track(1, {3.0, 0.0, 50.0}, Vec3::Zero())};
  e.tracks[0].reacts = false;
  const Command command = decide<Orca2d>(e, {.time_horizon_s = 10.0});
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_NEAR(command.velocity.x(), 0.0, 1e-9);
  EXPECT_NEAR(command.velocity.y(), 0.0, 1e-9);
}

}  // namespace
}  // namespace fairway
