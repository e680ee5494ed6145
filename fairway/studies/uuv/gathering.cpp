// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/gathering.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "fairway/core/math.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::uuv {
namespace {

constexpr double cruise_speed = 1.0;       // [m/s]
constexpr double patience_ratio = 4.0;     // of the straight way's time
constexpr double apart = 5 * kept_radius;  // in a crowd [m]

constexpr Agility agility{
    .speed_mps = 1.2, .acceleration_mps2 = 0.5, .turn_acceleration_radps2 = 5.0, .time_constant_s = 0.2};

constexpr std::array all_gatherings{
    Gathering{Pattern::swap, 2},    Gathering{Pattern::swap, 4},     Gathering{Pattern::swap, 8},
    Gathering{Pattern::swap, 16},   Gathering{Pattern::swap, 32},    Gathering{Pattern::swap, 50},
    Gathering{Pattern::streams, 8}, Gathering{Pattern::streams, 16}, Gathering{Pattern::streams, 32},
    Gathering{Pattern::crowd, 8},   Gathering{Pattern::crowd, 16},   Gathering{Pattern::crowd, 32},
};

constexpr std::array all_awarenesses{
    Awareness{"perfect+perfect", "perfect", "perfect"},
    Awareness{"perfect+acoustic", "perfect", "acoustic"},
    Awareness{"sonar+none", "sonar", "none"},
    Awareness{"sonar+acoustic", "sonar", "acoustic"},
    Awareness{"unicycles", "perfect", "perfect", Hull::unicycle},
};

Vec3 near_place(double n, double e, double reach, Rng& rng) {
  const double off_n = rng.uniform(-reach, reach);
  return {n + off_n, e + rng.uniform(-reach, reach), 0.0};
}

std::vector<Voyage> swaps(std::size_t count, Rng rng) {
  const auto n = static_cast<double>(count);
  const double radius = math::fmax(20.0, 4.0 * kept_radius * n / (2.0 * pi));
  std::vector<Voyage> voyages;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * pi * static_cast<double>(i) / n;
    const Vec3 start = near_place(radius * math::cos(angle), radius * math::sin(angle), 0.25, rng);
    voyages.push_back({start, -start});
  }
  return voyages;
}

/// The first half goes north, the other east.
std::vector<Voyage> crossing(std::size_t count, Rng rng) {
  const std::size_t rows = count / 4;
  std::vector<Voyage> voyages;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = i % (count / 2) / 2;
    const double abeam = i % 2 == 0 ? -3.0 : 3.0;
    const double behind = 20.0 + 5.0 * static_cast<double>(row);
    const double beyond = 20.0 + 5.0 * static_cast<double>(rows - 1 - row);
    const bool north = i < count / 2;
    const Vec3 start = north ? near_place(-behind, abeam, 0.5, rng) : near_place(abeam, -behind, 0.5, rng);
    const Vec3 goal = north ? Vec3{beyond, start.y(), 0.0} : Vec3{start.x(), beyond, 0.0};
    voyages.push_back({start, goal});
  }
  return voyages;
}

double nearest_of(const Vec3& place, const std::vector<Voyage>& voyages, Vec3 Voyage::*end) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Voyage& voyage : voyages) nearest = math::fmin(nearest, (voyage.*end - place).norm());
  return nearest;
}

std::vector<Voyage> crowding(std::size_t count, Rng rng) {
  const double half_side = 5.0 * std::sqrt(static_cast<double>(count));
  std::vector<Voyage> voyages;
  while (voyages.size() < count) {
    const Voyage drawn{near_place(0.0, 0.0, half_side, rng), near_place(0.0, 0.0, half_side, rng)};
    const bool fits = (drawn.goal - drawn.start).norm() >= half_side &&
                      nearest_of(drawn.start, voyages, &Voyage::start) >= apart &&
                      nearest_of(drawn.goal, voyages, &Voyage::goal) >= apart;
    if (fits) voyages.push_back(drawn);
  }
  return voyages;
}

}  // namespace

std::string_view name_of(Pattern pattern) {
  constexpr std::array names{"swap", "streams", "crowd"};
  return names[static_cast<std::size_t>(pattern)];
}

std::string Gathering::name() const { return fmt::format("{}_{}", name_of(pattern), count); }

std::span<const Gathering> gatherings() { return all_gatherings; }
std::span<const Awareness> awarenesses() { return all_awarenesses; }

std::span<const Method> gathering_methods() {
  static const std::vector<Method> methods{
      {"rvo", "rvo", {{"time_horizon_s", 6.0}}},
      {"vo", "vo", {{"time_horizon_s", 6.0}}},
      {"hrvo", "hrvo", {{"time_horizon_s", 6.0}}},
      {"orca2d", "orca2d", {{"time_horizon_s", 6.0}}},
      {"apf", "apf", {}},
      {"apf+stop_and_wait", "apf+stop_and_wait", {}},
      {"orca2d+stop_and_wait", "orca2d+stop_and_wait", {{"time_horizon_s", 6.0}}},
  };
  return methods;
}

std::vector<Voyage> voyages_of(const Gathering& gathering, std::uint64_t seed) {
  const Rng rng = Rng{seed}.stream(gathering.name());
  switch (gathering.pattern) {
    case Pattern::swap:
      return swaps(gathering.count, rng);
    case Pattern::streams:
      return crossing(gathering.count, rng);
    case Pattern::crowd:
      return crowding(gathering.count, rng);
  }
  return {};
}

Scenario gathering_scenario(const Gathering& gathering, const Awareness& awareness, const Method& method,
                            std::uint64_t seed) {
  const std::vector<Voyage> voyages = voyages_of(gathering, seed);
  double longest = 0.0;
  for (const Voyage& voyage : voyages) longest = math::fmax(longest, (voyage.goal - voyage.start).norm());

  Scenario scenario{.name = gathering.name(), .step_s = 0.1, .seed = seed};
  scenario.steps_per_decision = 2;
  scenario.duration_s = 1.0 + patience_ratio * longest / cruise_speed;
  scenario.exam = {
      .crit_dist_m = 6.0, .safety_distance_m = 2.0 * body_radius, .time_coefficient_ratio = patience_ratio};
  scenario.perception.kind = {.name = std::string(awareness.perception), .path = "perception"};
  scenario.exchange = {.name = std::string(awareness.exchange), .path = "exchange"};
  if (awareness.exchange == "acoustic") scenario.exchange.params = {{"update_rate_hz", 1.0}};
  for (std::size_t i = 0; i < voyages.size(); ++i) {
    VehicleSpec& uuv = scenario.vehicles.emplace_back(
        uuv_of(i, voyages[i].start, voyages[i].goal, cruise_speed, awareness.hull, agility));
    uuv.avoider = Choice{.name = std::string(method.algorithm), .params = method.params, .path = "avoider"};
    uuv.radius_m = kept_radius;
  }
  return scenario;
}

}  // namespace fairway::uuv
