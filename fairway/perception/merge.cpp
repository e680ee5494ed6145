// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/merge.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "fairway/core/params.hpp"
#include "fairway/perception/tracker/gate.hpp"

namespace fairway {
namespace {

constexpr std::size_t usual_pairs = 128;  // so many are told of round what is seen, and hardly ever more

/// An estimate and the covariance of its error.
struct Belief {
  Vec3 mean;
  Mat3 covariance;
};

Mat3 widened(const Mat3& covariance, double sigma) { return covariance + sigma * sigma * Mat3::Identity(); }

/// Two independent beliefs made one, with the sum of their information.
Belief fused(const Belief& a, const Belief& b) {
  const Mat3 share = a.covariance * (a.covariance + b.covariance).inverse();
  const Mat3 left = a.covariance - share * a.covariance;
  return {a.mean + share * (b.mean - a.mean), 0.5 * (left + left.transpose())};
}

}  // namespace

Merge::Merge(const MergeParams& params, std::size_t seen_count, std::size_t told_count)
    : params_{checked_params(params)},
      gate_{gate_of(params.merge_gate_ratio, 3)},
      assignment_{seen_count, std::min(told_count, usual_pairs)} {
  near_.reserve(told_count);
}

double Merge::distance(const Track& seen, const Track& told) const {
  const Mat3 covariance =
      seen.position_covariance + widened(told.position_covariance, params_.told_position_sigma_m);
  return distance2(told.position - seen.position, covariance, gate_);
}

void Merge::merge(std::span<const Track> seen, std::vector<Track>& told) {
  // most of the team is far from whoever is seen
  near_.clear();
  for (std::size_t j = 0; j < told.size(); ++j) {
    const auto may_be_told = [&](const Track& track) { return distance(track, told[j]) < gate_; };
    if (std::ranges::any_of(seen, may_be_told)) near_.push_back(j);
  }

  assignment_.begin(seen.size(), near_.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = 0; j < near_.size(); ++j) {
      const double apart = distance(seen[i], told[near_[j]]);
      if (apart < gate_) assignment_.offer(i, j, gate_ - apart);
    }
  }
  const auto pairs = assignment_.solve();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (pairs[i])
      combine(seen[i], told[near_[*pairs[i]]]);
    else
      told.push_back(seen[i]);
  }
}

void Merge::combine(const Track& seen, Track& told) const {
  const Belief place =
      fused({seen.position, seen.position_covariance},
            {told.position, widened(told.position_covariance, params_.told_position_sigma_m)});
  const Belief motion =
      fused({seen.velocity, seen.velocity_covariance},
            {told.velocity, widened(told.velocity_covariance, params_.told_velocity_sigma_mps)});
  told.position = place.mean;
  told.position_covariance = place.covariance;
  told.velocity = motion.mean;
  told.velocity_covariance = motion.covariance;
  told.age = std::min(told.age, seen.age);
}

}  // namespace fairway
