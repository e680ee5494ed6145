// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "fairway/core/error.hpp"
#include "fairway/core/testing/allocations.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/core/text.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/mcap_reader.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/testing/sample_run.hpp"

namespace fairway {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::recorded;
using testing::SampleRun;

void expect_same(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.tick, b.tick);
  EXPECT_EQ(a.time, b.time);
  ASSERT_EQ(a.vehicles.size(), b.vehicles.size());
  for (std::size_t i = 0; i < a.vehicles.size(); ++i) {
    const auto difference = first_difference(a.vehicles[i], b.vehicles[i]);
    EXPECT_FALSE(difference) << difference->quantity << ": " << difference->a << " against " << difference->b;
  }
  EXPECT_EQ(frame_hash(a), frame_hash(b));
}

TEST(Recording, GivesBackEveryFrameToTheBit) {
  const SampleRun run;
  const Recording recording = recorded(run);
  ASSERT_EQ(recording.size(), run.size());
  for (std::size_t i = 0; i < run.size(); ++i) {
    expect_same(run.frame(i), recording.frame(i));
    EXPECT_EQ(recording.frame(i).period, run.info.period);
    EXPECT_EQ(recording.hashes()[i], frame_hash(run.frame(i)));
  }
}

TEST(Recording, KeepsExtremesAndTheSignOfZero) {
  SampleRun run;
  const std::array extremes{-0.0, DBL_MAX, -DBL_MAX, DBL_MIN, 4.9e-324, DBL_EPSILON, 0.1, 1e300};
  for (std::size_t i = 0; i < extremes.size(); ++i) {
    VehicleFrame& v = run.at(i / 3, i % 3);
    v.state.p_n = v.state.v_b = v.state.omega_b = v.goal = v.command.velocity = Vec3::Constant(extremes[i]);
    v.state.q_nb.coeffs().setConstant(extremes[i]);
    v.command.heading = v.power = v.goal_speed = extremes[i];
  }
  const Recording recording = recorded(run);
  for (std::size_t i = 0; i < run.size(); ++i) expect_same(run.frame(i), recording.frame(i));
  EXPECT_TRUE(std::signbit(recording.frame(0).vehicles[0].state.p_n.x()));
}

TEST(Recording, KeepsTheInfo) {
  SampleRun run{2};
  run.info.vehicles[1].name = "Søløve 2";
  const Recording recording = recorded(run);
  const RecordingInfo& info = recording.info();
  EXPECT_EQ(info.version, run.info.version);
  EXPECT_EQ(info.scenario_name, run.info.scenario_name);
  EXPECT_EQ(info.scenario_yaml, run.info.scenario_yaml);
  EXPECT_EQ(info.seed, run.info.seed);
  EXPECT_EQ(info.period, run.info.period);
  EXPECT_EQ(info.vehicles, run.info.vehicles);
  EXPECT_EQ(recording.stride(), 1);
}

TEST(Recording, ManyChunksAreReadInOrder) {
  const SampleRun run{20, 150};  // 3000 vehicle frames of about 1 kB in chunks of 1 MiB
  const Recording recording = recorded(run);
  ASSERT_EQ(recording.size(), run.size());
  for (std::size_t i = 0; i < run.size(); ++i) expect_same(run.frame(i), recording.frame(i));
}

TEST(Recording, MayHaveNoFramesAndNoVehicles) {
  EXPECT_EQ(recorded(SampleRun{3, 0}).size(), 0U);
  EXPECT_EQ(recorded(SampleRun{0, 0}).size(), 0U);
}

TEST(Recording, WithAStrideKeepsEveryNthFrame) {
  const SampleRun run{2, 10};
  const Recording recording = recorded(run, 4);
  ASSERT_EQ(recording.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_same(run.frame(4 * i), recording.frame(i));
    EXPECT_EQ(recording.frame(i).period, 4 * run.info.period);
  }
  EXPECT_EQ(recording.stride(), 4);
  EXPECT_EQ(recording.run_frame_count(), 10U);
  EXPECT_EQ(recording.run_hash(), recorded(run).run_hash());
}

TEST(Recording, MovesWithItsFrames) {
  const SampleRun run;
  Recording first = recorded(run);
  const Recording second = std::move(first);
  for (std::size_t i = 0; i < run.size(); ++i) expect_same(run.frame(i), second.frame(i));
}

TEST(RecordingWriter, GivesTheSameBytesForTheSameRun) {
  const SampleRun run{4, 100};
  EXPECT_EQ(testing::recorded_bytes(run), testing::recorded_bytes(run));
}

TEST(RecordingWriter, ShowsTheFileOnlyWhenItIsComplete) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.mcap");
  const auto files = [&] {
    return std::distance(std::filesystem::directory_iterator{folder.file(".")},
                         std::filesystem::directory_iterator{});
  };
  const SampleRun run;
  {
    RecordingWriter abandoned{path, run.info};
    abandoned.write(run.frame(0));
    EXPECT_EQ(files(), 1);  // a temporary one
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_EQ(files(), 0);

  RecordingWriter writer{path, run.info};
  writer.write(run.frame(0));
  EXPECT_FALSE(std::filesystem::exists(path));
  writer.close();
  writer.close();
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(files(), 1);
  EXPECT_TRUE(is_of_kind(path, recording_file));
}

TEST(RecordingWriter, OfARunThatWasStoppedSaysSoAndIsComparedAsFarAsItGoes) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.mcap");
  const SampleRun run;
  RecordingWriter writer{path, run.info};
  for (std::size_t i = 0; i < 3; ++i) writer.write(run.frame(i));
  writer.close({.stopped = true});
  const Recording recording = Recording::read(path);
  EXPECT_TRUE(recording.stopped());
  EXPECT_FALSE(recorded(run).stopped());

  HashChecker checker{recording};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FALSE(checker.is_over());
    checker.write(run.frame(i));
  }
  EXPECT_TRUE(checker.is_over());
  EXPECT_TRUE(checker.same());
  EXPECT_THAT(checker.describe(), ::testing::EndsWith("; the recorded run was stopped there"));
}

TEST(RecordingWriter, RefusesWhatItCannotWrite) {
  const TemporaryFolder folder;
  const SampleRun run;
  const SampleRun other{2};
  EXPECT_THROW(RecordingWriter(folder.file("missing/run.mcap"), run.info), InputError);
  EXPECT_THROW(RecordingWriter(folder.file("run.mcap"), run.info, 0), InputError);
  RecordingWriter writer{folder.file("run.mcap"), run.info};
  EXPECT_THROW(writer.write(other.frame(0)), InputError);
  writer.write(run.frame(1));
  EXPECT_THROW(writer.write(run.frame(1)), InputError);
  writer.close();
  EXPECT_THROW(writer.write(run.frame(2)), InputError);
}

TEST(RecordingWriter, RefusesWhatNobodyCouldRead) {
  const TemporaryFolder folder;
  const auto refusal = [&](const RecordingInfo& info) {
    return refusal_by([&] { RecordingWriter{folder.file("run.mcap"), info}; });
  };
  RecordingInfo info = SampleRun{}.info;
  for (const double period : {0.0, -1.0, std::nan("")}) {
    info.period = period;
    EXPECT_EQ(refusal(info), "period_s: is " + number_text(period) + "; expected a positive number");
  }
  info.period = 0.1;
  info.scenario_name = "caf\xE9";
  EXPECT_EQ(refusal(info), "scenario: is not UTF-8; expected text in that encoding");

  testing::SketchingRun run;
  run.stroke(0, 1, 0).meaning = "\xFF";
  EXPECT_THAT(refusal_by([&] { run.record(folder.file("run.mcap")); }),
              HasSubstr("a stroke whose meaning is not UTF-8 cannot be recorded"));
}

TEST(RecordingWriter, DoesNotAllocateOnceItsBuffersHaveGrown) {
  const TemporaryFolder folder;
  const SampleRun run{4, 1000};
  RecordingWriter writer{folder.file("run.mcap"), run.info};
  // the first chunk of 1 MiB, at about 4 kB a frame, is written before frame 500
  for (std::size_t i = 0; i < 500; ++i) writer.write(run.frame(i));
  long allocated = 0, frames = 0;
  for (std::size_t i = 500; i < 1000; ++i) {
    const long before = allocation_count();
    writer.write(run.frame(i));
    const long after = allocation_count();
    allocated += after - before;
    frames += after == before ? 1 : 0;
  }
  // what is left are the entries that each chunk adds to the summary
  EXPECT_LE(allocated, 4);
  EXPECT_GE(frames, 496);
}

TEST(TopicNames, AreWhatRosAccepts) {
  EXPECT_THAT(topic_names({{VehicleId{0}, "auv_1", ""},
                           {VehicleId{1}, "asv-1", ""},
                           {VehicleId{2}, "asv 1", ""},
                           {VehicleId{3}, "", ""},
                           {VehicleId{4}, "7seas", ""},
                           {VehicleId{5}, "vehicle_4", ""}}),
              ElementsAre("auv_1", "asv_1", "vehicle_2", "vehicle_3", "vehicle_4", "vehicle_5"));
}

TEST(TopicNames, OfAWholeFleetAreFoundWithoutComparingAll) {
  std::vector<RecordingInfo::Vehicle> fleet(100'000, {VehicleId{0}, "auv", ""});
  const std::vector<std::string> names = topic_names(fleet);
  EXPECT_EQ(names.front(), "auv");
  EXPECT_EQ(names.back(), "vehicle_99999");
}

TEST(RecordingWriter, RefusesMoreVehiclesThanThereIsRoomFor) {
  const TemporaryFolder folder;
  RecordingInfo info;
  info.vehicles.resize(100'000);
  const auto refusal = [&] { RecordingWriter{folder.file("r.mcap"), info, 1}; };
  EXPECT_THAT(refusal_by(refusal),
              HasSubstr("r.mcap: cannot hold 100000 vehicles; with what is recorded of each it has room for "
                        "32500"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("r.mcap")));
}

TEST(FrameHash, ChangesWithAnyBit) {
  SampleRun run{2, 1};
  const std::uint64_t original = frame_hash(run.frame(0));
  const auto differs = [&] { return frame_hash(run.frame(0)) != original; };

  // every bit of every number
  VehicleFrame& v = run.at(0, 1);
  v.command.heading = 1.0;
  const std::uint64_t with_heading = frame_hash(run.frame(0));
  std::vector<double*> numbers{&*v.command.heading, &v.goal_speed, &v.power, run.actuators[1].data()};
  for (Vec3* vector : {&v.state.p_n, &v.state.v_b, &v.state.omega_b, &v.command.velocity, &v.goal}) {
    for (Eigen::Index k = 0; k < 3; ++k) numbers.push_back(&(*vector)[k]);
  }
  for (Eigen::Index k = 0; k < 4; ++k) numbers.push_back(&v.state.q_nb.coeffs()[k]);
  for (double* number : numbers) {
    for (unsigned bit = 0; bit < 64; ++bit) {
      const double kept = *number;
      *number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(kept) ^ (std::uint64_t{1} << bit));
      EXPECT_NE(frame_hash(run.frame(0)), with_heading) << bit;
      *number = kept;
    }
  }

  // and what is discrete
  SampleRun fresh{2, 1};
  VehicleFrame& w = run.at(0, 1);
  const VehicleFrame kept = fresh.at(0, 1);
  const auto restore = [&] {
    const auto actuators = w.actuators;
    w = kept;
    w.actuators = actuators;
  };
  restore();
  ASSERT_EQ(frame_hash(run.frame(0)), original);
  w.id = VehicleId{77};
  EXPECT_TRUE(differs());
  restore();
  w.phase = w.phase == Phase::arrived ? Phase::waiting : Phase::arrived;
  EXPECT_TRUE(differs());
  restore();
  w.command.mode = w.command.mode == Mode::hold ? Mode::avoid : Mode::hold;
  EXPECT_TRUE(differs());
  restore();
  w.command.astern = !w.command.astern;
  EXPECT_TRUE(differs());
  restore();
  w.command.heading.reset();
  const std::uint64_t without = frame_hash(run.frame(0));
  w.command.heading = 0.0;
  EXPECT_NE(frame_hash(run.frame(0)), without);
  restore();
  w.actuators = w.actuators.first(0);
  EXPECT_TRUE(differs());

  // two signs turned do not cancel
  SampleRun turned{2, 1};
  turned.at(0, 0).state.p_n = -turned.at(0, 0).state.p_n;
  EXPECT_NE(frame_hash(turned.frame(0)), original);
  Frame late = fresh.frame(0);
  late.tick = Tick{1};
  EXPECT_NE(frame_hash(late), original);
}

}  // namespace
}  // namespace fairway
