// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/avoidance/situation.hpp"
#include "fairway/record/record_cdr.hpp"
#include "fairway/record/record_text.hpp"

namespace fairway {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A record with a member of every kind, of which each boundary has to know what to do with it.
struct Buoy {
  TrackId id{};
  Vec3 position = Vec3::Zero();
  bool lit{};
  std::int32_t colour_count{};
  std::optional<double> period;
  std::optional<Vec3> drift;

  static consteval auto members() {
    using R = Buoy;
    return std::tuple{
        member<&R::id>("", "of the buoy"),
        member<&R::position>("m", "[m, NED]"),
        member<&R::lit>("", "whether it has a light"),
        member<&R::colour_count>("", "of its paint"),
        member<&R::period>("s", "of its light [s], or none"),
        member<&R::drift>("mps", "over ground [m/s, NED], or none"),
    };
  }
};

Buoy sample() {
  return {.id = TrackId{7}, .position = {1, 2, 3}, .lit = true, .colour_count = -2, .drift = Vec3{4, 5, 6}};
}

TEST(RecordMembers, ComeBackFromAMessage) {
  Bytes bytes;
  CdrWriter writer{bytes};
  put_record(writer, sample());
  CdrReader reader{bytes};
  Buoy read{.period = 9.0};
  get_record(reader, read);
  reader.finish();
  EXPECT_EQ(read.id, TrackId{7});
  EXPECT_EQ(read.position, Vec3(1, 2, 3));
  EXPECT_TRUE(read.lit);
  EXPECT_EQ(read.colour_count, -2);
  EXPECT_FALSE(read.period);
  EXPECT_EQ(read.drift, Vec3(4, 5, 6));
}

TEST(RecordMembers, StandInTheMessagesDefinitionInTheOrderInWhichTheyAreWritten) {
  EXPECT_EQ(record_definition<Buoy>("buoy_"),
            "# of the buoy\nuint32 id\n"
            "# whether it has a light\nbool lit\n"
            "# of its paint\nint32 colour_count\n"
            "# the period means something\nbool has_period\n"
            "# the drift means something\nbool has_drift\n"
            "# [m, NED]\nfloat64[3] buoy_position_m\n"
            "# of its light [s], or none\nfloat64 buoy_period_s\n"
            "# over ground [m/s, NED], or none\nfloat64[3] buoy_drift_mps\n");
}

TEST(RecordMembers, AreColumnsOfATable) {
  EXPECT_THAT(record_columns<Buoy>(), ElementsAre("id", "x_m", "y_m", "z_m", "lit", "colour_count",
                                                  "period_s", "drift_n_mps", "drift_e_mps", "drift_d_mps"));
  EXPECT_THAT(record_texts(sample()), ElementsAre("7", "1", "2", "3", "true", "-2", "", "4", "5", "6"));
}

TEST(RecordMembers, OfATrackAreAllOfThem) {
  // as many as the struct has: one that is not listed would be lost at every boundary
  [[maybe_unused]] const auto& [id, position, velocity, yaw, radius, age, priority, destination, reacts,
                                position_covariance, velocity_covariance] = Track{};
  std::size_t count = 0;
  for_each_member<Track>([&](const auto&) { ++count; });
  EXPECT_EQ(count, 11U);
  EXPECT_THAT(record_definition<Track>(), HasSubstr("float64[9] velocity_covariance_m2ps2"));
}

}  // namespace
}  // namespace fairway
