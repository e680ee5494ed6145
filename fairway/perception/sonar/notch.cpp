// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/notch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

constexpr std::size_t most_reach = 7;    // echoes
constexpr double least_depth = 0.1;      // [m], of what is turned in
constexpr double range_sigmas = 4.0;     // of noise that is no notch
constexpr double bearing_sigmas = 0.25;  // likewise, of noise across the line of sight after smoothing

}  // namespace

Notch::Notch(const SonarParams& params, double spacing)
    : range_sigma_{params.echo_range_sigma_m}, bearing_sigma_{radians(params.echo_bearing_sigma_deg)} {
  const double beams = std::round(bearing_sigma_ / spacing);  // by which noise moves an echo
  reach_ = beams < most_reach ? 1 + static_cast<std::size_t>(beams) : most_reach;
  places_.reserve(echo_capacity(params));
  hull_.reserve(echo_capacity(params));
}

/// The running median of the ranges: noise of bearings shuffles echoes where a side is steep.
void Notch::smooth(std::span<const Echo> thing) {
  places_.clear();
  for (std::size_t i = 0; i < thing.size(); ++i) {
    const std::size_t first = i - std::min(i, reach_), end = std::min(i + reach_ + 1, thing.size());
    std::array<double, 2 * most_reach + 1> near;
    std::ranges::transform(thing.subspan(first, end - first), near.begin(), &Echo::range);
    const auto middle = near.begin() + static_cast<std::ptrdiff_t>((end - first) / 2);
    std::nth_element(near.begin(), middle, near.begin() + static_cast<std::ptrdiff_t>(end - first));
    places_.emplace_back(*middle * unit_at(thing[i].bearing));
  }
}

/// The hull as seen from the sonar (Andrew 1979).
void Notch::wrap() {
  hull_.clear();
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const auto is_behind = [&](std::size_t i, std::size_t j) {
      return cross(places_[k] - places_[i], places_[j] - places_[i]) <= 0.0;
    };
    while (hull_.size() > 1 && is_behind(hull_[hull_.size() - 2], hull_.back())) hull_.pop_back();
    hull_.push_back(k);
  }
}

std::optional<std::size_t> Notch::find(std::span<const Echo> thing) {
  const std::size_t fewest = 2 * reach_ + 1;
  if (thing.size() <= 2 * fewest) return {};
  smooth(thing);
  wrap();

  std::optional<std::size_t> deepest;
  double most = 0.0;
  for (std::size_t e = 1; e < hull_.size(); ++e) {
    const Vec2& from = places_[hull_[e - 1]];
    const Vec2 chord = places_[hull_[e]] - from;
    const double length = chord.norm();
    const std::size_t end = std::min(hull_[e], thing.size() - fewest);
    for (std::size_t i = std::max(hull_[e - 1] + 1, fewest); i < end; ++i) {
      const double noise = range_sigmas * range_sigma_ + bearing_sigmas * bearing_sigma_ * thing[i].range;
      const double beyond = std::abs(cross(chord, places_[i] - from)) / length - noise - least_depth;
      if (!(beyond > most)) continue;
      most = beyond;
      deepest = i;
    }
  }
  return deepest;
}

}  // namespace fairway
