// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/merge.hpp"

#include <gtest/gtest.h>

#include "fairway/perception/tracker/tracker.hpp"

namespace fairway {
namespace {

Track seen_at(const Vec3& position, std::uint32_t serial = 0) {
  Track track{.id = TrackId{first_tracker_id + serial},
              .position = position,
              .radius = 1.4,
              .priority = std::numeric_limits<std::int32_t>::min(),
              .reacts = false};
  track.position_covariance = Vec3{0.04, 0.04, 9.0}.asDiagonal();
  track.velocity_covariance = Vec3{0.01, 0.01, 0.25}.asDiagonal();
  return track;
}

Track told_at(const Vec3& position, std::uint32_t id = 3) {
  return {.id = TrackId{id},
          .position = position,
          .velocity = {0.5, 0, 0},
          .radius = 1.0,
          .age = 2.0,
          .priority = 5,
          .destination = Vec3{90, 0, 0}};
}

std::vector<Track> merged(const std::vector<Track>& seen, std::vector<Track> told) {
  Merge{{}, 8, 8}.merge(seen, told);
  return told;
}

TEST(Merge, WhoIsSeenAndToldOfIsOneWithTheIdentityThatItTells) {
  const auto known = merged({seen_at({10, 1, 0})}, {told_at({10.5, 0, 3})});
  ASSERT_EQ(known.size(), 1U);
  EXPECT_EQ(known[0].id, TrackId{3});
  EXPECT_EQ(known[0].priority, 5);
  EXPECT_EQ(known[0].destination, Vec3(90, 0, 0));
  EXPECT_TRUE(known[0].reacts);
  EXPECT_EQ(known[0].radius, 1.0);
  EXPECT_EQ(known[0].age, 0.0);
}

TEST(Merge, EachAxisIsWeighedByWhatIsKnownOfIt) {
  const auto known = merged({seen_at({10, 1, 0})}, {told_at({10.5, 0, 3})});
  // seen within 0.2 m horizontally and 3 m vertically, told within 1 m
  EXPECT_NEAR(known[0].position.y(), 1.0 / 1.04, 1e-9);
  EXPECT_NEAR(known[0].position.z(), 0.9 * 3.0, 1e-9);
  EXPECT_NEAR(known[0].position_covariance(1, 1), 0.04 / 1.04, 1e-9);
  EXPECT_NEAR(known[0].velocity.x(), 0.5 * 0.01 / (0.01 + 0.0025), 1e-9);
}

TEST(Merge, WhoIsFarApartIsNotOne) {
  const auto known = merged({seen_at({10, 5, 0})}, {told_at({10, 0, 0})});
  ASSERT_EQ(known.size(), 2U);
  EXPECT_FALSE(known[1].reacts);
  EXPECT_EQ(known[1].position, Vec3(10, 5, 0));
}

TEST(Merge, OfTwoSeenByTheSideOfOneToldTheNearerIsIt) {
  const auto known = merged({seen_at({10, 2, 0}, 0), seen_at({10, -0.5, 0}, 1)}, {told_at({10, 0, 0})});
  ASSERT_EQ(known.size(), 2U);
  EXPECT_NEAR(known[0].position.y(), -0.5, 0.05);
  EXPECT_EQ(known[1].id, TrackId{first_tracker_id});
}

TEST(Merge, CoincidentTracksArePairedOneByOne) {
  const auto known = merged({seen_at({1, 0, 0}, 0), seen_at({1, 0, 0}, 1)},
                            {told_at({1, 0, 0}, 1), told_at({1, 0, 0}, 2), told_at({1, 0, 0}, 3)});
  EXPECT_EQ(known.size(), 3U);
  for (const Track& track : known) EXPECT_TRUE(is_finite(track.position));
}

}  // namespace
}  // namespace fairway
