// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/velocity_controller.hpp"
#include "fairway/core/testing/out_of_range.hpp"
#include "fairway/dynamics/catalog.hpp"

namespace fairway {
namespace {

TEST(VelocityControllerMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  const Vehicle vehicle = builtin_vehicles().make("sparus2");
  testing::expect_ranges_kept<VelocityController::Params>([&](const VelocityController::Params& params) {
    VelocityController{*vehicle.propulsion(), vehicle.actuators(), params};
  });
}

}  // namespace
}  // namespace fairway
