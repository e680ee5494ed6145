// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/direct/direct.hpp"

namespace fairway {

Command Direct::decide(const Situation& s, Memory&, Context& context) const noexcept {
  const Vec3 preferred = s.preferred_velocity();
  if (context.sketch) context.sketch->velocity(preferred, "preferred");
  return {.velocity = preferred, .mode = Mode::cruise};
}

}  // namespace fairway
