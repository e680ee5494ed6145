// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace fairway::ros2 {

/// What two readers of one topic have had of its publishers, so that each message is handled once. By the
/// time at which it was sent a message is known, and not told to be older: clocks are set back.
class TwinReaders {
 public:
  /// Whether the other of the two has had it already. What both have had is forgotten, and what one alone has
  /// had once it has had so many more as a reader keeps. O(those).
  bool has_been_seen(std::uint64_t publication, std::int64_t sent, std::int32_t reader) {
    constexpr std::size_t most = 100;
    const auto by_other = std::ranges::find_if(had_, [&](const Sighting& s) {
      return s.publication == publication && s.sent == sent && s.reader != reader;
    });
    if (by_other != had_.end()) {
      had_.erase(by_other);
      return true;
    }
    if (had_.size() == most) had_.pop_front();
    had_.push_back({publication, sent, reader});
    return false;
  }

 private:
  struct Sighting {
    std::uint64_t publication{};
    std::int64_t sent{};  ///< [ns]
    std::int32_t reader{};
  };
  std::deque<Sighting> had_;
};

}  // namespace fairway::ros2
