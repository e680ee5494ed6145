// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// Buffered Voronoi cells: each vehicle keeps to the part of space that is nearer to it than to any other,
/// set back by its radius, and so needs to know where the others are and nothing else (Zhou, Wang,
/// Bandyopadhyay, Schwager 2017). In space, or in the plane where everything lies in one. O(tracks + obstacle
/// vertices) and a velocity program. No memory.
///
///     paper            here
///     p_i, p_j         own.position, of a track
///     r_s              own.radius, and track.radius: the middle of the gap between two spheres
///     V-bar_i (4)      where own ship may be time_horizon_s from now
///     g_i*  (9)        the chosen velocity, for as long
struct Bvc {
  static constexpr AlgorithmInfo info{
      .name = "bvc",
      .title = "Buffered Voronoi cells",
      .source = "Zhou, Wang, Bandyopadhyay, Schwager 2017, sections III and IV",
      .handed = true,
      .needs_sway = true,
  };

  struct Params {
    double time_horizon_s = 2.0;
    double crit_dist_m = 20.0;
    double deadlock_ratio = 0.1;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::time_horizon_s>({0.01, 10000}, "a velocity that is kept so long stays in the cell"),
          field<&P::crit_dist_m>({0.1, 10000},
                                 "range within which neighbours count, centre to centre; to the surface of "
                                 "an obstacle"),
          field<&P::deadlock_ratio>({0, 1},
                                    "of the preferred speed: who could not go faster than this turns to "
                                    "starboard, along the edge of its cell"),
      };
    }
  };
  using Memory = NoMemory;

  Params params;

  /// Mode::cruise if nobody is in range, Mode::avoid if somebody is; Mode::infeasible if own ship is outside
  /// its cell and cannot be back in time.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;

  double farthest_obstacle() const noexcept { return params.crit_dist_m; }
};

static_assert(AvoidanceAlgorithm<Bvc>);

}  // namespace fairway
