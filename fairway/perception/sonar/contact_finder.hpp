// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fairway/core/echo.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/core/state.hpp"
#include "fairway/perception/contact.hpp"
#include "fairway/perception/sonar/notch.hpp"
#include "fairway/perception/sonar/sonar_params.hpp"
#include "fairway/perception/sonar/sweep.hpp"

namespace fairway {

/// Reads the echoes of a ping: what the chart explains is dismissed, neighbours of like range are one thing
/// unless they turn in where two touch, and a thing is the disc whose tangents its outermost echoes are;
/// where one of them is out of sight, the disc that its near side fits best. Holds scratch memory only.
class ContactFinder {
 public:
  explicit ContactFinder(const SonarParams& params);

  /// The contacts of one ping, nearest to the vehicle first, ties by bearing. `echoes` by bearing, then
  /// range, as Sonar::ping gives them; `estimate` is where the vehicle believes to be, and places the
  /// contacts; those of the `obstacles` that are charted explain echoes. Does not allocate once `contacts`
  /// has the capacity, for up to echo_capacity() echoes. O(n log n + beams x charted obstacles).
  void find(std::span<const Echo> echoes, std::span<const Obstacle> obstacles, const VehicleState& estimate,
            std::vector<Contact>& contacts);

 private:
  /// An echo and the thing that it belongs to.
  struct Member {
    std::size_t thing;
    Echo echo;
  };
  /// A thing in the plane of the hull.
  struct Sighting {
    Vec2 place;                  ///< of its centre, ahead and to starboard [m]
    Eigen::Matrix2d covariance;  ///< [m2]
    double radius;               ///< [m]
    double radius_variance;      ///< [m2]
  };

  void chart(std::span<const Obstacle> obstacles, const VehicleState& estimate);
  bool is_charted(const Echo& echo) const;
  void gather(std::span<const Echo> echoes);
  void sight(std::span<const Echo> thing, std::span<const Echo> echoes);
  bool is_cut_off(std::span<const Echo> thing, std::span<const Echo> echoes) const;
  Sighting disc(std::span<const Echo> thing) const;
  Sighting arc(std::span<const Echo> thing) const;
  Sighting piece(std::span<const Echo> thing) const;
  Contact placed(const Sighting& sighting, const VehicleState& estimate) const;

  SonarParams params_;
  double bearing_variance_;
  double neighbourhood_;  // bearings of neighbouring echoes differ by less [rad]
  Sweep chart_;
  Notch notch_;
  bool has_chart_{false};
  std::vector<Member> members_;  // by thing, then bearing
  std::vector<Echo> sorted_;     // their echoes
  std::vector<Vec2> sights_;     // and the unit vectors of their bearings
  std::vector<Sighting> sightings_;
};

}  // namespace fairway
