// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/velocity_controller.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "fairway/core/math.hpp"
#include "fairway/core/params.hpp"

namespace fairway {
namespace {

constexpr int surge = 0, sway = 1, heave = 2, roll = 3, pitch = 4, yaw = 5;

/// Rows of nu that thrusters can push independently of each other, the more important first: a row counts
/// if its part orthogonal to those before it is more than a millionth of it.
std::vector<int> independent_rows(const Eigen::MatrixXd& B) {
  std::vector<int> rows;
  Eigen::MatrixXd basis(0, B.cols());
  for (const int row : {yaw, heave, surge, sway, pitch, roll}) {
    const Eigen::RowVectorXd effect = B.row(row);
    const Eigen::RowVectorXd rest = effect - effect * basis.transpose() * basis;
    if (!(rest.norm() > 1e-6 * effect.norm())) continue;
    rows.push_back(row);
    basis.conservativeResize(basis.rows() + 1, Eigen::NoChange);
    basis.bottomRows<1>() = rest / rest.norm();
  }
  return rows;
}

}  // namespace

VelocityController::VelocityController(const Propulsion& propulsion, std::span<const ActuatorInfo> actuators,
                                       const Params& params)
    : observer_bandwidth_{checked_params(params).observer_bandwidth_radps},
      thrusters_{actuators},
      mean_{thrusters_.rest()} {
  const auto thrusters = static_cast<Eigen::Index>(actuators.size());
  if (propulsion.effectiveness.cols() != thrusters) {
    throw InputError("the thrust configuration has " + std::to_string(propulsion.effectiveness.cols()) +
                     " columns for " + std::to_string(thrusters) + " actuators");
  }

  // B^+ = B^T (B B^T)^-1 over the independent rows; roll and pitch, where independent, are asked for nothing
  const Eigen::MatrixXd all = propulsion.effectiveness;
  const std::vector<int> rows = independent_rows(all);
  if (rows.empty()) throw InputError("the actuators push nowhere: no velocity can be controlled");
  if (static_cast<std::size_t>(thrusters) > rows.size())
    allocator_.emplace(propulsion, actuators, AllocationMethod::bounded);
  Eigen::MatrixXd B(static_cast<Eigen::Index>(rows.size()), thrusters);
  for (std::size_t i = 0; i < rows.size(); ++i) B.row(static_cast<Eigen::Index>(i)) = all.row(rows[i]);
  Eigen::MatrixXd inverse = B.transpose() * (B * B.transpose()).inverse();
  inverse = (inverse.array().abs() > 1e-9 * inverse.cwiseAbs().maxCoeff()).select(inverse, 0.0);

  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = rows[i];
    if (row == roll || row == pitch) continue;
    const double bandwidth = row == surge  ? params.surge_bandwidth_radps
                             : row == sway ? params.sway_bandwidth_radps
                             : row == yaw  ? params.yaw_bandwidth_radps
                                           : params.heave_bandwidth_radps;
    axes_[axis_count_++] = {.row = row,
                            .mass = propulsion.mass(row, row),
                            .bandwidth = bandwidth,
                            .linear_damping = propulsion.linear_damping[row],
                            .quadratic_damping = propulsion.quadratic_damping[row],
                            .restoring = propulsion.restoring[row],
                            .push = inverse.col(static_cast<Eigen::Index>(i)),
                            .effect = all.row(row).transpose()};
  }
}

void VelocityController::reset() noexcept { memories_.fill({}); }

void VelocityController::observe(const Axis& axis, AccelerationObserver& memory,
                                 double velocity) const noexcept {
  memory.observe(velocity, thrusters_.step(), kept_surprise_, [&](double nu) {
    const double drag = (axis.linear_damping + axis.quadratic_damping * std::abs(nu)) * nu;
    return (axis.effect.dot(mean_) - axis.restoring - drag) / axis.mass;
  });
}

ActuatorValues VelocityController::allocate(std::array<double, 4>& missing) const noexcept {
  if (!allocator_) return share_in_turn(missing);
  Wrench tau = Wrench::Zero();
  for (std::size_t i = 0; i < axis_count_; ++i) tau[axes_[i].row] = missing[i];
  return allocator_->allocate(tau);
}

ActuatorValues VelocityController::share_in_turn(std::array<double, 4>& missing) const noexcept {
  ActuatorValues u = thrusters_.rest();
  // one axis after the other takes what the limits leave; the second round uses room that the first made:
  // thrust ahead lets the reversing thruster of a turn give more
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < axis_count_; ++i) {
      if (missing[i] == 0.0) continue;
      const ActuatorValues& push = axes_[i].push;
      double scale = 1.0;
      for (Eigen::Index k = 0; k < u.size(); ++k) {
        const double change = missing[i] * push[k];
        if (change == 0.0) continue;
        const double left = (change > 0.0 ? thrusters_.highest(k) : thrusters_.lowest(k)) - u[k];
        if (change > 0.0 ? change <= left : change >= left) continue;
        scale = std::min(scale, std::max(0.0, left / change));
      }
      for (Eigen::Index k = 0; k < u.size(); ++k) u[k] += scale * (missing[i] * push[k]);
      missing[i] *= 1.0 - scale;
    }
  }
  return thrusters_.limited(u);
}

ActuatorValues VelocityController::control(const BodyRequest& request, const Vec3& v_b, const Vec3& omega_b,
                                           double h) noexcept {
  const std::array<double, 6> wanted{request.surge_mps,     request.sway_mps, request.heave_mps, 0.0, 0.0,
                                     request.yaw_rate_radps};
  const std::array<double, 6> measured{v_b.x(), v_b.y(), v_b.z(), omega_b.x(), omega_b.y(), omega_b.z()};

  // the force that each axis asks for
  std::array<double, 4> missing{};
  for (std::size_t i = 0; i < axis_count_; ++i) {
    const Axis& axis = axes_[i];
    const double r = wanted[static_cast<std::size_t>(axis.row)];
    const double nu = measured[static_cast<std::size_t>(axis.row)];
    if (!std::isfinite(r) || !std::isfinite(nu)) continue;
    observe(axis, memories_[i], nu);
    missing[i] = axis.restoring + (axis.linear_damping + axis.quadratic_damping * std::abs(r)) * r +
                 axis.mass * (axis.bandwidth * (r - nu) - memories_[i].unexplained);
  }

  ActuatorValues u = allocate(missing);
  if (h != thrusters_.step()) kept_surprise_ = math::exp(-observer_bandwidth_ * h);
  mean_ = thrusters_.follow(u, h);
  return u;
}

}  // namespace fairway
