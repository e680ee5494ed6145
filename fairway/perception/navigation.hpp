// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "fairway/core/boxed.hpp"
#include "fairway/core/kind_info.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/state.hpp"

namespace fairway {

/// How wrong a vehicle is about itself. Position and heading drift slowly, as dead reckoning does; velocity
/// is noisy, as a Doppler log is.
struct NavigationParams {
  double position_sigma_m = 1.0;
  double position_correlation_s = 300.0;
  double depth_sigma_m = 0.01;
  double velocity_sigma_mps = 0.002;
  double heading_sigma_deg = 0.5;
  double heading_correlation_s = 300.0;
  double current_sigma_mps = 0.0;
  double stated_ratio = 1.0;

  static consteval auto fields() {
    return std::tuple{
        field<&NavigationParams::position_sigma_m>(
            {0, 1000}, "standard deviation of north and of east, each a Gauss-Markov process"),
        field<&NavigationParams::position_correlation_s>({0.1, 1e6}, "how long that error stays alike"),
        field<&NavigationParams::depth_sigma_m>({0, 100}, "standard deviation of depth, white"),
        field<&NavigationParams::velocity_sigma_mps>({0, 10}, "standard deviation of each axis, white"),
        field<&NavigationParams::heading_sigma_deg>({0, 180}, "standard deviation, a Gauss-Markov process"),
        field<&NavigationParams::heading_correlation_s>({0.1, 1e6}, "how long that error stays alike"),
        field<&NavigationParams::current_sigma_mps>(
            {0, 10}, "standard deviation of north and of east of the estimated current, a constant bias"),
        field<&NavigationParams::stated_ratio>(
            {0, 100}, "of position_sigma_m, what it states of itself; 0: nothing, below 1: it is too sure"),
    };
  }
};

/// The error of one vehicle's navigation: `perfect`, or `drifting`. A value.
class Navigation {
 public:
  /// The drift begins as it goes on, with its standard deviation. Throws InputError for an unknown kind or
  /// parameter.
  Navigation(std::string_view kind, const ParamValues& params, Rng rng);

  /// Where the vehicle believes to be and how it believes to move, one tick of `period` [s] after the last
  /// call.
  const VehicleState& estimate(const VehicleState& truth, double period);

  /// What the last call of `estimate` gave, `truth` being what it was given.
  const VehicleState& believed(const VehicleState& truth) const { return drift_ ? drift_->believed : truth; }

  /// What the vehicle estimates the current round it to be, which is `truth_n` [m/s, NED]: its velocity over
  /// ground less the one through the water, as a Doppler log that tracks both gives it. The estimate is off
  /// by a bias that stays the same for the run, and does not share the errors of `estimate`.
  Vec3 current(const Vec3& truth_n) const {
    return truth_n + (drift_ ? drift_->current_bias : Vec3{Vec3::Zero()});
  }

  /// What it states of itself: the standard deviation of north and of east. [m]
  double position_sigma() const {
    return drift_ ? drift_->params.stated_ratio * drift_->params.position_sigma_m : 0.0;
  }

 private:
  struct Drift {
    NavigationParams params;
    Rng rng;
    Vec2 position_error = Vec2::Zero();  // [m]
    double heading_error{};              // [rad]
    Vec3 current_bias = Vec3::Zero();    // [m/s, NED]
    VehicleState believed{};
  };

  Boxed<Drift> drift_;  // nothing: navigation is perfect
};

/// The kinds of navigation that there are.
std::vector<KindInfo> navigation_kinds();

}  // namespace fairway
