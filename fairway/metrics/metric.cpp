// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/metric.hpp"

namespace fairway {

const Neighbours& Neighbours::of(const Frame& frame) {
  const std::size_t count = frame.vehicles.size();
  own_.resize(count);
  const auto way_of = [&](std::size_t i) { return (frame.vehicles[i].state.p_n - own_[i].position).norm(); };
  double longest = 0.0;
  for (std::size_t i = 0; i < count; ++i) longest = std::fmax(longest, way_of(i));
  for (std::size_t i = 0; i < count; ++i) {
    const double way = way_of(i);
    own_[i].position = frame.vehicles[i].state.p_n;
    if (way + longest > 0.0) own_[i].clear = shorter(own_[i].clear - way - longest);
  }
  index_.rebuild(count, reach_, [&](std::size_t i) { return own_[i].position; });
  return *this;
}

}  // namespace fairway
