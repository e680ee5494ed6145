// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "fairway/avoidance/pledge/clearance.hpp"

namespace fairway::pledge {

/// What is asked of a plan beyond that it is clear: that whoever breaks and stops on its way is in nobody's
/// for a while (V5 of the README).
struct Headway {
  double aim{};               ///< for so long [s]; 0: nothing is asked
  Vec3 drift = Vec3::Zero();  ///< of who has stopped: the current [m/s]
};

/// What is asked in a current [m/s], where `still` is in still water [s]: twice as much, since who has
/// stopped is carried across ways that were clear of where it did.
Headway headway_in(const Vec3& current, double still) noexcept;

/// For how long whoever goes by `a` may have lain where it stopped, anywhere on its way, and drifted since,
/// when `b` comes within `apart` [m] of it for the first time; at most the aim [s]. To 0.1 s. O(knots) for
/// each of a few times.
double headway_of(const Reference& a, const Reference& b, double apart, const Headway& wanted) noexcept;

/// The least one of a member towards those of `others` that have been placed, and of these towards it.
double headway_of(std::size_t member, const Reference& reference, const Clearance& scene,
                  const Members& others, const Headway& wanted) noexcept;

/// The least one of those of `some` that have been placed towards those of `others`, and of these towards
/// them.
double headway_of(const Clearance& scene, const Members& some, const Members& others,
                  const Headway& wanted) noexcept;

}  // namespace fairway::pledge
