// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "fairway/core/ids.hpp"

namespace fairway {

/// Something that is to become a track, by how far it is.
struct Near {
  double distance2;  ///< [m2]
  TrackId id;
  std::size_t index;  ///< of what it is, to whoever asks
};

/// Nearest first, ties by id, and of them the first `most`. So the larger tracks are written once, in order.
inline void sort_nearest_first(std::vector<Near>& near,
                               std::size_t most = std::numeric_limits<std::size_t>::max()) {
  constexpr std::size_t few = 20;
  const auto is_nearer = [](const Near& a, const Near& b) {
    return a.distance2 != b.distance2 ? a.distance2 < b.distance2 : number(a.id) < number(b.id);
  };
  if (near.size() <= few) {  // by insertion
    for (std::size_t end = 1; end < near.size(); ++end) {
      const Near one = near[end];
      std::size_t k = end;
      for (; k > 0 && is_nearer(one, near[k - 1]); --k) near[k] = near[k - 1];
      near[k] = one;
    }
    if (most < near.size()) near.resize(most);
    return;
  }
  if (most < near.size()) {
    std::ranges::nth_element(near, near.begin() + static_cast<std::ptrdiff_t>(most), is_nearer);
    near.resize(most);
  }
  std::ranges::sort(near, is_nearer);
}

}  // namespace fairway
