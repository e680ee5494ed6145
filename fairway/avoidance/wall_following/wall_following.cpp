// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/wall_following/wall_following.hpp"

#include "fairway/avoidance/wall_following/corrected.hpp"
#include "fairway/avoidance/wall_following/printed.hpp"

namespace fairway {

Command WallFollowing::decide(const Situation& s, Memory& memory, Context& context) const noexcept {
  return params.form == WallFollowingForm::printed ? wall::decide_printed(params, s, memory.loop, context)
                                                   : wall::decide_corrected(params, s, memory.round, context);
}

}  // namespace fairway
