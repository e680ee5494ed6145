// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "fairway/record/diff.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/sketch_messages.hpp"
#include "fairway/record/testing/sample_run.hpp"

namespace fairway {
namespace {

using testing::checked;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::recorded;
using testing::recorded_bytes;
using testing::SampleRun;
using ::testing::SizeIs;
using testing::SketchingRun;

void expect_same_sketches(const Frame& a, const Frame& b) {
  ASSERT_EQ(a.vehicles.size(), b.vehicles.size());
  for (std::size_t i = 0; i < a.vehicles.size(); ++i) {
    const auto difference = first_sketch_difference(a.vehicles[i].strokes, b.vehicles[i].strokes);
    EXPECT_FALSE(difference) << difference->quantity << ": " << difference->a << " against " << difference->b;
  }
  const auto difference = first_flight_difference(a.flights, b.flights);
  EXPECT_FALSE(difference) << difference->quantity;
  EXPECT_TRUE(same_sketches(a, b));
}

TEST(RecordedSketch, IsGivenBackToTheBit) {
  const SketchingRun run{4, 20};
  const Recording recording = recorded(run);
  EXPECT_TRUE(recording.info().sketches);
  EXPECT_FALSE(recording.info().perception);
  ASSERT_EQ(recording.size(), run.size());
  for (std::size_t i = 0; i < run.size(); ++i) expect_same_sketches(run.frame(i), recording.frame(i));
  EXPECT_THAT(recording.frame(4).vehicles[0].strokes, SizeIs(7));
  EXPECT_THAT(recording.frame(4).vehicles[3].strokes, SizeIs(4));
  EXPECT_THAT(recording.frame(7).flights,
              ElementsAre(run.flights[7][0], run.flights[7][1], run.flights[7][2]));
  EXPECT_EQ(recording.frame(5).vehicles[1].strokes.front().meaning, run.strokes[21][0].meaning);
}

TEST(RecordedSketch, KeepsExtremesTheSignOfZeroAndThePayloadOfNan) {
  SketchingRun run;
  const auto odd_nan = std::bit_cast<double>(0x7FF8'0000'0000'1234ULL);
  Stroke& stroke = run.stroke(0, 0, 0);
  stroke.points = {{-0.0, std::numeric_limits<double>::max(), 4.9e-324}, {odd_nan, 0.0, 0.0}};
  stroke.size = std::numeric_limits<double>::infinity();
  stroke.yaw = odd_nan;
  stroke.side = std::numeric_limits<std::int32_t>::min();
  stroke.rgb = {0x000000U, 0xFFFFFFU, 0x123456U};
  stroke.meaning = std::string("a zero \0 inside", 15);
  const Recording recording = recorded(run);
  for (std::size_t i = 0; i < run.size(); ++i) expect_same_sketches(run.frame(i), recording.frame(i));
  EXPECT_TRUE(std::signbit(recording.frame(0).vehicles[0].strokes[0].points[0].x()));
}

TEST(RecordedSketch, MovesWithItsFramesAndSurvivesAStrideAndPerception) {
  SketchingRun run{3, 10};
  run.perceive();
  for (const std::int64_t stride : {1, 3, 4}) {
    Recording first = recorded(run, stride);
    const Recording recording = std::move(first);
    for (std::size_t i = 0; i < recording.size(); ++i) {
      const Frame frame = run.frame(i * static_cast<std::size_t>(stride));
      expect_same_sketches(frame, recording.frame(i));
      EXPECT_EQ(perception_hash(recording.frame(i)), perception_hash(frame));
    }
  }
}

TEST(RecordedSketch, IsWrittenOnlyWhereItChanges) {
  const Bytes bytes = recorded_bytes(SketchingRun{3, 10});  // anew in every second frame
  auto times = testing::writings(bytes);
  EXPECT_THAT(times["/auv_2/sketch"], ElementsAre(0, 2, 4, 6, 8));
  EXPECT_THAT(times["/fairway/flights"], ElementsAre(0, 2, 3, 4, 5, 6, 7, 8, 9));  // none before 0.2 s
  EXPECT_EQ(McapReader{bytes}.metadata().at("fairway").at("sketches"), "true");
}

TEST(RecordedSketch, LeavesARecordingWithoutItAsItIs) {
  const SampleRun plain;
  SketchingRun unasked;
  unasked.info.sketches = false;
  EXPECT_EQ(recorded_bytes(plain), recorded_bytes(unasked));

  const Recording recording = recorded(unasked);
  EXPECT_FALSE(recording.info().sketches);
  EXPECT_THAT(recording.frame(4).vehicles[0].strokes, IsEmpty());
  EXPECT_THAT(recording.frame(4).flights, IsEmpty());
  EXPECT_EQ(recording.run_hash(), recorded(SketchingRun{}).run_hash());
}

TEST(RecordedSketch, IsWrittenWithoutAllocatingOnceTheBuffersHaveGrown) {
  const long allocated = testing::allocations_from(600, SketchingRun{4, 800});
  EXPECT_LE(allocated, 8);  // entries that each chunk adds to the summary
}

TEST(SketchMessage, TakesThreeBytesAPixel) {
  Bytes without, with;
  Stroke stroke{.kind = Stroke::Kind::image, .meaning = "zones", .side = 10};
  encode_sketch(without, Stamp{0}, {&stroke, 1});
  stroke.rgb.assign(100, 0xA0B0C0U);
  encode_sketch(with, Stamp{0}, {&stroke, 1});
  EXPECT_EQ(with.size() - without.size(), 300U);
  EXPECT_EQ(with.back(), std::byte{0xC0});
}

TEST(SketchDifference, IsFoundInEveryMember) {
  const Stroke original{.kind = Stroke::Kind::path,
                        .meaning = "way",
                        .points = {{1.0, 2.0, 3.0}},
                        .size = 4.0,
                        .yaw = 5.0,
                        .side = 6,
                        .rgb = {7}};
  const auto named = [&](auto change) {
    Stroke other = original;
    change(other);
    const auto found = first_sketch_difference({&original, 1}, {&other, 1});
    return found ? found->quantity : "";
  };
  EXPECT_EQ(named([](Stroke&) {}), "");
  EXPECT_EQ(named([](Stroke& s) { s.kind = Stroke::Kind::tree; }), "sketch[0].kind");
  EXPECT_EQ(named([](Stroke& s) { s.meaning += "s"; }), "sketch[0].meaning");
  EXPECT_EQ(named([](Stroke& s) { s.points[0].y() = std::nextafter(2.0, 3.0); }), "sketch[0].points[0]");
  EXPECT_EQ(named([](Stroke& s) { s.points.clear(); }), "sketch[0].point_count");
  EXPECT_EQ(named([](Stroke& s) { s.size = -4.0; }), "sketch[0].size");
  EXPECT_EQ(named([](Stroke& s) { s.yaw = 0.0; }), "sketch[0].yaw_rad");
  EXPECT_EQ(named([](Stroke& s) { s.side = 0; }), "sketch[0].side_count");
  EXPECT_EQ(named([](Stroke& s) { s.rgb[0] = 8; }), "sketch[0].rgb[0]");
  EXPECT_EQ(named([](Stroke& s) { s.rgb.push_back(8); }), "sketch[0].pixel_count");
  EXPECT_EQ(first_sketch_difference({&original, 1}, {})->quantity, "stroke_count");

  const MessageFlight flight{1, 2, 3.0, 4.0, 5.0, false};
  MessageFlight later = flight;
  later.arrives = 6.0;
  const auto found = first_flight_difference({&flight, 1}, {&later, 1});
  EXPECT_EQ(found->quantity, "flights[0].arrives_s");
  EXPECT_EQ(found->b, "6");
  EXPECT_EQ(first_flight_difference({&flight, 1}, {})->quantity, "flight_count");
}

TEST(Diff, NamesTheFirstDifferenceInWhatWasDrawn) {
  const SketchingRun a;
  SketchingRun b, c;
  b.stroke(3, 1, 2).yaw += 1.0;
  const Difference d = diff(recorded(a), recorded(b));
  EXPECT_FALSE(d.same());
  ASSERT_TRUE(d.first);
  EXPECT_EQ(d.first->tick, Tick{3});
  EXPECT_EQ(d.first->vehicle, "auv_2");
  EXPECT_EQ(d.first->quantity, "sketch[2].yaw_rad");
  EXPECT_FALSE(d.farthest);

  c.flights[3][0].unheard = !c.flights[3][0].unheard;
  EXPECT_THAT(diff(recorded(a), recorded(c)).describe(), HasSubstr(" s): flights[0].unheard: "));
  EXPECT_TRUE(diff(recorded(a), recorded(SketchingRun{})).same());
}

TEST(Diff, OfARecordingWithoutSketchesComparesTheRest) {
  const Difference d = diff(recorded(SampleRun{}), recorded(SketchingRun{}));
  EXPECT_TRUE(d.same());
  EXPECT_THAT(d.setup, ElementsAre("sketches: not recorded against recorded"));
}

TEST(HashChecker, ComparesWhatWasDrawnWhereItIsRecorded) {
  SketchingRun now;
  const Recording recording = recorded(now);
  const Recording without = recorded(SampleRun{});
  EXPECT_TRUE(checked(recording, now).same());
  EXPECT_THAT(checked(recording, now).describe(), HasSubstr("recorded frames, and what was drawn"));

  now.flights[4][1].sent += 1.0;
  EXPECT_FALSE(checked(recording, now).same());
  EXPECT_THAT(checked(recording, now).describe(), HasSubstr("from tick 4 (0.4 s): flights[1].sent_s: "));
  now.stroke(2, 2, 0).meaning = "another";
  EXPECT_EQ(checked(recording, now).matched(), 3U);
  EXPECT_THAT(checked(recording, now).describe(),
              HasSubstr("from tick 2 (0.2 s): auv_3 sketch[0].meaning: "));
  EXPECT_TRUE(checked(without, now).same());
}

}  // namespace
}  // namespace fairway
