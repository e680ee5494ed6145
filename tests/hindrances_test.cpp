// SPDX-License-Identifier: Apache-2.0
// Whoever is in the catalog avoids what is in its way, or says that it does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "fairway/avoidance/apf/apf.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "tests/laws.hpp"

namespace fairway::laws {
namespace {

/// Something on the straight way from the origin to a goal 40 m north.
struct Hindrance {
  const char* name;
  bool AlgorithmInfo::*ignored;  ///< what declares that it is none of a method's business
  void (*put)(OwnedSituation&);
};

Vec3 at(double n, double e) { return {n, e, 50.0}; }

const std::vector<Hindrance> hindrances{
    {"a rock", &AlgorithmInfo::ignores_obstacles,
     [](OwnedSituation& e) {
       e.obstacles = {{.kind = Obstacle::Kind::sphere, .position = at(15, 0.4), .radius = 3.0}};
     }},
    {"a wall", &AlgorithmInfo::ignores_obstacles,
     [](OwnedSituation& e) {
       e.obstacles = {{.kind = Obstacle::Kind::segment, .from = at(12, -5), .to = at(12, 4)}};
     }},
    {"a pier", &AlgorithmInfo::ignores_obstacles,
     [](OwnedSituation& e) {
       e.add_polygon({at(12, -3), at(16, -3), at(16, 4), at(12, 4)});
     }},
    {"something slow on the same course", &AlgorithmInfo::ignores_movers,
     [](OwnedSituation& e) {
       e.tracks = {encounters::track(1, at(10, 0.4), {0.05, 0, 0})};
       e.tracks[0].reacts = false;
       e.tracks[0].priority = -1;  // whoever waits for anybody waits for it
     }},
};

/// Own sphere has 1 m, of which a method that weighs costs may give up a little [m].
constexpr double least_clearance = 0.9;

/// Defaults, except where the published ones do not keep clear of anything, which is on the method's page:
/// with W2 = 0.5 < W1 potential fields only slow down for what is ahead.
ParamValues params_of(const std::string& name) {
  return name.starts_with("apf") ? ParamValues{{"w2_ratio", 2.5}} : ParamValues{};
}

/// Between own centre and the surface of whatever is there [m].
double clearance(const OwnedSituation& e) {
  const Vec3& here = e.situation.own.position;
  double least = std::numeric_limits<double>::infinity();
  for (const Obstacle& o : e.obstacles) least = std::fmin(least, nearest_point(o, here).distance);
  for (const Track& t : e.tracks) least = std::fmin(least, (t.position - here).norm() - t.radius);
  return least;
}

/// What a way past a hindrance came to.
struct Way {
  bool reacted{};      ///< it was ever commanded otherwise than it would have been in open water
  double clearance{};  ///< the least [m]
};

/// A minute and a half with `avoider` of a point that does what it is told.
Way way_past(const Hindrance& hindrance, Avoider avoider) {
  OwnedSituation e = encounters::open_water();
  e.situation.period = 0.25;
  e.situation.goal.position = at(40, 0);
  e.situation.own.velocity = Vec3::Zero();
  e.situation.limits.max_acceleration = 0.5;
  e.situation.limits.max_turn_rate = 0.5;
  hindrance.put(e);

  Avoider unhindered = avoider;
  Way way{.clearance = clearance(e)};
  for (int step = 0; step < 360; ++step) {
    OwnedSituation open = e;
    open.tracks.clear();
    open.obstacles.clear();
    const Command command = avoider.decide(e);
    way.reacted = way.reacted || !(command == unhindered.decide(open));
    follow(e, command);
    way.clearance = std::fmin(way.clearance, clearance(e));
  }
  return way;
}

/// What of the hindrances is neither avoided nor declared to be ignored, or ignored in name alone.
std::vector<std::string> breaches(const Catalog& catalog, const std::string& name,
                                  const ParamValues& params) {
  std::vector<std::string> found;
  for (const Hindrance& hindrance : hindrances) {
    const Way way = way_past(hindrance, catalog.make(name, params, Rng{7}));
    const bool declared = catalog.ignores(name, hindrance.ignored);
    if (declared && way.reacted)
      found.push_back(std::string(hindrance.name) + ": reacts, and says it does not");
    const bool speaks = catalog.needs(name, &AlgorithmInfo::needs_link);  // and goes nowhere alone
    if (!declared && !way.reacted && !speaks)
      found.push_back(std::string(hindrance.name) + ": ignored, without saying so");
    if (!declared && way.clearance < least_clearance) {
      found.push_back(std::string(hindrance.name) + ": not avoided, clear by " +
                      std::to_string(way.clearance));
    }
  }
  return found;
}

TEST_P(Laws, WhatIsInTheWayIsAvoidedOrSaidToBeIgnored) {
  EXPECT_THAT(breaches(catalog(), GetParam(), params_of(GetParam())), testing::IsEmpty());
}

/// Direct, which avoids nobody, and says nothing of it.
struct Careless : Direct {
  static constexpr AlgorithmInfo info{.name = "careless", .title = "", .source = ""};
};

/// Potential fields that claim to see nothing.
struct Modest : Apf {
  static constexpr AlgorithmInfo info{
      .name = "modest", .title = "", .source = "", .ignores_obstacles = true, .ignores_movers = true};
};

TEST(Hindrances, WhoIgnoresThemWithoutSayingSoIsFound) {
  const std::vector<std::string> found = breaches(Catalog{}.add<Careless>(), "careless", {});
  for (const Hindrance& hindrance : hindrances) {
    EXPECT_THAT(found, testing::Contains(std::string(hindrance.name) + ": ignored, without saying so"));
  }
}

TEST(Hindrances, WhoAvoidsThemAndSaysOtherwiseIsFound) {
  const std::vector<std::string> found = breaches(Catalog{}.add<Modest>(), "modest", {});
  for (const Hindrance& hindrance : hindrances) {
    EXPECT_THAT(found, testing::Contains(std::string(hindrance.name) + ": reacts, and says it does not"));
  }
}

}  // namespace
}  // namespace fairway::laws
