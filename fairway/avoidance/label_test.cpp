// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/label.hpp"

#include <gtest/gtest.h>

#include <string>

namespace fairway {
namespace {

std::string text(const Label& label) { return std::string{std::string_view{label}}; }

TEST(Label, SaysWhoATrackIs) {
  EXPECT_EQ(text({"allowed by", TrackId{0}}), "allowed by vehicle 0");
  EXPECT_EQ(text({"waits for", TrackId{0x3FFF'FFFF}}), "waits for vehicle 1073741823");
  EXPECT_EQ(text({"allowed by", TrackId{first_tracker_id + 5}}), "allowed by contact 5");
  EXPECT_EQ(text({"allowed by", TrackId{first_drifter_id + 12}}), "allowed by drifter 12");
}

TEST(Label, HasAPlainNumberToo) { EXPECT_EQ(text({"band of another class", 2}), "band of another class 2"); }

TEST(Label, CutsOffWhatDoesNotFit) {
  const std::string long_text(80, 'x');
  EXPECT_EQ(text({long_text, TrackId{1}}), std::string(64, 'x'));
  EXPECT_EQ(text({long_text.substr(0, 60), 12345}), std::string(60, 'x') + " 123");
}

}  // namespace
}  // namespace fairway
