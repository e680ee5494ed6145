// SPDX-License-Identifier: Apache-2.0
// The laws that every avoider obeys. They run over the whole catalog, so a new algorithm is held to them
// by the line that lists it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/testing/allocations.hpp"

namespace fairway {
namespace {

using encounters::Encounter;

std::vector<std::string> everybody() {
  std::vector<std::string> names;
  const Catalog catalog = builtin_avoiders();
  for (const Catalog::Entry& entry : catalog.entries()) names.emplace_back(entry.info.name);
  names.emplace_back("apf+stop_and_wait");
  names.emplace_back("orca3d+stop_and_wait");
  names.emplace_back("orca3d+safety_filter");
  names.emplace_back("wall_following+safety_filter");
  for (const char* name : {"apf+inflate", "orca3d+inflate"}) names.emplace_back(name);
  return names;
}

/// One law for one avoider.
class Laws : public testing::TestWithParam<std::string> {
 protected:
  Avoider avoider() const { return builtin_avoiders().make(GetParam(), {}, Rng{7}); }

  bool has(bool AlgorithmInfo::*property) const {
    const Catalog catalog = builtin_avoiders();
    const std::string name = GetParam().substr(0, GetParam().find('+'));
    return catalog.find(name).info.*property;
  }

  /// Algorithms of the horizontal plane are shown scenes in it.
  Encounter suited(Encounter e) const {
    if (!has(&AlgorithmInfo::planar)) return e;
    const double depth = e.situation.own.position.z();
    e.situation.own.velocity.z() = 0.0;
    e.situation.goal.position.z() = depth;
    for (Track& t : e.tracks) {
      t.position.z() = depth;
      t.velocity.z() = 0.0;
    }
    return e.sorted();
  }

  /// Calls `law(avoider, encounter)` in 600 swarms of 0 to 19, half of them without room to pass.
  template <class Law>
  void everywhere(Law law) const {
    for (std::uint64_t i = 0; i < 600; ++i) {
      SCOPED_TRACE("swarm " + std::to_string(i));
      const Rng rng = Rng{42}.stream("swarm", i);
      const int count = static_cast<int>(i / 2 % 20);
      law(avoider(), suited(i % 2 == 0 ? encounters::crowd(count, rng) : encounters::congested(count, rng)));
    }
  }
};

/// How far two answers to the same question may differ by rounding [m/s].
constexpr double same = 1e-6;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST_P(Laws, TheSameSituationMemoryAndSeedGiveTheSameBits) {
  everywhere([](Avoider avoider, const Situation& s) {
    Avoider copy = avoider;
    for (int step = 0; step < 3; ++step) EXPECT_EQ(avoider.decide(s), copy.decide(s));
  });
}

TEST_P(Laws, CommandsAreFiniteAndWithinTheLimits) {
  everywhere([](Avoider avoider, Encounter e) {
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

TEST_P(Laws, AloneItGoesWhereItWasGoing) {
  const bool heads_for_it = has(&AlgorithmInfo::steers_by_heading);
  everywhere([&](Avoider avoider, Encounter e) {
    e.tracks.clear();
    const Vec3 preferred = e.situation.preferred_velocity();
    if (heads_for_it) e.situation.own.yaw = std::atan2(preferred.y(), preferred.x());
    const Command command = avoider.decide(e);
    EXPECT_EQ(command.mode, Mode::cruise);
    EXPECT_LT((command.velocity - preferred).norm(), 1e-15);
  });
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
    Encounter e = suited(i % 2 == 0 ? encounters::crowd(count, rng) : encounters::congested(count, rng));
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
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Encounter e = suited(encounters::congested(6, Rng{42}.stream("congested", i)));
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
  everywhere([](Avoider avoider, const Encounter& here) {
    const Encounter there = encounters::shifted(here, {512.0, -256.0, 32.0});
    Avoider twin = avoider;
    EXPECT_LT((avoider.decide(here).velocity - twin.decide(there).velocity).norm(), same);
  });
}

TEST_P(Laws, TheHeadingOfTheFrameDoesNotMatter) {
  if (!has(&AlgorithmInfo::isotropic)) GTEST_SKIP() << "knows north";
  everywhere([](Avoider avoider, const Encounter& e) {
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
  everywhere([](Avoider avoider, const Encounter& e) {
    const Vec3 expected = Avoider{avoider}.decide(e).velocity;
    const Vec3 answer = avoider.decide(encounters::mirrored(e)).velocity;
    EXPECT_LT((answer - Vec3(expected.x(), -expected.y(), expected.z())).norm(), same);
  });
}

TEST_P(Laws, TheOrderOfTheTracksDoesNotMatter) {
  everywhere([](Avoider avoider, Encounter e) {
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
    std::vector<Encounter> scenes{encounters::crowd(count, Rng{1}), encounters::congested(count, Rng{2})};
    scenes.push_back(scenes[0]);
    for (Track& t : scenes[2].tracks) t.position = scenes[2].situation.own.position;
    scenes.push_back(scenes[2]);
    for (Track& t : scenes[3].tracks) t.velocity = scenes[3].situation.own.velocity;
    for (const Encounter& e : scenes) {
      Avoider avoider = this->avoider();
      const Command command = avoider.decide(suited(e));
      EXPECT_TRUE(is_finite(command.velocity)) << count;
      EXPECT_LE(command.velocity.norm(), 1.5 * (1 + 1e-12)) << count;
    }
  }
}

TEST_P(Laws, WhoWantsToStayMayStayOrGiveWay) {
  everywhere([](Avoider avoider, Encounter e) {
    e.situation.goal.velocity = Vec3::Zero();
    EXPECT_TRUE(is_finite(avoider.decide(e).velocity));
    e.tracks.clear();
    EXPECT_EQ(avoider.decide(e).velocity, Vec3(0.0, 0.0, 0.0));
    e.situation.goal.velocity.reset();
    e.situation.goal.position = e.situation.own.position;
    EXPECT_EQ(avoider.decide(e).velocity, Vec3(0.0, 0.0, 0.0));
  });
}

TEST_P(Laws, WhoCannotMoveDoesNot) {
  everywhere([](Avoider avoider, Encounter e) {
    e.situation.limits.max_speed = 0.0;
    EXPECT_EQ(avoider.decide(e).velocity, Vec3(0.0, 0.0, 0.0));
  });
}

TEST_P(Laws, ObstaclesOfEveryKindAreAnswered) {
  const std::vector<Vec3> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Encounter open = encounters::open_water();
  const Vec3 own = open.situation.own.position;
  for (const Vec3& at : {Vec3{2, 0.1, 0}, Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{-1, -1, 0}}) {
    std::vector<Vec3> corners;
    for (const Vec3& corner : triangle) corners.push_back(corner + own + at);
    Encounter e = open;
    e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = own + at, .radius = 1.0},
                   {.kind = Obstacle::Kind::segment, .from = own + at, .to = own + at + Vec3{0, 9, 0}},
                   {.kind = Obstacle::Kind::segment, .from = own + at, .to = own + at},
                   {.kind = Obstacle::Kind::polygon, .vertices = corners}};
    Avoider avoider = this->avoider();
    EXPECT_TRUE(is_finite(avoider.decide(suited(e)).velocity));
  }
}

TEST_P(Laws, NonsenseIsAnsweredWithAStandstillAndInfeasible) {
  const std::vector<void (*)(Encounter&)> spoilers{
      [](Encounter& e) { e.situation.own.position.x() = nan; },
      [](Encounter& e) { e.situation.own.velocity.y() = nan; },
      [](Encounter& e) { e.situation.own.yaw = nan; },
      [](Encounter& e) { e.situation.own.radius = -1.0; },
      [](Encounter& e) { e.situation.goal.position.z() = std::numeric_limits<double>::infinity(); },
      [](Encounter& e) {
        e.situation.goal.velocity = Vec3{0.0, 0.0, nan};
      },
      [](Encounter& e) { e.situation.goal.cruise_speed = nan; },
      [](Encounter& e) { e.situation.limits.max_speed = nan; },
      [](Encounter& e) { e.situation.limits.max_climb_rate = nan; },
      [](Encounter& e) { e.situation.limits.max_depth = nan; },
      [](Encounter& e) { e.situation.period = 0.0; },
      [](Encounter& e) { e.situation.period = nan; },
      [](Encounter& e) { e.tracks[2].position.x() = nan; },
      [](Encounter& e) { e.tracks[0].velocity.x() = nan; },
      [](Encounter& e) { e.tracks[1].radius = nan; },
      [](Encounter& e) {
        e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = {nan, 0, 0}}};
      },
      [](Encounter& e) { e.obstacles = {{.kind = Obstacle::Kind::polygon}}; },
  };
  for (std::size_t i = 0; i < spoilers.size(); ++i) {
    Encounter e = encounters::crowd(5, Rng{1});
    spoilers[i](e);
    Avoider avoider = this->avoider();
    const Command standstill{.mode = Mode::infeasible, .note = why_unusable(e)};
    EXPECT_FALSE(standstill.note.empty()) << "spoiler " << i;
    EXPECT_EQ(avoider.decide(e), standstill) << "spoiler " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheCatalog, Laws, testing::ValuesIn(everybody()), [](const auto& instance) {
  std::string name = instance.param;
  for (char& c : name) {
    if (c == '+') c = '_';
  }
  return name;
});

/// What `action` was refused with.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Catalog, RefusesAnUnknownAlgorithmAndNamesTheNearest) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_THAT(refusal([&] { (void)catalog.make("orca_3d"); }), testing::HasSubstr("did you mean orca3d?"));
  EXPECT_THAT(refusal([&] { (void)catalog.make("apf+stop_and_wit"); }), testing::HasSubstr("stop_and_wait"));
  EXPECT_THAT(refusal([&] { (void)catalog.make("apf+orca3d"); }), testing::HasSubstr("wraps nothing"));
}

TEST(Catalog, RefusesAnUnknownParameterAndNamesTheNearest) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_THAT(refusal([&] {
                (void)catalog.make("orca3d", {{"time_horizon", 5.0}});
              }),
              testing::HasSubstr("time_horizon: unknown parameter of orca3d; did you mean time_horizon_s?"));
  EXPECT_THAT(refusal([&] {
                (void)catalog.make("apf", {{"w2_rato", 5.0}});
              }),
              testing::HasSubstr("did you mean w2_ratio?"));
}

TEST(Catalog, RefusesAValueOutOfRangeAndSaysWhatIsAccepted) {
  const Catalog catalog = builtin_avoiders();
  EXPECT_THAT(refusal([&] {
                (void)catalog.make("orca3d", {{"responsibility_ratio", 1.5}});
              }),
              testing::AllOf(testing::HasSubstr("1.5"), testing::HasSubstr("[0, 1]")));
  EXPECT_THAT(refusal([&] {
                (void)catalog.make("orca3d", {{"max_neighbours_count", 2.5}});
              }),
              testing::HasSubstr("a whole number"));
  EXPECT_THAT(refusal([&] {
                (void)catalog.make("apf", {{"speed_law", std::string("fast")}});
              }),
              testing::HasSubstr("one of clamped, bang_bang"));
}

TEST(Catalog, KnowsWrappersByTheirShortNames) {
  EXPECT_EQ(builtin_avoiders().make("apf+saw").info().name, "stop_and_wait");
  EXPECT_EQ(builtin_avoiders().make("apf+cbf").info().name, "safety_filter");
}

TEST(Catalog, ListsTheParametersOfAllLayersOnce) {
  const std::vector<ParamInfo> params = builtin_avoiders().params("apf+stop_and_wait");
  EXPECT_EQ(std::ranges::count(params, std::string("crit_dist_m"), &ParamInfo::name), 1);
  EXPECT_EQ(std::ranges::count(params, std::string("w2_ratio"), &ParamInfo::name), 1);
}

}  // namespace
}  // namespace fairway
