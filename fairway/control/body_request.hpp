// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// Velocities asked of the vehicle's own controller, in body axes, roll and pitch left alone.
struct BodyRequest {
  double surge_mps{};
  double sway_mps{};
  double heave_mps{};       ///< positive down
  double yaw_rate_radps{};  ///< positive to starboard
  bool through_water{};     ///< whether the velocities are through the water, instead of over ground

  friend bool operator==(const BodyRequest&, const BodyRequest&) = default;
};

}  // namespace fairway
