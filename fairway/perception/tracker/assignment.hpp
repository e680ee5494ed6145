// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fairway {

/// Pairs rows with columns so that the sum of gains is greatest; each is in one pair at most, and may be in
/// none. Exact, by shortest augmenting paths with potentials (Kuhn 1955, Munkres 1957; the successive
/// shortest paths of Jonker and Volgenant 1987).
class Assignment {
 public:
  /// Memory for so many rows and columns.
  Assignment(std::size_t max_rows, std::size_t max_columns);

  /// Begins anew, with no gain anywhere. Does not allocate within the sizes reserved.
  void begin(std::size_t rows, std::size_t columns);

  /// What it is worth to pair these two, > 0.
  void offer(std::size_t row, std::size_t column, double gain);

  /// The column of each row, or none. The same offers give the same pairs. O(n^2 m) with n the smaller and m
  /// the larger of rows and columns. Valid until the next begin().
  std::span<const std::optional<std::size_t>> solve();

 private:
  double cost(std::size_t worker, std::size_t job) const;
  void place(std::size_t worker);

  std::size_t rows_{};
  std::size_t columns_{};
  bool flipped_{};  // workers are the fewer: columns if flipped
  std::size_t workers_{};
  std::size_t jobs_{};
  std::vector<double> gains_;
  std::vector<double> of_worker_;  // potentials
  std::vector<double> of_job_;
  std::vector<double> slack_;      // of each job, along the paths from the worker being placed
  std::vector<std::size_t> from_;  // the job before it on the shortest path
  std::vector<std::size_t> taken_by_;
  std::vector<char> reached_;
  std::vector<std::optional<std::size_t>> pairs_;
};

}  // namespace fairway
