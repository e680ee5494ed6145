// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/testing/out_of_range.hpp"
#include "fairway/planning/blend/blend.hpp"
#include "fairway/planning/rrt_star/rrt_star.hpp"
#include "fairway/planning/teb/teb.hpp"

namespace fairway {
namespace {

template <class A>
class PlannerMadeInCpp : public ::testing::Test {};

using Planners = ::testing::Types<Blend, RrtStar, Teb>;
TYPED_TEST_SUITE(PlannerMadeInCpp, Planners);

TYPED_TEST(PlannerMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  testing::expect_ranges_kept<typename TypeParam::Params>(
      [](const typename TypeParam::Params& params) { Avoider{TypeParam{params}}; });
}

}  // namespace
}  // namespace fairway
