// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/lookout.hpp"

#include <algorithm>
#include <iterator>

namespace fairway {
namespace {

using Watch = std::variant<PerfectPerception, SonarWatch>;

Watch watch_of(std::string_view kind, const ParamValues& params, std::size_t track_count, Rng rng) {
  require_known(kind, "perception", perception_kinds());
  if (kind == "sonar") return SonarWatch{params, track_count, rng};
  if (!params.empty()) {
    throw InputError({}, params.front().first,
                     "perfect perception takes no parameter but range_m and obstacle_range_m");
  }
  return PerfectPerception{track_count};
}

}  // namespace

Lookout::Lookout(std::string_view kind, const ParamValues& params, const Reach& reach,
                 std::size_t track_count, Rng rng)
    : reach_{reach}, watch_{watch_of(kind, params, track_count, rng)} {}

void Lookout::sense(const Scene& scene, const Viewpoint& own) {
  if (SonarWatch* watch = std::get_if<SonarWatch>(&watch_)) watch->sense(scene, own);
}

void Lookout::report(const Scene& scene, const Viewpoint& own, std::vector<Track>& tracks,
                     std::vector<Obstacle>& obstacles) {
  if (SonarWatch* watch = std::get_if<SonarWatch>(&watch_)) {
    watch->report(scene, own, reach_, tracks);
    obstacles.clear();
    std::ranges::copy_if(scene.obstacles, std::back_inserter(obstacles), &Obstacle::charted);
    return;
  }
  std::get<PerfectPerception>(watch_).perceive(scene, own, reach_, tracks);
  perceive_obstacles(scene.obstacles, own.estimate.p_n, own.radius, reach_, obstacles);
}

std::span<const Echo> Lookout::echoes() const {
  const SonarWatch* watch = std::get_if<SonarWatch>(&watch_);
  return watch != nullptr ? watch->echoes() : std::span<const Echo>{};
}

std::vector<KindInfo> perception_kinds() {
  return {{"perfect", "What vehicles tell, and the truth of all else within reach", "", {}},
          {"sonar", "Forward-looking multibeam sonar and a multi-target tracker",
           "Bar-Shalom, Li, Kirubarajan 2001; Blackman, Popoli 1999", describe_params<SonarWatchParams>()}};
}

}  // namespace fairway
