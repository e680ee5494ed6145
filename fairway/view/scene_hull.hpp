// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// One of the hulls of a composite vehicle, in its body axes.
struct HullPart {
  double x{};    ///< of the middle, forward [m]
  double y{};    ///< to starboard [m]
  double z{};    ///< below [m]
  double yaw{};  ///< [rad]
};

/// What a vehicle looks like to the page.
struct Hull {
  std::string_view shape;       ///< as the page names them
  double length{};              ///< from bow to stern [m]
  double beam{};                ///< from side to side [m]
  std::vector<HullPart> parts;  ///< of a composite vehicle
};

/// By the vehicle's model and its parameters; a point of the vehicle's own radius for a model that none is
/// known for. The numbers are those of the README.md beside the model, in fairway/dynamics.
Hull hull_of(const VehicleSpec& spec);

}  // namespace fairway
