// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/contact_finder.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

constexpr double least_variance = 1e-4;  // [m2], 1 cm: what is never known better
constexpr double widest_sine = 0.95;     // of half the angle that a thing fills; beyond it is a wall

double square(double x) { return x * x; }

Vec2 place_of(const Echo& echo) { return echo.range * Vec2{std::cos(echo.bearing), std::sin(echo.bearing)}; }

}  // namespace

ContactFinder::ContactFinder(const SonarParams& params)
    : params_{params}, bearing_variance_{square(radians(params.bearing_sigma_deg))}, chart_{params} {
  // two missed beams between them, and noise of both
  neighbourhood_ = 3.0 * chart_.spacing() + 2.0 * std::sqrt(2.0 * bearing_variance_);
  members_.reserve(echo_capacity(params));
  sightings_.reserve(echo_capacity(params));
}

void ContactFinder::find(std::span<const Echo> echoes, std::span<const Obstacle> obstacles,
                         const VehicleState& estimate, std::vector<Contact>& contacts) {
  chart(obstacles, estimate);
  gather(echoes);

  sightings_.clear();
  for (std::size_t first = 0, end = 0; first < members_.size(); first = end) {
    while (end < members_.size() && members_[end].thing == members_[first].thing) ++end;
    sight({members_.data() + first, end - first});
  }
  std::ranges::sort(sightings_, [](const Sighting& a, const Sighting& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.bearing < b.bearing;
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
}

void ContactFinder::sight(std::span<const Member> thing) {
  const double extent = (place_of(thing.back().echo) - place_of(thing.front().echo)).norm();
  if (extent <= params_.max_extent_m) {
    sightings_.push_back(disc(thing));
    return;
  }
  std::size_t first = 0;
  for (std::size_t i = 1; i <= thing.size(); ++i) {
    const bool ends = i == thing.size() ||
                      (place_of(thing[i].echo) - place_of(thing[first].echo)).norm() > params_.max_extent_m;
    if (!ends) continue;
    sightings_.push_back(piece(thing.subspan(first, i - first)));
    first = i;
  }
}

ContactFinder::Sighting ContactFinder::disc(std::span<const Member> thing) const {
  const auto count = static_cast<double>(thing.size());
  double bearing = 0.0;
  for (const Member& m : thing) bearing += m.echo.bearing / count;
  double spread = 0.0;
  for (const Member& m : thing) spread += square(m.echo.bearing - bearing) / count;

  // beams are evenly spread over the angle 2a between the tangents: their variance tells it
  const double noise = bearing_variance_ * (count - 1.0) / count;
  const double evenly = std::max(0.0, spread - noise);
  const double half_angle =
      std::min(0.5 * std::sqrt(12.0 * evenly + square(chart_.spacing())), std::asin(widest_sine));
  const double sine = std::sin(half_angle);

  // at the angle b off its middle a disc is d (cos b - sqrt(sin^2 a - sin^2 b)) away
  double distance = 0.0;
  double central = 0.0;
  double least_range = thing.front().echo.range;
  for (const Member& m : thing) {
    least_range = std::min(least_range, m.echo.range);
    const double off = m.echo.bearing - bearing;
    if (std::abs(off) > 0.5 * half_angle) continue;
    distance += m.echo.range / (std::cos(off) - std::sqrt(square(sine) - square(std::sin(off))));
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
  const double radius_per_angle = distance * std::cos(half_angle) / (1.0 - sine);
  const double range_variance = square(params_.range_sigma_m / (1.0 - sine)) / std::max(central, 1.0);
  const double radius_variance = square(radius_per_angle) * angle_variance + square(sine) * range_variance;
  const double aside_variance = (bearing_variance_ + mean_square * params_.missed_ratio) / count + ragged;
  return {.distance = distance,
          .bearing = bearing,
          .radius = distance * sine,
          .distance_variance = range_variance + square(radius_per_angle) * angle_variance,
          .across_variance = square(distance) * aside_variance,
          .radius_variance = radius_variance};
}

ContactFinder::Sighting ContactFinder::piece(std::span<const Member> thing) const {
  Vec2 middle = Vec2::Zero();
  for (const Member& m : thing) middle += place_of(m.echo) / static_cast<double>(thing.size());
  double reach = 0.0;
  for (const Member& m : thing) reach = std::max(reach, (place_of(m.echo) - middle).norm());

  // where along a wall it was cut is chance
  const double chance = square(reach) / 3.0;
  return {.distance = middle.norm(),
          .bearing = std::atan2(middle.y(), middle.x()),
          .radius = reach,
          .distance_variance = square(params_.range_sigma_m) + chance,
          .across_variance = chance + middle.squaredNorm() * bearing_variance_,
          .radius_variance = chance};
}

Contact ContactFinder::placed(const Sighting& s, const VehicleState& estimate) const {
  const Mat3 R_nb = estimate.q_nb.toRotationMatrix();
  const Vec3 along = R_nb * Vec3{std::cos(s.bearing), std::sin(s.bearing), 0.0};
  const Vec3 across = R_nb * Vec3{-std::sin(s.bearing), std::cos(s.bearing), 0.0};
  const Vec3 down = R_nb.col(2);

  // a ball touches the beam with its centre up to a radius outside; everywhere there it is as likely
  const double half_aperture = 0.5 * radians(params_.vertical_aperture_deg);
  const double height = s.distance * std::sin(half_aperture) + s.radius;
  const double heading_variance = square(s.distance * radians(params_.heading_sigma_deg));

  Contact contact{.position = estimate.p_n + s.distance * along,
                  .radius = s.radius,
                  .radius_sigma = std::sqrt(s.radius_variance + least_variance)};
  contact.lasting =
      heading_variance * across * across.transpose() + square(height) / 3.0 * down * down.transpose();
  contact.covariance = contact.lasting + s.distance_variance * along * along.transpose() +
                       s.across_variance * across * across.transpose() + least_variance * Mat3::Identity();
  return contact;
}

}  // namespace fairway
