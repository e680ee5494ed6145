// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// What one beam of a forward-looking sonar heard: something solid, or a false echo. A beam that heard
/// nothing has none.
struct Echo {
  double range{};    ///< from the sonar [m]
  double bearing{};  ///< in the plane of the hull, 0 ahead, positive to starboard [rad]

  friend bool operator==(const Echo&, const Echo&) = default;
};

}  // namespace fairway
