// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace fairway {

/// Said of a decision for which the method had no room for all that was within its reach.
inline constexpr std::string_view words_of_left_out = "more is near than is looked at: the nearest counts";

/// Which places in a list of `N` the nearest of any number take. They are given out in the order in which
/// they are asked for; only when there is none left the farthest has to go, of equals the one that took its
/// place first.
template <std::size_t N>
class NearestFew {
 public:
  /// The place for what is `gap` away [m]: a new one, else that of the farthest if it is farther; N where it
  /// is to be left out. O(1) until all are taken, then O(N) for each that takes one.
  std::size_t place_for(double gap) noexcept {
    if (count_ < N) {
      gaps_[count_] = gap;
      return count_++;
    }
    left_out_ = true;
    if (kept_ == N) return N;
    if (farthest_ == N) {
      const auto first = gaps_.begin() + static_cast<std::ptrdiff_t>(kept_);
      farthest_ = static_cast<std::size_t>(std::max_element(first, gaps_.end()) - gaps_.begin());
    }
    if (!(gap < gaps_[farthest_])) return N;
    const std::size_t place = farthest_;
    gaps_[place] = gap;
    farthest_ = N;
    return place;
  }

  /// The first `count` places are taken for good.
  void take(std::size_t count) noexcept { count_ = kept_ = std::min(count, N); }

  /// Of those that have a place the first `most` keep it.
  void keep(std::size_t most = N) noexcept {
    kept_ = std::min(count_, most);
    farthest_ = N;
  }

  std::size_t count() const noexcept { return count_; }
  bool left_out() const noexcept { return left_out_; }

 private:
  std::array<double, N> gaps_;
  std::size_t count_ = 0;
  std::size_t kept_ = 0;      // never given up
  std::size_t farthest_ = N;  // of the others; N: not known
  bool left_out_ = false;
};

}  // namespace fairway
