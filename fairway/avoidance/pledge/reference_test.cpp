// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fairway/avoidance/pledge/clearance.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::pledge {
namespace {

Member drawn_member(Rng& rng) {
  const auto place = [&] { return Vec3{rng.uniform(-15, 15), rng.uniform(-15, 15), rng.uniform(0, 20)}; };
  return {.anchor = place(),
          .destination = place(),
          .arrival = 2.0,
          .radius = 1.0,
          .speed = 0.5,
          .climb = 0.2,
          .descent = 0.3,
          .turn = 4.0};
}

Plan drawn_plan(Rng& rng) {
  Plan plan{.epoch = {.tenths = 100},
            .centre = {rng.uniform(-3, 3), rng.uniform(-3, 3)},
            .to_port = rng.uniform(0, 1) < 0.5};
  for (Code& code : plan.codes) code = Code::of(static_cast<std::uint8_t>(rng.uniform(0, 256)));
  return plan;
}

TEST(Reference, BeginsAtTheAnchorEndsNearTheDestinationAndKeepsItsSpeeds) {
  Rng rng = Rng{1}.stream("reference");
  for (int i = 0; i < 500; ++i) {
    const Member member = drawn_member(rng);
    const Plan plan = drawn_plan(rng);
    const Reference way = reference_of(member, plan, plan.codes[0]);
    ASSERT_LT(way.knots().size(), Reference::most_knots);
    EXPECT_EQ(way.at(plan.start() + delay_of(member, plan.codes[0])), member.anchor);
    EXPECT_LE((way.at(1e6) - member.destination).norm(), member.arrival - 0.79);
    for (int k = 0; 0.37 * k < way.end(); ++k) {
      const double time = 0.37 * k;
      const Vec3 v = way.velocity(time);
      EXPECT_LE(horizontal_norm(v), member.speed * (1.0 + 1e-9));
      EXPECT_LE(v.z(), member.descent + 1e-9);
      EXPECT_GE(v.z(), -member.climb - 1e-9);
      EXPECT_LE((way.at(time + 0.1) - way.at(time)).norm(), 0.1 * 0.6) << "it never jumps";
    }
  }
}

TEST(Reference, WhoHasTurnedBeforeGoesAlongAndUpOrDownAtOnce) {
  Rng rng = Rng{6}.stream("reference");
  for (int i = 0; i < 100; ++i) {
    Member member = drawn_member(rng);
    member.destination = member.anchor + Vec3{12.0, 3.0, 6.0};
    const Plan plan = drawn_plan(rng);
    const Code straight{.ring = 0, .delay = 1, .dive = 0};
    const double turning = reference_of(member, plan, straight).end();
    member.turns_before = true;
    const Reference way = reference_of(member, plan, straight);
    const double leaves = plan.start() + delay_of(member, straight) + set_off;
    EXPECT_EQ(way.at(leaves), member.anchor);
    const Vec3 gone = way.at(leaves + 0.5) - member.anchor;
    EXPECT_GT(horizontal_norm(gone), 0.0);
    EXPECT_GT(gone.z(), 0.0);
    EXPECT_LT(way.end(), turning + set_off + 1e-9) << "it loses no more than it waits";
  }
}

// Levels are for those whose way is level; the sum of both speeds is within what they go.
TEST(Reference, GoesBelowTheOthersAndUpAgainWithinItsSpeed) {
  Rng rng = Rng{4}.stream("reference");
  for (int i = 0; i < 500; ++i) {
    Member member = drawn_member(rng);
    member.destination.z() = member.anchor.z() + rng.uniform(-0.9, 0.9);
    ASSERT_TRUE(has_levels(member));
    const Plan plan = drawn_plan(rng);
    Code code = plan.codes[0];
    for (code.dive = 1; code.dive <= most_levels; ++code.dive) {
      const Reference way = reference_of(member, plan, code);
      ASSERT_LT(way.knots().size(), Reference::most_knots);
      EXPECT_EQ(way.at(plan.start() + delay_of(member, code)), member.anchor);
      EXPECT_LE((way.at(1e6) - member.destination).norm(), member.arrival - 0.79);
      double deepest = 0.0;
      for (const Knot& knot : way.knots()) deepest = std::max(deepest, knot.position.z());
      const double level =
          std::max(member.anchor.z(), member.destination.z()) + code.dive * level_step(member);
      EXPECT_NEAR(deepest, level, 1e-9);
      const auto is_deepest = [&](const Knot& knot) { return knot.position.z() > level - 1e-9; };
      const auto first = std::ranges::find_if(way.knots(), is_deepest);
      const auto rest = std::ranges::subrange{first, way.knots().end()};
      const auto leaves = std::ranges::find_if_not(rest, is_deepest);
      EXPECT_GE(std::prev(leaves)->time - first->time, 8.0 - 1e-9) << "its heave has time to change its sign";
      for (int k = 0; 0.37 * k < way.end(); ++k) {
        const Vec3 v = way.velocity(0.37 * k);
        EXPECT_LE(v.norm(), member.speed * (1.0 + 1e-9));
        EXPECT_LE(v.z(), member.descent + 1e-9);
        EXPECT_GE(v.z(), -member.climb - 1e-9);
      }
    }
    code.dive = 0;
    for (const Knot& knot : reference_of(member, plan, code).knots())
      EXPECT_LT(std::fabs(knot.position.z() - member.anchor.z()), level_within);
    member.descent = level_keeping;
    EXPECT_FALSE(has_levels(member));
    EXPECT_FALSE(has_levels(as_told(member, Vec2::Zero()))) << "as others hear it too";
  }
}

TEST(Reference, OnTheSpotItDivesWhereItIsHeldAndClimbsWhereItEnds) {
  Rng rng = Rng{5}.stream("reference");
  int on_the_spot = 0;
  for (int i = 0; i < 500; ++i) {
    Member member = drawn_member(rng);
    member.destination.z() = member.anchor.z() + rng.uniform(-0.9, 0.9);
    member.arrival = 0.8;
    const Plan plan = drawn_plan(rng);
    const Code code = plan.codes[0];
    const Reference way = reference_of(member, plan, code);
    const double level =
        std::max(member.anchor.z(), member.destination.z()) + code.dive * level_step(member) - 1e-9;
    double astray = 0.0;  // of those above the level
    for (int k = 0; 0.37 * k < way.end(); ++k) {
      const Vec3 place = way.at(0.37 * k);
      const double off =
          std::min(horizontal_norm(place - member.anchor), horizontal_norm(place - member.destination));
      if (place.z() < level) astray = std::max(astray, off);
    }
    if (is_on_the_spot(member, code)) {
      ++on_the_spot;
      EXPECT_LT(astray, 1e-6);
      EXPECT_LE(way.at(plan.start() + delay_step * (code.delay - 1) + 1.0).z(),
                member.anchor.z() + member.descent + 1e-9);
      EXPECT_GT(way.at(plan.start() + delay_step * (code.delay - 1) + 1.0).z(), member.anchor.z())
          << "it does not wait for its bit";
    } else if (is_below(member, code)) {
      EXPECT_GT(astray, 1.0);
      EXPECT_EQ(delay_of(member, code), delay_step * code.delay);
    }
    member.destination.z() = member.anchor.z() + 5.0;
    EXPECT_FALSE(is_on_the_spot(member, code)) << "of a way that is not level all bits are a delay";
    EXPECT_EQ(delay_of(member, code), delay_step * code.delay);
  }
  EXPECT_GT(on_the_spot, 100);
}

TEST(Reference, LeastDistancesAndFirstTimesAreThoseOfManySamples) {
  Rng rng = Rng{2}.stream("reference");
  for (int i = 0; i < 200; ++i) {
    const Plan plan = drawn_plan(rng);
    const Member one = drawn_member(rng), two = drawn_member(rng);
    const Reference a = reference_of(one, plan, plan.codes[0]), b = reference_of(two, plan, plan.codes[1]);
    double sampled = never, first = never;
    constexpr double step = 0.01;
    const double begins = a.knots().front().time;
    const auto samples = static_cast<int>((std::max(a.end(), b.end()) + 1.0 - begins) / step);
    for (int k = 0; k < samples; ++k) {
      const double time = begins + step * k;
      sampled = std::min(sampled, (a.at(time) - b.at(time)).norm());
      if (first == never && (a.at(time) - two.anchor).norm() <= 4.0) first = time;
    }
    const double least = least_distance(a, b, begins);
    EXPECT_LE(least, sampled + 1e-9);
    EXPECT_GE(least, sampled - 0.6 * 2.0 * step);
    const double exact = first_within(a, two.anchor, 4.0);
    if (first == never) {
      EXPECT_TRUE(exact == never || std::fabs((a.at(exact) - two.anchor).norm() - 4.0) < 0.01);
    } else {
      EXPECT_LE(exact, first + 1e-9);
      EXPECT_GE(exact, std::min(first - 2.0 * step, a.knots().front().time));
    }
  }
}

TEST(Clearance, WhatItAcceptsStaysClearWhoeverDepartsAndWhereverSomebodyStops) {
  // every pattern of who departs and, of those who do not, of who waits at a gate for whom
  Rng rng = Rng{3}.stream("clearance");
  int placed = 0;
  for (int i = 0; i < 4000; ++i) {
    constexpr std::size_t count = 4;
    std::array<Member, most_members> members;
    for (std::size_t m = 0; m < count; ++m) members[m] = drawn_member(rng);
    const Plan plan = drawn_plan(rng);
    const Tubes tubes{.radius = 0.5, .told = 0.1};
    Clearance scene{members, 0b1111, tubes, plan.start()};
    for (std::size_t m = 0; m < count; ++m) {
      const Reference way = reference_of(members[m], plan, plan.codes[m]);
      if (scene.accepts(m, way)) scene.place(m, way);
    }
    if (scene.placed().count() < count) continue;
    ++placed;
    for (unsigned departs = 0; departs < 16; ++departs) {
      std::array<Reference, count> truth;
      for (std::size_t m = 0; m < count; ++m) {
        double stop = never;
        for (std::size_t other = 0; other < count; ++other)
          if (((departs >> other) & 1U) == 0) stop = std::min(stop, scene.gate(m, other));
        truth[m] = ((departs >> m) & 1U) == 0 ? Reference{members[m].anchor}
                   : stop < never             ? scene.reference(m).until(stop)
                                              : scene.reference(m);
      }
      for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < a; ++b)
          ASSERT_GE(least_distance(truth[a], truth[b], plan.start()),
                    std::min(2.0 + 2.0 * tubes.radius, (members[a].anchor - members[b].anchor).norm() - 0.01))
              << i << " " << departs << " " << a << " " << b;
    }
  }
  EXPECT_GT(placed, 20);
}

TEST(Clearance, WhoHindersAMemberDoesSoAloneAndWhetherAnybodyDoesIsTheSameWhoeverIsAskedFirst) {
  Rng rng = Rng{4}.stream("clearance");
  int hindered = 0, free = 0;
  for (int i = 0; i < 300; ++i) {
    std::array<Member, most_members> members;
    for (Member& member : members) member = drawn_member(rng);
    const Plan plan = drawn_plan(rng);
    const Tubes tubes{.radius = 0.5, .told = 0.1};
    Clearance scene{members, Members{}.set(), tubes, plan.start()};
    for (std::size_t m = 0; m < most_members; ++m) {
      const Reference way = reference_of(members[m], plan, plan.codes[m]);
      for (std::size_t suspected = 0; suspected < most_members; ++suspected) {
        const auto hindrance = scene.hindered_by(m, way, suspected);
        ASSERT_EQ(hindrance.has_value(), !scene.accepts(m, way)) << i << " " << m << " " << suspected;
        if (!hindrance || *hindrance == m) continue;
        Clearance alone{members, Members{}.set(), tubes, plan.start()};
        alone.place(*hindrance, scene.reference(*hindrance));
        ASSERT_EQ(alone.hindered_by(m, way), hindrance) << i << " " << m << " " << suspected;
      }
      (scene.accepts(m, way) ? free : hindered) += 1;
      if (scene.accepts(m, way)) scene.place(m, way);
    }
  }
  EXPECT_GT(hindered, 100);
  EXPECT_GT(free, 100);
}

}  // namespace
}  // namespace fairway::pledge
