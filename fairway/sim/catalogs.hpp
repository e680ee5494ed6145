// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/catalog.hpp"
#include "fairway/dynamics/catalog.hpp"
#include "fairway/planning/builtin.hpp"

namespace fairway {

/// Everything a scenario may choose from by name.
struct Catalogs {
  Catalog avoiders;
  VehicleCatalog vehicles;
};

/// All that comes with fairway.
inline Catalogs builtin_catalogs() {
  Catalogs catalogs{builtin_avoiders(), builtin_vehicles()};
  add_planners(catalogs.avoiders);
  return catalogs;
}

}  // namespace fairway
