// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/text.hpp"
#include "fairway/embed/avoider.hpp"
#include "fairway/embed/testing/interruptions.hpp"
#include "fairway/embed/testing/plain.hpp"

namespace fairway::embed {
namespace {

using encounters::OwnedSituation;
using testing::HasSubstr;

static_assert(std::is_trivially_copyable_v<Situation> && std::is_standard_layout_v<Situation>);
static_assert(std::is_trivially_copyable_v<Track> && std::is_standard_layout_v<Track>);
static_assert(std::is_trivially_copyable_v<Command>);
static_assert(std::is_nothrow_move_constructible_v<Avoider> && std::is_copy_constructible_v<Avoider>);

/// The whole catalog, and wrappers around methods.
std::vector<std::string> everybody() {
  std::vector<std::string> names = algorithms();
  for (const char* name :
       {"apf+stop_and_wait", "orca3d+stop_and_wait+inflate", "avoa+inflate", "orca3d+cbf"}) {
    names.emplace_back(name);
  }
  return names;
}

/// A swarm of 0 to 19, half of them without room to pass, among solids of every kind; with all in it that a
/// situation may have.
struct Scene {
  explicit Scene(std::uint64_t i)
      : e{i % 2 == 0 ? encounters::crowd(static_cast<int>(i / 2 % 20), Rng{42}.stream("scene", i))
                     : encounters::congested(static_cast<int>(i / 2 % 20), Rng{42}.stream("scene", i))} {
    Rng rng = Rng{43}.stream("scene", i);
    fairway::Situation& s = e.situation;
    if (i % 3 == 0) s.goal.velocity = encounters::direction(rng);
    if (i % 8 == 0) s.current = 0.2 * encounters::direction(rng);
    if (i % 9 == 0) s.goal.arrival = 0.5;
    if (i % 5 == 0)
      s.limits = {.max_speed = 1.5, .max_climb_rate = 0.3, .max_acceleration = 0.2, .max_turn_rate = 0.4};
    if (i % 7 == 0) s.limits.max_depth = s.own.position.z() + 0.01;
    if (i % 11 == 0) s.limits.min_speed = 0.5;
    s.limits.sternway = i % 13 != 0;
    s.limits.sway = i % 6 != 0;
    for (fairway::Track& t : e.tracks) {
      if (rng.uniform(0.0, 1.0) < 0.3) t.destination = t.position + 10.0 * encounters::direction(rng);
      t.reacts = rng.uniform(0.0, 1.0) < 0.8;
      t.age = rng.uniform(0.0, 3.0);
      t.yaw = rng.uniform(-pi, pi);
      const Vec3 a = encounters::direction(rng);
      t.position_covariance = rng.uniform(0.0, 1.0) * a * a.transpose();
    }
    if (i % 4 == 0) {
      const Vec3 at = s.own.position + 6.0 * encounters::direction(rng);
      corners = {at, at + Vec3{3, 0, 0}, at + Vec3{3, 3, 0}, at + Vec3{0, 3, 0}};
      e.obstacles = {{.kind = fairway::Obstacle::Kind::polygon, .vertices = corners},
                     {.kind = fairway::Obstacle::Kind::sphere,
                      .position = s.own.position + 5.0 * encounters::direction(rng),
                      .radius = 1.5},
                     {.kind = fairway::Obstacle::Kind::segment,
                      .from = s.own.position + 4.0 * encounters::direction(rng),
                      .to = s.own.position + 9.0 * encounters::direction(rng)}};
    }
    if (i % 4 != 0) s.envelope = &envelope;
    if (i % 6 == 0) {
      model.mass << 80, 90, 90, 5, 8, 8;
      model.linear_damping << 10, 20, 20, 3, 3, 3;
      model.greatest << 30, 20, 20, 0, 0, 5;
      model.least = -model.greatest;
      s.model = &model;
    }
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() = default;

  OwnedSituation e;
  std::vector<Vec3> corners;
  fairway::OnboardModel model;
  fairway::Envelope envelope = encounters::of_a_boat();
};

class Embedded : public testing::TestWithParam<std::string> {
 protected:
  Avoider embedded(const Capacity& capacity = {}) const { return Avoider{GetParam(), {}, capacity, 7}; }
  fairway::Avoider avoider() const { return builtin_avoiders().make(GetParam(), {}, Rng{7}); }

  /// Every how manieth scene it is shown: one decision of avoa_improved may take 10 ms in such a throng.
  std::uint64_t stride() const { return GetParam() == "avoa_improved" ? 9 : 1; }
};

TEST_P(Embedded, DecidesAsTheLibraryDoesToTheBit) {
  for (std::uint64_t i = 0; i < 160; i += stride()) {
    SCOPED_TRACE(i);
    Scene scene{i};
    Avoider embedded = this->embedded();
    fairway::Avoider avoider = this->avoider();
    for (int step = 0; step < 3; ++step) {
      const fairway::Command expected = avoider.decide(scene.e);
      const Command command = embedded.decide(PlainSituation{scene.e}.view());
      ASSERT_TRUE(same(command, expected)) << step;
      EXPECT_EQ(command.left_out, 0U);
      carry_out(scene.e, expected);
    }
  }
}

TEST_P(Embedded, NeitherAllocatesNorThrowsNorLocksFromTheFirstDecisionOn) {
  std::vector<PlainSituation> situations;
  for (std::uint64_t i = 0; i < 600; i += stride()) situations.emplace_back(Scene{i}.e);
  for (int count = 33; count < 40; ++count) situations.emplace_back(encounters::crowd(count, Rng{1}));
  for (const std::size_t first : {0U, 39U, 71U, 400U}) {  // whatever it meets first
    Avoider embedded = this->embedded();
    const long news = allocation_count();
    const Interruptions before = interruptions();
    for (std::size_t i = 0; i < situations.size(); ++i) {
      (void)embedded.decide(situations[(first + i) % situations.size()].view());
    }
    const Interruptions after = interruptions();
    EXPECT_EQ(allocation_count(), news);
    EXPECT_EQ(after.allocations, before.allocations);
    EXPECT_EQ(after.throws, before.throws);
    EXPECT_EQ(after.locks, before.locks);
  }
}

TEST_P(Embedded, ACopyIsASnapshot) {
  Scene scene{19};
  Avoider original = embedded();
  (void)original.decide(PlainSituation{scene.e}.view());
  Avoider copy = original;
  std::vector<Command> answers;
  OwnedSituation later = scene.e;
  for (int step = 0; step < 20; ++step) {
    answers.push_back(original.decide(PlainSituation{later}.view()));
    carry_out(later, {});
  }
  Avoider moved = std::move(copy);
  copy = moved;
  const long before = allocation_count();
  later = scene.e;
  for (int step = 0; step < 20; ++step) {
    const PlainSituation s{later};
    const long news = allocation_count();
    const Command command = copy.decide(s.view());
    EXPECT_EQ(allocation_count(), news) << step;
    EXPECT_EQ(command.velocity, answers[static_cast<std::size_t>(step)].velocity) << step;
    carry_out(later, {});
  }
  EXPECT_GT(allocation_count(), before);  // the encounters' own: the count is alive
}

INSTANTIATE_TEST_SUITE_P(OfTheCatalog, Embedded, testing::ValuesIn(everybody()), [](const auto& instance) {
  std::string name = instance.param;
  std::ranges::replace(name, '+', '_');
  return name;
});

TEST(Interruptions, AreCountedWhereTheyHappen) {
  if (!counts_interruptions()) GTEST_SKIP() << "a sanitizer counts instead";
  const Interruptions before = interruptions();
  std::mutex mutex;
  { const std::scoped_lock lock{mutex}; }
  EXPECT_GT(interruptions().locks, before.locks);
  EXPECT_THROW((void)std::string().at(0), std::out_of_range);  // thrown inside the standard library
  EXPECT_GT(interruptions().throws, before.throws);
  const long mallocs = interruptions().allocations;
  const Eigen::VectorXd numbers = Eigen::VectorXd::Zero(100);  // not by operator new
  EXPECT_EQ(interruptions().allocations, mallocs + 1);
  EXPECT_EQ(numbers.sum(), 0.0);
}

TEST(EmbeddedAvoider, TakesTracksInAnyOrder) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    PlainSituation s{Scene{i}.e};
    const Command expected = Avoider{"orca3d"}.decide(s.view());
    std::ranges::reverse(s.tracks);
    EXPECT_EQ(Avoider{"orca3d"}.decide(s.view()).velocity, expected.velocity);
  }
}

TEST(EmbeddedAvoider, KeepsTheNearestTracksWhereThereAreTooMany) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    OwnedSituation e = encounters::congested(30, Rng{i});
    PlainSituation all{e};
    std::ranges::reverse(all.tracks);
    const Command command =
        Avoider{"orca3d", {}, {.tracks = 4, .obstacles = 0, .vertices = 0}}.decide(all.view());
    e.tracks.resize(4);
    EXPECT_TRUE(same(command, builtin_avoiders().make("orca3d").decide(e)));
    EXPECT_EQ(command.left_out, 26U);
  }
}

TEST(EmbeddedAvoider, KeepsTheNearestObstaclesWhereThereAreTooMany) {
  OwnedSituation e = encounters::open_water();
  const std::vector<Vec3> near{{3, -1, 0}, {5, -1, 0}, {5, 1, 0}, {3, 1, 0}},
      far{{30, 0, 0}, {40, 0, 0}, {40, 9, 0}};
  e.obstacles = {{.kind = fairway::Obstacle::Kind::polygon, .vertices = far},
                 {.kind = fairway::Obstacle::Kind::sphere, .position = {60, 0, 50}, .radius = 1},
                 {.kind = fairway::Obstacle::Kind::polygon, .vertices = near},
                 {.kind = fairway::Obstacle::Kind::sphere, .position = {0, 4, 50}, .radius = 1}};
  const PlainSituation all{e};
  OwnedSituation nearest = e;
  nearest.obstacles = {e.obstacles[2], e.obstacles[3]};
  const fairway::Command expected = builtin_avoiders().make("orca2d").decide(nearest);
  EXPECT_EQ(expected.mode, fairway::Mode::avoid);

  const Command by_count =
      Avoider{"orca2d", {}, {.tracks = 0, .obstacles = 2, .vertices = 64}}.decide(all.view());
  EXPECT_TRUE(same(by_count, expected));
  EXPECT_EQ(by_count.left_out, 2U);

  // of the polygons one has room: the farther is left out, what is behind it is not
  const Command by_vertices =
      Avoider{"orca2d", {}, {.tracks = 0, .obstacles = 9, .vertices = 5}}.decide(all.view());
  EXPECT_TRUE(same(by_vertices, expected));
  EXPECT_EQ(by_vertices.left_out, 1U);
}

TEST(EmbeddedAvoider, AnswersNonsenseWithAStandstillWhereverItStands) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto answer = [](const PlainSituation& s) {
    return Avoider{"orca3d", {}, {.tracks = 3, .obstacles = 1, .vertices = 0}}.decide(s.view());
  };
  const OwnedSituation crowd = encounters::crowd(12, Rng{1});
  for (std::size_t i = 0; i < 12; ++i) {
    PlainSituation s{crowd};
    EXPECT_NE(answer(s).mode, Mode::infeasible);
    s.tracks[i].position[1] = nan;
    EXPECT_EQ(answer(s).mode, Mode::infeasible) << "track " << i;
    EXPECT_EQ(answer(s).velocity, Triple{});
  }
  PlainSituation s{crowd};
  s.situation.own.position[2] = nan;
  EXPECT_EQ(answer(s).mode, Mode::infeasible);
  s = PlainSituation{crowd};
  s.situation.period = 0.0;
  EXPECT_EQ(answer(s).mode, Mode::infeasible);
  EXPECT_EQ(answer(s).note, "the period is not a positive number");

  Avoider avoider{"orca3d"};
  Situation nothing_there = PlainSituation{crowd}.situation;
  nothing_there.track_count = 1;
  EXPECT_EQ(avoider.decide(nothing_there).mode, Mode::infeasible);
  EXPECT_EQ(avoider.decide(nothing_there).note, "a pointer is null where its count is not 0");
  nothing_there.track_count = 0;
  nothing_there.obstacle_count = 1;
  EXPECT_EQ(avoider.decide(nothing_there).mode, Mode::infeasible);
  Obstacle hollow;
  hollow.kind = ObstacleKind::polygon;
  hollow.vertex_count = 3;
  nothing_there.obstacles = &hollow;
  EXPECT_EQ(avoider.decide(nothing_there).mode, Mode::infeasible);
}

/// As text; what is given by it, back again.
std::vector<std::string> numbers_of(const fairway::Envelope& envelope) {
  std::vector<std::string> numbers;
  const auto add = [&](std::string name, const double* first, std::size_t count) {
    name += "=";
    for (std::size_t i = 0; i < count; ++i) name += (i > 0 ? " " : "") + number_text(first[i]);
    numbers.push_back(std::move(name));
  };
  for_each_member<fairway::Envelope>([&](const auto& m) {
    const auto& value = envelope.*(m.at);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
      add(m.name_with_unit(), &value, 1);
    } else {
      add(m.name_with_unit(), value.data(), value.size());
    }
  });
  return numbers;
}

TEST(EmbeddedAvoider, WhatTheVehicleCanDoIsGivenAsNumbers) {
  // every member is another number, so that none is taken for another
  fairway::Envelope envelope = encounters::of_a_boat();
  double next = 0.5;
  for_each_member<fairway::Envelope>([&](const auto& m) {
    auto& value = envelope.*(m.at);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
      value = (next -= 0.01);
    } else {
      for (double& v : value) v = (next -= 0.01);
    }
  });
  const Envelope given = envelope_of(numbers_of(envelope));
  static_assert(sizeof(Envelope) == sizeof(fairway::Envelope));
  OwnedSituation e = encounters::under_way(envelope);
  e.obstacles = {encounters::buoy(9.0, 0.2)};
  PlainSituation s{e};
  s.envelope = given;
  const fairway::Command expected = builtin_avoiders().make("direct+trackable").decide(e);
  EXPECT_TRUE(expected.turn_rate.has_value());
  EXPECT_TRUE(same(Avoider{"direct+trackable"}.decide(s.view()), expected));
  EXPECT_EQ(plain(envelope).ahead, given.ahead);
  EXPECT_EQ(plain(envelope).following_errors, given.following_errors);

  const auto refusal = [](const std::vector<std::string>& numbers) -> std::string {
    try {
      envelope_of(numbers);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal({"ahead"}), "setting \"ahead\": expected name=value");
  EXPECT_EQ(refusal({"ahed_mps=1"}).substr(0, 27), "ahed_mps: unknown number; d");
  EXPECT_EQ(refusal({"ahead_mps=-1"}), "ahead_mps: is \"-1\"; expected a number, 0 or more");

  s.envelope->ahead = std::numeric_limits<double>::quiet_NaN();
  const Command command = Avoider{"direct+trackable"}.decide(s.view());
  EXPECT_EQ(command.mode, Mode::infeasible);
  EXPECT_THAT(std::string(command.note), HasSubstr("envelope"));
}

std::string refusal(const std::string& algorithm, const std::vector<std::string>& settings) {
  try {
    const Avoider avoider{algorithm, settings};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(EmbeddedAvoider, IsMadeByNameAndSettings) {
  const PlainSituation s{encounters::head_on(8.0)};
  const Triple straight_on{1, 0, 0};  // contact is 3 s off
  EXPECT_EQ(Avoider("orca3d", {"time_horizon_s=2"}).decide(s.view()).velocity, straight_on);
  EXPECT_NE(Avoider("orca3d", {"time_horizon_s=20"}).decide(s.view()).velocity, straight_on);
  EXPECT_EQ(refusal("apf+saw", {"crit_dist_m=4", "speed_law=bang_bang"}), "accepted");
  EXPECT_THAT(algorithms(), testing::IsSupersetOf({"apf", "orca3d", "avoa", "inflate"}));
  EXPECT_THAT(algorithms(), testing::Not(testing::Contains("pledge")));
}

TEST(EmbeddedAvoider, SaysWhatItCannotBeMadeOfAndWhatWasProbablyMeant) {
  EXPECT_EQ(refusal("orca_3d", {}), "unknown algorithm \"orca_3d\"; did you mean orca3d?");
  EXPECT_THAT(refusal("pledge", {}), HasSubstr("pledge decides nothing without a link to the others"));
  EXPECT_EQ(refusal("orca3d", {"time_horizon=2"}),
            "time_horizon: unknown parameter of orca3d; did you mean time_horizon_s?");
  EXPECT_THAT(refusal("orca3d", {"time_horizon_s=soon"}), HasSubstr("\"soon\"; expected a number"));
  EXPECT_EQ(refusal("orca3d", {"time_horizon_s"}), "setting \"time_horizon_s\": expected name=value");
  EXPECT_EQ(refusal("orca3d", {"time_horizon_s=1", "time_horizon_s=2"}),
            "setting time_horizon_s: given twice");
}

}  // namespace
}  // namespace fairway::embed
