// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <span>
#include <vector>

#include "fairway/experiment/progress.hpp"
#include "fairway/experiment/run.hpp"
#include "fairway/experiment/store.hpp"

namespace fairway {

/// Thrown by a run that was cut short on purpose: it is not stored, and is made another time.
struct RunAbandoned : std::exception {
  const char* what() const noexcept override { return "abandoned"; }
};

struct ExecutorOptions {
  unsigned jobs{0};                             ///< threads; 0 = as many as the machine has
  Progress* progress{nullptr};                  ///< told of every batch; may be null
  const std::atomic<bool>* stop{nullptr};       ///< no run is begun once it is true; may be null
  bool retry_failures{false};                   ///< make those again that are stored as failed
  std::size_t batch_runs{256};                  ///< stored together, at the latest …
  std::chrono::milliseconds batch_period{500};  ///< … so long after the first of them
  std::function<void()> stored;                 ///< called after each batch, by the thread that stored it
};

struct ExecutorReport {
  std::size_t present{};        ///< were stored before
  std::size_t made{};           ///< were stored now
  std::size_t failed{};         ///< of these, with a failure
  std::size_t failed_before{};  ///< of those that were stored before and were not made again
  bool stopped{};               ///< some are still missing, because `stop` was set
};

/// Makes the runs that the store does not have, on several threads, and stores them in batches from the
/// calling thread. `run(i)` makes specs[i] and is called by several threads at once. An exception from it
/// is stored as that run's failure and the others go on. What the store holds afterwards does not depend
/// on the number of threads. Once stopped, it waits for the runs in progress and stores them.
/// Throws InputError before anything is run if two specs share a key, and if the store cannot be written.
ExecutorReport run_missing(std::span<const RunSpec> specs,
                           const std::function<std::vector<Measure>(std::size_t)>& run, Store& store,
                           const ExecutorOptions& options = {});

}  // namespace fairway
