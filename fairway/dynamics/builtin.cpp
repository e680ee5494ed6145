// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/catalog.hpp"
#include "fairway/dynamics/kinematic/kinematic.hpp"
#include "fairway/dynamics/minerva/minerva.hpp"
#include "fairway/dynamics/minerva_transport/minerva_transport.hpp"
#include "fairway/dynamics/otter/otter.hpp"
#include "fairway/dynamics/remus100/remus100.hpp"
#include "fairway/dynamics/sparus2/sparus2.hpp"
#include "fairway/dynamics/zarco/zarco.hpp"

namespace fairway {

VehicleCatalog builtin_vehicles() {
  return VehicleCatalog{}
      .add<Kinematic>()
      .add<Sparus2>()
      .add<Minerva>()
      .add<MinervaTransport>()
      .add<Otter>()
      .add<OtterByThrust>()
      .add<Remus100>()
      .add<Zarco>();
}

}  // namespace fairway
