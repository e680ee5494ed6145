// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/catalog.hpp"
#include "fairway/dynamics/kinematic/kinematic.hpp"
#include "fairway/dynamics/sparus2/sparus2.hpp"

namespace fairway {

VehicleCatalog builtin_vehicles() { return VehicleCatalog{}.add<Kinematic>().add<Sparus2>(); }

}  // namespace fairway
