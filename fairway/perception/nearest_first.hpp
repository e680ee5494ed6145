// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fairway/core/ids.hpp"

namespace fairway {

/// Something that is to become a track, by how far it is.
struct Near {
  double distance2;  ///< [m2]
  TrackId id;
  std::size_t index;  ///< of what it is, to whoever asks
};

/// Nearest first, ties by id. So the larger tracks are written once, in order.
inline void sort_nearest_first(std::vector<Near>& near) {
  std::ranges::sort(near, [](const Near& a, const Near& b) {
    return a.distance2 != b.distance2 ? a.distance2 < b.distance2 : number(a.id) < number(b.id);
  });
}

}  // namespace fairway
