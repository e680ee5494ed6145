// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <string>

namespace fairway {

/// How far a campaign is.
struct ProgressCount {
  std::size_t total{};    ///< runs of the campaign
  std::size_t present{};  ///< of these, already stored when it began
  std::size_t made{};     ///< made since
  std::size_t failed{};   ///< of those made
};

/// "crit_dist: 120 of 480 runs, 3 failed, 12.5 runs/s, 0:29 left".
std::string progress_text(const std::string& name, const ProgressCount& count, double elapsed_s);

/// A line on a terminal that is redrawn in place at most five times a second. Where the output is no
/// terminal, nothing at all.
class Progress {
 public:
  explicit Progress(std::string name, int descriptor = STDERR_FILENO);

  void begin(const ProgressCount& count);
  void update(const ProgressCount& count);
  void end(const ProgressCount& count);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const ProgressCount& count, const char* ending);

  std::string name_;
  int descriptor_;
  bool visible_;
  Clock::time_point began_;
  Clock::time_point drawn_;
};

}  // namespace fairway
