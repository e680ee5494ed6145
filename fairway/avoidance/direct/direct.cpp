// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/direct/direct.hpp"

namespace fairway {

Command Direct::decide(const Situation& s, Memory&, Context&) const noexcept {
  return {.velocity = s.preferred_velocity(), .mode = Mode::cruise};
}

}  // namespace fairway
