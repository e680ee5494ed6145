// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "fairway/exam/exam_page.hpp"
#include "fairway/experiment/labels.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {

/// Times to decide, summed up by whoever makes runs, on several threads.
class DecisionClock {
 public:
  void add(const Labels& labels, const DecisionTimes& times) {
    const auto label = [&](const char* name) { return *find_label(labels, name); };
    const std::lock_guard guard{mutex_};
    DecisionTimes& sum = sums_[{label("family"), label("method"), label("tuned") == "true"}];
    sum.count += times.count;
    sum.total_s += times.total_s;
    sum.worst_s = std::max(sum.worst_s, times.worst_s);
  }

  std::vector<DecisionTime> all() const {
    std::vector<DecisionTime> times;
    for (const auto& [key, sum] : sums_) {
      if (sum.count == 0) continue;
      const auto& [family, method, tuned] = key;
      times.push_back({family, method, tuned, sum.count, 1e6 * sum.total_s / static_cast<double>(sum.count),
                       1e6 * sum.worst_s});
    }
    return times;
  }

 private:
  std::mutex mutex_;
  std::map<std::tuple<std::string, std::string, bool>, DecisionTimes> sums_;
};

}  // namespace fairway::cli
