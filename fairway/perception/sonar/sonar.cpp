// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/sonar.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

SonarParams checked(const SonarParams& params) {
  check_params(params);
  check(params);
  return params;
}

/// Knuth's product of uniforms. O(mean).
int poisson(double mean, Rng& rng) {
  const double limit = math::exp(-mean);
  int count = 0;
  double product = rng.uniform(0.0, 1.0);
  while (product > limit) {
    product *= rng.uniform(0.0, 1.0);
    ++count;
  }
  return count;
}

}  // namespace

Sonar::Sonar(const SonarParams& params) : params_{checked(params)}, sweep_{params} {}

void Sonar::ping(const VehicleState& truth, const Scene& scene, Rng& rng, Rng& false_rng,
                 std::vector<Echo>& echoes) {
  sweep_.look_from(truth.p_n, truth.q_nb);
  for (std::size_t i = 0; i < scene.movers.size(); ++i) {
    if (i != scene.own_index) sweep_.add_sphere(scene.movers[i].position, scene.movers[i].radius);
  }
  for (const Obstacle& obstacle : scene.obstacles) sweep_.add(obstacle);

  echoes.clear();
  add_true(rng, echoes);
  add_false(false_rng, echoes);
  std::ranges::sort(echoes, [](const Echo& a, const Echo& b) {
    return a.bearing != b.bearing ? a.bearing < b.bearing : a.range < b.range;
  });
}

void Sonar::add_true(Rng& rng, std::vector<Echo>& echoes) const {
  const double bearing_sigma = radians(params_.echo_bearing_sigma_deg);
  const std::span<const double> ranges = sweep_.ranges();
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    if (ranges[beam] < params_.min_range_m || ranges[beam] > params_.max_range_m) continue;
    if (rng.uniform(0.0, 1.0) < params_.missed_ratio) continue;
    const double range_error = params_.echo_range_sigma_m * rng.normal();
    const double bearing_error = bearing_sigma * rng.normal();
    echoes.push_back({std::max(0.0, ranges[beam] + range_error), sweep_.bearing(beam) + bearing_error});
  }
}

void Sonar::add_false(Rng& rng, std::vector<Echo>& echoes) const {
  const double half_field = 0.5 * radians(params_.field_of_view_deg);
  const int count = poisson(params_.false_echoes_count, rng);
  for (int i = 0; i < count; ++i) {
    const double range = rng.uniform(params_.min_range_m, params_.max_range_m);
    echoes.push_back({range, rng.uniform(-half_field, half_field)});
  }
}

Fan Sonar::fan(const VehicleState& state) const {
  return {.origin = state.p_n,
          .q_nb = state.q_nb,
          .half_field = 0.5 * radians(params_.field_of_view_deg),
          .half_aperture = 0.5 * radians(params_.vertical_aperture_deg),
          .min_range = params_.min_range_m,
          .max_range = params_.max_range_m};
}

}  // namespace fairway
