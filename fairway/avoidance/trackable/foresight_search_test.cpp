// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "fairway/avoidance/testing/boat.hpp"
#include "fairway/avoidance/trackable/testing/plans.hpp"

namespace fairway::trackable {
namespace {

using encounters::of_a_boat;
using encounters::of_a_torpedo;
using encounters::OwnedSituation;

/// How near a plan comes, by its path alone.
struct Alone {
  bool keeps_margin = true;      ///< between steps too, where it is not lost already
  bool keeps_a_bit_more = true;  ///< by 0.15 m
  std::size_t clear_steps = 0;
  double room = std::numeric_limits<double>::infinity();
  double last_room = std::numeric_limits<double>::infinity();
};

Alone alone(const Foresight& foresight, const Situation& s, double margin, const Plan& plan) {
  constexpr int parts = 16;
  Alone found;
  const Foresight::Path path = foresight.path(plan);
  for (const Track& t : s.tracks) {
    const Vec2 from = (t.position - s.own.position).head<2>();
    const double contact = t.radius + s.own.radius, gap = from.norm() - contact;
    const double left = gap > 0.0 ? 0.9 * gap : gap;
    Vec2 before = Vec2::Zero();
    for (std::size_t k = 0; k < path.count; ++k) {
      for (int part = 1; part <= parts; ++part) {
        const double share = static_cast<double>(part) / parts;
        const double time = (static_cast<double>(k) + share) * foresight.step();
        const Vec2 at = before + share * (path.points[k] - before);
        const double room = (at - time * t.velocity.head<2>() - from).norm() - contact;
        if (part == parts || left > margin + 0.15)
          found.keeps_margin = found.keeps_margin && room >= std::min(margin, left) - 2e-9;
        found.keeps_a_bit_more = found.keeps_a_bit_more && room >= std::min(margin + 0.15, left);
        if (part == parts) found.room = std::min(found.room, room);
        if (part == parts && k + 1 == path.count) found.last_room = std::min(found.last_room, room);
      }
      before = path.points[k];
    }
  }
  return found;
}

TEST(ForesightSearch, OfManyPlansSideBySideTheOneIsTakenThatOneAtATimeIsFound) {
  constexpr double margin = 0.3;
  const Envelope boat = of_a_boat(), torpedo = of_a_torpedo();
  int clear = 0, backed_up = 0, lost = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Rng rng = Rng{3}.stream("plans", i);
    OwnedSituation e = i % 2 == 0 ? encounters::crowd(12, rng) : encounters::congested(7, rng);
    const Envelope& envelope = i % 3 == 0 ? torpedo : boat;
    for (Track& t : e.tracks) t.position.z() = e.situation.own.position.z();
    e.situation.envelope = &envelope;
    const Situation s = e.sorted();
    const TurnLaw law{envelope, Limits::none};
    const Foresight foresight = foresight_of(law, s, {.hold = 1.0, .window = 8.0, .margin = margin});

    std::vector<Plan> plans(i % 4 < 2 ? 1 + rng.index(3) : 70);
    double quickest = 0.0;
    for (Plan& plan : plans) {
      plan = {.direction = unit_at(rng.uniform(-pi, pi)), .speed = rng.uniform(0.0, 1.5)};
      quickest = std::max(quickest, plan.speed);
    }
    std::size_t first_clear = plans.size();
    std::vector<Alone> all;
    for (std::size_t k = 0; k < plans.size(); ++k) {
      const Alone found = alone(foresight, s, margin, plans[k]);
      const bool is_clear = foresight.is_clear(plans[k], quickest);
      EXPECT_LE(is_clear, found.keeps_margin) << i << ' ' << k;
      EXPECT_GE(is_clear, found.keeps_a_bit_more) << i << ' ' << k;
      if (is_clear) first_clear = std::min(first_clear, k);
      all.push_back(found);
      all.back().clear_steps = foresight.clear_steps(plans[k], quickest);
    }
    const auto [at, prospect] = foresight.best_of(plans[0], Columns{plans}.courses, plans.size());
    EXPECT_EQ(prospect == Prospect::clear, first_clear < plans.size()) << i;
    if (prospect == Prospect::clear) {
      EXPECT_EQ(at, first_clear) << i;
    } else if (prospect == Prospect::backed_up) {
      for (std::size_t k = 0; k < at; ++k)
        EXPECT_EQ(foresight.best_of(plans[k], Columns{{plans[k]}}.courses, 1).prospect, Prospect::lost);
    } else {
      // it leaves nearly as much room as any, and of those most at the end; of a torpedo as much as any that
      // is clear for as long
      const bool stops = envelope.least == 0.0;
      const std::size_t longest = stops ? 0 : std::ranges::max(all, {}, &Alone::clear_steps).clear_steps;
      std::erase_if(all, [&](const Alone& other) { return other.clear_steps < longest; });
      EXPECT_GE(foresight.clear_steps(plans[at], quickest), longest) << i;
      const Alone taken = alone(foresight, s, margin, plans[at]);
      const double most = std::ranges::max(all, {}, &Alone::room).room;
      const double enough = most > 0.0 && stops ? 0.75 * most : most;
      EXPECT_GE(taken.room, enough - 1e-9) << i;
      for (const Alone& other : all)
        if (other.room > enough + 1e-9) EXPECT_LE(other.last_room, taken.last_room + 1e-9) << i;
    }
    ++(prospect == Prospect::clear ? clear : prospect == Prospect::backed_up ? backed_up : lost);
  }
  EXPECT_GT(clear, 50);
  EXPECT_GT(backed_up, 2);
  EXPECT_GT(lost, 50);
}

TEST(ForesightSearch, WhoIsSetAsideNeedsABackupButForWhatGoesAlong) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = encounters::under_way(boat);
  e.situation.own.position = {0.0, 0.0, 50.0};
  const TurnLaw law{boat, Limits::none};
  const std::vector<Plan> on_or_off{{.speed = 1.0}, {.direction = unit_at(-pi / 4), .speed = 1.0}};
  const Plan turns_away{.speed = 1.0, .turn_rate = -0.13};
  const auto taken = [&](bool is_set_aside) {
    const Situation s = e;
    const Foresight foresight = foresight_of(
        law, s,
        {.hold = 1.0, .window = 10.0, .margin = 0.3, .drift = {0.0, 0.2}, .is_set_aside = is_set_aside});
    EXPECT_EQ(foresight.is_clear(on_or_off[0], 1.0), true);
    EXPECT_EQ(foresight.is_safe(on_or_off[0]), !is_set_aside || !e.tracks.empty());
    const auto pick_for = [&](const Plan& asked) {
      return foresight.best_of(asked, Columns{on_or_off}.courses, on_or_off.size()).at;
    };
    const std::size_t at = pick_for(on_or_off[0]);
    EXPECT_EQ(pick_for(turns_away), at == 0 ? on_or_off.size() : at);  // a turn rate needs one, too
    return at;
  };
  // it can go on past the buoy, but not stop there: what sets it aside would set it on that
  e.obstacles = {encounters::buoy(2.25, 1.95)};
  EXPECT_EQ(taken(false), 0u);
  EXPECT_EQ(taken(true), 1u);
  // nor can it stop before a boat that comes up astern, which goes along
  e.obstacles.clear();
  e.tracks = {encounters::track(1, {-3.0, 0.0, 50.0}, {0.9, 0.0, 0.0}, 0.5)};
  EXPECT_EQ(taken(true), 0u);
}

TEST(ForesightSearch, WhoIsAskedToGoAsternLooksAstern) {
  const Envelope boat = of_a_boat();
  OwnedSituation e = encounters::under_way(boat);
  e.situation.own.velocity = Vec3::Zero();
  e.obstacles = {encounters::buoy(-4.0, 0.0)};
  const TurnLaw law{boat, Limits::none};
  const Situation s = e;
  const Foresight foresight = foresight_of(law, s, {.hold = 1.0, .window = 10.0, .margin = 0.3});
  const Plan astern{.speed = -1.0, .turn_rate = 0.0};
  const std::vector<Plan> ahead{{.speed = 1.0}};
  EXPECT_FALSE(foresight.is_safe(astern));
  EXPECT_EQ(foresight.best_of(astern, Columns{ahead}.courses, ahead.size()).at, 0u);
}

}  // namespace
}  // namespace fairway::trackable
