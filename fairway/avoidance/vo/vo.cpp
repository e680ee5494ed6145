// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/vo/vo.hpp"

namespace fairway {

Command Vo::decide(const Situation& s, Memory&, Context& context) const noexcept {
  return velocity_obstacle::decide(s, params, velocity_obstacle::Responsibility::all, context);
}

}  // namespace fairway
