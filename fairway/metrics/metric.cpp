// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/metric.hpp"

namespace fairway {
namespace {

constexpr std::size_t few = 24;  // vehicles look round sooner than it is found out whether they need to

}  // namespace

const Neighbours& Neighbours::of(const Frame& frame) {
  const std::size_t count = frame.vehicles.size();
  own_.resize(count);
  double longest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    Own& own = own_[i];
    const Vec3& position = frame.vehicles[i].state.p_n;
    const double way = count <= few ? 0.0 : (position - own.position).norm();
    longest = std::fmax(longest, way);
    own.position = position;
    own.clear = count <= few ? 0.0 : own.clear - way;
  }
  if (longest > 0.0) {
    for (Own& own : own_) own.clear = shorter(own.clear - longest);
  }
  index_.rebuild(count, reach_, [&](std::size_t i) { return own_[i].position; });
  return *this;
}

}  // namespace fairway
