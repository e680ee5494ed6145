// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/hrvo/hrvo.hpp"

namespace fairway {

Command Hrvo::decide(const Situation& s, Memory&, Context& context) const noexcept {
  return velocity_obstacle::decide(s, params, velocity_obstacle::Responsibility::by_side, context);
}

}  // namespace fairway
