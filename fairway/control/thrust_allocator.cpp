// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/thrust_allocator.hpp"

#include <Eigen/SVD>
#include <cmath>

namespace fairway {

ThrustAllocator::ThrustAllocator(const Propulsion& propulsion, std::span<const ActuatorInfo> actuators,
                                 AllocationMethod method)
    : method_{method}, B_{propulsion.effectiveness} {
  const auto thrusters = static_cast<Eigen::Index>(actuators.size());
  if (B_.cols() != thrusters) {
    throw InputError("the thrust configuration has " + std::to_string(B_.cols()) + " columns for " +
                     std::to_string(thrusters) + " actuators");
  }
  lowest_.resize(thrusters);
  highest_.resize(thrusters);
  for (Eigen::Index i = 0; i < thrusters; ++i) {
    lowest_[i] = actuators[static_cast<std::size_t>(i)].range.lo;
    highest_[i] = actuators[static_cast<std::size_t>(i)].range.hi;
  }
  const Eigen::MatrixXd B = B_;
  inverse_ = B.completeOrthogonalDecomposition().pseudoInverse();
}

ActuatorValues ThrustAllocator::allocate(const Wrench& tau) const noexcept {
  Wrench wanted = tau;
  for (double& axis : wanted) {
    if (!std::isfinite(axis)) axis = 0.0;
  }
  const ActuatorValues u = inverse_ * wanted;
  return u.cwiseMax(lowest_).cwiseMin(highest_);
}

}  // namespace fairway
