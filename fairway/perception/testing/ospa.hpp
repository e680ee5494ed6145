// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "fairway/core/vec.hpp"
#include "fairway/perception/tracker/assignment.hpp"

namespace fairway {

/// Optimal subpattern assignment metric of order 2 between two sets of points in the horizontal plane [m]:
/// root mean square distance of the best pairs, in which every missing and every false point, and every pair
/// farther apart, counts as `cutoff` (Schuhmacher, Vo, Vo 2008, eq. 3).
inline double ospa(const std::vector<Vec3>& truth, const std::vector<Vec3>& found, double cutoff) {
  const std::size_t most = std::max(truth.size(), found.size());
  if (most == 0) return 0.0;
  Assignment assignment{truth.size(), found.size()};
  assignment.begin(truth.size(), found.size());
  const auto saved = [&](std::size_t i, std::size_t j) {
    return cutoff * cutoff - (truth[i] - found[j]).head<2>().squaredNorm();
  };
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < found.size(); ++j) {
      if (saved(i, j) > 0.0) assignment.offer(i, j, saved(i, j));
    }
  }
  double sum = static_cast<double>(most) * cutoff * cutoff;
  const auto pairs = assignment.solve();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (pairs[i]) sum -= saved(i, *pairs[i]);
  }
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(most));
}

}  // namespace fairway
