// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/avoider.hpp"

/// Keep right: the preferred velocity, turned to starboard while somebody would come too near along it. An
/// example of a method, and no good one: it sees no obstacle. O(tracks), no memory.
struct KeepRight {
  static constexpr fairway::AlgorithmInfo info{
      .name = "keep_right",
      .title = "Turns to starboard of whoever comes too near",
      .source = "An example; no paper.",
      .handed = true,
  };

  struct Params {
    double horizon_s = 60.0;
    double margin_m = 2.0;
    double turn_deg = 40.0;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          fairway::field<&P::horizon_s>({0.1, 1000}, "who comes too near later than this is left alone"),
          fairway::field<&P::margin_m>({0, 100}, "kept between the spheres of two vehicles"),
          fairway::field<&P::turn_deg>({1, 90}, "to starboard, while somebody would come too near"),
      };
    }
  };
  using Memory = fairway::NoMemory;

  Params params;

  fairway::Command decide(const fairway::Situation& s, Memory& memory,
                          fairway::Context& context) const noexcept;
};

static_assert(fairway::AvoidanceAlgorithm<KeepRight>);
