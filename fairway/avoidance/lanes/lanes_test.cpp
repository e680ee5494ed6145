// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/orca3d/half_space.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/avoidance/trackable/fan.hpp"
#include "fairway/avoidance/velocity_program/velocity_program.hpp"
#include "fairway/core/angles.hpp"

namespace fairway::lanes {
namespace {

using encounters::OwnedSituation;

constexpr double tau = 5.0;

/// From room for all to none, with one or another who overlaps, is at the same place or has the same
/// velocity.
OwnedSituation drawn(std::uint64_t index) {
  Rng rng = Rng{1}.stream("lanes", index);
  const int count = static_cast<int>(rng.index(13));
  OwnedSituation e = index % 2 == 0 ? encounters::crowd(count, rng)
                                    : encounters::congested(count, rng.stream("congested", 0));
  for (Track& t : e.tracks) {
    const std::uint64_t oddity = rng.index(12);
    if (oddity == 0) t.position = e.situation.own.position;
    if (oddity <= 1) t.velocity = e.situation.own.velocity;
    if (oddity == 2) t.reacts = false;
  }
  return e;
}

double share_of(const Track& t) { return t.reacts ? 0.5 : 1.0; }

/// What one number at a time comes to.
struct Alone {
  std::vector<HalfSpace> half_spaces;
  VecOf<double> velocity;
  double violation;
};

Alone alone(const Situation& s) {
  Alone result;
  for (const Track& t : s.tracks) {
    const double north = number(t.id) % 2 == 0 ? 1.0 : -1.0;
    const orca::RelativeNeighbour neighbour{t.position - s.own.position, s.own.velocity - t.velocity,
                                            s.own.radius + t.radius, Vec3{north, 0.0, 0.0}};
    const orca::Change change = orca::least_change(neighbour, tau, s.period);
    result.half_spaces.push_back(orca::half_space(change, s.own.velocity, share_of(t)));
  }
  std::array<HalfSpace, 16> room;
  result.violation =
      nearest_velocity<double>(std::span<const HalfSpace>{result.half_spaces}, s.preferred_velocity(),
                               s.limits.max_speed, true, room.data(), result.velocity);
  return result;
}

void write(const Vec3& position, const Vec3& velocity, double radius, double last, std::size_t width,
           double* at) {
  const std::array<double, columns> numbers{position.x(), position.y(), position.z(), velocity.x(),
                                            velocity.y(), velocity.z(), radius,       last};
  for (std::size_t c = 0; c < columns; ++c) at[c * width] = numbers[c];
}

void write_neighbour(const Situation& s, std::size_t index, std::size_t width, double* at) {
  if (index >= s.tracks.size()) return write(Vec3::Zero(), Vec3::Zero(), -1.0, 0.0, width, at);
  const Track& t = s.tracks[index];
  write(t.position, t.velocity, t.radius, number(t.id) % 2 == 0 ? share_of(t) : -share_of(t), width, at);
}

/// The bits of a half-space or of a choice, given as four columns.
using Bits = std::array<std::uint64_t, 4>;
Bits bits_of(const VecOf<double>& v, double last) {
  return {std::bit_cast<std::uint64_t>(v.x()), std::bit_cast<std::uint64_t>(v.y()),
          std::bit_cast<std::uint64_t>(v.z()), std::bit_cast<std::uint64_t>(last)};
}
Bits bits_of(const double* answer, std::size_t width, std::size_t lane) {
  return bits_of({answer[lane], answer[width + lane], answer[2 * width + lane]}, answer[3 * width + lane]);
}

TEST(Lanes, NarrowKernelsComeFirst) {
  std::size_t last = 1;
  for (const Kernel* each : kernels()) {
    const Kernel& kernel = *each;
    EXPECT_GT(kernel.lanes, last);
    last = kernel.lanes;
    EXPECT_EQ(&kernel_for(kernel.lanes), &kernel);
  }
  EXPECT_EQ(&kernel_for(1000), kernels().back());
}

TEST(Lanes, EachNeighbourHasTheHalfSpaceThatItHasAlone) {
  for (const Kernel* each : kernels()) {
    const Kernel& kernel = *each;
    const std::size_t width = kernel.lanes;
    for (std::uint64_t i = 0; i < 4000; ++i) {
      const OwnedSituation e = drawn(i);
      const Situation s = e;
      const Alone expected = alone(s);
      std::array<double, columns> own;
      write(s.own.position, s.own.velocity, s.own.radius, 0.0, 1, own.data());
      alignas(64) std::array<double, columns * most_lanes> others;
      alignas(64) std::array<double, 4 * most_lanes> answer;
      for (std::size_t lane = 0; lane < width; ++lane) write_neighbour(s, lane, width, others.data() + lane);
      kernel.half_spaces(tau, s.period, own.data(), others.data(), answer.data());
      for (std::size_t lane = 0; lane < std::min(width, s.tracks.size()); ++lane) {
        const HalfSpace& h = expected.half_spaces[lane];
        EXPECT_EQ(bits_of(answer.data(), width, lane), bits_of(h.normal, h.offset))
            << kernel.name << ", scene " << i << ", lane " << lane;
      }
    }
  }
}

TEST(Lanes, EachVehicleDecidesAsItDoesAlone) {
  const auto crowd = std::make_unique<Crowd>();
  for (const Kernel* each : kernels()) {
    const Kernel& kernel = *each;
    const std::size_t width = kernel.lanes;
    int infeasible = 0;
    for (std::uint64_t i = 0; i < 4000; i += width) {
      std::vector<OwnedSituation> owned;
      std::vector<Alone> expected;
      crowd->time_horizon = tau;
      crowd->period = 0.1;
      crowd->neighbours = 0;
      for (std::size_t lane = 0; lane < width; ++lane) {
        owned.push_back(drawn(i + lane));
        const Situation s = owned.back();
        expected.push_back(alone(s));
        write(s.own.position, s.own.velocity, s.own.radius, s.limits.max_speed, width, crowd->own + lane);
        const Vec3 preferred = s.preferred_velocity();
        for (std::size_t c = 0; c < 3; ++c)
          crowd->preferred[c * width + lane] = preferred[static_cast<Eigen::Index>(c)];
        crowd->neighbours = std::max(crowd->neighbours, s.tracks.size());
      }
      for (std::size_t k = 0; k < crowd->neighbours; ++k)
        for (std::size_t lane = 0; lane < width; ++lane)
          write_neighbour(owned[lane], k, width, crowd->others + k * columns * width + lane);
      alignas(64) std::array<double, 4 * most_lanes> answer;
      kernel.decide(*crowd, answer.data());
      for (std::size_t lane = 0; lane < width; ++lane) {
        EXPECT_EQ(bits_of(answer.data(), width, lane),
                  bits_of(expected[lane].velocity, expected[lane].violation))
            << kernel.name << ", scene " << i + lane;
        infeasible += expected[lane].violation > 0.0 ? 1 : 0;
      }
    }
    EXPECT_GT(infeasible, 400) << kernel.name;
  }
}

TEST(Lanes, EachProgramComesToWhatItComesToAlone) {
  constexpr std::size_t stride = 16;
  constexpr double max_speed = 0.7;
  for (const Kernel* each : kernels()) {
    const std::size_t width = each->lanes;
    for (std::uint64_t i = 0; i < 4000; i += width) {
      std::vector<std::array<double, stride>> allowed(4 * 13), preferred(3);
      std::vector<Vec3> expected;
      for (std::size_t lane = 0; lane < width; ++lane) {
        const OwnedSituation e = drawn(i + lane);
        const Situation s = e;
        const std::vector<HalfSpace> half_spaces = alone(s).half_spaces;
        for (std::size_t k = 0; k < 13; ++k) {
          const HalfSpace h = k < half_spaces.size() ? half_spaces[k] : HalfSpace::everything();
          const std::array numbers{h.normal.x(), h.normal.y(), h.normal.z(), h.offset};
          for (std::size_t c = 0; c < 4; ++c) allowed[4 * k + c][lane] = numbers[c];
        }
        const Vec3 wanted = s.preferred_velocity();
        for (std::size_t c = 0; c < 3; ++c) preferred[c][lane] = wanted[static_cast<Eigen::Index>(c)];
        expected.push_back(fairway::nearest_velocity(half_spaces, wanted, max_speed).velocity);
      }
      alignas(64) std::array<double, 3 * most_lanes> answer;
      each->choose({13, stride, allowed[0].data(), preferred[0].data(), max_speed}, answer.data());
      for (std::size_t lane = 0; lane < width; ++lane)
        EXPECT_EQ(bits_of({answer[lane], answer[width + lane], answer[2 * width + lane]}, 0.0),
                  bits_of(expected[lane], 0.0))
            << each->name << ", scene " << i + lane;
    }
  }
}

/// Places on a coarse lattice, so that many are equally far, and their numbers.
std::array<std::vector<double>, 4> lattice(std::size_t count, Rng rng) {
  std::array<std::vector<double>, 4> columns;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < count; ++i) columns[c].push_back(static_cast<double>(rng.index(5)));
    columns[c].resize(count + most_lanes, 0.0);
  }
  for (std::size_t i = 0; i < count + most_lanes; ++i) columns[3].push_back(static_cast<double>(i));
  return columns;
}

TEST(Lanes, WhoIsWithinReachIsFoundAndPutInOrder) {
  for (const Kernel* each : kernels()) {
    const Kernel& kernel = *each;
    std::size_t all = 0;
    for (std::uint64_t scene = 0; scene < 500; ++scene) {
      Rng rng = Rng{2}.stream("reach", scene);
      const std::size_t count = 1 + rng.index(most_found), begin = rng.index(count);
      const auto columns = lattice(count, rng.stream("lattice", 0));
      const std::array<const double*, 4> at{columns[0].data(), columns[1].data(), columns[2].data(),
                                            columns[3].data()};
      const std::array<double, 3> place{2.0, 2.0, 1.0};
      const double reach2 = rng.uniform(0.0, 12.0);

      std::vector<std::pair<double, std::uint32_t>> expected;
      for (std::size_t i = begin; i < count; ++i) {
        const double n = at[0][i] - 2.0, e = at[1][i] - 2.0, d = at[2][i] - 1.0;
        const double distance2 = n * n + e * e + d * d;
        if (distance2 <= reach2) expected.emplace_back(distance2, static_cast<std::uint32_t>(i));
      }
      std::ranges::sort(expected);

      std::array<double, most_found + most_lanes> distances2, numbers;
      std::array<std::uint32_t, most_found> ordered;
      const Found found{distances2.data(), numbers.data()};
      const std::size_t half = begin + (count - begin) / 2;
      std::size_t within = kernel.within(at.data(), begin, half, place.data(), reach2, found, 0);
      within = kernel.within(at.data(), half, count, place.data(), reach2, found, within);
      ASSERT_EQ(within, expected.size()) << kernel.name << ", scene " << scene;
      kernel.order(found, within, ordered.data());
      for (std::size_t i = 0; i < within; ++i)
        EXPECT_EQ(ordered[i], expected[i].second) << kernel.name << ", scene " << scene;
      all += within;
    }
    EXPECT_GT(all, 2000U) << kernel.name;
  }
}

using trackable::Fan;

std::array<double, Fan::motion_columns> members(const trackable::Motion<double>& m) {
  return {m.north, m.east, m.ahead_north, m.ahead_east, m.turn_rate, m.speed, m.sway, m.error};
}

TEST(Lanes, PlansRolledOutSideBySideComeToTheBitsThatTheyComeToAlone) {
  int kept_clear = 0, touched = 0;
  for (std::uint64_t index = 0; index < 2000; ++index) {
    Rng rng = Rng{1}.stream("fans", index);
    const auto any = [&](double least, double most) { return rng.uniform(least, most); };
    trackable::Response response{.law = {.gain = any(0.3, 2.0),
                                         .turn_share = 0.9,
                                         .max_turn_rate = any(0.2, 1.0),
                                         .ahead = any(1.0, 3.0)},
                                 .step = any(0.1, 0.4),
                                 .turn_share = any(0.1, 1.0),
                                 .surge_share = any(0.1, 1.0),
                                 .most_turn = any(0.02, 0.2),
                                 .most_faster = any(0.05, 0.5),
                                 .most_slower = any(0.05, 0.5),
                                 .lost_slower = any(0.0, 0.2),
                                 .slip = {.by_turn = any(0.0, 1.0),
                                          .share = any(0.1, 1.0),
                                          .linear = any(0.0, 1.0),
                                          .square = index % 3 == 0 ? 0.0 : any(0.0, 8.0)},
                                 .drift_north = any(-0.2, 0.2),
                                 .drift_east = any(-0.2, 0.2)};
    for (double& rate : response.law.turn_rates) rate = any(0.2, 1.0);
    response.law.sure_turn_rate = index % 2 == 0 ? 0.17 : 0.0;
    if (index % 7 == 0) response.law.brakes_first_above = 0.3;

    std::array<trackable::Hazard, 3> hazards;
    std::array<double, 3> near2;
    for (std::size_t i = 0; i < hazards.size(); ++i) {
      hazards[i] = {.north = any(-8, 8), .east = any(-8, 8), .velocity_north = any(-1, 1), .contact = 2.0};
      near2[i] = any(0.0, 5.0);
    }
    hazards[2].along_north = 3.0;
    hazards[2].along_east = any(-3, 3);
    hazards[2].length2 = 9.0 + hazards[2].along_east * hazards[2].along_east;
    const std::array<std::size_t, 3> first_steps{0, 5, 0};

    Fan given;
    given.response = &response;
    given.hazards = hazards.data();
    given.near2 = near2.data();
    given.first_steps = first_steps.data();
    given.hazard_count = hazards.size();
    given.begin = index % 3 == 0 ? 4 : 0;
    given.steps = trackable::most_steps - index % 20;
    given.hold_steps = 6;
    given.asks_room = true;
    given.plans = std::array{Fan::Plans::courses, Fan::Plans::stop, Fan::Plans::circle}[index % 3];
    const auto start = [&] {
      const Vec2 ahead = unit_at(any(-pi, pi));
      return trackable::Motion<double>{any(-1, 1),     any(-1, 1),    ahead.x(),      ahead.y(),
                                       any(-0.5, 0.5), any(0.0, 2.0), any(-0.1, 0.1), any(-pi, pi)};
    };
    const trackable::Motion<double> now = start();
    const Vec2 direction = unit_at(any(-pi, pi)), standing = unit_at(any(-pi, pi));
    std::array<double, 2 * most_lanes> cosines, sines;
    trackable::Courses courses{.north = direction.x(),
                               .east = direction.y(),
                               .side = index % 2 == 0 ? 1.0 : -1.0,
                               .cosines = cosines.data(),
                               .sines = sines.data(),
                               .speeds = {}};
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      const Vec2 turn = unit_at(any(-pi, pi));
      cosines[i] = turn.x();
      sines[i] = turn.y();
      courses.speeds[i] = std::max(0.0, any(-0.5, 2.0));
    }
    given.courses = &courses;
    given.now = &now;
    given.first = most_lanes;
    if (index % 2 == 0) {
      response.standing_north = standing.x();
      response.standing_east = standing.y();
    }
    std::array<trackable::Motion<double>, most_lanes> starts;
    for (std::size_t lane = 0; lane < most_lanes; ++lane) {
      starts[lane] = start();
      for (std::size_t c = 0; c < Fan::motion_columns; ++c) given.motion[c][lane] = members(starts[lane])[c];
      given.side[lane] = lane % 2 == 0 ? 1.0 : -1.0;
    }

    for (const Kernel* kernel : kernels()) {
      Fan fan = given;
      kernel->roll(fan);
      for (std::size_t lane = 0; lane < kernel->lanes; ++lane) {
        trackable::Motion<double> m = starts[lane];
        trackable::Heading<double> heading{m.ahead_north, m.ahead_east};
        double speed = 0.0;
        if (fan.plans == Fan::Plans::courses) {
          const double cosine = cosines[fan.first + lane], sine = courses.side * sines[fan.first + lane];
          m = now;
          speed = courses.speeds[fan.first + lane];
          heading = trackable::heading_for(response, cosine * direction.x() - sine * direction.y(),
                                           sine * direction.x() + cosine * direction.y(), speed);
          m.error = heading.error(m);
        } else if (fan.plans == Fan::Plans::stop) {
          if (index % 2 == 0) heading = {standing.x(), standing.y()};
          m.error = index % 2 == 0 ? heading.error(m) : 0.0;
        }
        const double circle = fan.side[lane] * trackable::greatest_turn_rate(response.law, m.speed);
        trackable::Motion<double> held = m;
        std::array<double, 3> least2;
        least2.fill(std::numeric_limits<double>::infinity());
        std::size_t k = fan.begin;
        for (; k < fan.steps; ++k) {
          if (k == fan.hold_steps) held = m;
          if (fan.plans == Fan::Plans::circle)
            trackable::advance(response, m.speed, circle, m);
          else
            trackable::follow(response, heading, speed, m);
          bool is_near = false;
          for (std::size_t i = 0; i < hazards.size(); ++i) {
            if (k < first_steps[i]) continue;
            const double time = static_cast<double>(k + 1) * response.step;
            const double d2 = trackable::distance2(hazards[i], time, m.north, m.east);
            least2[i] = std::min(least2[i], d2);
            is_near = is_near || d2 < near2[i];
          }
          if (is_near) break;
        }
        EXPECT_EQ(fan.clear_steps[lane], static_cast<double>(k)) << kernel->name << ' ' << index;
        if (k > fan.hold_steps) {
          for (std::size_t c = 0; c < Fan::motion_columns; ++c)
            EXPECT_EQ(std::bit_cast<std::uint64_t>(fan.held[c][lane]),
                      std::bit_cast<std::uint64_t>(members(held)[c]))
                << kernel->name << ' ' << index << ' ' << c;
        }
        ++(k == fan.steps ? kept_clear : touched);
        if (k < fan.steps) continue;
        double room = std::numeric_limits<double>::infinity(), last_room = room;
        for (std::size_t i = 0; i < hazards.size(); ++i) {
          const double end = static_cast<double>(k) * response.step;
          const double last2 = trackable::distance2(hazards[i], end, m.north, m.east);
          room = std::min(room, std::sqrt(least2[i]) - 2.0);
          last_room = std::min(last_room, std::sqrt(last2) - 2.0);
        }
        EXPECT_EQ(fan.room[lane], room) << kernel->name << ' ' << index;
        EXPECT_EQ(fan.last_room[lane], last_room) << kernel->name << ' ' << index;
      }
    }
  }
  EXPECT_GT(kept_clear, 500);
  EXPECT_GT(touched, 500);
}

}  // namespace
}  // namespace fairway::lanes
