// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <tuple>

#include "fairway/core/record.hpp"

namespace fairway {

/// What a vehicle can or may do. A limit that is not set does not bind.
struct Limits {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double max_speed{none};
  double max_climb_rate{none};
  double max_acceleration{none};
  double max_turn_rate{none};
  double min_depth{-none};
  double max_depth{none};

  // what the vehicle cannot do, whatever it is told; by default it can do all of it
  double min_speed{0.0};
  bool sternway{true};
  bool sway{true};

  static consteval auto members() {
    using R = Limits;
    return std::tuple{
        member<&R::max_speed>("mps", "over ground [m/s]").required().not_negative(),
        member<&R::max_climb_rate>("mps", "vertical, either way [m/s]; zero for a surface vehicle")
            .not_negative(),
        member<&R::max_acceleration>("mps2", "[m/s2]; for methods that reason about reachable velocities")
            .not_negative(),
        member<&R::max_turn_rate>("radps", "[rad/s]; likewise").not_negative(),
        member<&R::min_depth>("m", "ceiling: no command leads above it [m]"),
        member<&R::max_depth>("m", "floor: no command leads below it [m]"),
        member<&R::min_speed>("mps", "through the water; slower than this the vehicle does not steer [m/s]")
            .not_negative(),
        member<&R::sternway>("", "whether it can go astern"),
        member<&R::sway>("", "whether it can go sideways"),
    };
  }

  friend bool operator==(const Limits&, const Limits&) = default;
};

/// `limit`, or `otherwise` where it does not bind.
constexpr double limit_or(double limit, double otherwise) { return limit < Limits::none ? limit : otherwise; }

}  // namespace fairway
