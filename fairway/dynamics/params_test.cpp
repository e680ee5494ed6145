// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/testing/out_of_range.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/dynamics/catalog.hpp"
#include "fairway/dynamics/kinematic/kinematic.hpp"
#include "fairway/dynamics/minerva/minerva.hpp"
#include "fairway/dynamics/minerva_transport/minerva_transport.hpp"
#include "fairway/dynamics/otter/otter.hpp"
#include "fairway/dynamics/remus100/remus100.hpp"
#include "fairway/dynamics/sparus2/sparus2.hpp"
#include "fairway/dynamics/zarco/zarco.hpp"

namespace fairway {
namespace {

template <class M>
class VehicleMadeInCpp : public ::testing::Test {};

using Models =
    ::testing::Types<Kinematic, Minerva, MinervaTransport, Otter, OtterByThrust, Remus100, Sparus2, Zarco>;
TYPED_TEST_SUITE(VehicleMadeInCpp, Models);

TYPED_TEST(VehicleMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  testing::expect_ranges_kept<typename TypeParam::Params>(
      [](const typename TypeParam::Params& params) { Vehicle{TypeParam{params}}; });
}

TEST(VehiclesMadeInCpp, AreAllOfTheCatalog) {
  EXPECT_EQ(builtin_vehicles().entries().size(), 8U) << "name the new one among Models";
}

TEST(MinervaTransportMadeInCpp, NamesTheStationThatIsOutOfRange) {
  MinervaTransport::Params params;
  params.layout.at(2).thrust_ratio = -1.0;
  const std::string refusal = refusal_by([&] { MinervaTransport{params}; });
  EXPECT_TRUE(refusal.starts_with("layout[2].thrust_ratio: is -1; expected")) << refusal;
}

}  // namespace
}  // namespace fairway
