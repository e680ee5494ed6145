// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/navigation.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// One step of a Gauss-Markov process, exact for any period.
double drifted(double error, double sigma, double correlation_time, double period, Rng& rng) {
  const double kept = math::exp(-period / correlation_time);
  return kept * error + sigma * std::sqrt(1.0 - kept * kept) * rng.normal();
}

}  // namespace

Navigation::Navigation(std::string_view kind, const ParamValues& params, Rng rng) {
  require_known(kind, "navigation", navigation_kinds());
  if (kind == "perfect") {
    if (!params.empty()) throw InputError({}, params.front().first, "perfect navigation takes no parameters");
    return;
  }
  drift_.emplace(Drift{.params = params_of<NavigationParams>(params), .rng = rng});
  Drift& drift = *drift_;
  drift.position_error = drift.params.position_sigma_m * Vec2{drift.rng.normal(), drift.rng.normal()};
  drift.heading_error = radians(drift.params.heading_sigma_deg) * drift.rng.normal();
  Rng of_current = rng.stream("current");
  drift.current_bias = drift.params.current_sigma_mps * Vec3{of_current.normal(), of_current.normal(), 0.0};
}

const VehicleState& Navigation::estimate(const VehicleState& truth, double period) {
  if (!drift_) return truth;
  auto& [params, rng, position_error, heading_error, bias, believed] = *drift_;
  for (double& error : position_error)
    error = drifted(error, params.position_sigma_m, params.position_correlation_s, period, rng);
  heading_error =
      drifted(heading_error, radians(params.heading_sigma_deg), params.heading_correlation_s, period, rng);

  believed = truth;
  believed.p_n += Vec3{position_error.x(), position_error.y(), params.depth_sigma_m * rng.normal()};
  believed.q_nb = quaternion_of({.yaw = heading_error}) * truth.q_nb;
  believed.v_b += params.velocity_sigma_mps * Vec3{rng.normal(), rng.normal(), rng.normal()};
  return believed;
}

std::vector<KindInfo> navigation_kinds() {
  return {{"perfect", "A vehicle knows where it is and how it moves", "", {}},
          {"drifting", "Position and heading drift as dead reckoning does, velocity is noisy",
           "first-order Gauss-Markov processes (Gelb 1974)", describe_params<NavigationParams>()}};
}

}  // namespace fairway
