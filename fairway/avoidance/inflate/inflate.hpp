// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// Allows for what is not known of others: shows another avoider every track with its sphere grown by k
/// sigma, which holds a Gaussian error of position with a chosen probability. sigma^2 is the greatest
/// eigenvalue of the position's covariance, k the quantile of the chi distribution, whose degrees of freedom
/// are those that the inner avoider thinks in. O(tracks) besides the inner avoider.
struct Inflate {
  static constexpr AlgorithmInfo info{
      .name = "inflate",
      .title = "Grow the spheres of others by what is uncertain of where they are",
      .source = "chi distribution of the norm of a Gaussian error",
      .ignores_obstacles = true,  // it shows others larger, and leaves it to the inner avoider what to do
      .ignores_movers = true,
      .shows_only = true,
  };

  struct Params {
    double confidence_ratio = 0.95;
    double max_growth_m = 10.0;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::confidence_ratio>({0, 0.999999},
                                           "probability that the grown sphere holds the other's true one"),
          field<&Params::max_growth_m>({0, 10000}, "no sphere grows by more, however old its track"),
      };
    }
  };

  struct Memory {
    std::vector<Track> shown;
  };

  Params params;
  double k_space;  ///< with 3 degrees of freedom
  double k_plane;  ///< with 2

  explicit Inflate(const Params& chosen);

  /// As the inner avoider answers the grown tracks. Does not allocate once the memory has the capacity.
  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;

  /// By how much the sphere of `track` grows; for a planar avoider by the horizontal error only. [m]
  double growth(const Track& track, bool is_planar) const noexcept;
};

static_assert(AvoidanceWrapper<Inflate>);

}  // namespace fairway
