// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/instant.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/view/explain/testing/recorded_run.hpp"

namespace fairway {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Instant, FindsAVehicleByNameThenIdThenIndex) {
  const RecordingInfo info{.vehicles = {{VehicleId{1}, "first", "sparus2"},
                                        {VehicleId{7}, "second", "sparus2"},
                                        {VehicleId{9}, "0", "sparus2"}}};
  EXPECT_EQ(vehicle_called(info, "second"), 1u);
  EXPECT_EQ(vehicle_called(info, "0"), 2u);
  EXPECT_EQ(vehicle_called(info, "1"), 0u);
  EXPECT_EQ(vehicle_called(info, "7"), 1u);
  EXPECT_EQ(vehicle_called(info, "2"), 2u);
  EXPECT_THAT(
      [&] { (void)vehicle_called(info, "frist"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("--vehicle frist"), HasSubstr("did you mean first?"))));
  EXPECT_THROW((void)vehicle_called(info, "3"), InputError);
  EXPECT_THROW((void)vehicle_called(info, "-1"), InputError);
  EXPECT_THROW((void)vehicle_called(info, ""), InputError);
}

TEST(Instant, IsTheLastRecordedFrameAtOrBeforeTheTime) {
  const Recording recording = testing::recorded(testing::scenario_of("head_on", {{"duration_s", "2"}}), 4);
  const double period = recording.info().period;
  ASSERT_EQ(recording.run_frame_count(), static_cast<std::size_t>(std::lround(2.0 / period)) + 1);
  EXPECT_EQ(frame_at(recording, 0.0), 0u);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double time = recording.frame(i).time;
    EXPECT_EQ(frame_at(recording, time), i);
    EXPECT_EQ(frame_at(recording, time - 1e-12), i) << "as typed, with fewer digits";
    EXPECT_EQ(frame_at(recording, time + 0.9 * period), i);
  }
  EXPECT_EQ(frame_at(recording, 2.0), recording.size() - 1);
  for (const double outside : {-0.1, 2.0 + 2.0 * period, 1e300, std::nan(""), -HUGE_VAL}) {
    EXPECT_THAT([&] { (void)frame_at(recording, outside); },
                ThrowsMessage<InputError>(
                    AllOf(HasSubstr("--time"), HasSubstr("outside the run"), HasSubstr("from 0 to 2.05 s"))));
  }
}

}  // namespace
}  // namespace fairway
