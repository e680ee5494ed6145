// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/course.hpp"

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/studies/disc.hpp"

namespace fairway::surface {
namespace {

constexpr double other_speed = 0.55;  // [m/s], as published

/// A wall across the way at `wall`, `half_width` to either side, and arms from `arms` up to it: a buoy every
/// metre.
std::vector<Vec2> u_shape(int arms, int wall, int half_width) {
  std::vector<Vec2> buoys;
  for (int e = -half_width; e <= half_width; ++e) buoys.emplace_back(wall, e);
  for (int n = arms; n < wall; ++n) {
    buoys.emplace_back(n, -half_width);
    buoys.emplace_back(n, half_width);
  }
  return buoys;
}

std::vector<Vec2> lane() {
  std::vector<Vec2> buoys{{8.0, -4.2}, {8.0, 4.2}};
  for (const double n : {8.0, 10.0, 12.0, 14.0, 16.0}) {
    buoys.emplace_back(n, -2.2);
    buoys.emplace_back(n, 2.2);
  }
  return buoys;
}

/// Table I of campos2019: amplitude, period, direction. Its directions are not of unit length; here they are
/// directions alone.
WavesSpec table_1() {
  return {.components = {{.amplitude_m = 0.06, .period_s = 12.6, .direction_rad = pi},
                         {.amplitude_m = 0.04, .period_s = 3.7, .direction_rad = 0.75 * pi},
                         {.amplitude_m = 0.03, .period_s = 6.3, .direction_rad = 0.25 * pi}}};
}

Vec2 anywhere_near(const Vec2& place, double reach, Rng& rng) {
  const double n = rng.uniform(-reach, reach);
  return place + Vec2{n, rng.uniform(-reach, reach)};
}

Vec3 afloat(const Vec2& v) { return {v.x(), v.y(), 0.0}; }

}  // namespace

std::string_view name_of(Course course) {
  constexpr std::array names{"u_wall",  "u_narrow",   "u_deep",  "cluttered",
                             "head_on", "orthogonal", "diagonal"};
  return names[static_cast<std::size_t>(course)];
}

std::vector<ObstacleSpec> Layout::obstacles() const {
  std::vector<ObstacleSpec> specs;
  for (const Vec2& buoy : buoys) specs.push_back(disc(afloat(buoy), buoy_radius));
  if (vessel) specs.push_back(disc(afloat(*vessel), vessel_radius, afloat(vessel_velocity)));
  return specs;
}

Layout layout_of(Course course) {
  Layout layout;
  layout.water.waves = table_1();
  switch (course) {
    case Course::u_wall:
      layout.buoys = u_shape(3, 6, 3);
      break;
    case Course::u_narrow:
      layout.buoys = u_shape(6, 8, 2);
      break;
    case Course::u_deep:
      layout.buoys = u_shape(6, 10, 4);
      break;
    case Course::cluttered:
      layout.buoys = {{5.0, 0.5},   {6.0, -3.5},  {6.5, 4.0},   {9.0, -1.5}, {10.0, 2.5},
                      {11.0, -5.0}, {13.0, 0.5},  {14.0, -3.5}, {14.5, 4.5}, {17.0, -1.0},
                      {18.0, 2.5},  {19.0, -4.5}, {21.0, 0.8}};
      break;
    case Course::head_on:
      layout.buoys = lane();
      layout.vessel = {16.0, 0.0};
      layout.vessel_velocity = {-other_speed, 0.0};
      break;
    case Course::orthogonal:
      layout.buoys = {{10.0, 4.0}, {16.0, -4.0}, {18.0, 3.5}};
      layout.vessel = {12.5, -6.5};
      layout.vessel_velocity = {0.0, other_speed};
      break;
    case Course::diagonal:
      layout.buoys = {{9.0, -4.0}, {16.0, 5.0}, {19.0, -3.5}};
      layout.vessel = {15.0, -6.0};
      layout.vessel_velocity = other_speed * Vec2{-std::sqrt(0.5), std::sqrt(0.5)};
      break;
  }
  return layout;
}

Layout scaled(Course course, double length) {
  Layout layout = layout_of(course);
  const double scale = length / proposed_length;
  layout.goal *= scale;
  for (Vec2& buoy : layout.buoys) buoy *= scale;
  if (layout.vessel) *layout.vessel *= scale;
  return layout;
}

Layout varied(Course course, std::uint64_t seed) {
  Layout layout = layout_of(course);
  Rng rng = Rng{seed}.stream(name_of(course));
  layout.start.head<2>() = anywhere_near({0.0, 0.0}, 1.0, rng);
  layout.heading = rng.uniform(-0.3, 0.3);
  for (Vec2& buoy : layout.buoys) buoy = anywhere_near(buoy, 0.3, rng);
  if (layout.vessel) {
    layout.vessel = anywhere_near(*layout.vessel, 1.0, rng);
    const double speed_ratio = rng.uniform(0.8, 1.2);
    layout.vessel_velocity = speed_ratio * turned(layout.vessel_velocity, rng.uniform(-0.2, 0.2));
  }

  const double height = rng.uniform(0.01, 0.3);
  const double period = rng.uniform(3.0, 8.0);
  const double waves_to = rng.uniform(-pi, pi);
  layout.water.waves = {.spectrum = SpectrumSpec{.spectrum = SpectrumKind::jonswap,
                                                 .significant_height_m = height,
                                                 .peak_period_s = period,
                                                 .direction_rad = waves_to,
                                                 .components_count = 20}};
  const double current_speed = rng.uniform(0.0, 0.2);
  const double current_to = rng.uniform(-pi, pi);
  layout.water.current_n = current_speed * Vec3{math::cos(current_to), math::sin(current_to), 0.0};
  return layout;
}

}  // namespace fairway::surface
