// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_program/velocity_program.hpp"

#include <algorithm>
#include <array>

namespace fairway {

VelocityChoice nearest_velocity(std::span<const HalfSpace> half_spaces, const Vec3& preferred,
                                double max_speed) noexcept {
  std::array<HalfSpace, max_half_spaces> room;
  half_spaces = half_spaces.first(std::min(half_spaces.size(), max_half_spaces));
  lanes::VecOf<double> v;
  const double violation =
      lanes::nearest_velocity<double>(half_spaces, preferred, max_speed, true, room.data(), v);
  return {v, violation};
}

}  // namespace fairway
