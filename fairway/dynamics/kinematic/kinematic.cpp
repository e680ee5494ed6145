// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/kinematic/kinematic.hpp"

#include "fairway/core/params.hpp"

namespace fairway {

Kinematic::Kinematic(const Params& p)
    : rate_{1.0 / checked_params(p).time_constant_s},
      max_acceleration_{p.max_acceleration_mps2},
      max_turn_acceleration_{p.max_turn_acceleration_radps2},
      sways_{p.max_sway_mps > 0.0},
      actuators_{ActuatorInfo{"surge_mps",
                              "setpoint of the speed ahead through the water",
                              {-p.max_reverse_mps, p.max_speed_mps},
                              0.0},
                 ActuatorInfo{"heave_mps",
                              "setpoint of the speed down through the water",
                              {-p.max_heave_mps, p.max_heave_mps},
                              0.0},
                 ActuatorInfo{"yaw_rate_radps",
                              "setpoint of the turn rate, positive to starboard",
                              {-p.max_turn_rate_radps, p.max_turn_rate_radps},
                              0.0},
                 ActuatorInfo{"sway_mps",
                              "setpoint of the speed to starboard through the water",
                              {-p.max_sway_mps, p.max_sway_mps},
                              0.0}} {}

}  // namespace fairway
