// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa_improved/outlook.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::avoa_improved {
namespace {

/// Slower than this is stopped [m/s].
constexpr double stopped = 0.02;

/// This near to a heading it is nearly reached [rad].
constexpr double nearly = 0.4;

/// More than rounding makes of a distance.
constexpr double beyond_rounding = 1.0 + 1e-9;

/// Something that neither of two goes in a step, so that nothing is divided by none [m].
constexpr double least = 1e-9;

/// Where the margin is lost already, this share of what is left of it is kept.
constexpr double kept_of_lost = 0.9;

std::size_t steps_in(double window) {
  const double steps = std::ceil(window / Outlook::step);
  return static_cast<std::size_t>(std::clamp(steps, 1.0, static_cast<double>(Outlook::most_steps)));
}

/// What comes later weighs less: the command will have changed by then.
double weight_at(double t, double window) { return math::fmax(0.0, 1.0 - t / (window + Outlook::step)); }

}  // namespace

Outlook::Outlook(const VesselResponse& helm, const Foresight& foresight, const OwnMotion& own,
                 double own_radius, double greatest_speed, std::span<const Capsule> fixed,
                 std::span<const Capsule> moving) noexcept
    : helm_{helm},
      foresight_{foresight},
      own_{own},
      own_radius_{own_radius},
      steps_{steps_in(foresight.window)},
      hold_steps_{foresight.turn_aware ? std::min(steps_, steps_in(foresight.hold)) : steps_},
      gone_{helm.share(step)} {
  const double fastest = math::fmax(greatest_speed, std::abs(own.speed)) + own.drift.norm();
  const double stopping = helm.response + fastest / helm.max_acceleration;
  const double fixed_for =
      math::fmin(foresight.window, math::fmax(foresight.near, foresight.hold + stopping));
  for (const Capsule& solid : fixed) add_if_near(solid, fastest * fixed_for, fixed_, fixed_count_);
  for (const Capsule& solid : moving)
    add_if_near(solid, (fastest + solid.velocity.norm()) * foresight.window, moving_, moving_count_);
}

void Outlook::add_if_near(const Capsule& solid, double reach, std::array<Hazard, Capsules::capacity>& to,
                          std::size_t& count) noexcept {
  const double contact = solid.radius + own_radius_;
  const double gap = distance_to_axis(solid, own_.position) - contact;
  if (gap > reach + foresight_.margin + foresight_.danger) return;
  const double left = gap > 0.0 ? kept_of_lost * gap : gap;
  const double keep = std::min(foresight_.margin, left);
  const double far = beyond_rounding * (contact + keep + foresight_.danger);
  to[count++] = {&solid, contact, keep, far, step * solid.velocity.norm()};
}

const Outlook::TurnAhead& Outlook::turn_to(double heading, std::size_t index) noexcept {
  TurnAhead& turn = turns_[index];
  if (turn.is_known) return turn;
  turn.is_known = true;
  turn.reached = 0;
  if (!foresight_.turn_aware) {
    turn.direction.fill(unit_at(heading));
    return turn;
  }
  double yaw = own_.yaw;
  double rate = own_.yaw_rate;
  for (std::size_t k = 0; k < steps_; ++k) {
    const double before = rate;
    if (std::abs(wrap_angle(heading - yaw)) > nearly) turn.reached = k + 1;
    rate = helm_.turn_rate_after(rate, helm_.turn_rate(wrap_angle(heading - yaw)), step, gone_);
    const double turned = 0.5 * (before + rate) * step;
    turn.direction[k] = unit_at(yaw + 0.5 * turned);
    yaw += turned;
  }
  return turn;
}

void Outlook::advance(Advance& at, double speed, const Vec2& direction) const noexcept {
  const double before = foresight_.turn_aware ? at.speed : speed;
  at.speed = foresight_.turn_aware ? helm_.speed_after(before, speed, step, gone_) : speed;
  at.position += step * (0.5 * (before + at.speed) * direction + own_.drift);
}

Outlook::Room Outlook::room(Watch& watch, std::size_t k, const Vec2& own, double t) const noexcept {
  Room found{.beyond = Limits::none};
  for (std::size_t i = 0; i < watch.hazards.size(); ++i) {
    if (k < watch.next[i]) continue;
    const Hazard& hazard = watch.hazards[i];
    const Capsule& solid = *hazard.solid;
    const Vec2 relative = own - t * solid.velocity;
    const double distance =
        solid.is_disc() ? (relative - solid.from).norm() : distance_to_axis(solid, relative);
    if (distance >= hazard.far) {
      const double steps = (distance - hazard.far) / (beyond_rounding * (watch.gone + hazard.gone) + least);
      watch.next[i] = static_cast<std::uint8_t>(math::fmin(static_cast<double>(k + 1) + steps, most_steps));
      continue;
    }
    found.beyond = math::fmin(found.beyond, distance - hazard.contact - hazard.keep);
    found.is_none = found.is_none || (hazard.keep > 0.0 && distance < hazard.contact);
  }
  return found;
}

void Outlook::weigh(const Room& room, double t, double window, Prospect& prospect) const noexcept {
  // hulls that have touched stay where they are
  prospect.touches = prospect.touches || room.is_none;
  if (!prospect.touches && room.beyond >= foresight_.danger) return;
  const double weight = weight_at(t, window);
  prospect.severity += weight * (prospect.touches ? own_radius_ : math::fmax(0.0, -room.beyond));
  if (room.beyond >= foresight_.danger) return;
  const double closeness = math::fmin(1.0, 1.0 - room.beyond / foresight_.danger);
  prospect.danger = math::fmax(prospect.danger, weight * closeness);
}

bool Outlook::can_stop(Advance at, const TurnAhead& turn, std::size_t from, Watch watch) const noexcept {
  for (std::size_t k = from; k < steps_ && std::abs(at.speed) > stopped; ++k) {
    advance(at, 0.0, turn.direction[k]);
    if (room(watch, k, at.position, 0.0).beyond < 0.0) return false;
  }
  return true;
}

Prospect Outlook::of(const Manoeuvre& m, double bearable) noexcept {
  return foresee(m, [=](const Prospect& p) { return p.is_clear && !(p.danger > bearable); });
}

Prospect Outlook::to_the_end_of(const Manoeuvre& m, double too_severe) noexcept {
  return foresee(m, [=](const Prospect& p) { return !(p.severity >= too_severe); });
}

template <class GoOn>
Prospect Outlook::foresee(const Manoeuvre& m, GoOn go_on) noexcept {
  const TurnAhead& turn = turn_to(m.heading, m.heading_index);
  const double fastest = std::max({std::abs(own_.speed), std::abs(m.speed), std::abs(m.speed_after)});
  const double gone = step * (fastest + own_.drift.norm());
  Watch on_fixed{fixed(), gone};
  Watch on_moving{moving(), gone};
  Prospect prospect{.is_clear = true};
  Advance at{own_.position, own_.speed};
  Advance kept = at;  // without what is to follow: who comes will not wait for it
  for (std::size_t k = 0; k < steps_ && go_on(prospect); ++k) {
    const double t = step * static_cast<double>(k + 1);
    if (k == hold_steps_) prospect.is_clear = prospect.is_clear && can_stop(at, turn, k, on_fixed);
    advance(at, k < turn.reached ? m.speed : m.speed_after, turn.direction[k]);
    advance(kept, m.speed, turn.direction[k]);

    const Room from_moving = room(on_moving, k, kept.position, t);
    prospect.is_clear = prospect.is_clear && from_moving.beyond >= 0.0;
    weigh(from_moving, t, foresight_.window, prospect);

    if (k >= hold_steps_ && t > foresight_.near) continue;
    const Room from_fixed = room(on_fixed, k, at.position, 0.0);
    prospect.is_clear = prospect.is_clear && (k >= hold_steps_ || from_fixed.beyond >= 0.0);
    weigh(from_fixed, t, foresight_.near, prospect);
  }
  return prospect;
}

std::span<const Vec2> Outlook::path(const Manoeuvre& m) noexcept {
  const TurnAhead& turn = turn_to(m.heading, m.heading_index);
  Advance at{own_.position, own_.speed};
  for (std::size_t k = 0; k < steps_; ++k) {
    advance(at, k < turn.reached ? m.speed : m.speed_after, turn.direction[k]);
    path_[k] = at.position;
  }
  return {path_.data(), steps_};
}

}  // namespace fairway::avoa_improved
