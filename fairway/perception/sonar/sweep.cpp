// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double unheard = std::numeric_limits<double>::infinity();

double turn(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Least distance to a disc round (`ahead`, `below`) within `half_aperture` of ahead, in the plane of one
/// beam.
double range_of_disc(double ahead, double below, double radius2, double half_aperture, double tan_aperture) {
  const double distance2 = ahead * ahead + below * below;
  if (distance2 <= radius2) return 0.0;
  const double distance = std::sqrt(distance2);
  if (std::abs(below) <= ahead * tan_aperture) return distance - std::sqrt(radius2);

  // its centre is outside: along the edge of the beam that is nearer to it
  const double off = std::abs(math::atan2(below, ahead)) - half_aperture;
  const auto [sine, cosine] = math::sin_cos(off);
  const double chord2 = radius2 - distance2 * sine * sine;
  if (off >= 0.5 * pi || chord2 < 0.0) return unheard;
  return distance * cosine - std::sqrt(chord2);
}

/// Numbers t from `low` to `high`.
struct Interval {
  double low;
  double high;

  /// Leaves those with at + slope t >= 0.
  void keep_positive(double at, double slope) {
    if (slope > 0.0) low = std::max(low, -at / slope);
    if (slope < 0.0) high = std::min(high, -at / slope);
    if (slope == 0.0 && at < 0.0) high = -unheard;
  }
  bool is_empty() const { return low > high; }
};

}  // namespace

Sweep::Sweep(const SonarParams& params)
    : half_field_{0.5 * radians(params.field_of_view_deg)},
      half_aperture_{0.5 * radians(params.vertical_aperture_deg)},
      tan_aperture_{math::sin(half_aperture_) / math::cos(half_aperture_)},
      max_range_{params.max_range_m},
      spacing_{radians(params.field_of_view_deg) / params.beams_count},
      bearings_n_(static_cast<std::size_t>(params.beams_count), Vec2::Zero()),
      ranges_(static_cast<std::size_t>(params.beams_count), unheard) {
  for (std::size_t beam = 0; beam < ranges_.size(); ++beam) bearings_b_.push_back(unit_at(bearing(beam)));
}

void Sweep::look_from(const Vec3& p_n, const Eigen::Quaterniond& q_nb) {
  origin_ = p_n;
  q_bn_ = q_nb.conjugate();
  const Mat3 R_nb = q_nb.toRotationMatrix();
  down_n_ = R_nb.col(2).head<2>();
  for (std::size_t beam = 0; beam < ranges_.size(); ++beam)
    bearings_n_[beam] = R_nb.topLeftCorner<2, 2>() * bearings_b_[beam];
  std::ranges::fill(ranges_, unheard);
}

Sweep::Beams Sweep::beams_between(double low, double high) const {
  const auto beam_from = [&](double bearing) {
    const double beam = std::ceil((bearing + half_field_) / spacing_ - 0.5);
    return static_cast<std::size_t>(std::clamp(beam, 0.0, static_cast<double>(ranges_.size())));
  };
  return {beam_from(low), beam_from(std::nextafter(high, unheard))};
}

void Sweep::hear(std::size_t beam, double range) {
  if (range <= max_range_) ranges_[beam] = std::min(ranges_[beam], range);
}

void Sweep::add_sphere(const Vec3& centre, double radius) {
  const Vec3 c_b = q_bn_ * (centre - origin_);
  if (c_b.squaredNorm() > (max_range_ + radius) * (max_range_ + radius)) return;
  const Vec2 c = c_b.head<2>();
  const double distance = c.norm();
  const double middle = math::atan2(c.y(), c.x());
  const double half_width = distance > radius ? math::asin(radius / distance) : 2.0 * pi;

  const Beams seen = beams_between(middle - half_width, middle + half_width);
  for (std::size_t beam = seen.first; beam < seen.end; ++beam) {
    const double aside = turn(bearings_b_[beam], c);
    const double radius2 = radius * radius - aside * aside;
    if (radius2 < 0.0) continue;
    hear(beam, range_of_disc(bearings_b_[beam].dot(c), c_b.z(), radius2, half_aperture_, tan_aperture_));
  }
}

void Sweep::add(const Obstacle& obstacle) {
  const double distance = nearest_point(obstacle, origin_).distance;
  if (distance > max_range_) return;
  if (distance <= 0.0) {
    std::ranges::fill(ranges_, 0.0);
    return;
  }
  switch (obstacle.kind) {
    case Obstacle::Kind::sphere:
      return add_sphere(obstacle.position, obstacle.radius);
    case Obstacle::Kind::segment:
      return add_segment(obstacle.from, obstacle.to);
    case Obstacle::Kind::polygon:
      for (std::size_t i = 0, j = obstacle.vertices.size() - 1; i < obstacle.vertices.size(); j = i++)
        add_wall(obstacle.vertices[j].head<2>(), obstacle.vertices[i].head<2>());
  }
}

void Sweep::add_segment(const Vec3& from, const Vec3& to) {
  const Vec3 a = q_bn_ * (from - origin_);
  const Vec3 b = q_bn_ * (to - origin_);
  const double of_a = math::atan2(a.y(), a.x());
  const double of_b = math::atan2(b.y(), b.x());

  // one that passes astern may be seen at both ends
  Beams seen = beams_between(std::min(of_a, of_b), std::max(of_a, of_b));
  if (std::abs(of_a - of_b) > pi) seen = {0, ranges_.size()};
  for (std::size_t beam = seen.first; beam < seen.end; ++beam) {
    const Vec2& u = bearings_b_[beam];
    const double side_a = turn(u, a.head<2>());
    const double side_b = turn(u, b.head<2>());
    if (side_a * side_b > 0.0 || side_a == side_b) continue;
    const Vec3 met = a + side_a / (side_a - side_b) * (b - a);
    const double ahead = u.dot(met.head<2>());
    if (ahead >= 0.0 && std::abs(met.z()) <= ahead * tan_aperture_) hear(beam, met.norm());
  }
}

void Sweep::add_wall(const Vec2& from, const Vec2& to) {
  // seen from the sonar, `a` is the end to port and `b` the one to starboard
  Vec2 a = from - origin_.head<2>();
  Vec2 b = to - origin_.head<2>();
  if (turn(a, b) < 0.0) a.swap(b);
  const double length = (b - a).norm();
  if (length == 0.0) return;
  const double distance = turn(a, b) / length;
  if (distance > max_range_) return;
  const Vec2 normal = Vec2{b.y() - a.y(), a.x() - b.x()} / length;

  // a direction of a beam is u + t down, t the tangent of its elevation; both ends bound t linearly
  const Interval aperture{-tan_aperture_, tan_aperture_};
  for (std::size_t beam = 0; beam < ranges_.size(); ++beam) {
    const Vec2& u = bearings_n_[beam];
    Interval t = aperture;
    t.keep_positive(turn(a, u), turn(a, down_n_));
    t.keep_positive(turn(u, b), turn(down_n_, b));
    if (t.is_empty()) continue;

    // the wall is nearest where the direction runs most squarely into it
    const double square = normal.dot(u);
    const double tilt = normal.dot(down_n_);
    const auto closing = [&](double tangent) {
      return (square + tilt * tangent) / std::sqrt(1.0 + tangent * tangent);
    };
    double best = std::max(closing(t.low), closing(t.high));
    if (square > 0.0) best = std::max(best, closing(std::clamp(tilt / square, t.low, t.high)));
    if (best > 0.0) hear(beam, distance / best);
  }
}

}  // namespace fairway
