// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/rvo/rvo.hpp"

namespace fairway {

Command Rvo::decide(const Situation& s, Memory&, Context& context) const noexcept {
  return velocity_obstacle::decide(s, params, velocity_obstacle::Responsibility::shared, context);
}

}  // namespace fairway
