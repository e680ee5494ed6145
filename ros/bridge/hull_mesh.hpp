// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <string>
#include <vector>

#include "ros/bridge/plain.hpp"

namespace fairway::bridge {

/// The surface of a vehicle's hull as triangles, three points each, in body axes forward, starboard, down,
/// about the body's origin. `shape` as of bridge::FleetVehicle; an ellipsoid for one that is not known.
/// [m]
std::vector<Triple> hull_mesh(const std::string& shape, double length, double beam);

}  // namespace fairway::bridge
