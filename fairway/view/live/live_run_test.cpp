// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/live/live_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "fairway/view/live/testing/sample_frames.hpp"

namespace fairway {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using testing::SampleFrames;

const std::atomic<bool> never{false};

TEST(LiveRun, AtNoSpeedStepsAreDueAtOnce) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 0.0}};
  const auto begin = Clock::now();
  for (int k = 0; k < 1000; ++k) {
    ASSERT_TRUE(run.await_turn(k * 3600.0, never));
    run.write(frames.at(k));
  }
  EXPECT_LT(Clock::now() - begin, 5s);
}

TEST(LiveRun, KeepsToTheClockTimesItsSpeed) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 20.0}};
  run.write(frames.at(0));
  ASSERT_TRUE(run.await_turn(0.1, never));  // from here on
  const auto begin = Clock::now();
  for (int k = 2; k <= 21; ++k) ASSERT_TRUE(run.await_turn(0.1 * k, never));
  EXPECT_GE(Clock::now() - begin, 100ms);  // 2 s of the run
  EXPECT_LT(Clock::now() - begin, 2s);
}

TEST(LiveRun, AtNextToNoSpeedTheNextStepIsNotDue) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 1e-300}};
  run.write(frames.at(0));
  ASSERT_TRUE(run.await_turn(0.1, never));  // from here on
  std::atomic<bool> stop{false};
  const std::jthread stopping{[&] {
    std::this_thread::sleep_for(100ms);
    stop = true;
  }};
  EXPECT_FALSE(run.await_turn(0.2, stop));
}

TEST(LiveRun, WhatItFellBehindIsNotMadeUpForInARush) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 10.0}};
  run.write(frames.at(0));
  ASSERT_TRUE(run.await_turn(0.1, never));
  std::this_thread::sleep_for(600ms);  // 6 s of the run
  const auto begin = Clock::now();
  for (int k = 2; k <= 12; ++k) ASSERT_TRUE(run.await_turn(0.1 * k, never));
  EXPECT_GE(Clock::now() - begin, 95ms);  // 1 s of the run
}

TEST(LiveRun, BegunPausedItShowsOneFrameAndWaitsUntilItIsStopped) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 0.0, .paused = true}};
  ASSERT_TRUE(run.await_turn(0.0, never));
  run.write(frames.at(0));

  std::atomic<bool> stop{false};
  std::jthread stopping{[&] {
    std::this_thread::sleep_for(30ms);
    stop = true;
  }};
  EXPECT_FALSE(run.await_turn(0.1, stop));
}

TEST(LiveRun, EachStepAskedForWhilePausedIsMadeOnceAndResumingForgetsTheRest) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 0.0}};
  run.write(frames.at(0));
  EXPECT_FALSE(run.step());  // not paused
  run.pause();
  EXPECT_TRUE(run.step());
  EXPECT_TRUE(run.step());
  EXPECT_TRUE(run.await_turn(0.1, never));
  EXPECT_TRUE(run.await_turn(0.2, never));
  EXPECT_TRUE(run.step());
  run.resume();
  run.pause();
  std::atomic<bool> stop{false};
  std::jthread stopping{[&] {
    std::this_thread::sleep_for(30ms);
    stop = true;
  }};
  EXPECT_FALSE(run.await_turn(0.3, stop));
  run.finish();
  EXPECT_FALSE(run.step());
}

TEST(LiveRun, ItsStateIsThatOfTheNewestFrame) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 4.0, .paused = true}};
  const auto before = run.part(0, 0);
  EXPECT_TRUE(before["part"].is_null());
  EXPECT_EQ(before["state"].dump(),
            R"({"divergence":"","done":false,"paused":true,"speed":4.0,"time_s":0.0})");
  run.write(frames.at(5));
  run.finish("diverged: robot0 at 0.6 s");
  EXPECT_EQ(
      run.part(0, 0)["state"].dump(),
      R"({"divergence":"diverged: robot0 at 0.6 s","done":true,"paused":false,"speed":4.0,"time_s":0.5})");
}

TEST(LiveRun, APartThatDoesNotFollowOnWhatThereIsBeginsAtTheBeginning) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {}, {.vehicle_frames = 8}};
  for (int k = 0; k < 5; ++k) run.write(frames.at(k));
  EXPECT_EQ(run.part(3, 0)["part"]["first"], 3);
  EXPECT_EQ(run.part(3, 0)["part"]["count"], 2);
  EXPECT_TRUE(run.part(5, 0)["part"].is_null());
  EXPECT_EQ(run.part(6, 0)["part"]["first"], 0);  // of another run
  for (int k = 5; k < 20; ++k) run.write(frames.at(k));
  const auto thinned = run.part(5, 0)["part"];
  EXPECT_EQ(thinned["first"], 0);
  EXPECT_GT(thinned["generation"].get<int>(), 0);
}

TEST(LiveRun, WhoeverReadsWhileItIsMadeGetsEveryFrameOnceAndInOrder) {
  const SampleFrames frames;
  LiveRun run{frames.scenario, {.speed = 0.0}};
  constexpr int count = 3000;
  std::jthread making{[&] {
    for (int k = 0; k < count; ++k) {
      run.await_turn(0.1 * k, never);
      run.write(frames.at(k));
    }
    run.finish();
  }};
  std::size_t have = 0;
  for (bool done = false; !done || have < count;) {
    const auto answer = run.part(have, 0);
    done = answer["state"]["done"];
    const auto& part = answer["part"];
    if (part.is_null()) {
      ASSERT_TRUE(!done || have == count) << "only " << have << " frames";
      continue;
    }
    ASSERT_EQ(part["first"], have);
    ASSERT_LE(part["count"], LiveRun::most_frames);
    have += part["count"].get<std::size_t>();
  }
  EXPECT_EQ(have, count);
}

}  // namespace
}  // namespace fairway
