// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/record.hpp"

namespace fairway {

/// What one beam of a forward-looking sonar heard: something solid, or a false echo. A beam that heard
/// nothing has none.
struct Echo {
  double range{};
  double bearing{};

  static consteval auto members() {
    return std::tuple{
        member<&Echo::range>("m", "from the sonar [m]"),
        member<&Echo::bearing>("rad", "in the plane of the hull, 0 ahead, positive to starboard [rad]")};
  }

  friend bool operator==(const Echo&, const Echo&) = default;
};

}  // namespace fairway
