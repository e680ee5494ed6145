// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/tracker/assignment.hpp"

#include <algorithm>
#include <limits>

namespace fairway {
namespace {

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

}  // namespace

Assignment::Assignment(std::size_t max_rows, std::size_t max_columns) {
  const std::size_t most = std::max(max_rows, max_columns) + 1;
  gains_.reserve(max_rows * max_columns);
  of_worker_.reserve(most);
  of_job_.reserve(most);
  slack_.reserve(most);
  from_.reserve(most);
  taken_by_.reserve(most);
  reached_.reserve(most);
  pairs_.reserve(max_rows);
}

void Assignment::begin(std::size_t rows, std::size_t columns) {
  rows_ = rows;
  columns_ = columns;
  flipped_ = rows > columns;
  workers_ = std::min(rows, columns);
  jobs_ = std::max(rows, columns);
  gains_.assign(rows * columns, 0.0);
}

void Assignment::offer(std::size_t row, std::size_t column, double gain) {
  gains_[row * columns_ + column] = gain;
}

double Assignment::cost(std::size_t worker, std::size_t job) const {
  return -(flipped_ ? gains_[job * columns_ + worker] : gains_[worker * columns_ + job]);
}

std::span<const std::optional<std::size_t>> Assignment::solve() {
  // every worker gets a job; one that gains nothing is no pair
  of_worker_.assign(workers_, 0.0);
  of_job_.assign(jobs_ + 1, 0.0);
  taken_by_.assign(jobs_ + 1, nobody);
  for (std::size_t worker = 0; worker < workers_; ++worker) place(worker);

  pairs_.assign(rows_, std::nullopt);
  for (std::size_t job = 0; job < jobs_; ++job) {
    const std::size_t worker = taken_by_[job];
    if (worker == nobody || cost(worker, job) >= 0.0) continue;
    if (flipped_)
      pairs_[job] = worker;
    else
      pairs_[worker] = job;
  }
  return pairs_;
}

void Assignment::place(std::size_t worker) {
  // the worker begins on a job beside the real ones, from which paths of least cost are grown
  const std::size_t start = jobs_;
  slack_.assign(jobs_, std::numeric_limits<double>::infinity());
  from_.assign(jobs_, start);
  reached_.assign(jobs_ + 1, 0);
  taken_by_[start] = worker;

  std::size_t job = start;
  while (taken_by_[job] != nobody) {
    reached_[job] = 1;
    const std::size_t holder = taken_by_[job];
    std::size_t nearest = nobody;
    for (std::size_t next = 0; next < jobs_; ++next) {
      if (reached_[next] != 0) continue;
      const double reduced = cost(holder, next) - of_worker_[holder] - of_job_[next];
      if (reduced < slack_[next]) {
        slack_[next] = reduced;
        from_[next] = job;
      }
      if (nearest == nobody || slack_[next] < slack_[nearest]) nearest = next;
    }

    // potentials follow, so that the nearest job costs nothing more
    const double step = slack_[nearest];
    for (std::size_t other = 0; other <= jobs_; ++other) {
      if (reached_[other] != 0) {
        of_worker_[taken_by_[other]] += step;
        of_job_[other] -= step;
      } else {
        slack_[other] -= step;
      }
    }
    job = nearest;
  }

  // along the path to the free job everyone moves on by one
  while (job != start) {
    taken_by_[job] = taken_by_[from_[job]];
    job = from_[job];
  }
}

}  // namespace fairway
