// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fairway::embed {

/// One of many, by how near it is.
struct Near {
  double range{};  ///< or its square; what is none, such as NaN, counts as nearest, so that nobody passes
                   ///< over it
  std::uint32_t id{};
  std::size_t index{};  ///< of what it is, to whoever asks

  friend bool operator<(const Near& a, const Near& b) {
    if (a.range != b.range) return a.range < b.range;
    return a.id != b.id ? a.id < b.id : a.index < b.index;
  }
};

/// The nearest of any number, in room for a few that is made once. Equal ranges by id. O(log room) for each.
class Nearest {
 public:
  /// Throws std::bad_alloc.
  void reserve(std::size_t room) {
    kept_.reserve(room);
    room_ = room;
  }

  void clear() noexcept { kept_.clear(); }

  void offer(Near near) noexcept {
    if (!(near.range >= lowest)) near.range = lowest;
    if (kept_.size() < room_) {
      kept_.push_back(near);
      std::push_heap(kept_.begin(), kept_.end());
    } else if (room_ > 0 && near < kept_.front()) {  // the farthest goes
      std::pop_heap(kept_.begin(), kept_.end());
      kept_.back() = near;
      std::push_heap(kept_.begin(), kept_.end());
    }
  }

  void sort() noexcept { std::sort(kept_.begin(), kept_.end()); }
  void sort_as_given() noexcept { std::ranges::sort(kept_, {}, &Near::index); }

  /// `keeps` is asked once of each, in their order.
  template <class Keeps>
  void keep_if(Keeps keeps) noexcept {
    std::size_t count = 0;
    for (const Near& near : kept_) {
      if (keeps(near)) kept_[count++] = near;
    }
    kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(count), kept_.end());
  }

  std::span<const Near> kept() const noexcept { return kept_; }

 private:
  static constexpr double lowest = -1e308;  // inside of a solid ranges are negative

  std::vector<Near> kept_;
  std::size_t room_{};
};

}  // namespace fairway::embed
