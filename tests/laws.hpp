// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/testing/encounters.hpp"

/// The laws that every avoider obeys, for the tests of any catalog: a program links the laws and one file
/// that says whom they are for. So a new algorithm is held to them by the line that lists it.
namespace fairway::laws {

using encounters::OwnedSituation;

/// Whoever the laws are for. Each program of tests has its own.
Catalog catalog();

/// Every entry of the catalog, and `combinations` such as "orca3d+stop_and_wait".
inline std::vector<std::string> everybody(const std::vector<std::string>& combinations) {
  std::vector<std::string> names;
  const Catalog all = catalog();
  for (const Catalog::Entry& entry : all.entries()) names.emplace_back(entry.info.name);
  names.insert(names.end(), combinations.begin(), combinations.end());
  return names;
}

/// A name that a test may have.
inline std::string test_name(const testing::TestParamInfo<std::string>& instance) {
  std::string name = instance.param;
  std::ranges::replace(name, '+', '_');
  return name;
}

/// One period later, for a point that does what it is told at once: along its heading where it is told to
/// turn, any way otherwise, bow first. The others keep their course.
inline void follow(OwnedSituation& e, Command command) {
  Ownship& own = e.situation.own;
  if (command.turn_rate) {
    const auto ahead = [&] { return Vec3{std::cos(own.yaw), std::sin(own.yaw), 0.0}; };
    const double surge = command.velocity.dot(ahead());
    own.yaw = wrap_angle(own.yaw + e.situation.period * *command.turn_rate);
    command.velocity = surge * ahead();
  } else if (command.heading) {
    own.yaw = *command.heading;
  } else if (horizontal_norm(command.velocity) > 0.0) {
    own.yaw = std::atan2(command.velocity.y(), command.velocity.x());
  }
  own.yaw_rate = command.turn_rate.value_or(0.0);
  carry_out(e, command);
}

/// One law for one avoider.
class Laws : public testing::TestWithParam<std::string> {
 protected:
  Avoider avoider(const ParamValues& params = {}) const { return catalog().make(GetParam(), params, Rng{7}); }

  /// Whether the algorithm itself, within all wrappers, has this property.
  bool has(bool AlgorithmInfo::*property) const {
    const Catalog all = catalog();
    return all.find(GetParam().substr(0, GetParam().find('+'))).info.*property;
  }

  /// Algorithms of the horizontal plane are shown scenes in it.
  OwnedSituation suited(OwnedSituation e) const {
    if (!has(&AlgorithmInfo::planar)) return e;
    const double depth = e.situation.own.position.z();
    e.situation.own.velocity.z() = 0.0;
    e.situation.goal.position.z() = depth;
    for (Track& t : e.tracks) {
      t.position.z() = depth;
      t.velocity.z() = 0.0;
    }
    for (Obstacle& o : e.obstacles) o.position.z() = o.from.z() = o.to.z() = depth;
    return e.sorted();
  }

  /// Calls `law(avoider, encounter)` in 600 scenes of 0 to 19 vehicles: with room to pass, without, and among
  /// obstacles, walls and what drifts. For those that plan, a thousand times as slow, in 24 of 0 to 7.
  template <class Law>
  void everywhere(Law law) const {
    const bool plans = has(&AlgorithmInfo::allocates);
    const std::uint64_t scenes = plans ? 24 : 600;
    for (std::uint64_t i = 0; i < scenes; ++i) {
      SCOPED_TRACE("scene " + std::to_string(i));
      const Rng rng = Rng{42}.stream("swarm", i);
      const int count = static_cast<int>(i / 3 % (plans ? 8 : 20));
      law(avoider(), suited(i % 3 == 0   ? encounters::crowd(count, rng)
                            : i % 3 == 1 ? encounters::congested(count, rng)
                                         : encounters::harbour(count, rng)));
    }
  }
};

}  // namespace fairway::laws
