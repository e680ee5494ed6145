// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/executor.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <tuple>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

using Clock = std::chrono::steady_clock;
using Run = std::function<std::vector<Measure>(std::size_t)>;

// how late a stop may be noticed
constexpr std::chrono::milliseconds watch_period{50};

void refuse_duplicates(std::span<const RunSpec> specs) {
  std::vector<std::size_t> order(specs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(specs[a].key, a) < std::tie(specs[b].key, b);
  });
  const auto same = [&](std::size_t a, std::size_t b) { return specs[a].key == specs[b].key; };
  const auto twice = std::adjacent_find(order.begin(), order.end(), same);
  if (twice == order.end()) return;
  const auto text = [&](std::size_t i) {
    return labels_text(specs[i].labels) + " seed=" + std::to_string(specs[i].seed);
  };
  throw InputError("the same run is asked for twice: " + text(twice[0]) + " and " + text(twice[1]));
}

/// Why the measures cannot be stored, or empty.
std::string fault_of(const std::vector<Measure>& measures) {
  std::set<std::pair<int, std::string_view>> measured;
  for (const Measure& m : measures) {
    if (!measured.emplace(m.vehicle, m.quantity).second)
      return m.quantity + " was measured twice for one vehicle";
  }
  return "";
}

/// One run with its clock and its failure; nothing if it was abandoned.
std::optional<RunRecord> make(const RunSpec& spec, std::size_t index, const Run& run) {
  RunRecord record{.spec = spec, .measures = {}, .wall_s = 0.0, .failure = {}};
  const auto began = Clock::now();
  try {
    record.measures = run(index);
    record.failure = fault_of(record.measures);
  } catch (const RunAbandoned&) {
    return {};
  } catch (const std::exception& error) {
    record.failure = error.what();
    if (record.failure.empty()) record.failure = "failed without a message";
  } catch (...) {
    record.failure = "failed with an exception of unknown type";
  }
  if (!record.failure.empty()) record.measures.clear();
  record.wall_s = std::chrono::duration<double>(Clock::now() - began).count();
  return record;
}

/// What the threads hand to the writer.
class Outbox {
 public:
  explicit Outbox(std::size_t threads) : working_{threads} {}

  void add(RunRecord record) {
    const std::lock_guard guard{mutex_};
    records_.push_back(std::move(record));
    changed_.notify_one();
  }

  void leave() {
    const std::lock_guard guard{mutex_};
    --working_;
    changed_.notify_one();
  }

  /// Moves what is there to the end of `batch`; waits for something until `until`. False once every
  /// thread has left and nothing remains.
  bool collect(std::vector<RunRecord>& batch, Clock::time_point until) {
    std::unique_lock guard{mutex_};
    changed_.wait_until(guard, until, [&] { return !records_.empty() || working_ == 0; });
    std::move(records_.begin(), records_.end(), std::back_inserter(batch));
    records_.clear();
    return working_ > 0;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<RunRecord> records_;
  std::size_t working_;
};

struct StopAll {
  std::vector<std::jthread>& threads;
  ~StopAll() {
    for (std::jthread& thread : threads) thread.request_stop();
  }
};

}  // namespace

ExecutorReport run_missing(std::span<const RunSpec> specs, const Run& run, Store& store,
                           const ExecutorOptions& options) {
  refuse_duplicates(specs);
  std::vector<std::size_t> missing;
  std::size_t failed_before = 0;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const Store::Status status = store.status(specs[i].key);
    const bool again = status == Store::Status::failed && options.retry_failures;
    if (status == Store::Status::missing || again) missing.push_back(i);
    failed_before += status == Store::Status::failed && !again ? 1 : 0;
  }
  ProgressCount count{.total = specs.size(), .present = specs.size() - missing.size()};
  if (options.progress != nullptr) options.progress->begin(count);

  const auto stopped = [&] {
    return options.stop != nullptr && options.stop->load(std::memory_order_relaxed);
  };
  const std::size_t wanted =
      options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  const std::size_t threads = std::min(wanted, missing.size());
  Outbox outbox{threads};
  std::atomic<std::size_t> next{0};

  // left by an exception, all are told to stop before any is waited for
  std::vector<std::jthread> pool;
  const StopAll stop_all{pool};
  for (std::size_t t = 0; t < threads; ++t) {
    pool.emplace_back([&](const std::stop_token& abort) {
      while (!abort.stop_requested() && !stopped()) {
        const std::size_t place = next.fetch_add(1, std::memory_order_relaxed);
        if (place >= missing.size()) break;
        const std::size_t index = missing[place];
        if (auto record = make(specs[index], index, run)) outbox.add(std::move(*record));
      }
      outbox.leave();
    });
  }

  // this thread alone writes
  std::vector<RunRecord> batch;
  Clock::time_point due{};
  for (bool working = threads > 0; working;) {
    const std::size_t before = batch.size();
    working = outbox.collect(batch, Clock::now() + watch_period);
    if (before == 0 && !batch.empty()) due = Clock::now() + options.batch_period;
    const bool full = batch.size() >= options.batch_runs || Clock::now() >= due;
    if (!batch.empty() && (full || !working || stopped())) {
      store.put(batch);
      count.made += batch.size();
      count.failed += static_cast<std::size_t>(
          std::count_if(batch.begin(), batch.end(), [](const RunRecord& r) { return !r.failure.empty(); }));
      batch.clear();
      if (options.stored) options.stored();
    }
    if (options.progress != nullptr) options.progress->update(count);
  }
  if (options.progress != nullptr) options.progress->end(count);
  return {.present = count.present,
          .made = count.made,
          .failed = count.failed,
          .failed_before = failed_before,
          .stopped = count.present + count.made < count.total};
}

}  // namespace fairway
