// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/control/body_request.hpp"
#include "fairway/core/params.hpp"

namespace fairway {

/// How a velocity over ground becomes surge, sway, heave and yaw rate.
enum class SteeringKind {
  turn_then_go,      ///< turn on the spot until nearly aligned, then go (raja2024, Algorithm 1)
  proportional,      ///< turn while going; surge falls with the cosine of the heading error
  holonomic,         ///< go there by surge and sway and keep the heading, for a vehicle that can
  speed_and_course,  ///< keep the speed while turning towards the course (campos2019: v and omega of theta)
  crab,  ///< head for the velocity through the water that makes the wanted one over ground; never stop
};

template <>
struct EnumNames<SteeringKind> {
  static constexpr std::array names{"turn_then_go", "proportional", "holonomic", "speed_and_course", "crab"};
};

/// Symbols of raja2024 (Table I): ORI_ERROR, K_ROT_MIN, K_ROT_MAX, ROT_VEL.
struct SteeringParams {
  SteeringKind kind = SteeringKind::turn_then_go;
  double ori_error_rad = 0.6;
  double k_rot_min_ratio = 0.15;
  double k_rot_max_ratio = 0.3;
  double rot_vel_radps = 0.45;
  double turn_gain_hz = 0.5;
  double max_turn_rate_radps = 0.3;
  double heading_rad = 0.0;
  double min_speed_mps = 0.0;
  double circle_radius_m = 20.0;

  friend bool operator==(const SteeringParams&, const SteeringParams&) = default;

  static consteval auto fields() {
    return std::tuple{
        field<&SteeringParams::kind>("which law"),
        field<&SteeringParams::ori_error_rad>({0.01, 3.2},
                                              "turn_then_go: heading error above which it stops to turn"),
        field<&SteeringParams::k_rot_min_ratio>({0, 10}, "turn_then_go: turning coefficient while moving"),
        field<&SteeringParams::k_rot_max_ratio>({0, 10}, "turn_then_go: turning coefficient while stopped"),
        field<&SteeringParams::rot_vel_radps>({0, 10},
                                              "turn_then_go: rotation speed that the coefficients scale"),
        field<&SteeringParams::turn_gain_hz>({0, 10}, "all but turn_then_go: yaw rate per heading error"),
        field<&SteeringParams::max_turn_rate_radps>({0, 10}, "all but turn_then_go: largest yaw rate"),
        field<&SteeringParams::heading_rad>({-6.3, 6.3},
                                            "holonomic: kept where the method commands no heading"),
        field<&SteeringParams::min_speed_mps>({0, 100}, "crab: least speed through the water"),
        field<&SteeringParams::circle_radius_m>({0.1, 1e4},
                                                "crab: of the circle in place of holding a position"),
    };
  }
};

/// The body request that carries out `command` from the present heading. With `command.astern` a
/// velocity behind the beam is met stern first (Algorithm 1, lines 14 to 41, with |alpha| in lines 27
/// and 30). A velocity that is purely vertical leaves the heading alone. A commanded turn rate is taken as it
/// is, with the velocity's part along the heading as surge.
BodyRequest steer(const SteeringParams& params, const Command& command, double yaw) noexcept;

/// Likewise by `crab`, for a vehicle that cannot stop, in a current [m/s, NED] that it knows. The request is
/// one through the water: it heads for the commanded velocity less the current, at its speed (surge, of which
/// heave is the vertical part) but never below `min_speed_mps`. Without a course, as when it is to stop in
/// still water, it keeps its heading. A commanded heading or turn rate is taken as it is; with a turn rate,
/// or a heading beside the commanded velocity, the part of that speed along the bow is made.
BodyRequest steer_through_water(const SteeringParams& params, const Command& command, double yaw,
                                const Vec3& current_n) noexcept;

}  // namespace fairway
