// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/sketch.hpp"

namespace fairway {

/// Point sensors spread evenly round the vehicle, the first ahead (rehman2021, section II).
struct PointSensors {
  int count = 4;
  double arm = 3.2;    ///< from the body origin [m]
  double range = 5.0;  ///< to the surface of what is detected [m]
};

/// Something that a sensor sees: printed methods take for granted that it tells where the centre is.
struct Detection {
  Vec3 centre = Vec3::Zero();    ///< [m, NED]
  Vec3 velocity = Vec3::Zero();  ///< [m/s, NED]
  double distance{};             ///< from the sensor to the surface [m]
};

/// The detection with the least distance: of obstacles as listed, then of tracks, the first of equals. A
/// track is a sphere. O(sensors x (tracks + obstacle vertices)).
std::optional<Detection> nearest_detected(const Situation& s, const PointSensors& sensors) noexcept;

/// The range of every sensor, and the way to what is detected as `meaning`.
void draw(const PointSensors& sensors, const Ownship& own, const std::optional<Detection>& detected,
          std::string_view meaning, Sketch& sketch);

}  // namespace fairway
