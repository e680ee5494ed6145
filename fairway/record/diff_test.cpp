// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/diff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "fairway/core/text.hpp"
#include "fairway/record/csv.hpp"
#include "fairway/record/hash_checker.hpp"
#include "fairway/record/quantities.hpp"
#include "fairway/record/testing/sample_run.hpp"

namespace fairway {
namespace {

using testing::checked;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::recorded;
using testing::SampleRun;

TEST(Diff, OfARunWithItselfIsNone) {
  const SampleRun run;
  const Difference d = diff(recorded(run), recorded(run));
  EXPECT_TRUE(d.same());
  EXPECT_THAT(d.setup, IsEmpty());
  EXPECT_EQ(d.describe(), "5 common frames, the same to the bit\n");
}

TEST(Diff, NamesTheFirstQuantityAndTheFarthestPosition) {
  const SampleRun a;
  SampleRun b;
  b.at(2, 1).command.mode = a.frame(2).vehicles[1].command.mode == Mode::hold ? Mode::cruise : Mode::hold;
  b.at(3, 0).state.p_n += Vec3{0.0, 0.0, 3.0};
  b.at(4, 2).state.p_n += Vec3{0.0, 1.0, 0.0};
  const Difference d = diff(recorded(a), recorded(b));
  EXPECT_FALSE(d.same());
  ASSERT_TRUE(d.first);
  EXPECT_EQ(d.first->tick, Tick{2});
  EXPECT_EQ(d.first->vehicle, "auv_2");
  EXPECT_EQ(d.first->quantity, "mode");
  EXPECT_NE(d.first->a, d.first->b);
  ASSERT_TRUE(d.farthest);
  EXPECT_EQ(d.farthest->tick, Tick{3});
  EXPECT_EQ(d.farthest->vehicle, "auv_1");
  EXPECT_NEAR(d.farthest->distance, 3.0, 1e-12);
  EXPECT_THAT(d.describe(), HasSubstr("first difference at tick 2 (0.2 s): auv_2 mode: "));
}

TEST(Diff, TellsATimeWithoutTheLastDigitsOfItsRounding) {
  EXPECT_EQ(instant_text(Tick{1111}, 1111 * 0.05), "tick 1111 (55.55 s)");
  EXPECT_NE(number_text(1111 * 0.05), "55.55");
}

TEST(Diff, SeesTheLastBit) {
  const SampleRun a;
  SampleRun b;
  double& x = b.at(4, 2).state.p_n.x();
  x = std::nextafter(x, 1e9);
  const Difference d = diff(recorded(a), recorded(b));
  ASSERT_TRUE(d.first);
  EXPECT_EQ(d.first->quantity, "x_m");
  EXPECT_EQ(d.first->b, number_text(x));

  SampleRun c;
  c.actuators[14][1] = -c.actuators[14][1];
  EXPECT_EQ(diff(recorded(a), recorded(c)).first->quantity, "actuator_1");
}

TEST(Diff, ComparesCommonTicksAndCountsTheOthers) {
  const SampleRun run{3, 10};
  const SampleRun shorter{3, 8};
  const Difference d = diff(recorded(run), recorded(shorter));
  EXPECT_FALSE(d.same());
  EXPECT_FALSE(d.first);
  EXPECT_EQ(d.compared, 8U);
  EXPECT_EQ(d.only_in_a, 2U);
  EXPECT_THAT(d.describe(), HasSubstr("only in the first: 2 frames"));
  const Difference strided = diff(recorded(run, 3), recorded(run));
  EXPECT_EQ(strided.compared, 4U);
  EXPECT_EQ(strided.only_in_b, 6U);
  EXPECT_FALSE(strided.first);
}

TEST(Diff, TellsASetupThatIsNotTheSame) {
  const SampleRun a;
  SampleRun b;
  b.info.seed = 7;
  b.info.vehicles[0].model = "zarco";
  const Difference d = diff(recorded(a), recorded(b));
  EXPECT_TRUE(d.same());
  EXPECT_THAT(d.setup,
              ElementsAre("seed: 18446744073709551615 against 7", "vehicles[0].model: otter against zarco"));
  EXPECT_FALSE(diff(recorded(a), recorded(SampleRun{2})).same());
}

TEST(Csv, HasARowPerVehicleAndFrameThatReadsBackToTheBit) {
  SampleRun run{3, 2};
  run.info.vehicles[1].name = "a,\"b\"";
  run.at(0, 0).command.heading.reset();
  run.at(0, 0).state.p_n.x() = 0.1 + 0.2;
  std::ostringstream out;
  export_csv(recorded(run), out);
  std::istringstream lines{out.str()};
  std::string header, first, second, line;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_EQ(
      header,
      "tick,time_s,vehicle,id,phase,x_m,y_m,z_m,qw_ratio,qx_ratio,qy_ratio,qz_ratio,roll_rad,pitch_rad,yaw_"
      "rad,u_mps,v_mps,w_mps,p_radps,q_radps,r_radps,goal_n_m,goal_e_m,goal_d_m,goal_speed_mps,command_n_mps,"
      "command_e_mps,command_d_mps,command_heading_rad,command_turn_rate_radps,command_force_x_n,command_"
      "force_y_n,command_force_z_n,command_moment_k_nm,command_moment_m_nm,command_moment_n_nm,mode,astern,"
      "power_w,force_x_n,force_y_n,force_z_n,moment_k_nm,moment_m_nm,moment_n_nm,actuator_0,actuator_1");
  EXPECT_THAT(first, ::testing::StartsWith("0,0,auv_1,1,"));
  EXPECT_THAT(first, HasSubstr(",0.30000000000000004,"));
  EXPECT_THAT(second, ::testing::StartsWith("0,0,\"a,\"\"b\"\"\",2,"));
  EXPECT_EQ(std::ranges::count(first, ','), std::ranges::count(header, ','));
  int rows = 2;
  while (std::getline(lines, line)) ++rows;
  EXPECT_EQ(rows, 6);
}

TEST(HashChecker, AgreesWithTheSameRunAtAnyStride) {
  const SampleRun run{3, 10};
  for (const std::int64_t stride : {1, 3, 20}) {
    const Recording recording = recorded(run, stride);
    const HashChecker checker = checked(recording, run);
    EXPECT_TRUE(checker.same()) << checker.describe();
    EXPECT_EQ(checker.matched(), recording.size());
    EXPECT_THAT(checker.describe(), ::testing::StartsWith("the same to the bit: "));
  }
}

TEST(HashChecker, RemembersTheFirstMismatch) {
  const SampleRun run;
  const Recording recording = recorded(run);
  SampleRun now;
  now.at(1, 2).state.v_b.y() = 7.0;
  now.at(3, 0).power = 1.0;
  const HashChecker checker = checked(recording, now);
  EXPECT_FALSE(checker.same());
  ASSERT_TRUE(checker.first_mismatch());
  EXPECT_EQ(checker.first_mismatch()->tick, Tick{1});
  EXPECT_EQ(checker.first_mismatch()->expected, recording.hashes()[1]);
  EXPECT_EQ(checker.matched(), 3U);
  EXPECT_THAT(checker.describe(), HasSubstr("differs from tick 1 (0.1 s): auv_3 v_mps: "));
  EXPECT_THAT(checker.describe(), HasSubstr("was recorded, now 7"));
}

TEST(HashChecker, SeesAnotherTimeAndAnotherPeriod) {
  const SampleRun run{2, 4};
  const Recording recording = recorded(run, 2);
  const auto verdict_on = [&](double later, double period) {
    HashChecker checker{recording};
    for (std::size_t i = 0; i < run.size(); ++i) {
      Frame frame = run.frame(i);
      frame.time += later;
      frame.period = period;
      checker.write(frame);
    }
    return checker.describe();
  };
  EXPECT_THAT(verdict_on(0.0, 0.1), ::testing::StartsWith("the same to the bit: 2 of 2"));
  EXPECT_THAT(verdict_on(1.0, 0.1), HasSubstr("differs from tick 0 (1 s): time_s: 0 was recorded, now 1"));
  EXPECT_THAT(verdict_on(0.0, 0.5), HasSubstr("period_s: 0.2 was recorded, now 1"));
}

TEST(HashChecker, SeesARunOfAnotherLengthAndFramesBetweenTheRecordedOnes) {
  const SampleRun run{2, 10};
  const Recording recording = recorded(run, 4);
  const HashChecker early = checked(recording, run, 9);
  EXPECT_FALSE(early.same());
  EXPECT_FALSE(early.first_mismatch());
  EXPECT_EQ(early.describe(), "another length: 10 frames were run, now 9");

  SampleRun now{2, 10};
  now.at(5, 0).power += 1.0;
  const HashChecker between = checked(recording, now);
  EXPECT_FALSE(between.same());
  EXPECT_EQ(between.describe(), "differs between the recorded frames, of which 3 of 3 match");
}

}  // namespace
}  // namespace fairway
