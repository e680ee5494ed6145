// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/core/params.hpp"
#include "fairway/perception/tracker/assignment.hpp"

namespace fairway {

struct MergeParams {
  double told_position_sigma_m = 1.0;
  double told_velocity_sigma_mps = 0.05;
  double merge_gate_ratio = 0.99;

  static consteval auto fields() {
    return std::tuple{
        field<&MergeParams::told_position_sigma_m>(
            {0.001, 1000}, "what told positions are trusted to, own and others' navigation together"),
        field<&MergeParams::told_velocity_sigma_mps>({0.001, 100}, "what told velocities are trusted to"),
        field<&MergeParams::merge_gate_ratio>(
            {0.5, 0.999999}, "probability that a vehicle seen is taken for the one that tells"),
    };
  }
};

/// Makes one of who is both seen and told of. Holds scratch memory only.
class Merge {
 public:
  /// Memory for so many tracks of each kind.
  Merge(const MergeParams& params, std::size_t seen_count, std::size_t told_count);

  /// Turns `told` into all that is known: whoever of it passes as one of `seen` gets that one's share of
  /// position and velocity by information weights and its age if that is less, and keeps its identity,
  /// radius, priority, destination and reaction; the rest of `seen` is appended. Pairs are the best of all,
  /// within the gate. Does not allocate within the sizes reserved.
  void merge(std::span<const Track> seen, std::vector<Track>& told);

 private:
  double distance(const Track& seen, const Track& told) const;
  void combine(const Track& seen, Track& told) const;

  MergeParams params_;
  double gate_;
  Assignment assignment_;
  std::vector<std::size_t> near_;  // of those told
};

}  // namespace fairway
