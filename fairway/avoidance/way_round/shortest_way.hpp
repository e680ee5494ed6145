// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/avoidance/avoa_improved/capsule.hpp"
#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// Shows another avoider the shortest way round all that does not move and has been seen, be it an obstacle
/// or a track that stands still and does not react, instead of the straight one: the velocity that it prefers
/// points along the taut string to the goal. For methods that look a few seconds ahead and stand where the
/// straight way ends. As seen from above; depth is left to the mission. It avoids nobody itself. O(ends of
/// solids squared x solids) at worst.
struct ShortestWay {
  static constexpr AlgorithmInfo info{
      .name = "way_round",
      .title = "Prefer the shortest way round what does not move",
      .source = "fairway; taut string over tangents, by A*, as in avoa_improved",
      .handed = true,
      .ignores_movers = true,
      .shows_only = true,
      .finds_way = true,
  };

  struct Params {
    double way_margin_m = 0.6;
    double commitment_m = 4.0;
    double bend_m = 2.0;
    double same_place_m = 0.2;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::way_margin_m>({0, 1000},
                                  "kept by the way between own sphere and every surface; at least twice what "
                                  "the inner avoider keeps"),
          field<&P::commitment_m>({0, 1000}, "to turn back, another way must be shorter by this"),
          field<&P::bend_m>({0, 1000}, "length that a radian of turning counts for"),
          field<&P::same_place_m>({0, 1000}, "what is seen this near to what was seen before is the same"),
      };
    }
  };

  struct Memory {
    avoa_improved::Chart chart;
    std::optional<Vec2> committed;  ///< the direction of the way taken last, unit [NED]
  };

  Params params;

  /// As the inner avoider answers the situation with that preferred velocity. Where there is no way with the
  /// margin, one with a quarter of it; where there is none either, the straight one.
  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceWrapper<ShortestWay>);

}  // namespace fairway
