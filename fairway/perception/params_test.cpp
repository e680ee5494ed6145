// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/acoustic_channel.hpp"
#include "fairway/core/testing/out_of_range.hpp"
#include "fairway/perception/merge.hpp"
#include "fairway/perception/sonar/sonar.hpp"
#include "fairway/perception/tracker/tracker.hpp"

namespace fairway {
namespace {

TEST(SonarMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  testing::expect_ranges_kept<SonarParams>([](const SonarParams& params) { Sonar{params}; });
}

TEST(TrackerMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  testing::expect_ranges_kept<TrackerParams>([](const TrackerParams& params) { Tracker{params}; });
}

TEST(MergeMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  testing::expect_ranges_kept<MergeParams>([](const MergeParams& params) { Merge{params, 4, 2}; });
}

TEST(AcousticChannelMadeInCpp, RefusesAParameterOutsideItsRangeByName) {
  testing::expect_ranges_kept<AcousticParams>([](const AcousticParams& params) {
    AcousticChannel{params, 2, 0.05, Rng{1}};
  });
}

}  // namespace
}  // namespace fairway
