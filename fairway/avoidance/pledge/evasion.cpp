// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/pledge/evasion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::pledge {
namespace {

constexpr double heaving = 1.0;         // before it climbs or dives [s]
constexpr double sooner = 10.0;         // what is so far ahead weighs half as much as what is now [s]
constexpr double stopped_share = 0.25;  // by which it counts where others may have stopped
constexpr double of_going = 0.002;      // what a metre costs, as nearness [m2/m]
constexpr std::array durations{4.0, 8.0, 16.0};  // for which it goes [s]
constexpr std::size_t course_count = 8;

double seconds_ahead(std::size_t second) noexcept { return static_cast<double>(second + 1); }

/// What lacks of a distance, squared [m2].
double lacking(double apart, double distance_squared) noexcept {
  const double lacks = math::fmax(apart - std::sqrt(distance_squared), 0.0);
  return lacks * lacks;
}

}  // namespace

Evasion::Evasion(const Situation& s, double turn) noexcept : s_{s}, turn_{turn} {
  for (std::size_t i = 0; i < seconds; ++i)
    adrift_[i] = s.own.position + stopping * (1.0 - math::exp(-seconds_ahead(i) / stopping)) * s.own.velocity;
}

void Evasion::avoid(const Reference& way, double apart) noexcept {
  if (count_ == most_others) return;
  Other& other = others_[count_++];
  other.apart = apart;
  other.moves = way.knots().size() > 1;
  for (std::size_t i = 0; i < seconds; ++i) other.path[i] = way.at(s_.time + seconds_ahead(i));
}

/// It begins to go level some seconds ahead, once it has turned.
Evasion::Path Evasion::gone(const Vec3& velocity, double begins, double lasts) const noexcept {
  Path path = adrift_;
  const double ceiling = math::fmax(s_.limits.min_depth, std::min(0.0, s_.own.position.z()));
  const double floor = math::fmax(s_.limits.max_depth, ceiling);
  for (std::size_t i = 0; i < seconds; ++i) {
    const double level = std::clamp(seconds_ahead(i) - begins, 0.0, lasts);
    const double steep = std::clamp(seconds_ahead(i) - heaving, 0.0, lasts);
    path[i] += Vec3{level * velocity.x(), level * velocity.y(), steep * velocity.z()};
    path[i].z() = std::clamp(path[i].z(), ceiling, floor);
  }
  return path;
}

double Evasion::Other::nearness(const Vec3& place, std::size_t second) const noexcept {
  const double sum = lacking(apart, (place - path[second]).squaredNorm());
  if (!moves) return sum;
  double nearest = apart * apart;
  for (std::size_t i = 0; i < second; i += 2) nearest = std::min(nearest, (place - path[i]).squaredNorm());
  return sum + stopped_share * lacking(apart, nearest);
}

/// What lacks of the distances that are wanted, squared, in all seconds [m2]; anything more than `enough`
/// where it is more.
double Evasion::nearness(const Path& own, double enough) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < seconds && sum < enough; ++i) {
    double now = 0.0;
    for (std::size_t k = 0; k < count_; ++k) now += others_[k].nearness(own[i], i);
    for (const Obstacle& obstacle : s_.obstacles) {
      const double off = math::fmax(nearest_point(obstacle, own[i]).distance, 0.0);
      now += lacking(s_.own.radius, off * off);
    }
    sum += now * sooner / (sooner + static_cast<double>(i));
  }
  return sum;
}

std::optional<Vec3> Evasion::best() const noexcept {
  double least = nearness(gone(Vec3::Zero(), 0.0, 0.0), std::numeric_limits<double>::infinity());
  if (least <= 0.0) return {};
  std::optional<Vec3> found;
  const auto consider = [&](const Vec3& wanted, double begins) {
    const Vec3 velocity = within_limits(s_, wanted);
    for (const double lasts : durations) {
      const double going = of_going * lasts * velocity.norm();
      const double near = going + nearness(gone(velocity, begins, lasts), least - going);
      if (near >= least) continue;
      least = near;
      found = velocity;
    }
  };
  const double able = s_.envelope != nullptr ? s_.envelope->ahead : s_.goal.cruise_speed;
  const double speed = std::min(able, s_.limits.max_speed);
  for (const double steep : {-speed, 0.0, speed}) {
    if (steep != 0.0) consider({0.0, 0.0, steep}, 0.0);
    for (std::size_t k = 0; k < course_count; ++k) {
      const double off = wrap_angle(2.0 * pi * static_cast<double>(k) / course_count);
      const Vec2 through = speed * unit_at(s_.own.yaw + off);
      const double begins = math::fmax(stopping, turn_ * std::fabs(off) / pi);
      consider({through.x() + s_.current.x(), through.y() + s_.current.y(), steep}, begins);
    }
  }
  return found;
}

}  // namespace fairway::pledge
