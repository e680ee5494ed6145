// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/tangent.hpp"

#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::avoa_improved {
namespace {

/// Sweeps this near to a full turn are none: rounding [rad].
constexpr double no_sweep = 1e-9;

}  // namespace

Vec2 Turn::at(double angle) const { return centre + radius * unit_at(angle); }

double Turn::sweep(double arrival, double departure) const {
  const double wrapped = wrap_angle(sign_of(side) * (departure - arrival));
  if (wrapped >= 0.0) return wrapped;
  return wrapped > -no_sweep ? 0.0 : wrapped + 2.0 * pi;
}

std::optional<Tangent> tangent(const Turn& from, const Turn& to) {
  // with u along the line and n = u turned to starboard, the line touches a circle at -sign radius n from its
  // centre, so that to.centre - from.centre = length u + offset n
  const Vec2 between = to.centre - from.centre;
  const double offset = sign_of(to.side) * to.radius - sign_of(from.side) * from.radius;
  const double square = between.squaredNorm() - offset * offset;
  if (square < 0.0 || between.isZero(0.0)) return {};
  const double length = std::sqrt(square);
  const double heading = math::atan2(between.y(), between.x()) - math::atan2(offset, length);
  return Tangent{.heading = heading,
                 .length = length,
                 .departure = heading - 0.5 * pi * sign_of(from.side),
                 .arrival = heading - 0.5 * pi * sign_of(to.side)};
}

}  // namespace fairway::avoa_improved
