// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <utility>

#include "fairway/core/rng.hpp"
#include "fairway/dynamics/fossen.hpp"
#include "fairway/dynamics/integrate.hpp"

namespace fairway {

/// A body without actuators, as a model to integrate.
template <class Body>
struct Adrift {
  using Params = NoParams;
  static constexpr VehicleInfo info{"adrift", "a body without actuators", "test"};

  explicit Adrift(Params);  // a model has to have it; nobody calls it
  explicit Adrift(Body of) : body{std::move(of)} {}
  std::span<const ActuatorInfo> actuators() const { return {}; }
  StateRate derivative(const VehicleState& x, const ActuatorValues&, const Water& water) const noexcept {
    return body.derivative(x, fossen::Vector6::Zero(), water);
  }
  double power(const ActuatorValues&) const noexcept { return 0.0; }

  Body body;
};

template <class Body>
VehicleState integrated(const Adrift<Body>& model, VehicleState x, double duration, double h,
                        const Water& water = {}) {
  const long steps = std::lround(duration / h);
  for (long i = 0; i < steps; ++i) x = rk4(model, x, ActuatorValues{}, water, h);
  return x;
}

inline Vec3 random_vector(Rng& rng, double size) {
  return size * Vec3{rng.normal(), rng.normal(), rng.normal()};
}

inline Eigen::Quaterniond random_orientation(Rng& rng) {
  return Eigen::Quaterniond{rng.normal(), rng.normal(), rng.normal(), rng.normal()}.normalized();
}

}  // namespace fairway
