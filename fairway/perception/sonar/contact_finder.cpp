// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/contact_finder.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/perception/sonar/circle_fit.hpp"

namespace fairway {
namespace {

constexpr double least_variance = 1e-4;  // [m2], 1 cm: what is never known better
constexpr double heard_from = 0.25;      // [m], beyond the least range: what is there may reach into it
constexpr double widest_sine = 0.95;     // of half the angle that a thing fills; beyond it is a wall

double square(double x) { return x * x; }

Vec2 place_of(const Echo& echo) { return echo.range * unit_at(echo.bearing); }

}  // namespace

ContactFinder::ContactFinder(const SonarParams& params)
    : params_{params},
      bearing_variance_{square(radians(params.echo_bearing_sigma_deg))},
      chart_{params},
      notch_{params, chart_.spacing()} {
  // two missed beams between them, and noise of both
  neighbourhood_ = 3.0 * chart_.spacing() + 2.0 * std::sqrt(2.0 * bearing_variance_);
  members_.reserve(echo_capacity(params));
  sorted_.reserve(echo_capacity(params));
  sights_.reserve(echo_capacity(params));
  sightings_.reserve(echo_capacity(params));
}

void ContactFinder::find(std::span<const Echo> echoes, std::span<const Obstacle> obstacles,
                         const VehicleState& estimate, std::vector<Contact>& contacts) {
  chart(obstacles, estimate);
  gather(echoes);

  sightings_.clear();
  for (std::size_t first = 0, end = 0; first < members_.size(); first = end) {
    while (end < members_.size() && members_[end].thing == members_[first].thing) ++end;
    sight({sorted_.data() + first, end - first}, echoes);
  }
  std::ranges::sort(sightings_, [](const Sighting& a, const Sighting& b) {
    const double far_a = a.place.squaredNorm();
    const double far_b = b.place.squaredNorm();
    return far_a != far_b ? far_a < far_b : a.place.y() < b.place.y();
  });

  contacts.clear();
  for (const Sighting& sighting : sightings_) contacts.push_back(placed(sighting, estimate));
}

void ContactFinder::chart(std::span<const Obstacle> obstacles, const VehicleState& estimate) {
  chart_.look_from(estimate.p_n, estimate.q_nb);
  has_chart_ = false;
  for (const Obstacle& obstacle : obstacles) {
    if (!obstacle.charted) continue;
    chart_.add(obstacle);
    has_chart_ = true;
  }
}

bool ContactFinder::is_charted(const Echo& echo) const {
  if (!has_chart_) return false;
  const double aside = std::min(params_.chart_tolerance_m / std::max(echo.range, 0.1), 0.5 * pi);
  const auto [first, end] = chart_.beams_between(echo.bearing - aside, echo.bearing + aside);
  const auto near = chart_.ranges().subspan(first, end - first);
  return std::ranges::any_of(
      near, [&](double range) { return std::abs(range - echo.range) <= params_.chart_tolerance_m; });
}

void ContactFinder::gather(std::span<const Echo> echoes) {
  members_.clear();
  std::size_t things = 0;
  for (const Echo& echo : echoes) {
    if (is_charted(echo)) continue;

    // it belongs to what the nearest neighbour of like range belongs to
    std::size_t thing = things;
    for (std::size_t i = members_.size(); i-- > 0;) {
      const Echo& neighbour = members_[i].echo;
      if (echo.bearing - neighbour.bearing > neighbourhood_) break;
      if (std::abs(echo.range - neighbour.range) > params_.cluster_gap_m) continue;
      thing = members_[i].thing;
      break;
    }
    if (thing == things) ++things;
    members_.push_back({thing, echo});
  }
  std::ranges::sort(members_, [](const Member& a, const Member& b) {
    if (a.thing != b.thing) return a.thing < b.thing;
    return a.echo.bearing != b.echo.bearing ? a.echo.bearing < b.echo.bearing : a.echo.range < b.echo.range;
  });
  sorted_.clear();
  sights_.clear();
  for (const Member& member : members_) {
    sorted_.push_back(member.echo);
    sights_.push_back(unit_at(member.echo.bearing));
  }
}

void ContactFinder::sight(std::span<const Echo> thing, std::span<const Echo> echoes) {
  if (const auto notch = notch_.find(thing)) {
    sight(thing.first(*notch), echoes);
    sight(thing.subspan(*notch), echoes);
    return;
  }
  const double extent = (place_of(thing.back()) - place_of(thing.front())).norm();
  if (extent <= params_.max_extent_m) {
    sightings_.push_back(is_cut_off(thing, echoes) ? arc(thing) : disc(thing));
    return;
  }
  std::size_t first = 0;
  for (std::size_t i = 1; i <= thing.size(); ++i) {
    const bool ends =
        i == thing.size() || (place_of(thing[i]) - place_of(thing[first])).norm() > params_.max_extent_m;
    if (!ends) continue;
    sightings_.push_back(piece(thing.subspan(first, i - first)));
    first = i;
  }
}

bool ContactFinder::is_cut_off(std::span<const Echo> thing, std::span<const Echo> echoes) const {
  const Echo& port = thing.front();
  const Echo& starboard = thing.back();
  const double edge = 0.5 * radians(params_.field_of_view_deg) - 0.5 * neighbourhood_;
  if (port.bearing < -edge || starboard.bearing > edge) return true;

  // what is nearer than the sonar hears may be a part of it
  const double least_range = params_.min_range_m + heard_from;
  if (std::ranges::any_of(thing, [&](const Echo& echo) { return echo.range < least_range; })) return true;

  // something nearer stands where it might go on
  const auto hides = [&](const Echo& echo) {
    const bool beside_port = echo.bearing < port.bearing && echo.range < port.range;
    const bool beside_starboard = echo.bearing > starboard.bearing && echo.range < starboard.range;
    return beside_port || beside_starboard;
  };
  const auto from = std::ranges::lower_bound(echoes, port.bearing - neighbourhood_, {}, &Echo::bearing);
  const auto to = std::ranges::upper_bound(echoes, starboard.bearing + neighbourhood_, {}, &Echo::bearing);
  return std::any_of(from, to, hides);
}

ContactFinder::Sighting ContactFinder::disc(std::span<const Echo> thing) const {
  const auto count = static_cast<double>(thing.size());
  double bearing = 0.0;
  for (const Echo& echo : thing) bearing += echo.bearing / count;
  double spread = 0.0;
  for (const Echo& echo : thing) spread += square(echo.bearing - bearing) / count;

  // beams are evenly spread over the angle 2a between the tangents: their variance tells it
  const double noise = bearing_variance_ * (count - 1.0) / count;
  const double evenly = std::max(0.0, spread - noise);
  const double half_angle =
      std::min(0.5 * std::sqrt(12.0 * evenly + square(chart_.spacing())), math::asin(widest_sine));
  const auto [sine, cosine] = math::sin_cos(half_angle);

  // at the angle b off its middle a disc is d (cos b - sqrt(sin^2 a - sin^2 b)) away
  double distance = 0.0;
  double central = 0.0;
  double least_range = thing.front().range;
  for (const Echo& echo : thing) {
    least_range = std::min(least_range, echo.range);
    const double off = echo.bearing - bearing;
    if (std::abs(off) > 0.5 * half_angle) continue;
    const auto [sine_off, cosine_off] = math::sin_cos(off);
    distance += echo.range / (cosine_off - std::sqrt(square(sine) - square(sine_off)));
    central += 1.0;
  }
  distance = central > 0.0 ? distance / central : least_range / (1.0 - sine);

  // errors to first order; of a beam more or less at either side, too
  const double ragged = square(chart_.spacing()) / 24.0;
  const double mean_square = square(half_angle) / 3.0;
  const double spread_variance = (4.0 * mean_square * bearing_variance_ + 2.0 * square(bearing_variance_) +
                                  0.8 * square(mean_square) * params_.missed_ratio) /
                                 count;
  const double angle_variance = square(1.5 / half_angle) * spread_variance + ragged;
  const double radius_per_angle = distance * cosine / (1.0 - sine);
  const double range_variance = square(params_.echo_range_sigma_m / (1.0 - sine)) / std::max(central, 1.0);
  const double aside_variance = (bearing_variance_ + mean_square * params_.missed_ratio) / count + ragged;
  Eigen::Matrix2d sight;
  sight << unit_at(bearing), starboard_of(unit_at(bearing));
  const Vec2 variances{range_variance + square(radius_per_angle) * angle_variance,
                       square(distance) * aside_variance};
  return {.place = distance * sight.col(0),
          .covariance = sight * variances.asDiagonal() * sight.transpose(),
          .radius = distance * sine,
          .radius_variance = square(radius_per_angle) * angle_variance + square(sine) * range_variance};
}

ContactFinder::Sighting ContactFinder::arc(std::span<const Echo> thing) const {
  // its centre is somewhere behind what is seen of it
  const Sighting seen = disc(thing);
  const double scale = 0.25 * params_.max_extent_m;
  const Circle prior{seen.place, seen.radius, square(scale) * Mat3::Identity()};
  const auto first = static_cast<std::size_t>(thing.data() - sorted_.data());
  const auto sights = std::span{sights_}.subspan(first, thing.size());
  const Circle circle = fitted(prior, thing, sights, {square(params_.echo_range_sigma_m), bearing_variance_});

  // what the echoes leave open stays open: in that pings err alike for about a second
  const double alike = std::max(1.0, params_.rate_hz);
  const Mat3 covariance =
      circle.covariance + (alike - 1.0) / square(scale) * circle.covariance * circle.covariance;
  return {.place = circle.centre,
          .covariance = covariance.topLeftCorner<2, 2>(),
          .radius = circle.radius,
          .radius_variance = covariance(2, 2)};
}

ContactFinder::Sighting ContactFinder::piece(std::span<const Echo> thing) const {
  Vec2 middle = Vec2::Zero();
  for (const Echo& echo : thing) middle += place_of(echo) / static_cast<double>(thing.size());
  double reach = 0.0;
  for (const Echo& echo : thing) reach = std::max(reach, (place_of(echo) - middle).norm());

  // where along a wall it was cut is chance
  const double chance = square(reach) / 3.0;
  const Vec2 across = Vec2{-middle.y(), middle.x()};
  return {.place = middle,
          .covariance = (square(params_.echo_range_sigma_m) + chance) * Eigen::Matrix2d::Identity() +
                        bearing_variance_ * across * across.transpose(),
          .radius = reach,
          .radius_variance = chance};
}

Contact ContactFinder::placed(const Sighting& s, const VehicleState& estimate) const {
  const Mat3 R_nb = estimate.q_nb.toRotationMatrix();
  const auto hull = R_nb.leftCols<2>();
  const Vec3 across = hull * Vec2{-s.place.y(), s.place.x()};
  const Vec3 down = R_nb.col(2);

  // a ball touches the beam with its centre up to a radius outside; everywhere there it is as likely
  const double half_aperture = 0.5 * radians(params_.vertical_aperture_deg);
  const double height = s.place.norm() * math::sin(half_aperture) + s.radius;
  const double heading_variance = square(radians(params_.heading_sigma_deg));

  Contact contact{.position = estimate.p_n + hull * s.place,
                  .radius = s.radius,
                  .radius_sigma = std::sqrt(s.radius_variance + least_variance)};
  contact.lasting =
      heading_variance * across * across.transpose() + square(height) / 3.0 * down * down.transpose();
  contact.covariance =
      contact.lasting + hull * s.covariance * hull.transpose() + least_variance * Mat3::Identity();
  return contact;
}

}  // namespace fairway
