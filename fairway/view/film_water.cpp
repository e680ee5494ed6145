// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_water.hpp"

namespace fairway {
namespace {

constexpr std::size_t most_depths = 8;

/// All points of a profile, or `most_depths` of them evenly, the first and the last among them.
std::vector<double> depths_of(const std::vector<ProfilePoint>& profile) {
  const std::size_t count = std::min(profile.size(), most_depths);
  std::vector<double> depths;
  for (std::size_t i = 0; i < count; ++i)
    depths.push_back(profile[i * (profile.size() - 1) / (count - 1)].depth_m);
  return depths;
}

}  // namespace

std::vector<double> current_depths(const WaterSpec& water) {
  if (water.current.sheared) return depths_of(water.current.sheared->profile);
  const bool flows = water.current.gauss_markov || !water.current_n.isZero(0.0);
  return flows ? std::vector<double>{0.0} : std::vector<double>{};
}

FilmWater::FilmWater(const Scenario& scenario)
    : sea_{scenario.water, Rng{scenario.seed}},
      period_{scenario.step_s},
      depths_{current_depths(scenario.water)},
      currents_(depths_.size()) {
  look();
}

void FilmWater::move_to(Tick tick) {
  for (; tick_ < tick; tick_ = next(tick_)) sea_.advance(period_);
  look();
}

void FilmWater::look() {
  for (std::size_t i = 0; i < depths_.size(); ++i) currents_[i] = sea_.current_at(depths_[i]);
}

}  // namespace fairway
