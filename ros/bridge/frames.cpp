// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/frames.hpp"

#include <stdexcept>

namespace fairway::bridge {

Frame frame_of(const std::string& name) {
  if (name == "enu") return Frame::enu;
  if (name == "ned") return Frame::ned;
  throw std::runtime_error("frame: " + name + ": expected enu or ned");
}

// The world turns by half about (1, 1, 0)/sqrt(2), the body by half about its forward axis: with
// t = (0, i + j)/sqrt(2) and b = (0, i), q_enu = t q_ned b, here without its factor of -1.
Quaternion flip_attitude(const Quaternion& q) {
  constexpr double half_sqrt2 = 0.70710678118654752440;
  const auto& [w, x, y, z] = q;
  return {half_sqrt2 * (w + z), half_sqrt2 * (x + y), half_sqrt2 * (x - y), half_sqrt2 * (w - z)};
}

Motion motion_in(Frame frame, const Motion& motion) {
  return {motion.time,
          world_in(frame, motion.position_n),
          attitude_in(frame, motion.q_nb),
          body_in(frame, motion.v_b),
          body_in(frame, motion.omega_b),
          motion.position_sigma};
}

}  // namespace fairway::bridge
