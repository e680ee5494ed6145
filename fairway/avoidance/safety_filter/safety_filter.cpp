// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/safety_filter/safety_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/avoidance/ability.hpp"
#include "fairway/avoidance/nearest_few.hpp"
#include "fairway/avoidance/safety_filter/barrier.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using Params = SafetyFilter::Params;

/// Eight sides of an octagon, both ways of two axes, and way ahead.
constexpr std::size_t max_bounds = 13;

/// A share of sideways motion below this is none: the sidestep is to starboard.
constexpr double collinear = 1e-6;

/// What is asked and what can be done, as horizontal accelerations from `origin` [m/s2, NED]: of forces, zero
/// is no acceleration; of velocities, it is to stop within the response time.
struct Request {
  Vec2 nominal;
  Vec2 origin = Vec2::Zero();
  std::array<HalfPlane, max_bounds> bounds;
  std::size_t bound_count = 0;
  double max_length = std::numeric_limits<double>::infinity();

  void bound(const Vec2& normal, double offset) {
    bounds[bound_count++] = {normal, offset + normal.dot(origin)};
  }
  std::span<const HalfPlane> hard() const { return {bounds.data(), bound_count}; }
};

bool has_masses(const OnboardModel* model) {
  return model != nullptr && model->mass[0] > 0.0 && model->mass[1] > 0.0;
}

/// Body axis `axis`, ahead or to starboard.
Vec2 axis_of(const Ownship& own, int axis) {
  const Vec2 ahead = unit_at(own.yaw);
  return axis == 0 ? ahead : starboard_of(ahead);
}

/// a = (F - d(nu)) / m of one body axis.
double acceleration_of(const OnboardModel& model, const Ownship& own, int axis, double force) {
  return (force - model.drag(axis, axis_of(own, axis).dot(own.velocity.head<2>()))) / model.mass[axis];
}

void bound_by_forces(Request& request, const Params& params, const Ownship& own, const OnboardModel& model,
                     int axis) {
  const Vec2 direction = axis_of(own, axis);
  const double authority = params.authority_ratio;
  request.bound(direction, acceleration_of(model, own, axis, authority * model.least[axis]));
  request.bound(-direction, -acceleration_of(model, own, axis, authority * model.greatest[axis]));
}

Request request_of_forces(const Params& params, const Ownship& own, const OnboardModel& model,
                          const Wrench& wrench) {
  Request request{.nominal = Vec2::Zero()};
  for (int axis = 0; axis < 2; ++axis) {
    request.nominal += acceleration_of(model, own, axis, wrench[axis]) * axis_of(own, axis);
    bound_by_forces(request, params, own, model, axis);
  }
  return request;
}

/// Who can neither stop nor go astern keeps its least speed ahead, as far as the acceleration and the speed
/// limit let it.
void bound_by_way(Request& request, const Params& params, const Situation& s) {
  const Vec2 bow = axis_of(s.own, 0);
  const double ahead = bow.dot(s.own.velocity.head<2>());
  const double within_reach = ahead + params.response_s * math::cos(pi / 8) * s.limits.max_acceleration;
  const double kept = std::min({s.limits.min_speed, s.limits.max_speed, within_reach});
  request.bound(bow, (kept - ahead) / params.response_s);
}

/// a = (v_d - v) / T, within an octagon inside the circle of the greatest acceleration, within the forces of
/// axes that have an actuator, since along one that has none the vehicle turns, and ahead for who must.
Request request_of_velocities(const Params& params, const Situation& s, const Vec3& wanted) {
  const Vec2 v = s.own.velocity.head<2>();
  Request request{.nominal = wanted.head<2>() / params.response_s,
                  .origin = v / params.response_s,
                  .max_length = math::fmax(s.limits.max_speed, v.norm()) / params.response_s};
  for (int side = 0; s.limits.max_acceleration < Limits::none && side < 8; ++side) {
    const double bearing = s.own.yaw + side * pi / 4;
    request.bound(unit_at(bearing), -math::cos(pi / 8) * s.limits.max_acceleration);
  }
  for (int axis = 0; has_masses(s.model) && axis < 2; ++axis)
    if (s.model->least[axis] < s.model->greatest[axis])
      bound_by_forces(request, params, s.own, *s.model, axis);
  if (only_goes_ahead(s.limits)) bound_by_way(request, params, s);
  return request;
}

/// The barriers of everything near, on the stack.
class Barriers {
 public:
  /// For forces with a `response` of zero.
  Barriers(const Params& params, const Situation& s, double response) : own_{s.own} {
    const BarrierGains gains{params.k1_hz, params.k2_hz, params.margin_m + s.own.position_error(), response};
    find_hazards_near(s, params.activation_m, hazards_);
    count_ = hazards_.count;
    for (std::size_t i = 0; i < count_; ++i) barriers_[i] = barrier(hazards_.all[i], s.own, gains);
  }

  bool empty() const { return count_ == 0; }
  bool left_out() const { return hazards_.left_out; }
  bool any_late() const {
    return std::any_of(barriers_.begin(), barriers_.begin() + count_,
                       [](const Barrier& b) { return b.is_late; });
  }

  /// As the velocities that the accelerations they allow lead to within the response time.
  void draw(double response, Sketch& sketch) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const HalfPlane& h = barriers_[i].acceleration;
      const double least = response * h.offset + h.normal.dot(own_.velocity.head<2>());
      const Vec3 normal{h.normal.x(), h.normal.y(), 0.0};
      sketch.half_space(least * normal, normal, "allowed by a barrier");
    }
  }

  /// The filtered acceleration from the request's origin, or nothing if the nominal one, as far as it is
  /// possible, keeps every barrier.
  std::optional<PlaneChoice> filter(const Params& params, const Request& request) const {
    std::array<HalfPlane, max_bounds + max_hazards> all;
    std::size_t n = 0;
    for (const HalfPlane& h : request.hard()) all[n++] = h;
    for (std::size_t i = 0; i < count_; ++i) {
      const HalfPlane& h = barriers_[i].acceleration;
      all[n++] = {h.normal, h.offset + h.normal.dot(request.origin)};
    }

    const Vec2 possible =
        nearest_in_plane({request.hard(), request.bound_count, request.max_length}, request.nominal).point;
    std::size_t worst = request.bound_count;
    for (std::size_t i = worst; i < n; ++i)
      if (all[i].violation(possible) > all[worst].violation(possible)) worst = i;
    const double violation = all[worst].violation(possible);
    if (violation <= 0.0) return {};

    const Vec2 beside =
        violation * sidestep(params, request, all[worst], hazards_.all[worst - request.bound_count]);
    return nearest_in_plane({{all.data(), n}, request.bound_count, request.max_length},
                            request.nominal + beside);
  }

 private:
  /// Where the wanted motion relative to the hazard leads straight at its middle, a push back ends in a
  /// standstill in front of it: aside as well, to the side that the motion tends to, to starboard if none.
  Vec2 sidestep(const Params& params, const Request& request, const HalfPlane& h,
                const Hazard& hazard) const {
    const Vec2 acceleration = request.nominal - request.origin;
    const Vec2 wanted = (own_.velocity - hazard.velocity).head<2>() + params.response_s * acceleration;
    const Vec2 starboard{h.normal.y(), -h.normal.x()};
    const double towards = -wanted.dot(h.normal);
    const double aside = wanted.dot(starboard);
    if (towards <= 0.0) return Vec2::Zero();
    const double side = aside < -collinear * towards ? -1.0 : 1.0;
    return params.sidestep_ratio * math::fmax(0.0, 1.0 - std::abs(aside) / towards) * side * starboard;
  }

  const Ownship& own_;
  Hazards hazards_;
  std::array<Barrier, max_hazards> barriers_;
  std::size_t count_ = 0;
};

void draw(Sketch& sketch, const Command& inner, const Command& filtered) {
  sketch.velocity(inner.velocity, "before the safety filter");
  sketch.velocity(filtered.velocity, "after the safety filter");
}

}  // namespace

Command SafetyFilter::decide(const Situation& s, Avoider& inner, Memory& memory,
                             Context& context) const noexcept {
  const Command asked = inner.decide_usable(s, context.sketch);
  if (!trackable::must_turn(s)) {
    Command answer = filtered(s, asked, context.sketch);
    if (answer.note.empty()) answer.note = trackable::words_of_ignorance(s);
    return answer;
  }
  const trackable::Keeping keeping{
      .margins = {.navigation = s.own.position_error(), .extra = params.margin_m}, .hold = params.hold_s};
  return trackable::Keeper{keeping, s, memory}.keep(asked, deviations, context.sketch);
}

Command SafetyFilter::filtered(const Situation& s, const Command& asked, Sketch* sketch) const noexcept {
  const bool by_forces = asked.wrench && has_masses(s.model);
  const Barriers barriers{params, s, by_forces ? 0.0 : params.response_s};
  if (barriers.empty()) return asked;
  if (sketch != nullptr) barriers.draw(params.response_s, *sketch);

  const Request request = by_forces ? request_of_forces(params, s.own, *s.model, *asked.wrench)
                                    : request_of_velocities(params, s, asked.velocity);
  const std::optional<PlaneChoice> choice = barriers.filter(params, request);

  Command answer = asked;
  if (!by_forces) answer.wrench.reset();
  if (barriers.left_out() && answer.note.empty()) answer.note = words_of_left_out;
  if (!choice) return answer;

  const Vec2 acceleration = choice->point - request.origin;
  answer.velocity.head<2>() = s.own.velocity.head<2>() + params.response_s * acceleration;
  for (int axis = 0; by_forces && axis < 2; ++axis) {
    const Vec2 direction = axis_of(s.own, axis);
    (*answer.wrench)[axis] = s.model->mass[axis] * direction.dot(acceleration) +
                             s.model->drag(axis, direction.dot(s.own.velocity.head<2>()));
  }
  if (!by_forces) {  // these are of the velocity that was asked for, and lead along the bow
    answer.turn_rate.reset();
    answer.heading.reset();
  }
  answer.astern = true;
  answer.mode = choice->is_feasible() ? Mode::avoid : Mode::infeasible;
  if (barriers.any_late()) answer.note = "closing in faster than the safety filter lets: it began too late";
  if (!choice->is_feasible()) answer.note = "nothing within the bounds keeps clear of all";
  if (sketch != nullptr) draw(*sketch, asked, answer);
  return answer;
}

}  // namespace fairway
