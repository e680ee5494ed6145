// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway::avoa {
namespace {

constexpr std::uint32_t black = 0;
constexpr double darkest_grey = 0.25;  // of what is feasible, so that it does not look forbidden

std::uint32_t rgb(double red, double green, double blue) {
  const auto byte = [](double part) { return static_cast<std::uint32_t>(std::lround(255.0 * part)); };
  return byte(red) << 16U | byte(green) << 8U | byte(blue);
}

/// From 0, dark grey, to 1, white.
std::uint32_t grey(double light) {
  const double value = darkest_grey + (1.0 - darkest_grey) * light;
  return rgb(value, value, value);
}

/// The colour of full value; `hue` and `saturation` in [0, 1].
std::uint32_t colour(double hue, double saturation) {
  const auto part = [&](double shift) {
    const double sector = std::fmod(6.0 * hue + shift, 6.0);
    return 1.0 - saturation * std::clamp(std::min(sector, 4.0 - sector), 0.0, 1.0);
  };
  return rgb(part(5.0), part(3.0), part(1.0));
}

}  // namespace

void draw(const VelocitySpace& space, const VelocityMetric& metric, double yaw,
          std::vector<std::uint32_t>& pixels, Sketch& sketch) {
  const VelocityGrid& grid = space.grid();
  pixels.resize(static_cast<std::size_t>(grid.cell_count()));
  const auto paint = [&](std::string_view meaning, auto colour_of) {
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = colour_of(static_cast<int>(i));
    sketch.image({.rgb = pixels, .side = grid.side(), .reach = grid.reach(), .yaw = yaw}, meaning);
  };

  paint("protective zones", [&](int cell) {
    if (!space.is_feasible(cell)) return black;
    const PolarVelocity& v = space.velocity(cell);
    return colour(v.heading < 0.0 ? 1.0 + v.heading / (2.0 * pi) : v.heading / (2.0 * pi),
                  std::min(v.speed / grid.reach(), 1.0));
  });

  paint("cost of danger", [&](int cell) {
    const bool forbidden = space.zones().forbidden()[static_cast<std::size_t>(cell)] != 0;
    return forbidden ? black : grey(1.0 - space.danger(cell));
  });

  // stretched over what is feasible, so that the differences show
  const auto cost_of = [&](int cell) { return metric(space.velocity(cell), space.danger(cell)); };
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const std::int32_t cell : space.feasible()) {
    least = std::min(least, cost_of(cell));
    most = std::max(most, cost_of(cell));
  }
  const double span = most > least ? most - least : 1.0;
  paint("metric",
        [&](int cell) { return space.is_feasible(cell) ? grey((most - cost_of(cell)) / span) : black; });
}

}  // namespace fairway::avoa
