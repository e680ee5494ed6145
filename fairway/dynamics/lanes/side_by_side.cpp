// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/lanes/side_by_side.hpp"

#include <algorithm>

namespace fairway {
namespace {

/// In lanes that nobody is in the first body moves once more.
void repeat_first(double* columns, std::size_t count, std::size_t width, std::size_t from) {
  for (double* column = columns; column < columns + count * width; column += width)
    std::fill(column + from, column + width, column[0]);
}

/// One number of each column for each of `values`.
template <class... Values>
void write(double* at, std::size_t width, const Values&... values) {
  std::size_t column = 0;
  ((at[width * column++] = values), ...);
}

}  // namespace

SideBySide::SideBySide(const SubmergedBody& body, double h, const lanes::MotionKernel& kernel) noexcept
    : body_{body}, kernel_{kernel} {
  bodies_.h = h;
}

void SideBySide::add(VehicleState& x, const lanes::PushOf<double>& push, const Water& water) noexcept {
  const bool flows = water.current_n != Vec3::Zero(), accelerates = water.current_rate_n != Vec3::Zero();
  if (count_ > 0 && (flows != bodies_.flows || accelerates != bodies_.accelerates)) finish();
  bodies_.flows = flows;
  bodies_.accelerates = accelerates;

  const std::size_t width = kernel_.lanes, lane = count_;
  const auto& [p, q, v, omega] = x;
  write(bodies_.motion + lane, width, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(),
        omega.x(), omega.y(), omega.z());
  write(bodies_.push + lane, width, push.force.x(), push.force.y(), push.force.z(), push.moment.x(),
        push.moment.y(), push.moment.z());
  const Vec3 &c = water.current_n, &rate = water.current_rate_n;
  write(bodies_.water + lane, width, c.x(), c.y(), c.z(), rate.x(), rate.y(), rate.z(), water.density);
  states_[count_++] = &x;
  if (count_ == width) finish();
}

void SideBySide::finish() noexcept {
  if (count_ == 0) return;
  const std::size_t width = kernel_.lanes;
  if (count_ < width) {
    repeat_first(bodies_.motion, 13, width, count_);
    repeat_first(bodies_.push, 6, width, count_);
    repeat_first(bodies_.water, 7, width, count_);
  }
  kernel_.step(body_.numbers(), bodies_);
  for (std::size_t lane = 0; lane < count_; ++lane) {
    const double* at = bodies_.motion + lane;
    const auto of = [&](std::size_t column) { return at[column * width]; };
    *states_[lane] = {.p_n = {of(0), of(1), of(2)},
                      .q_nb = {of(3), of(4), of(5), of(6)},
                      .v_b = {of(7), of(8), of(9)},
                      .omega_b = {of(10), of(11), of(12)}};
  }
  count_ = 0;
}

}  // namespace fairway
