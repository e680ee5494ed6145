// SPDX-License-Identifier: Apache-2.0
// C++17: included by ROS nodes, whose message headers are not C++20.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fairway::bridge {

using Triple = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w, x, y, z

/// Where a vehicle is and how it moves, as fairway has it: NED, body forward-starboard-down.
struct Motion {
  double time{};                ///< [s]
  Triple position_n{};          ///< [m, NED]
  Quaternion q_nb{1, 0, 0, 0};  ///< body to NED
  Triple v_b{};                 ///< over ground [m/s, body]
  Triple omega_b{};             ///< [rad/s, body]
  double position_sigma{};      ///< deviation of the error of position, to the worst side; 0: not stated [m]
};

/// Asked of a vehicle's own controller: over ground, body forward-starboard-down.
struct BodyVelocity {
  double surge_mps{}, sway_mps{}, heave_mps{}, yaw_rate_radps{};
};

inline bool is_finite(const BodyVelocity& v) {
  return std::isfinite(v.surge_mps) && std::isfinite(v.sway_mps) && std::isfinite(v.heave_mps) &&
         std::isfinite(v.yaw_rate_radps);
}

/// Settings as text, by name: what `--set` and ROS parameters hold.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// What was drawn, ready to be shown: one primitive.
struct Mark {
  /// The values are those of visualization_msgs/Marker.
  enum class Kind { sphere = 2, line = 4, words = 9, triangles = 11 };
  Kind kind{Kind::line};
  std::string meaning;                      ///< "velocity obstacle", as in the viewer's key
  std::vector<Triple> points;               ///< [m, NED]; a line's in order, triangles' by threes
  double radius{};                          ///< of a sphere [m]
  std::array<float, 4> colour{1, 1, 1, 1};  ///< red, green, blue, alpha
  double width{0.05};                       ///< of a line, and the height of words [m]
  std::string words{};                      ///< above the first point
};

}  // namespace fairway::bridge
