// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/reading.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/pledge/pledge.hpp"
#include "fairway/avoidance/pledge/words.hpp"
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"
#include "fairway/core/rng.hpp"

namespace fairway::pledge {
namespace {

const Vec2 read_from{100.0, 0.0};
const Member read_member{.anchor = {110.0, 0.0, 5.0}, .destination = {90.0, -20.0, 5.0}};

/// Vehicle 2 of 5, at 100 s, before a plan of vehicle 0 for 123.4 s.
Header header_of_two() {
  return {.sender = 2, .epoch = {1234, 0}, .sent = 100.0, .acknowledged = 0b01111, .heard = 0b11111};
}

Reading read_of_five(const Speech& speech, std::uint32_t from = 2) {
  return reading_of({VehicleId{from}, 100.0, speech}, read_from, {.vehicles = 5});
}

std::vector<std::uint32_t> awaited_in(const Reading& reading) {
  std::vector<std::uint32_t> numbers;
  for (const VehicleId id : reading.awaited) numbers.push_back(number(id));
  return numbers;
}

using Numbers = std::vector<std::uint32_t>;

TEST(Reading, OfAStateSaysWhereItIsHeldAndWhomItWaitsFor) {
  Header header = header_of_two();
  header.epoch = {};
  header.acknowledged = {};
  header.heard = 0b10101;
  const Reading reading = read_of_five(encode(StateWord{header, read_member}, read_from));
  EXPECT_EQ(reading.text, "is held at [110, 0, 5] m NED and goes to [90, -20, 5] m NED; has heard 0 2 4");
  EXPECT_EQ(awaited_in(reading), (Numbers{1, 3}));
}

TEST(Reading, OfAPlanSaysWhoHasAcknowledgedIt) {
  Header header = header_of_two();
  PlanWord word{header, {.epoch = header.epoch, .participants = 0b00111}};
  Reading reading = read_of_five(encode(word, read_from));
  EXPECT_EQ(
      reading.text,
      "is held; has heard 0 1 2 3 4; plan of 0 for 123.4 s, by which go 0 1 2: acknowledged by 0 1 2 3, "
      "departed none");
  EXPECT_EQ(awaited_in(reading), Numbers{4});

  word.header.acknowledged.reset(2);
  EXPECT_EQ(awaited_in(read_of_five(encode(word, read_from))), Numbers{})
      << "it has not acknowledged it itself";
  word.header = header;
  word.header.status = Status::moving;
  word.header.departed = 0b00100;
  reading = read_of_five(encode(word, read_from));
  EXPECT_EQ(reading.text.substr(0, 14), "is on its way;");
  EXPECT_EQ(awaited_in(reading), Numbers{});
}

TEST(Reading, OfAWordPassedOnSaysWhoseItIs) {
  const Reading reading = read_of_five(encode(StateWord{header_of_two(), read_member}, read_from), 3);
  EXPECT_EQ(reading.text.substr(0, 36), "passes on what 2 said at 100 s: is h");
  EXPECT_EQ(awaited_in(reading), Numbers{}) << "whoever passes it on need not wait";
}

TEST(Reading, CallsMembersOfAGroupByTheirNumbersAmongAll) {
  Header header = header_of_two();  // of sixteen in two groups: the even ones are its group, it is member 1
  header.round = 3;
  header.acknowledged = 0b11111111;
  header.acknowledged.reset(7);
  header.heard = 0b11111111;
  header.epoch.author = 3;
  const Reading reading = reading_of({VehicleId{2}, 100.0, encode(StateWord{header, read_member}, read_from)},
                                     read_from, {.vehicles = 16});
  EXPECT_NE(
      reading.text.find("plan of 6 for 123.4 s: acknowledged by 0 2 4 6 8 10 12, departed none; in round 3"),
      std::string::npos)
      << reading.text;
  EXPECT_EQ(awaited_in(reading), Numbers{14});
}

TEST(Reading, OfGarbageSaysThatItIsNone) {
  Rng rng = Rng{1}.stream("garbage");
  for (int i = 0; i < 1000; ++i) {
    Speech speech{.size = static_cast<std::uint8_t>(rng.index(Speech::most_bytes + 1))};
    for (std::uint8_t& byte : speech.bytes) byte = static_cast<std::uint8_t>(rng.index(256));
    const Reading reading = read_of_five(speech);
    EXPECT_FALSE(reading.text.empty());
    EXPECT_TRUE(decode(speech, read_from, 100.0) || reading.text == "not a word of pledge") << reading.text;
  }
  Header stranger = header_of_two();
  stranger.sender = 5;
  EXPECT_EQ(read_of_five(encode(StateWord{stranger, read_member}, read_from)).text,
            "a word of pledge by 5, who is not of the team");
}

TEST(Reading, IsThatOfTheMethodInsideAWrapperToo) {
  const Avoider avoider{StopAndWait{}, Avoider{Pledge{{.team_count = 5, .datum_north_m = 100.0}}}};
  const Heard word{VehicleId{2}, 100.0, encode(StateWord{header_of_two(), read_member}, read_from)};
  ASSERT_TRUE(avoider.reading(word));
  EXPECT_EQ(avoider.reading(word)->text, read_of_five(word.speech).text);
  EXPECT_FALSE(Avoider{Direct{}}.reading(word)) << "a method that does not say how";
}

}  // namespace
}  // namespace fairway::pledge
