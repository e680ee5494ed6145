// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/merge.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "fairway/perception/tracker/tracker.hpp"

namespace fairway {
namespace {

/// An estimate and the covariance of its error.
struct Belief {
  Vec3 mean;
  Mat3 covariance;
};

Mat3 widened(const Mat3& covariance, double sigma) { return covariance + sigma * sigma * Mat3::Identity(); }

/// Of two independent beliefs: with the sum of their information.
Belief fused(const Belief& a, const Belief& b) {
  const Mat3 share = a.covariance * (a.covariance + b.covariance).inverse();
  const Mat3 left = a.covariance - share * a.covariance;
  return {a.mean + share * (b.mean - a.mean), 0.5 * (left + left.transpose())};
}

}  // namespace

Merge::Merge(const MergeParams& params, std::size_t seen_count, std::size_t told_count)
    : params_{params}, gate_{gate_of(params.merge_gate_ratio)}, assignment_{seen_count, told_count} {}

void Merge::merge(std::span<const Track> seen, std::vector<Track>& told) {
  const std::size_t told_count = told.size();
  const double position_sigma = params_.told_position_sigma_m;
  assignment_.begin(seen.size(), told_count);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = 0; j < told_count; ++j) {
      const Vec3 apart = told[j].position - seen[i].position;
      const Mat3 covariance =
          seen[i].position_covariance + widened(told[j].position_covariance, position_sigma);
      const double distance2 = apart.dot(covariance.inverse() * apart);
      if (distance2 < gate_) assignment_.offer(i, j, gate_ - distance2);
    }
  }

  const auto pairs = assignment_.solve();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!pairs[i]) {
      told.push_back(seen[i]);
      continue;
    }
    Track& both = told[*pairs[i]];
    const Belief place = fused({seen[i].position, seen[i].position_covariance},
                               {both.position, widened(both.position_covariance, position_sigma)});
    const Belief motion =
        fused({seen[i].velocity, seen[i].velocity_covariance},
              {both.velocity, widened(both.velocity_covariance, params_.told_velocity_sigma_mps)});
    both.position = place.mean;
    both.position_covariance = place.covariance;
    both.velocity = motion.mean;
    both.velocity_covariance = motion.covariance;
    both.age = std::min(both.age, seen[i].age);
  }
}

}  // namespace fairway
