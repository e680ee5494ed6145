// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/trackable/trackable.hpp"

#include <algorithm>

namespace fairway {

Command Trackable::decide(const Situation& s, Avoider& inner, Memory& memory,
                          Context& context) const noexcept {
  const double shown_margin = params.shown_margin_m + s.own.position_error();
  Situation shown = s;
  shown.own.position_sigma = 0.0;  // its sphere is larger by that
  if (!trackable::must_turn(s)) {
    shown.own.radius += shown_margin;
    Command command = inner.decide_usable(shown, context.sketch);
    if (command.note.empty()) command.note = trackable::words_of_ignorance(s);
    return command;
  }
  trackable::Keeper keeper{{.margins = {.tracking = params.tracking_bound_m,
                                        .perception = params.perception_error_m,
                                        .navigation = params.navigation_error_m + s.own.position_error(),
                                        .current = params.current_error_mps,
                                        .extra = params.margin_m},
                            .hold = params.hold_s,
                            .drift_settling = params.drift_settling_s},
                           s,
                           memory};
  shown.own.radius += std::max(0.0, std::min(shown_margin, keeper.room_now()));
  return keeper.keep(inner.decide_usable(shown, context.sketch), deviations, context.sketch);
}

}  // namespace fairway
