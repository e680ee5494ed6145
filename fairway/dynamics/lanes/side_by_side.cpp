// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/lanes/side_by_side.hpp"

namespace fairway {

void SideBySide::add(VehicleState& x, const lanes::PushOf<double>& push, const Water& water) noexcept {
  const bool flows = water.current_n != Vec3::Zero(), accelerates = water.current_rate_n != Vec3::Zero();
  if (flows != bodies_.flows || accelerates != bodies_.accelerates) finish();
  bodies_.flows = flows;
  bodies_.accelerates = accelerates;

  const std::size_t width = kernel_.lanes;
  const auto& [p, q, v, omega] = x;
  bodies_.motion.write(width, count_, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(),
                       omega.x(), omega.y(), omega.z());
  bodies_.push.write(width, count_, push.force.x(), push.force.y(), push.force.z(), push.moment.x(),
                     push.moment.y(), push.moment.z());
  const Vec3 &c = water.current_n, &rate = water.current_rate_n;
  bodies_.water.write(width, count_, c.x(), c.y(), c.z(), rate.x(), rate.y(), rate.z(), water.density);
  states_[count_++] = &x;
  if (count_ == width) finish();
}

void SideBySide::finish() noexcept {
  if (count_ == 0) return;
  const std::size_t width = kernel_.lanes;
  bodies_.motion.repeat_first(width, count_);
  bodies_.push.repeat_first(width, count_);
  bodies_.water.repeat_first(width, count_);
  kernel_.step(body_.numbers(), bodies_);
  for (std::size_t lane = 0; lane < count_; ++lane) {
    const auto of = [&](std::size_t column) { return bodies_.motion.of(width, lane, column); };
    *states_[lane] = {.p_n = {of(0), of(1), of(2)},
                      .q_nb = {of(3), of(4), of(5), of(6)},
                      .v_b = {of(7), of(8), of(9)},
                      .omega_b = {of(10), of(11), of(12)}};
  }
  count_ = 0;
}

}  // namespace fairway
