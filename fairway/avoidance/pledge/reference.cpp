// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

// of a ring, by one straight piece at most [rad]
constexpr double piece = std::numbers::pi / 9.0;
// at a corner sharper than this a member halts and turns [rad]; the corners of a ring are 0.35
constexpr double sharp = 0.5;
// on a level at least: who climbed at once after its dive would lag by more than its tube [s]
constexpr double level_rest = 8.0;
constexpr double level_gap = 2.5;  // between the spheres of two on levels, for their tubes of a metre [m]
// within it of the destination a member may end, beyond what it is off its way when it arrives [m]
constexpr double surely = 0.8;

/// The corners of a horizontal way.
struct Line {
  std::array<Vec2, 20> corners{};
  std::size_t count{0};

  void add(const Vec2& corner) {
    if (count < corners.size()) corners[count++] = corner;
  }
};

/// Where on the ring the way from `from` meets it, as a bearing from the centre: by a tangent, or from within
/// straight outwards. `side` is 1 if the ring is gone round with the centre to starboard.
double contact(const Vec2& from, const Vec2& centre, double radius, double side) {
  const Vec2 out = from - centre;
  return math::atan2(out.y(), out.x()) +
         side * math::acos(std::min(radius / math::fmax(out.norm(), 1e-9), 1.0));
}

/// Straight on, or by a ring; straight too where that stays clear of the ring on the side on which it is
/// passed.
Line line_of(const Vec2& from, const Vec2& to, const Plan& plan, double radius) {
  Line line;
  line.add(from);
  const double side = plan.to_port ? -1.0 : 1.0;
  if (radius > 0.0) {
    // with the centre to starboard bearings from it grow
    const double begins = contact(from, plan.centre, radius, side);
    const double ends = contact(to, plan.centre, radius, -side);
    double swept = side * (ends - begins);
    swept -= 2.0 * std::numbers::pi * std::floor(swept / (2.0 * std::numbers::pi));
    if (swept < 1.5 * std::numbers::pi) {
      const int pieces = static_cast<int>(std::floor(swept / piece)) + 1;
      for (int i = 0; i <= pieces; ++i)
        line.add(plan.centre + radius * unit_at(begins + side * swept * (static_cast<double>(i) / pieces)));
    }
  }
  line.add(to);
  return line;
}

/// Up to where it is as near to the place as it needs to be.
Reference ended_near(const Reference& whole, const Vec3& place, double distance) {
  const double time = first_within(whole, place, distance);
  return time < whole.end() ? whole.until(time) : whole;
}

/// How far along its passage a member is at a time, and how deep.
struct Milestone {
  double time{};   ///< [s]
  double along{};  ///< its passage, by the time that this takes without levels [s]
  double depth{};  ///< [m]
};

/// When it begins to go, to dive or to turn by a plan [s].
double leaves_at(const Member& member, const Plan& plan, const Code& code) {
  return plan.start() + delay_of(member, code) + (member.turns_before ? set_off : 0.0);
}

/// Evenly from one milestone to the next.
class Milestones {
 public:
  void add(const Milestone& next) { all_[count_++] = next; }
  std::span<const Milestone> all() const { return {all_.data(), count_}; }

  Milestone at(double time) const { return between(&Milestone::time, time); }
  /// When it is so far along.
  double time_of(double along) const { return between(&Milestone::along, along).time; }

 private:
  Milestone between(double Milestone::*by, double value) const {
    std::size_t after = 1;
    while (after + 1 < count_ && all_[after].*by < value) ++after;
    const Milestone &a = all_[after - 1], &b = all_[after];
    const double span = b.*by - a.*by;
    const double share = span > 0.0 ? std::clamp((value - a.*by) / span, 0.0, 1.0) : 1.0;
    return {a.time + share * (b.time - a.time), a.along + share * (b.along - a.along),
            a.depth + share * (b.depth - a.depth)};
  }

  std::array<Milestone, 5> all_{};
  std::size_t count_{0};
};

/// Down from `leaves` on, along the level, and up again to be there at the end of a passage of `duration`.
/// While it dives and climbs it is slower along by what that takes of its speed, or, on the spot, halts.
Milestones milestones_of(const Member& member, const Code& code, double leaves, double duration) {
  const double from = member.anchor.z(), to = member.destination.z();
  const double level = math::fmax(from, to) + code.dive * level_step(member);
  const bool on_the_spot = is_on_the_spot(member, code);
  const auto share_left = [&](double rate) {
    if (on_the_spot) return 0.0;
    return std::sqrt(math::fmax(1.0 - rate * rate / (member.speed * member.speed), 0.0));
  };
  const double is_down = leaves + (level - from) / member.descent;
  const double turned = leaves + turns_for(member), goes = on_the_spot ? math::fmax(turned, is_down) : turned;
  const double climbs_for = (level - to) / member.climb;
  const double along_diving =
      std::min(share_left(member.descent) * math::fmax(is_down - goes, 0.0), duration);
  const double along_level = math::fmax(duration - along_diving - share_left(member.climb) * climbs_for, 0.0);
  const double rises = math::fmax(goes, is_down) + math::fmax(along_level, level_rest);

  Milestones way;
  way.add({leaves, 0.0, from});
  if (goes < is_down) way.add({goes, 0.0, from + member.descent * turns_for(member)});
  way.add({is_down, along_diving, level});
  if (goes >= is_down) way.add({goes, 0.0, level});
  way.add({rises, along_diving + along_level, level});
  way.add({rises + climbs_for, duration, to});
  return way;
}

Reference below_others(const Member& member, const Plan& plan, const Code& code, const Passage& passage) {
  const double leaves = leaves_at(member, plan, code);
  const Milestones way = milestones_of(member, code, leaves, passage.duration());
  std::array<double, Reference::most_knots> times{};
  std::size_t count = 0;
  for (const Milestone& each : way.all()) times[count++] = each.time;
  for (const double along : passage.times()) times[count++] = way.time_of(along);
  std::sort(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(count));

  Reference whole;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && times[i] <= times[i - 1]) continue;
    const Milestone now = way.at(times[i]);
    const Vec2 place = passage.at(now.along);
    whole.add({times[i], {place.x(), place.y(), now.depth}});
  }
  return ended_near(whole, member.destination, ends_before(member));
}

/// When two that move evenly for `duration` are first within `distance`, from now; never if never.
double time_within(const Vec3& apart, const Vec3& velocity, double duration, double distance) {
  const double a = velocity.squaredNorm(), b = apart.dot(velocity);
  const double c = apart.squaredNorm() - distance * distance;
  if (c <= 0.0) return 0.0;
  const double under = b * b - a * c;
  if (a <= 0.0 || b >= 0.0 || under < 0.0) return never;
  const double time = (-b - std::sqrt(under)) / a;
  return time <= duration ? time : never;
}

/// The place at a time, where `after` is the number of the first knot behind it.
Vec3 between(std::span<const Knot> knots, std::size_t after, double time) {
  if (after == 0) return knots.front().position;
  if (after == knots.size()) return knots.back().position;
  const Knot &a = knots[after - 1], &b = knots[after];
  return a.position + ((time - a.time) / (b.time - a.time)) * (b.position - a.position);
}

}  // namespace

Vec3 Reference::at(double time) const noexcept {
  std::size_t after = 0;
  while (after < count_ && knots_[after].time <= time) ++after;
  return between(knots(), after, time);
}

Vec3 Reference::velocity(double time) const noexcept {
  const std::span<const Knot> all = knots();
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (time >= all[i - 1].time && time < all[i].time)
      return (all[i].position - all[i - 1].position) / (all[i].time - all[i - 1].time);
  }
  return Vec3::Zero();
}

Reference Reference::until(double time) const noexcept {
  Reference shorter;
  for (const Knot& knot : knots()) {
    if (knot.time < time) shorter.add(knot);
  }
  shorter.add({time, at(time)});
  return shorter;
}

Reference Reference::moved(double seconds, const Vec3& off) const noexcept {
  Reference other;
  for (const Knot& knot : knots()) other.add({knot.time + seconds, knot.position + off});
  return other;
}

Passage::Passage(const Member& member, const Plan& plan, std::uint8_t ring) noexcept {
  const Line line = line_of(member.anchor.head<2>(), member.destination.head<2>(), plan,
                            ring_radius[ring] * ring_scale[plan.scale]);
  const double speed = math::fmax(member.speed, 0.01);
  double time = 0.0;
  for (std::size_t i = 0; i < line.count; ++i) {
    const Vec2& corner = line.corners[i];
    if (i > 0) time += (corner - line.corners[i - 1]).norm() / speed;
    add(time, corner);
    if (i == 0 || i + 1 == line.count) continue;
    const Vec2 before = corner - line.corners[i - 1], after = line.corners[i + 1] - corner;
    const double angle = std::fabs(math::atan2(cross(before, after), before.dot(after)));
    if (angle > sharp) add(time += member.turn * angle / std::numbers::pi, corner);
  }
}

Vec2 Passage::at(double time) const noexcept {
  std::size_t i = 1;
  while (i + 1 < count_ && times_[i] < time) ++i;
  if (count_ < 2 || times_[i] <= times_[i - 1]) return places_[count_ < 2 ? 0 : i];
  const double share = std::clamp((time - times_[i - 1]) / (times_[i] - times_[i - 1]), 0.0, 1.0);
  return places_[i - 1] + share * (places_[i] - places_[i - 1]);
}

Reference reference_of(const Member& member, const Plan& plan, const Code& code) noexcept {
  return reference_of(member, plan, code, Passage{member, plan, code.ring});
}

Reference reference_of(const Member& member, const Plan& plan, const Code& code,
                       const Passage& passage) noexcept {
  if (is_below(member, code)) return below_others(member, plan, code, passage);
  const double leaves = leaves_at(member, plan, code), goes = leaves + turns_for(member);
  const double down = member.destination.z() - member.anchor.z();
  const double rate = math::fmax(down > 0.0 ? member.descent : member.climb, 0.01);
  const double along = turns_for(member) + passage.duration(), vertical = std::fabs(down) / rate;
  const double dives = leaves + math::fmax(along - vertical, 0.0) * code.dive / 3.0;

  std::array<double, Reference::most_knots> times{leaves, dives, dives + vertical};
  std::size_t count = 3;
  for (const double time : passage.times()) times[count++] = goes + time;
  std::sort(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(count));

  Reference whole;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && times[i] <= times[i - 1]) continue;
    const Vec2 place = passage.at(times[i] - goes);
    const double share = vertical > 0.0 ? std::clamp((times[i] - dives) / vertical, 0.0, 1.0) : 1.0;
    whole.add({times[i], {place.x(), place.y(), member.anchor.z() + share * down}});
  }
  return ended_near(whole, member.destination, ends_before(member));
}

bool has_levels(const Member& member) noexcept {
  return std::fabs(member.destination.z() - member.anchor.z()) < level_within &&
         member.descent > level_keeping && member.climb > level_keeping && member.speed > level_keeping;
}

bool is_below(const Member& member, const Code& code) noexcept { return code.dive > 0 && has_levels(member); }

bool is_on_the_spot(const Member& member, const Code& code) noexcept {
  return is_below(member, code) && code.delay % 2 == 1;
}

double turns_ahead_by(const Member& member) noexcept {
  return member.turns_before ? math::fmax(member.turn - set_off, 0.0) : 0.0;
}

double turns_for(const Member& member) noexcept { return member.turns_before ? 0.0 : member.turn; }

double delay_of(const Member& member, const Code& code) noexcept {
  return delay_step * (code.delay - (is_on_the_spot(member, code) ? 1 : 0));
}

double level_step(const Member& member) noexcept { return 2.0 * member.radius + level_gap; }

double ends_before(const Member& member) noexcept { return math::fmax(member.arrival - surely, 0.0); }

double least_distance(std::span<const Knot> a, std::span<const Knot> b, double from, double to,
                      double enough) noexcept {
  double least = never;
  double begins = from;
  std::size_t i = 0, j = 0;
  for (;;) {
    while (i < a.size() && a[i].time <= begins) ++i;
    while (j < b.size() && b[j].time <= begins) ++j;
    const Vec3 apart = between(a, i, begins) - between(b, j, begins);
    const double ends = std::min({i < a.size() ? a[i].time : never, j < b.size() ? b[j].time : never, to});
    if (ends == never) return std::min(least, apart.norm());
    const Vec3 change = between(a, i, ends) - between(b, j, ends) - apart;
    const double square = change.squaredNorm();
    const double share = square > 0.0 ? std::clamp(-apart.dot(change) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, (apart + share * change).norm());
    if (ends >= to || least < enough) return least;
    begins = ends;
  }
}

double first_within(const Reference& reference, const Vec3& place, double distance) noexcept {
  const std::span<const Knot> all = reference.knots();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const double duration = all[i + 1].time - all[i].time;
    const Vec3 velocity = (all[i + 1].position - all[i].position) / duration;
    const double time = time_within(all[i].position - place, velocity, duration, distance);
    if (time < never) return all[i].time + time;
  }
  return (all.back().position - place).norm() <= distance ? all.back().time : never;
}

}  // namespace fairway::pledge
