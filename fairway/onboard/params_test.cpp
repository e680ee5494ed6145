// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/testing/out_of_range.hpp"
#include "fairway/onboard/testing/fixes.hpp"

namespace fairway {
namespace {

TEST(HelmMadeInCpp, RefusesAParameterOfItsSteeringOutsideItsRangeByName) {
  testing::expect_ranges_kept<SteeringParams>([](const SteeringParams& params) {
    fixes::Parts setup = fixes::setup();
    setup.ship.steering = params;
    (void)fixes::helm_of(setup);
  });
}

TEST(HelmMadeInCpp, RefusesAParameterOfItsPolicyOutsideItsRangeByName) {
  testing::expect_ranges_kept<OnboardPolicy>([](const OnboardPolicy& params) {
    fixes::Parts setup = fixes::setup();
    setup.policy = params;
    (void)fixes::helm_of(setup);
  });
}

}  // namespace
}  // namespace fairway
