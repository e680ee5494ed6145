// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <thread>

#include "fairway/core/rng.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/experiment/testing/sample_runs.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;
constexpr std::size_t runs = 400;

/// A process that works on the store until it is killed or done.
template <class Work>
pid_t child(const Work& work) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    try {
      work();
      ::_exit(0);
    } catch (...) {
      ::_exit(1);
    }
  }
  return pid;
}

/// True if it was the signal that ended it.
bool kill_child(pid_t pid) {
  ::kill(pid, SIGKILL);
  int status = 0;
  ::waitpid(pid, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
  return WIFSIGNALED(status);
}

/// A number that parent and child share.
class SharedNumber {
 public:
  SharedNumber()
      : number_{::mmap(nullptr, sizeof(Number), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)} {
    if (number_ == MAP_FAILED) throw std::runtime_error("no shared memory");
  }
  ~SharedNumber() { ::munmap(number_, sizeof(Number)); }
  SharedNumber(const SharedNumber&) = delete;
  SharedNumber& operator=(const SharedNumber&) = delete;

  using Number = std::atomic<std::size_t>;
  Number& operator*() { return *static_cast<Number*>(number_); }

 private:
  void* number_;
};

/// Starts `work` on a store again and again, kills it after a random number of runs and a random moment
/// more, then finishes it by the executor.
void kill_and_resume(const std::function<void(Store&, SharedNumber::Number& made)>& work) {
  const auto specs = sample::specs(runs);
  Store whole = Store::in_memory();
  run_missing(specs, sample::measures, whole);
  const std::string expected = sample::csv_of(whole);

  Rng rng{7};
  int killed_midway = 0;
  for (int round = 0; round < 8; ++round) {
    const TemporaryFolder folder;
    const std::string file = folder.file("results.db");
    std::size_t kept = 0;
    for (int attempt = 0; attempt < 3; ++attempt) {
      SharedNumber made;
      const std::size_t target = 1 + rng.index(80);
      const auto more = std::chrono::duration<double, std::milli>(rng.uniform(0.0, 5.0));
      const pid_t pid = child([&] {
        Store store = Store::open(file);
        work(store, *made);
      });
      const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds{20};
      while (*made < target && std::chrono::steady_clock::now() < patience) {
        std::this_thread::sleep_for(std::chrono::microseconds{100});
      }
      std::this_thread::sleep_for(more);
      const bool killed = kill_child(pid);

      // whatever was stored before is still there, each run once
      Store store = Store::open(file);
      EXPECT_GE(store.size(), kept);
      EXPECT_LE(store.size(), runs);
      kept = store.size();
      killed_midway += killed && kept > 0 && kept < runs ? 1 : 0;
    }
    Store store = Store::open(file);
    std::atomic<std::size_t> calls{0};
    run_missing(
        specs, [&](std::size_t i) { return ++calls, sample::measures(i); }, store);
    EXPECT_EQ(calls, runs - kept);
    EXPECT_EQ(sample::csv_of(store), expected);
  }
  EXPECT_GE(killed_midway, 12) << "half of the kills must interrupt something";
}

TEST(KillTest, AnInterruptedCampaignResumesToTheSameBytes) {
  kill_and_resume([](Store& store, SharedNumber::Number& made) {
    const auto run = [&](std::size_t i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
      ++made;
      return sample::measures(i);
    };
    run_missing(sample::specs(runs), run, store,
                {.jobs = 3, .batch_runs = 8, .batch_period = std::chrono::milliseconds{20}});
  });
}

TEST(KillTest, AnInterruptedWriteResumesToTheSameBytes) {
  // nearly all of the time is spent in transactions
  kill_and_resume([](Store& store, SharedNumber::Number& made) {
    const auto records = sample::records(runs);
    for (std::size_t i = 0; i < runs; i += 4) {
      made += store.contains(records[i].spec.key) ? 0 : 4;
      store.put(std::span(records).subspan(i, 4));
    }
  });
}

TEST(KillTest, AWritersDeathFreesTheStore) {
  const TemporaryFolder folder;
  const std::string file = folder.file("results.db");
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t pid = child([&] {
    Store store = Store::open(file);
    store.put(sample::records(5));
    if (::write(ready[1], "x", 1) != 1) return;
    while (true) ::pause();
  });
  char byte{};
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  ::close(ready[0]);
  ::close(ready[1]);

  EXPECT_THAT(refusal_by([&] { Store::open(file); }), HasSubstr("another process is writing to it"));
  EXPECT_EQ(Store::open_existing(file).size(), 5U);

  EXPECT_TRUE(kill_child(pid));
  EXPECT_EQ(Store::open(file).size(), 5U);
}

}  // namespace
}  // namespace fairway
