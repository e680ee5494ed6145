// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fairway/core/echo.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/perception/sonar/sonar_params.hpp"

namespace fairway {

/// Finds where things that touch part: the near side of one thing bulges towards the sonar, and where two
/// meet the echoes turn in, away from it. Holds scratch memory only.
class Notch {
 public:
  /// `spacing` is that of the beams [rad].
  Notch(const SonarParams& params, double spacing);

  /// The echo of a thing, in order of bearing, that lies deepest behind the hull of the others as seen from
  /// the sonar, and deeper than noise explains; both sides of it keep echoes enough to be things. None where
  /// the thing is one. Does not allocate for up to echo_capacity() echoes. O(n).
  std::optional<std::size_t> find(std::span<const Echo> thing);

 private:
  void smooth(std::span<const Echo> thing);
  void wrap();

  double range_sigma_;             // of an echo [m]
  double bearing_sigma_;           // [rad]
  std::size_t reach_;              // of the running median, in echoes to either side
  std::vector<Vec2> places_;       // smoothed, ahead and to starboard [m]
  std::vector<std::size_t> hull_;  // those of them that nothing lies before
};

}  // namespace fairway
