// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/navigation.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

/// One step of a Gauss-Markov process, exact for any period.
double drifted(double error, double sigma, double correlation_time, double period, Rng& rng) {
  const double kept = std::exp(-period / correlation_time);
  return kept * error + sigma * std::sqrt(1.0 - kept * kept) * rng.normal();
}

}  // namespace

Navigation::Navigation(std::string_view kind, const ParamValues& params, Rng rng) : rng_{rng} {
  require_known(kind, "navigation", navigation_kinds());
  is_perfect_ = kind == "perfect";
  if (is_perfect_) {
    if (!params.empty()) throw InputError({}, params.front().first, "perfect navigation takes no parameters");
    return;
  }
  params_ = params_of<NavigationParams>(params);
  position_error_ = params_.position_sigma_m * Vec2{rng_.normal(), rng_.normal()};
  heading_error_ = radians(params_.heading_sigma_deg) * rng_.normal();
  Rng of_current = rng.stream("current");
  current_bias_ = params_.current_sigma_mps * Vec3{of_current.normal(), of_current.normal(), 0.0};
}

VehicleState Navigation::estimate(const VehicleState& truth, double period) {
  if (is_perfect_) return truth;
  for (double& error : position_error_)
    error = drifted(error, params_.position_sigma_m, params_.position_correlation_s, period, rng_);
  heading_error_ = drifted(heading_error_, radians(params_.heading_sigma_deg), params_.heading_correlation_s,
                           period, rng_);

  VehicleState believed = truth;
  believed.p_n += Vec3{position_error_.x(), position_error_.y(), params_.depth_sigma_m * rng_.normal()};
  believed.q_nb = Eigen::Quaterniond{Eigen::AngleAxisd{heading_error_, Vec3::UnitZ()}} * truth.q_nb;
  believed.v_b += params_.velocity_sigma_mps * Vec3{rng_.normal(), rng_.normal(), rng_.normal()};
  return believed;
}

std::vector<KindInfo> navigation_kinds() {
  return {{"perfect", "A vehicle knows where it is and how it moves", "", {}},
          {"drifting", "Position and heading drift as dead reckoning does, velocity is noisy",
           "first-order Gauss-Markov processes (Gelb 1974)", describe_params<NavigationParams>()}};
}

}  // namespace fairway
