// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/plane_program/plane_program.hpp"

namespace fairway {

/// Which wall following.
enum class WallFollowingForm {
  printed,    ///< four point sensors, obstacle centres, scaled position errors as velocities, forces
  corrected,  ///< the disc round the vehicle, surfaces, bounded velocities, memory of the way round
};

template <>
struct EnumNames<WallFollowingForm> {
  static constexpr std::array names{"printed", "corrected"};
};

/// Wall following: to the goal, and along what is in the way while it is (rehman2021, section III-A-2, eqs.
/// 12-18). `printed` answers with forces for a vehicle that carries out `Command::wrench`; `corrected` with
/// velocities for any vehicle that can go any way. O(sensors x (tracks + obstacle vertices)); `corrected`
/// O(n^2) in what is near.
///
///     paper               here
///     K_gtg, K_ao, alpha  goal_gain_hz, wall_gain_hz, alpha_ratio
///     e_eta,gtg           goal.position - own.position
///     e_eta,ao            eta - eta_obs, away from the obstacle's centre
///     R                   eq. 17 unless the other way, eq. 18, leads nearer to the goal
///     nu_d                R(yaw)^T of the desired velocity
struct WallFollowing {
  static constexpr AlgorithmInfo info{
      .name = "wall_following",
      .title = "Wall following with go-to-goal and avoid-obstacle behaviours",
      .source = "rehman2021, section III-A-2, eqs. 12-18, Table 2; corrected form: fairway",
      .planar = true,
      .isotropic = false,  // the printed form holds a heading,
      .commands_forces = true,
      .needs_sway = true,
  };

  struct Params {
    WallFollowingForm form = WallFollowingForm::printed;
    int sensor_count = 4;
    double sensor_arm_m = 3.2;
    double sensor_range_m = 5.0;
    double goal_gain_hz = 0.5;
    double wall_gain_hz = 1.0;
    double alpha_ratio = 3.0;
    double heading_rad = 0.0;
    double goal_surge_kp_kgps = 3.0;
    double goal_surge_ki_npm = 0.0;
    double goal_surge_kd_kg = 5.0;
    double goal_sway_kp_kgps = 5.0;
    double goal_sway_ki_npm = 0.0;
    double goal_sway_kd_kg = 10.0;
    double goal_yaw_kp_nmprad = 5.0;
    double goal_yaw_ki_nmpradps = 0.0;
    double goal_yaw_kd_kgm2ps = 1.0;
    double wall_surge_kp_kgps = 3.0;
    double wall_surge_ki_npm = 0.0;
    double wall_surge_kd_kg = 1.0;
    double wall_sway_kp_kgps = 6.0;
    double wall_sway_ki_npm = 0.0;
    double wall_sway_kd_kg = 5.0;
    double wall_yaw_kp_nmprad = 2.0;
    double wall_yaw_ki_nmpradps = 0.0;
    double wall_yaw_kd_kgm2ps = 1.0;
    double standoff_m = 1.0;
    double approach_gain_hz = 0.0;

    static consteval auto fields() {
      using P = Params;
      constexpr Range gain{0, 1e6};
      return std::tuple{
          field<&P::form>("printed, or corrected"),
          field<&P::sensor_count>({1, 64}, "printed: point sensors, spread evenly from dead ahead"),
          field<&P::sensor_arm_m>({0, 1000}, "printed: from the body origin to each sensor"),
          field<&P::sensor_range_m>({0, 10000},
                                    "what has its surface this near counts: to a sensor if printed, "
                                    "to own sphere if corrected"),
          field<&P::goal_gain_hz>({0, 100}, "printed: K_gtg, desired velocity per distance to the goal"),
          field<&P::wall_gain_hz>({0, 100}, "printed: K_ao, desired velocity per distance to the centre"),
          field<&P::alpha_ratio>({0, 1000}, "printed: scaling factor along the obstacle"),
          field<&P::heading_rad>({-7, 7}, "printed: heading that is held"),
          field<&P::goal_surge_kp_kgps>(gain, "printed, go-to-goal: K_Px"),
          field<&P::goal_surge_ki_npm>(gain, "printed, go-to-goal: K_Ix"),
          field<&P::goal_surge_kd_kg>(gain, "printed, go-to-goal: K_Dx, a virtual mass"),
          field<&P::goal_sway_kp_kgps>(gain, "printed, go-to-goal: K_Py"),
          field<&P::goal_sway_ki_npm>(gain, "printed, go-to-goal: K_Iy"),
          field<&P::goal_sway_kd_kg>(gain, "printed, go-to-goal: K_Dy, a virtual mass"),
          field<&P::goal_yaw_kp_nmprad>(gain, "printed, go-to-goal: K_Ppsi"),
          field<&P::goal_yaw_ki_nmpradps>(gain, "printed, go-to-goal: K_Ipsi"),
          field<&P::goal_yaw_kd_kgm2ps>(gain, "printed, go-to-goal: K_Dpsi"),
          field<&P::wall_surge_kp_kgps>(gain, "printed, avoid-obstacle: K_Px"),
          field<&P::wall_surge_ki_npm>(gain, "printed, avoid-obstacle: K_Ix"),
          field<&P::wall_surge_kd_kg>(gain, "printed, avoid-obstacle: K_Dx, a virtual mass"),
          field<&P::wall_sway_kp_kgps>(gain, "printed, avoid-obstacle: K_Py"),
          field<&P::wall_sway_ki_npm>(gain, "printed, avoid-obstacle: K_Iy"),
          field<&P::wall_sway_kd_kg>(gain, "printed, avoid-obstacle: K_Dy, a virtual mass"),
          field<&P::wall_yaw_kp_nmprad>(gain, "printed, avoid-obstacle: K_Ppsi"),
          field<&P::wall_yaw_ki_nmpradps>(gain, "printed, avoid-obstacle: K_Ipsi"),
          field<&P::wall_yaw_kd_kgm2ps>(gain, "printed, avoid-obstacle: K_Dpsi"),
          field<&P::standoff_m>({0, 1000}, "corrected: kept between own sphere and every surface"),
          field<&P::approach_gain_hz>(
              {0, 100},
              "corrected: closing speed allowed per metre beyond the standoff; 0: 0.3, "
              "or 1 where way_round shows a way that trackable keeps to"),
      };
    }
  };

  /// What the printed controllers remember.
  struct Loop {
    bool following = false;
    std::optional<double> last_time;  ///< of the call before [s]
    Vec2 last_nu = Vec2::Zero();      ///< surge and sway then [m/s, body]
    Vec3 integral = Vec3::Zero();     ///< of the errors of surge, sway, yaw since the switch [m, rad s]
  };

  /// What the corrected form remembers of the way round something.
  struct Round {
    bool following = false;
    double turn = 1.0;          ///< 1: away from the wall is to starboard, -1: to port
    Vec2 along = Vec2::Zero();  ///< the way taken last, unit [NED]
    double hit_distance = 0.0;  ///< to the goal, where following began [m]
    Vec2 goal = Vec2::Zero();   ///< as of the last decision [m, NE]
  };

  struct Memory {
    Loop loop;
    Round round;
  };

  Params params;

  /// The corrected form's standoff; the printed one keeps nothing for certain.
  double kept_margin() const { return params.form == WallFollowingForm::corrected ? params.standoff_m : 0.0; }

  /// Mode::cruise while going to the goal, Mode::avoid while following, Mode::infeasible if `corrected` finds
  /// no velocity that keeps the standoff, with the one that violates it least.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<WallFollowing>);

}  // namespace fairway
