// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/executor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <thread>

#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;

TEST(ExecutorTest, AnyNumberOfThreadsLeavesTheSameBytes) {
  const auto specs = sample::specs(200);
  std::string expected;
  for (const unsigned jobs : {1U, 2U, 8U, 0U}) {
    for (const std::size_t batch : {1U, 7U, 1000U}) {
      Store store = Store::in_memory();
      const auto report = run_missing(specs, sample::measures, store, {.jobs = jobs, .batch_runs = batch});
      EXPECT_EQ(report.made, specs.size());
      EXPECT_FALSE(report.stopped);
      if (expected.empty()) expected = sample::csv_of(store);
      EXPECT_EQ(sample::csv_of(store), expected);
    }
  }
  EXPECT_THAT(expected, HasSubstr("cube20_8,orca3d,99,1,navigation_time_s,"));
}

TEST(ExecutorTest, OnlyMissingRunsAreMade) {
  const auto specs = sample::specs(50);
  Store store = Store::in_memory();
  store.put(sample::records(20));
  std::atomic<int> calls{0};
  const auto report =
      run_missing(specs, [&](std::size_t i) { return ++calls, sample::measures(i); }, store, {.jobs = 4});
  EXPECT_EQ(calls, 30);
  EXPECT_EQ(report.present, 20U);
  EXPECT_EQ(report.made, 30U);
  EXPECT_EQ(run_missing(specs, sample::measures, store).made, 0U);
}

TEST(ExecutorTest, RunsInAsManyThreadsAsItIsTold) {
  // each run waits until three are in progress at once
  std::atomic<int> inside{0};
  std::atomic<bool> met{false};
  Store store = Store::in_memory();
  run_missing(sample::specs(3),
              [&](std::size_t i) {
                if (++inside == 3) met = true;
                for (int wait = 0; wait < 5000 && !met; ++wait)
                  std::this_thread::sleep_for(std::chrono::milliseconds{1});
                return sample::measures(i);
              },
              store, {.jobs = 3});
  EXPECT_TRUE(met);
}

TEST(ExecutorTest, OneRunsFailureIsItsOwn) {
  const auto run = [](std::size_t i) -> std::vector<Measure> {
    if (i == 3) throw std::runtime_error("diverged at 12 s");
    if (i == 4) throw 4;  // NOLINT: whatever a run may throw
    if (i == 5) return {{"x_m", 0, 1.0}, {"x_m", 0, 2.0}};
    return sample::measures(i);
  };
  const auto specs = sample::specs(20);
  Store store = Store::in_memory();
  const auto report = run_missing(specs, run, store, {.jobs = 4});
  EXPECT_EQ(report.made, 20U);
  EXPECT_EQ(report.failed, 3U);
  EXPECT_FALSE(report.stopped);
  for (const RunRecord& record : store.all()) {
    const bool bad = record.spec.key == "run3" || record.spec.key == "run4" || record.spec.key == "run5";
    EXPECT_EQ(record.measures.empty(), bad);
    EXPECT_EQ(record.failure.empty(), !bad);
    if (record.spec.key == "run3") {
      EXPECT_EQ(record.failure, "diverged at 12 s");
    }
  }
  // a failure is a result too, unless it is asked to be tried again
  EXPECT_EQ(run_missing(specs, sample::measures, store).made, 0U);
  EXPECT_EQ(run_missing(specs, sample::measures, store, {.retry_failures = true}).made, 3U);
  Store whole = Store::in_memory();
  run_missing(specs, sample::measures, whole);
  EXPECT_EQ(sample::csv_of(store), sample::csv_of(whole));
}

TEST(ExecutorTest, TheSameRunTwiceIsRefusedBeforeAnythingIsRun) {
  auto specs = sample::specs(4);
  specs[3].key = specs[1].key;
  Store store = Store::in_memory();
  EXPECT_THAT(refusal_by([&] { run_missing(specs, sample::measures, store); }),
              HasSubstr("case=cube20_8 method=orca3d seed=0 and case=cube20_8 method=orca3d seed=1"));
  EXPECT_EQ(store.size(), 0U);
}

std::atomic<bool> interrupted{false};

TEST(ExecutorTest, CtrlCLeavesAUsableStoreThatIsContinued) {
  const TemporaryFolder folder;
  const auto specs = sample::specs(100);
  Store whole = Store::in_memory();
  run_missing(specs, sample::measures, whole);

  const auto before = std::signal(SIGINT, [](int) { interrupted = true; });
  {
    Store store = Store::open(folder.file("results.db"));
    const auto run = [](std::size_t i) {
      if (i == 30) std::raise(SIGINT);
      return sample::measures(i);
    };
    const auto report = run_missing(specs, run, store, {.jobs = 2, .stop = &interrupted});
    EXPECT_TRUE(report.stopped);
    EXPECT_GE(report.made, 30U);
    EXPECT_LT(report.made, 100U);
    EXPECT_EQ(store.size(), report.made);
  }
  std::signal(SIGINT, before);

  Store store = Store::open(folder.file("results.db"));
  const std::size_t kept = store.size();
  const auto report = run_missing(specs, sample::measures, store);
  EXPECT_EQ(report.present, kept);
  EXPECT_FALSE(report.stopped);
  EXPECT_EQ(sample::csv_of(store), sample::csv_of(whole));
}

TEST(ExecutorTest, ARunThatWasCutShortIsNotStored) {
  Store store = Store::in_memory();
  const auto run = [](std::size_t i) -> std::vector<Measure> {
    if (i == 2) throw RunAbandoned{};
    return sample::measures(i);
  };
  const auto report = run_missing(sample::specs(5), run, store);
  EXPECT_EQ(report.made, 4U);
  EXPECT_TRUE(report.stopped);
  EXPECT_FALSE(store.contains("run2"));
}

TEST(ExecutorTest, AStoreThatCannotBeWrittenStopsTheThreads) {
  const TemporaryFolder folder;
  { Store::open(folder.file("results.db")); }
  Store reader = Store::open_existing(folder.file("results.db"));
  EXPECT_THROW(run_missing(sample::specs(1000), sample::measures, reader, {.jobs = 4, .batch_runs = 1}),
               std::logic_error);
}

TEST(ExecutorTest, FinishedRunsAreStoredWhileALongOneGoesOn) {
  const TemporaryFolder folder;
  Store store = Store::open(folder.file("results.db"));
  const auto specs = sample::specs(10);
  std::atomic<bool> seen{false};
  const auto run = [&](std::size_t i) {
    // the first run lasts until a reader has found the others in the file
    for (int wait = 0; i == 0 && wait < 500 && !seen; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
      seen = Store::open_existing(folder.file("results.db")).size() == 9;
    }
    return sample::measures(i);
  };
  run_missing(specs, run, store,
              {.jobs = 2, .batch_runs = 1000, .batch_period = std::chrono::milliseconds{100}});
  EXPECT_TRUE(seen);
  EXPECT_EQ(store.size(), 10U);
}

}  // namespace
}  // namespace fairway
