// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/hard_switching/point_sensors.hpp"

namespace fairway {

/// Hard switching between a pull to the goal and a turn on the spot, as printed: a memoryless switch on what
/// four point sensors detect, and forces, not velocities (rehman2021, section III-A-1, eqs. 9-11). For
/// vehicles that carry out `Command::wrench`. O(sensors x (tracks + obstacle vertices)).
///
///     paper             here
///     eta_si            sensor i, sensor_arm_m from the body origin
///     d_s               radius of the obstacle + sensor_range_m, both from its centre
///     eta_dgtg - eta    goal.position - own.position
///     psi_dao           Memory::set_point, latched when the switch closes
///     tau_gtg, tau_ao   go_to_goal(), turn_away()
///     J^-1              R(yaw)^T
struct HardSwitching {
  static constexpr AlgorithmInfo info{
      .name = "hard_switching",
      .title = "Hard switching between go-to-goal and avoid-obstacle controllers",
      .source = "rehman2021, section III-A-1, eqs. 9-11, Table 1",
      .planar = true,
      .commands_forces = true,
      .needs_sway = true,
  };

  struct Params {
    int sensor_count = 4;
    double sensor_arm_m = 3.2;
    double sensor_range_m = 5.0;
    double goal_kp_npm = 1.3;
    double goal_ki_npmps = 0.0;
    double goal_kd_kgps = 0.0;
    double yaw_kp_nmprad = 200.0;
    double yaw_ki_nmpradps = 0.0;
    double yaw_kd_kgm2ps = 1.0;
    bool latch = true;

    static consteval auto fields() {
      using P = Params;
      constexpr Range gain{0, 1e6};
      return std::tuple{
          field<&P::sensor_count>({1, 64}, "point sensors, spread evenly from dead ahead"),
          field<&P::sensor_arm_m>({0, 1000}, "from the body origin to each sensor"),
          field<&P::sensor_range_m>({0, 10000}, "a sensor detects what has its surface this near"),
          field<&P::goal_kp_npm>(gain, "go-to-goal: force per error, north and east alike"),
          field<&P::goal_ki_npmps>(gain, "go-to-goal: force per integrated error"),
          field<&P::goal_kd_kgps>(gain, "go-to-goal: force per rate of the error"),
          field<&P::yaw_kp_nmprad>(gain, "avoid-obstacle: moment per heading error"),
          field<&P::yaw_ki_nmpradps>(gain, "avoid-obstacle: moment per integrated error"),
          field<&P::yaw_kd_kgm2ps>(gain, "avoid-obstacle: moment per rate of the error"),
          field<&P::latch>("turn 90 deg from the heading at switch-on; else from the present one, "
                           "eq. 10 as written, which spins for ever"),
      };
    }
  };

  struct Memory {
    bool avoiding = false;
    double set_point = 0.0;             ///< psi_dao [rad]
    std::optional<double> last_time;    ///< of the call before [s]
    Vec3 goal_integral = Vec3::Zero();  ///< of the error since the switch opened [m s, NED]
    double yaw_integral = 0.0;          ///< of the error since the switch closed [rad s]
  };

  Params params;

  /// Mode::cruise while going to the goal, with the preferred velocity; Mode::avoid while turning, with none.
  /// Either way a wrench: surge and sway, or yaw.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;

 private:
  Wrench go_to_goal(const Situation& s, Memory& memory, double elapsed) const noexcept;
  Wrench turn_away(const Situation& s, Memory& memory, double elapsed) const noexcept;
};

static_assert(AvoidanceAlgorithm<HardSwitching>);

}  // namespace fairway
