// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/band.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::teb {
namespace {

Knot knot_at(const Pose& pose, double time) {
  return {pose.position.x(), pose.position.y(), pose.heading, time};
}

Knot halfway(const Knot& a, const Knot& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]),
          a[heading_of] + 0.5 * wrap_angle(b[heading_of] - a[heading_of]), a[time_of]};
}

/// The time that the speed limits leave from one knot to the next.
double quickest(const TebParams& params, const Knot& a, const Knot& b) {
  const double way = math::hypot(b[0] - a[0], b[1] - a[1]);
  const double turn = std::abs(wrap_angle(b[heading_of] - a[heading_of]));
  return math::fmax(way / params.max_vel_x_mps, turn / params.max_vel_theta_radps);
}

/// One walk along the band; false if nothing had to be done.
bool resize_once(const TebParams& params, Band& band) {
  auto& knots = band.knots;
  const auto most = static_cast<std::size_t>(params.max_samples_count);
  const auto least = static_cast<std::size_t>(params.min_samples_count);
  bool changed = false;
  for (std::size_t i = 0; i + 1 < knots.size();) {
    const double time = knots[i][time_of];
    const bool last = i + 2 == knots.size();
    const auto here = knots.begin() + static_cast<std::ptrdiff_t>(i);

    if (time > 2.0 * params.dt_ref_s && knots.size() < most) {
      (*here)[time_of] = 0.5 * time;
      knots.insert(here + 1, halfway(*here, *(here + 1)));
      changed = true;
      continue;  // the halves may still be long
    }
    if (time > params.dt_ref_s + params.dt_hysteresis_s && !last) {
      (*(here + 1))[time_of] += time - params.dt_ref_s;
      (*here)[time_of] = params.dt_ref_s;
      changed = true;
    } else if (time < params.dt_ref_s - params.dt_hysteresis_s && knots.size() > least) {
      changed = true;
      if (last) {
        (*(here - 1))[time_of] += time;
        knots.erase(here);
        return changed;
      }
      (*here)[time_of] += (*(here + 1))[time_of];
      knots.erase(here + 1);
      continue;  // what is left may still be short
    }
    ++i;
  }
  return changed;
}

}  // namespace

double Band::duration() const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < size(); ++i) sum += time(i);
  return sum;
}

Band band_along(const TebParams& params, std::span<const Vec2> path, const Pose& start, const Pose& end) {
  constexpr double most_steps = 500;
  const double step = params.max_vel_x_mps * params.dt_ref_s;
  Band band;
  for (std::size_t leg = 0; leg + 1 < path.size(); ++leg) {
    const Vec2 way = path[leg + 1] - path[leg];
    const double heading = math::atan2(way.y(), way.x());
    const int steps = static_cast<int>(std::clamp(std::ceil(way.norm() / step), 1.0, most_steps));
    for (int k = 0; k < steps; ++k)
      band.knots.push_back(knot_at({path[leg] + way * k / steps, heading}, 0.0));
  }
  band.knots.push_back(knot_at(end, 0.0));
  band.knots.front() = knot_at(start, 0.0);
  while (band.size() < static_cast<std::size_t>(params.min_samples_count)) {
    band.knots.insert(band.knots.begin() + 1, halfway(band.knots[0], band.knots[1]));
  }
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    band.time(i) = math::fmax(1e-3, quickest(params, band.knots[i], band.knots[i + 1]));
  }
  return band;
}

void resize(const TebParams& params, Band& band) {
  const int walks = params.include_dynamic_obstacles ? 100 : 1;
  for (int walk = 0; walk < walks && resize_once(params, band); ++walk) {
  }
}

bool still_leads_to(const TebParams& params, const Band& band, const Pose& end) {
  const Pose old = band.pose(band.size() - 1);
  return (end.position - old.position).norm() < params.force_reinit_new_goal_dist_m &&
         std::abs(wrap_angle(end.heading - old.heading)) < params.force_reinit_new_goal_angular_rad;
}

void advance(const TebParams& params, Band& band, const Pose& start, const Pose& end) {
  constexpr std::size_t farthest = 10;
  const std::size_t spare =
      band.size() - std::min(band.size(), static_cast<std::size_t>(params.min_samples_count));
  std::size_t nearest = 0;
  while (nearest < std::min(farthest, spare) && (band.position(nearest + 1) - start.position).norm() <
                                                    (band.position(nearest) - start.position).norm()) {
    ++nearest;
  }
  // the time to the next pose stays that of the first
  const double time = band.time(0);
  band.knots.erase(band.knots.begin(), band.knots.begin() + static_cast<std::ptrdiff_t>(nearest));
  band.knots.front() = knot_at(start, time);
  band.knots.back() = knot_at(end, 0.0);
}

}  // namespace fairway::teb
