// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "fairway/scenario/scenario.hpp"

namespace fairway::uuv {

/// What sails.
enum class Hull {
  point,    ///< goes any way at once, as the paper's UUV; it keeps its heading
  unicycle  ///< goes where it heads, and turns there at up to 1 rad/s
};
inline constexpr std::array hulls{Hull::point, Hull::unicycle};
std::string_view name_of(Hull hull);

/// What it can do.
struct Agility {
  double speed_mps{};  ///< any way that it goes at all
  double acceleration_mps2{};
  double turn_acceleration_radps2{};
  double time_constant_s{};
};

/// "uuv1" and so on, from `start` to `goal` [m, NED] at `speed` [m/s], heading there; done 1 m from it.
/// Whoever comes first has the right of way.
VehicleSpec uuv_of(std::size_t index, const Vec3& start, const Vec3& goal, double speed, Hull hull,
                   const Agility& agility);

}  // namespace fairway::uuv
