// SPDX-License-Identifier: Apache-2.0
// Counted messages: each carries its number in the first covariance of its pose, which nobody else uses.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace fairway::testing {

/// What has come of one sender.
struct Count {
  std::int64_t received{}, lost{}, out_of_order{}, next{};

  /// Messages before the first one that is heard are not missed.
  void see(std::int64_t number) {
    if (received > 0) {
      lost += std::max<std::int64_t>(number - next, 0);
      out_of_order += number < next ? 1 : 0;
    }
    ++received;
    next = number + 1;
  }
};

/// One line for tests to read: by vehicle, how many came, how many are missing, and the last one's number.
inline std::string told(const std::map<std::string, Count>& counts) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [name, count] : counts)
    json[name] = {{"received", count.received},
                  {"lost", count.lost},
                  {"out_of_order", count.out_of_order},
                  {"last", count.next - 1}};
  return json.dump();
}

}  // namespace fairway::testing
