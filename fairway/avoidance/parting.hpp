// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/ids.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// Which way to leave somebody who is at exactly the same place, where geometry says nothing: north
/// for the smaller id, south for the larger, so that the two part. Unit vector [NED].
inline Vec3 parting_direction(VehicleId own, TrackId other) {
  return number(own) <= number(other) ? Vec3{1.0, 0.0, 0.0} : Vec3{-1.0, 0.0, 0.0};
}

}  // namespace fairway
