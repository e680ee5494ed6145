// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/divergence.hpp"

#include <cmath>

#include "fairway/core/text.hpp"

namespace fairway {
namespace {

// a quaternion is normalised after every step: it is of unit length to rounding, or broken
constexpr double unit_tolerance = 1e-6;

}  // namespace

// a comparison with NaN does not hold
std::string_view why_impossible(const VehicleState& x) noexcept {
  const bool near = x.p_n.squaredNorm() <= farthest_m * farthest_m;
  const bool slow = x.v_b.squaredNorm() <= fastest_mps * fastest_mps;
  const bool calm = x.omega_b.squaredNorm() <= fastest_turn_radps * fastest_turn_radps;
  const bool turned = std::abs(x.q_nb.squaredNorm() - 1.0) <= unit_tolerance;
  if (near && slow && calm && turned) return {};
  if (!is_finite(x) || !turned) return "its state is not finite";
  if (!slow) return "its speed is beyond 200 m/s";
  if (!calm) return "its turn rate is beyond 200 rad/s";
  return "its position is beyond 20000 km";
}

std::string_view why_impossible(const Command& command) noexcept {
  return is_finite(command) ? std::string_view{} : "its command is not finite";
}

std::string_view why_impossible(const BodyRequest& request) noexcept {
  const Vec3 velocity_b{request.surge_mps, request.sway_mps, request.heave_mps};
  const bool finite = is_finite(velocity_b) && std::isfinite(request.yaw_rate_radps);
  return finite ? std::string_view{} : "what is asked of its controller is not finite";
}

std::string_view why_impossible(const ActuatorValues& demand) noexcept {
  return demand.allFinite() ? std::string_view{} : "what is demanded of its actuators is not finite";
}

std::string text_of(const Divergence& divergence, std::string_view vehicle) {
  return std::string("diverged: ").append(vehicle) + " at " +
         number_text(std::round(1e6 * divergence.time) / 1e6) + " s: " + std::string(divergence.why);
}

}  // namespace fairway
