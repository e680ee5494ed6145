// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/csv.hpp"
#include "fairway/record/diff.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/hash_checker.hpp"
#include "fairway/record/messages.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/testing/sample_run.hpp"

namespace fairway {
namespace {

using testing::checked;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::PerceivingRun;
using testing::recorded;
using testing::recorded_bytes;
using testing::SampleRun;
using ::testing::SizeIs;
using ::testing::StartsWith;

void expect_same_perception(const Frame& a, const Frame& b) {
  ASSERT_EQ(a.vehicles.size(), b.vehicles.size());
  for (std::size_t i = 0; i < a.vehicles.size(); ++i) {
    const auto difference = first_perception_difference(a.vehicles[i], b.vehicles[i]);
    EXPECT_FALSE(difference) << difference->quantity << ": " << difference->a << " against " << difference->b;
  }
  EXPECT_EQ(perception_hash(a), perception_hash(b));
  EXPECT_EQ(frame_hash(a), frame_hash(b));
}

TEST(RecordedPerception, IsGivenBackToTheBit) {
  const PerceivingRun run{4, 20};
  const Recording recording = recorded(run);
  EXPECT_TRUE(recording.info().perception);
  ASSERT_EQ(recording.size(), run.size());
  std::uint64_t run_hash = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    expect_same_perception(run.frame(i), recording.frame(i));
    EXPECT_EQ(recording.perception_hashes()[i], perception_hash(run.frame(i)));
    run_hash = mix_hash(run_hash, perception_hash(run.frame(i)));
  }
  EXPECT_EQ(recording.run_perception_hash(), run_hash);
  EXPECT_THAT(recording.frame(4).vehicles[0].tracks, SizeIs(3));
  EXPECT_THAT(recording.frame(4).vehicles[0].echoes, SizeIs(4));
}

TEST(RecordedPerception, KeepsExtremesTheSignOfZeroAndThePayloadOfNan) {
  PerceivingRun run;
  const auto odd_nan = std::bit_cast<double>(0x7FF8'0000'0000'1234ULL);
  run.track(0, 0, 0).position = {-0.0, std::numeric_limits<double>::max(), 4.9e-324};
  run.track(0, 0, 0).age = std::numeric_limits<double>::infinity();
  run.track(0, 1, 1).yaw = odd_nan;
  run.track(2, 0, 0).position_covariance.setConstant(odd_nan);
  run.echoes[12][0] = {-0.0, odd_nan};  // frame 4
  const Recording recording = recorded(run);
  for (std::size_t i = 0; i < run.size(); ++i) expect_same_perception(run.frame(i), recording.frame(i));
  EXPECT_TRUE(std::signbit(recording.frame(0).vehicles[0].tracks[0].position.x()));
}

TEST(RecordedPerception, MovesWithItsFramesAndSurvivesAStride) {
  const PerceivingRun run{3, 10};
  for (const std::int64_t stride : {1, 3, 4}) {
    Recording first = recorded(run, stride);
    const Recording recording = std::move(first);
    for (std::size_t i = 0; i < recording.size(); ++i) {
      expect_same_perception(run.frame(i * static_cast<std::size_t>(stride)), recording.frame(i));
    }
    EXPECT_EQ(recording.run_perception_hash(), recorded(run).run_perception_hash());
  }
}

TEST(RecordedPerception, IsWrittenOnlyWhereItChanges) {
  auto times = testing::writings(recorded_bytes(PerceivingRun{3, 10}));  // anew in every second frame
  EXPECT_THAT(times["/auv_2/tracks"], ElementsAre(0, 2, 4, 6, 8));
  EXPECT_THAT(times["/auv_1/echoes"], ElementsAre(0, 2, 4, 6, 8));
  EXPECT_THAT(times["/auv_2/echoes"], ElementsAre(0));  // it has no sonar
  EXPECT_THAT(times["/fairway/perception"], SizeIs(10));
}

TEST(RecordedPerception, LeavesARecordingWithoutItAsItIs) {
  const SampleRun blind;
  PerceivingRun silent;
  silent.info.perception = false;
  EXPECT_EQ(recorded_bytes(blind), recorded_bytes(silent));

  const Recording recording = recorded(silent);
  EXPECT_FALSE(recording.info().perception);
  EXPECT_THAT(recording.perception_hashes(), IsEmpty());
  EXPECT_THAT(recording.frame(0).vehicles[0].tracks, IsEmpty());
  EXPECT_EQ(recording.run_hash(), recorded(PerceivingRun{}).run_hash());
}

TEST(RecordedPerception, IsWrittenWithoutAllocatingOnceTheBuffersHaveGrown) {
  const long allocated = testing::allocations_from(600, PerceivingRun{4, 800});
  EXPECT_LE(allocated, 4);  // entries that each chunk adds to the summary
}

TEST(PerceptionHash, ChangesWithAnyBitOfATrackOrAnEcho) {
  PerceivingRun run{2, 3};
  const std::uint64_t original = perception_hash(run.frame(2));
  const auto differs = [&] { return perception_hash(run.frame(2)) != original; };
  Track& track = run.track(2, 1, 0);
  const Track kept = track;

  std::vector<double*> numbers{&track.yaw, &track.radius, &track.age, &run.echoes[4][0].range,
                               &run.echoes[4][1].bearing};
  for (Eigen::Index k = 0; k < 3; ++k) {
    numbers.push_back(&track.position[k]);
    numbers.push_back(&track.velocity[k]);
  }
  for (Eigen::Index k = 0; k < 9; ++k) {
    numbers.push_back(track.position_covariance.data() + k);
    numbers.push_back(track.velocity_covariance.data() + k);
  }
  for (double* number : numbers) {
    for (unsigned bit = 0; bit < 64; ++bit) {
      const double before = *number;
      *number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(before) ^ (std::uint64_t{1} << bit));
      EXPECT_TRUE(differs()) << bit;
      *number = before;
    }
  }
  ASSERT_FALSE(differs());

  track.id = TrackId{5};
  EXPECT_TRUE(differs());
  track = kept;
  track.priority = -track.priority - 1;
  EXPECT_TRUE(differs());
  track = kept;
  track.reacts = !track.reacts;
  EXPECT_TRUE(differs());
  track = kept;
  track.destination = Vec3{1.0, 2.0, 3.0};
  const std::uint64_t somewhere = perception_hash(run.frame(2));
  track.destination->z() = 4.0;
  EXPECT_NE(perception_hash(run.frame(2)), somewhere);
  track.destination.reset();
  EXPECT_NE(perception_hash(run.frame(2)), somewhere);
  track = kept;
  run.at(2, 0).tracks = {};
  EXPECT_TRUE(differs());
}

TEST(PerceptionHash, LeavesTheFrameHashAlone) {
  const SampleRun blind;
  const PerceivingRun seeing;
  for (std::size_t i = 0; i < blind.size(); ++i) {
    EXPECT_EQ(frame_hash(blind.frame(i)), frame_hash(seeing.frame(i)));
    EXPECT_NE(perception_hash(blind.frame(i)), perception_hash(seeing.frame(i)));
  }
}

TEST(Diff, NamesTheFirstDifferenceInWhatWasPerceived) {
  const PerceivingRun a;
  PerceivingRun b;
  double& x = b.track(3, 1, 1).position.x();
  x = std::nextafter(x, 1e9);
  const Difference d = diff(recorded(a), recorded(b));
  EXPECT_FALSE(d.same());
  ASSERT_TRUE(d.first);
  EXPECT_EQ(d.first->tick, Tick{3});
  EXPECT_EQ(d.first->vehicle, "auv_2");
  EXPECT_EQ(d.first->quantity, "tracks[1].x_m");
  EXPECT_EQ(d.first->b, number_text(x));
  EXPECT_FALSE(d.farthest);

  PerceivingRun c;
  c.echoes[12].pop_back();
  c.at(4, 0).echoes = c.echoes[12];
  EXPECT_EQ(diff(recorded(a), recorded(c)).first->quantity, "echo_count");
  EXPECT_TRUE(diff(recorded(a), recorded(PerceivingRun{})).same());
}

TEST(Diff, OfARecordingWithoutPerceptionComparesTheRest) {
  const Difference d = diff(recorded(SampleRun{}), recorded(PerceivingRun{}));
  EXPECT_TRUE(d.same());
  EXPECT_THAT(d.setup, ElementsAre("perception: not recorded against recorded"));
}

TEST(HashChecker, ComparesWhatWasPerceivedWhereItIsRecorded) {
  PerceivingRun now;
  const Recording recording = recorded(now);
  const Recording without = recorded(SampleRun{});
  now.track(2, 2, 0).destination = Vec3{7.0, 8.0, 9.0};
  const HashChecker checker = checked(recording, now);
  EXPECT_FALSE(checker.same());
  EXPECT_EQ(checker.matched(), 4U);
  EXPECT_THAT(checker.describe(),
              StartsWith("differs from tick 2 (0.2 s): auv_3 tracks[0].destination_n_m: "));
  EXPECT_TRUE(checked(without, now).same());

  const PerceivingRun again;
  for (const std::int64_t stride : {1, 2}) {
    const Recording kept = recorded(again, stride);
    const HashChecker agreeing = checked(kept, again);
    EXPECT_TRUE(agreeing.same());
    EXPECT_THAT(agreeing.describe(), HasSubstr("recorded frames, and what was perceived"));
  }
}

TEST(HashChecker, SeesPerceptionThatDiffersBetweenTheRecordedFrames) {
  PerceivingRun now{2, 9};
  const Recording recording = recorded(now, 4);
  now.track(6, 0, 0).yaw += 1.0;
  const HashChecker checker = checked(recording, now);
  EXPECT_FALSE(checker.same());
  EXPECT_EQ(checker.describe(), "differs between the recorded frames, of which 3 of 3 match");
}

TEST(Csv, OfTracksHasARowForEachAndOfEchoesToo) {
  PerceivingRun run{3, 3};
  run.track(0, 0, 1).position.x() = 0.1 + 0.2;
  run.track(0, 0, 1).destination.reset();
  const Recording recording = recorded(run);
  std::ostringstream tracks, echoes;
  export_tracks_csv(recording, tracks);
  export_echoes_csv(recording, echoes);
  const std::string rows = tracks.str();
  EXPECT_EQ(std::ranges::count(rows, '\n'), 1 + 3 * 3 * 2);
  EXPECT_THAT(rows, StartsWith("tick,time_s,vehicle,id,x_m,"));
  EXPECT_THAT(rows, HasSubstr("\n0,0,auv_1,2147483649,0.30000000000000004,"));
  EXPECT_EQ(std::ranges::count(echoes.str(), '\n'), 1 + 2);
  EXPECT_THAT(echoes.str(), HasSubstr("\n2,0.2,auv_1," + number_text(run.echoes[6][0].range) + ','));

  const Recording blind = recorded(SampleRun{});
  EXPECT_THROW(export_tracks_csv(blind, tracks), InputError);
}

TEST(Echoes, AreACloudOfPointsInBodyAxes) {
  Bytes message;
  const std::array echoes{Echo{2.0, 0.0}, Echo{10.0, 0.5}};
  encode_echoes(message, Stamp{0}, "auv/base_link_fsd", echoes);
  std::vector<Echo> back;
  decode_echoes(message, back);
  EXPECT_THAT(back, ElementsAre(echoes[0], echoes[1]));

  // the last point, before is_dense: float32 x and y ahead and to starboard
  ByteReader point{ByteView{message}.last(33)};
  EXPECT_EQ(point.number<float>(), static_cast<float>(10.0 * std::cos(0.5)));
  EXPECT_EQ(point.number<float>(), static_cast<float>(10.0 * std::sin(0.5)));
  EXPECT_EQ(point.number<float>(), 0.0F);
}

}  // namespace
}  // namespace fairway
