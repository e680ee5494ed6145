// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/lookout.hpp"

#include <limits>

namespace fairway {

Lookout::Lookout(std::string_view kind, const ParamValues& params, const Reach& reach,
                 std::size_t track_count, Rng rng)
    : reach_{reach} {
  require_known(kind, "perception", perception_kinds());
  if (kind == "sonar") {
    sonar_.emplace(params, track_count, rng);
  } else if (!params.empty()) {
    throw InputError({}, params.front().first,
                     "perfect perception takes no parameter but range_m and obstacle_range_m");
  }
}

void Lookout::sense(const Scene& scene, const Viewpoint& own) {
  if (sonar_) sonar_->sense(scene, own);
}

void Lookout::report(const Scene& scene, const Viewpoint& own, std::vector<Near>& near,
                     std::vector<Track>& tracks, std::vector<Obstacle>& obstacles) {
  if (sonar_) {
    sonar_->report(scene, own, reach_, tracks);
    constexpr double none = -std::numeric_limits<double>::infinity();
    perceive_obstacles(scene, own, {.vehicles = none, .obstacles = none}, near, obstacles);
    return;
  }
  perceive_movers(scene, own, reach_, near, tracks);
  perceive_obstacles(scene, own, reach_, near, obstacles);
}

std::span<const Echo> Lookout::echoes() const { return sonar_ ? sonar_->echoes() : std::span<const Echo>{}; }

std::vector<KindInfo> perception_kinds() {
  return {{"perfect", "What vehicles tell, and the truth of all else within reach", "", {}},
          {"sonar", "Forward-looking multibeam sonar and a multi-target tracker",
           "Bar-Shalom, Li, Kirubarajan 2001; Blackman, Popoli 1999", describe_params<SonarWatchParams>()}};
}

}  // namespace fairway
