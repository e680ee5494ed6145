// SPDX-License-Identifier: Apache-2.0
// The laws that every avoider obeys. They run over the whole catalog, so a new algorithm is held to them
// by the line that lists it.
#include "tests/laws.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "fairway/avoidance/drawing.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway::laws {
namespace {

/// How far two answers to the same question may differ by rounding [m/s].
constexpr double same = 1e-6;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST_P(Laws, TheSameSituationMemoryAndSeedGiveTheSameBits) {
  everywhere([](Avoider avoider, const Situation& s) {
    Avoider twin = avoider;
    for (int step = 0; step < 3; ++step) {
      Avoider copy = avoider;
      const Command expected = avoider.decide(s);
      EXPECT_EQ(twin.decide(s), expected);
      EXPECT_EQ(copy.decide(s), expected);
    }
  });
}

TEST_P(Laws, CommandsAreFiniteAndWithinTheLimits) {
  everywhere([](Avoider avoider, OwnedSituation e) {
    Situation& s = e.situation;
    s.limits.max_climb_rate = 0.3;
    s.limits.min_depth = s.own.position.z() - 0.02;  // 0.2 m/s up is too fast, at a period of 0.1 s
    s.limits.max_depth = s.own.position.z() + 0.01;
    const Vec3 v = avoider.decide(e).velocity;
    EXPECT_TRUE(is_finite(v));
    EXPECT_LE(v.norm(), s.limits.max_speed * (1 + 1e-12));
    EXPECT_GE(v.z(), -0.2 - 1e-12);
    EXPECT_LE(v.z(), 0.1 + 1e-12);
  });
}

/// Nobody else, and heading for the goal.
OwnedSituation alone(OwnedSituation e) {
  e.tracks.clear();
  e.obstacles.clear();
  const Vec3 preferred = e.situation.preferred_velocity();
  e.situation.own.yaw = std::atan2(preferred.y(), preferred.x());
  return e;
}

TEST_P(Laws, AloneItGoesWhereItWasGoing) {
  if (has(&AlgorithmInfo::allocates)) GTEST_SKIP() << "a plan begins at rest";
  if (has(&AlgorithmInfo::needs_link)) GTEST_SKIP() << "goes nowhere without the others";
  everywhere([&](Avoider avoider, OwnedSituation e) {
    e = alone(e);
    const Vec3 preferred = e.situation.preferred_velocity();
    const Command command = avoider.decide(e);
    EXPECT_EQ(command.mode, Mode::cruise);
    EXPECT_LT((command.velocity - preferred).norm(), 1e-15);
  });
}

TEST_P(Laws, AloneAPlanIsTheStraightWay) {
  if (!has(&AlgorithmInfo::allocates)) GTEST_SKIP() << "goes there at once, which is a law of its own";
  for (std::uint64_t i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    Avoider avoider = this->avoider();
    OwnedSituation e = alone(suited(encounters::crowd(0, Rng{42}.stream("alone", i))));
    const Vec3 start = e.situation.own.position, goal = e.situation.goal.position;
    for (int step = 0; step < 300; ++step) {
      const Command command = avoider.decide(e);
      ASSERT_EQ(command.mode, Mode::cruise) << step;
      follow(e, command);
    }
    const Vec3 gone = e.situation.own.position - start, ahead = unit(Vec3{goal - start});
    EXPECT_GT(gone.dot(ahead), std::fmin(5.0, 0.8 * (goal - start).norm()));
    EXPECT_LT((gone - gone.dot(ahead) * ahead).norm(), 0.02);  // measured 0.006 of teb
  }
}

TEST_P(Laws, InSteadyStateDecidingDoesNotAllocate) {
  if (has(&AlgorithmInfo::allocates)) GTEST_SKIP() << "a planner that must";
  everywhere([](Avoider avoider, const Situation& s) {
    (void)avoider.decide(s);
    const long before = allocation_count();
    (void)avoider.decide(s);
    EXPECT_EQ(allocation_count(), before);
  });
}

TEST_P(Laws, LookingDoesNotChangeACommandForEver) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const Rng rng = Rng{41}.stream("scene", i);
    const int count = static_cast<int>(i / 2);
    OwnedSituation e = suited(i % 2 == 0 ? encounters::crowd(count, rng) : encounters::congested(count, rng));
    Avoider alone = avoider(), looked_at = avoider();
    Drawing drawing;
    for (int step = 0; step < 10; ++step) {
      drawing.clear();
      const Command command = alone.decide(e);
      ASSERT_EQ(looked_at.decide(e, &drawing), command) << step;
      carry_out(e, command);
    }
    e.tracks.clear();
    ASSERT_EQ(looked_at.decide(e), alone.decide(e));  // what it remembers is the same
  }
}

TEST_P(Laws, InACongestedSceneItDrawsSomethingThatMakesSense) {
  if (has(&AlgorithmInfo::needs_link)) GTEST_SKIP() << "thinks of nothing without the others";
  for (std::uint64_t i = 0; i < 40; ++i) {
    const OwnedSituation e = suited(encounters::congested(6, Rng{42}.stream("congested", i)));
    Drawing drawing;
    (void)avoider().decide(e, &drawing);
    EXPECT_FALSE(drawing.strokes().empty()) << i;
    for (const Stroke& stroke : drawing.strokes()) {
      SCOPED_TRACE(stroke.meaning);
      EXPECT_FALSE(stroke.meaning.empty());
      EXPECT_TRUE(std::ranges::all_of(stroke.points, [](const Vec3& p) { return is_finite(p); }));
      EXPECT_EQ(stroke.rgb.size(), static_cast<std::size_t>(stroke.side * stroke.side));
      EXPECT_EQ(stroke.points.empty(), stroke.kind == Stroke::Kind::image);
    }
  }
}

TEST_P(Laws, TheOriginOfTheFrameDoesNotMatter) {
  // a search for the minimum of a sum of squares magnifies rounding: measured 0.03 m/s of teb
  const double allowed = has(&AlgorithmInfo::allocates) ? 0.05 : same;
  everywhere([&](Avoider avoider, const OwnedSituation& here) {
    const OwnedSituation there = encounters::shifted(here, {512.0, -256.0, 32.0});
    Avoider twin = avoider;
    EXPECT_LT((avoider.decide(here).velocity - twin.decide(there).velocity).norm(), allowed);
  });
}

TEST_P(Laws, TheHeadingOfTheFrameDoesNotMatter) {
  if (!has(&AlgorithmInfo::isotropic)) GTEST_SKIP() << "knows north";
  everywhere([](Avoider avoider, const OwnedSituation& e) {
    const Vec3 expected = Avoider{avoider}.decide(e).velocity;
    for (const double angle : {0.7, 2.0, pi, -1.3}) {
      const Vec3 answer = Avoider{avoider}.decide(encounters::turned(e, angle)).velocity;
      EXPECT_LT((answer - Eigen::AngleAxisd(angle, Vec3::UnitZ()) * expected).norm(), same) << angle;
    }
  });
}

TEST_P(Laws, TheMirroredSceneHasTheMirroredAnswer) {
  if (!has(&AlgorithmInfo::isotropic)) GTEST_SKIP() << "knows north";
  if (has(&AlgorithmInfo::handed)) GTEST_SKIP() << "prefers a side";
  everywhere([](Avoider avoider, const OwnedSituation& e) {
    const Vec3 expected = Avoider{avoider}.decide(e).velocity;
    const Vec3 answer = avoider.decide(encounters::mirrored(e)).velocity;
    EXPECT_LT((answer - Vec3(expected.x(), -expected.y(), expected.z())).norm(), same);
  });
}

TEST_P(Laws, TheOrderOfTheTracksDoesNotMatter) {
  everywhere([](Avoider avoider, OwnedSituation e) {
    const Command expected = Avoider{avoider}.decide(e);
    Rng rng{5};
    for (std::size_t k = e.tracks.size(); k > 1; --k) std::swap(e.tracks[k - 1], e.tracks[rng.index(k)]);
    const Command shuffled = avoider.decide(e);
    EXPECT_EQ(shuffled.mode, expected.mode);
    EXPECT_LT((shuffled.velocity - expected.velocity).norm(), 3e-8 * e.situation.limits.max_speed);
  });
}

TEST_P(Laws, AnyNumberOfTracksIsAnsweredEvenAllAtOnePlace) {
  for (const int count : {0, 1, 2, 3, 50, 500}) {
    std::vector<OwnedSituation> scenes{encounters::crowd(count, Rng{1}),
                                       encounters::congested(count, Rng{2})};
    scenes.push_back(scenes[0]);
    for (Track& t : scenes[2].tracks) t.position = scenes[2].situation.own.position;
    scenes.push_back(scenes[2]);
    for (Track& t : scenes[3].tracks) t.velocity = scenes[3].situation.own.velocity;
    for (const OwnedSituation& e : scenes) {
      Avoider avoider = this->avoider();
      const Command command = avoider.decide(suited(e));
      EXPECT_TRUE(is_finite(command.velocity)) << count;
      EXPECT_LE(command.velocity.norm(), 1.5 * (1 + 1e-12)) << count;
    }
  }
}

TEST_P(Laws, WhoWantsToStayMayStayOrGiveWay) {
  everywhere([](Avoider avoider, OwnedSituation e) {
    e.situation.goal.velocity = Vec3::Zero();
    EXPECT_TRUE(is_finite(avoider.decide(e).velocity));
    e.tracks.clear();
    e.obstacles.clear();
    EXPECT_EQ(avoider.decide(e).velocity, Vec3(0.0, 0.0, 0.0));
    e.situation.goal.velocity.reset();
    e.situation.goal.position = e.situation.own.position;
    EXPECT_EQ(avoider.decide(e).velocity, Vec3(0.0, 0.0, 0.0));
  });
}

TEST_P(Laws, WhoCannotMoveDoesNot) {
  everywhere([](Avoider avoider, OwnedSituation e) {
    e.situation.limits.max_speed = 0.0;
    EXPECT_EQ(avoider.decide(e).velocity, Vec3(0.0, 0.0, 0.0));
  });
}

TEST_P(Laws, ObstaclesOfEveryKindAreAnswered) {
  const std::vector<Vec3> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const OwnedSituation open = encounters::open_water();
  const Vec3 own = open.situation.own.position;
  for (const Vec3& at : {Vec3{2, 0.1, 0}, Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{-1, -1, 0}}) {
    std::vector<Vec3> corners;
    for (const Vec3& corner : triangle) corners.push_back(corner + own + at);
    OwnedSituation e = open;
    e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = own + at, .radius = 1.0},
                   {.kind = Obstacle::Kind::segment, .from = own + at, .to = own + at + Vec3{0, 9, 0}},
                   {.kind = Obstacle::Kind::segment, .from = own + at, .to = own + at},
                   {.kind = Obstacle::Kind::polygon, .vertices = corners}};
    Avoider avoider = this->avoider();
    EXPECT_TRUE(is_finite(avoider.decide(suited(e)).velocity));
  }
}

TEST_P(Laws, NonsenseIsAnsweredWithAStandstillAndInfeasible) {
  const std::vector<void (*)(OwnedSituation&)> spoilers{
      [](OwnedSituation& e) { e.situation.own.position.x() = nan; },
      [](OwnedSituation& e) { e.situation.own.velocity.y() = nan; },
      [](OwnedSituation& e) { e.situation.own.yaw = nan; },
      [](OwnedSituation& e) { e.situation.own.radius = -1.0; },
      [](OwnedSituation& e) { e.situation.goal.position.z() = std::numeric_limits<double>::infinity(); },
      [](OwnedSituation& e) {
        e.situation.goal.velocity = Vec3{0.0, 0.0, nan};
      },
      [](OwnedSituation& e) { e.situation.goal.cruise_speed = nan; },
      [](OwnedSituation& e) { e.situation.limits.max_speed = nan; },
      [](OwnedSituation& e) { e.situation.limits.max_climb_rate = nan; },
      [](OwnedSituation& e) { e.situation.limits.max_depth = nan; },
      [](OwnedSituation& e) { e.situation.period = 0.0; },
      [](OwnedSituation& e) { e.situation.period = nan; },
      [](OwnedSituation& e) { e.tracks[2].position.x() = nan; },
      [](OwnedSituation& e) { e.tracks[0].velocity.x() = nan; },
      [](OwnedSituation& e) { e.tracks[1].radius = nan; },
      [](OwnedSituation& e) {
        e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {nan, 0, 0}}};
      },
      [](OwnedSituation& e) { e.obstacles = {{.kind = Obstacle::Kind::polygon}}; },
  };
  for (std::size_t i = 0; i < spoilers.size(); ++i) {
    OwnedSituation e = encounters::crowd(5, Rng{1});
    spoilers[i](e);
    Avoider avoider = this->avoider();
    const Command standstill{.mode = Mode::infeasible, .note = why_unusable(e)};
    EXPECT_FALSE(standstill.note.empty()) << "spoiler " << i;
    EXPECT_EQ(avoider.decide(e), standstill) << "spoiler " << i;
  }
}

}  // namespace
}  // namespace fairway::laws
