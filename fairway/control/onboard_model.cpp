// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/onboard_model.hpp"

#include "fairway/control/thrust_allocator.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

/// The largest wrench along `axis` in the direction of `sign` that the thrusters give, nothing else asked.
double most(const ThrustAllocator& allocator, const Propulsion& propulsion, int axis, double sign,
            double bound) {
  const auto gives = [&](double value) {
    Wrench asked = Wrench::Zero();
    asked[axis] = sign * value;
    const Wrench given = propulsion.effectiveness * allocator.allocate(asked);
    return (given - asked).norm() <= 1e-6 * bound;
  };
  double lo = 0.0, hi = bound;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (lo + hi);
    (gives(middle) ? lo : hi) = middle;
  }
  return sign * lo;
}

}  // namespace

std::optional<OnboardModel> onboard_model(const Vehicle& vehicle) {
  const Propulsion* propulsion = vehicle.propulsion();
  if (propulsion == nullptr) return {};
  OnboardModel model{.mass = propulsion->mass.diagonal(),
                     .linear_damping = propulsion->linear_damping,
                     .quadratic_damping = propulsion->quadratic_damping,
                     .restoring = propulsion->restoring};
  const ThrustAllocator allocator{*propulsion, vehicle.actuators(), AllocationMethod::bounded};
  for (int axis = 0; axis < 6; ++axis) {
    double bound = 0.0;  // every thruster at its limit
    for (Eigen::Index i = 0; i < propulsion->effectiveness.cols(); ++i) {
      const Range range = vehicle.actuators()[static_cast<std::size_t>(i)].range;
      bound += std::abs(propulsion->effectiveness(axis, i)) * math::fmax(-range.lo, range.hi);
    }
    if (bound <= 0.0) continue;
    model.least[axis] = most(allocator, *propulsion, axis, -1.0, bound);
    model.greatest[axis] = most(allocator, *propulsion, axis, 1.0, bound);
  }
  return model;
}

}  // namespace fairway
