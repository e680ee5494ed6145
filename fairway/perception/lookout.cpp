// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/lookout.hpp"

#include <vector>

namespace fairway {

Lookout::Lookout(std::string_view kind, const ParamValues& params, const Reach& reach,
                 std::size_t track_count, Rng)
    : reach_{reach}, perfect_{track_count} {
  const std::vector<std::string_view> kinds{"perfect"};
  if (kind != "perfect") throw InputError({}, "kind", "unknown perception" + suggestion(kind, kinds));
  if (!params.empty()) {
    throw InputError({}, params.front().first,
                     "perfect perception takes no parameter but range_m and obstacle_range_m");
  }
}

void Lookout::sense(const Scene&, const Viewpoint&) {}

void Lookout::report(const Scene& scene, const Viewpoint& own, std::vector<Track>& tracks,
                     std::vector<Obstacle>& obstacles) {
  perfect_.perceive(scene, own, reach_, tracks);
  perceive_obstacles(scene.obstacles, own.estimate.p_n, own.radius, reach_, obstacles);
}

}  // namespace fairway
