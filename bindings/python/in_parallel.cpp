// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/in_parallel.hpp"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace fairway::python {
namespace {

namespace py = pybind11;

/// The threads and what they have come to.
class Workers {
 public:
  Workers(std::size_t count, std::atomic<bool>& stop, const std::function<void(std::size_t)>& work)
      : count_{count}, stop_{stop}, work_{work} {}

  /// As many as the machine gives; throws std::system_error where it gives none.
  void start(unsigned jobs) {
    threads_.reserve(jobs);
    while (threads_.size() < jobs) {
      begin();
      try {
        threads_.emplace_back([this] { toil(); });
      } catch (const std::system_error&) {
        end();
        if (threads_.empty()) throw;
        break;
      }
    }
  }

  /// True once no thread is at work any more; false after `period` at the latest.
  bool await(std::chrono::milliseconds period) {
    std::unique_lock lock{mutex_};
    return finished_.wait_for(lock, period, [this] { return running_ == 0; });
  }

  void join() {
    for (std::thread& thread : threads_) thread.join();
  }

  std::size_t done() const { return done_.load(std::memory_order_relaxed); }
  const std::exception_ptr& failure() const { return failure_; }

 private:
  void begin() {
    const std::lock_guard lock{mutex_};
    ++running_;
  }
  void end() {
    const std::lock_guard lock{mutex_};
    if (--running_ == 0) finished_.notify_all();
  }

  void toil() {
    try {
      while (!stop_.load(std::memory_order_relaxed)) {
        const std::size_t i = next_.fetch_add(1, std::memory_order_relaxed);
        if (i >= count_) break;
        work_(i);
        done_.fetch_add(1, std::memory_order_relaxed);
      }
    } catch (...) {
      stop_ = true;
      const std::lock_guard lock{mutex_};
      if (!failure_) failure_ = std::current_exception();
    }
    end();
  }

  std::size_t count_;
  std::atomic<bool>& stop_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
  std::condition_variable finished_;
  unsigned running_{0};
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace

void in_parallel(std::size_t count, unsigned jobs, std::atomic<bool>& stop,
                 const std::function<void(std::size_t)>& work,
                 const std::function<void(std::size_t done)>& tell) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  jobs = static_cast<unsigned>(std::min<std::size_t>(jobs == 0 ? cores : std::min(jobs, cores), count));
  Workers workers{count, stop, work};
  std::exception_ptr raised;
  {
    const py::gil_scoped_release unlocked;
    workers.start(jobs);
    while (!workers.await(std::chrono::milliseconds{50})) {
      if (raised) continue;
      const py::gil_scoped_acquire locked;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (tell) tell(workers.done());
      } catch (...) {
        raised = std::current_exception();
        stop = true;
      }
    }
    workers.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (workers.failure()) std::rethrow_exception(workers.failure());
  if (tell) tell(workers.done());
}

}  // namespace fairway::python
