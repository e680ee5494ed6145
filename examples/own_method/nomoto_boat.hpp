// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/fossen.hpp"
#include "fairway/dynamics/vehicle_model.hpp"

/// A boat described by two time constants: the surge speed and the yaw rate follow their setpoints as
/// first-order lags. For the yaw rate this is Nomoto's first-order model, T r_dot + r = setpoint (Fossen
/// 2021, section 7.2). An example of a vehicle: it drifts with the current and does not feel waves.
class NomotoBoat {
 public:
  static constexpr fairway::VehicleInfo info{.name = "nomoto_boat",
                                             .title = "A boat described by two time constants",
                                             .source = "An example; Nomoto's first-order model",
                                             .floats = true};

  struct Params {
    double max_speed_mps{2.0};
    double max_turn_rate_radps{0.2};
    double surge_time_constant_s{5.0};
    double yaw_time_constant_s{2.0};

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          fairway::field<&P::max_speed_mps>({0.1, 20}, "fastest ahead through the water"),
          fairway::field<&P::max_turn_rate_radps>({0.01, 2}, "fastest turn to either side"),
          fairway::field<&P::surge_time_constant_s>({0.1, 100}, "of the approach to a speed"),
          fairway::field<&P::yaw_time_constant_s>({0.1, 100}, "of the approach to a turn rate"),
      };
    }
  };

  explicit NomotoBoat(const Params& p)
      : params_{p},
        actuators_{
            fairway::ActuatorInfo{"surge_mps", "setpoint of the speed ahead", {0, p.max_speed_mps}, 0.0},
            fairway::ActuatorInfo{"yaw_rate_radps",
                                  "setpoint of the turn rate, positive to starboard",
                                  {-p.max_turn_rate_radps, p.max_turn_rate_radps},
                                  0.0}} {}

  std::span<const fairway::ActuatorInfo> actuators() const { return actuators_; }

  fairway::StateRate derivative(const fairway::VehicleState& x, const fairway::ActuatorValues& u,
                                const fairway::Water& water) const noexcept {
    const fairway::fossen::Matrix3 R = fairway::fossen::rotation(x.q_nb);  // body to NED
    const fairway::Vec3 current_b = R.transpose() * water.current_n;
    const fairway::Vec3 through_water = x.v_b - current_b;

    fairway::StateRate rate;
    rate.p_n = R * x.v_b;
    rate.q_nb = fairway::fossen::quaternion_rate(x.q_nb, x.omega_b);
    rate.v_b = (fairway::Vec3{u[0], 0.0, 0.0} - through_water) / params_.surge_time_constant_s -
               x.omega_b.cross(current_b);
    rate.omega_b = (fairway::Vec3{0.0, 0.0, u[1]} - x.omega_b) / params_.yaw_time_constant_s;
    return rate;
  }

  double power(const fairway::ActuatorValues&) const noexcept {
    return 0.0;
  }  // nothing is known of its drive

 private:
  Params params_;
  std::array<fairway::ActuatorInfo, 2> actuators_;
};

static_assert(fairway::VehicleModel<NomotoBoat>);
