// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/thrust_allocator.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>

namespace fairway {
namespace {

constexpr int yaw_axis = 5;
constexpr double yaw_priority = 30.0;
constexpr double relative_epsilon = 1e-12;
constexpr double most_wrench = 1e9;  // [N, N m] no thruster gives it, and its square is finite

Wrench weights_of(const Eigen::MatrixXd& B) {
  Wrench weights = Wrench::Zero();
  for (int axis = 0; axis < 6; ++axis) {
    const double most = B.cols() > 0 ? B.row(axis).cwiseAbs().maxCoeff() : 0.0;
    if (most > 0.0) weights[axis] = (axis == yaw_axis ? yaw_priority : 1.0) / most;
  }
  return weights;
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  if (matrix.isZero(0.0)) return Eigen::MatrixXd::Zero(matrix.cols(), matrix.rows());
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

/// U^T of the singular vectors that span the range of `WB`, one per row.
Eigen::MatrixXd range_axes(const Eigen::MatrixXd& WB) {
  if (WB.isZero(0.0)) return Eigen::MatrixXd(0, 6);
  Eigen::JacobiSVD<Eigen::MatrixXd> svd{WB, Eigen::ComputeThinU | Eigen::ComputeThinV};
  svd.setThreshold(1e-9);
  return svd.matrixU().leftCols(svd.rank()).transpose();
}

}  // namespace

ThrustAllocator::ThrustAllocator(const Propulsion& propulsion, std::span<const ActuatorInfo> actuators,
                                 AllocationMethod method)
    : method_{method} {
  const auto thrusters = static_cast<Eigen::Index>(actuators.size());
  const Eigen::MatrixXd B = propulsion.effectiveness;
  if (B.cols() != thrusters) {
    throw InputError("the thrust configuration has " + std::to_string(B.cols()) + " columns for " +
                     std::to_string(thrusters) + " actuators");
  }
  lowest_.resize(thrusters);
  highest_.resize(thrusters);
  for (Eigen::Index i = 0; i < thrusters; ++i) {
    lowest_[i] = actuators[static_cast<std::size_t>(i)].range.lo;
    highest_[i] = actuators[static_cast<std::size_t>(i)].range.hi;
  }

  weights_ = weights_of(B);
  axes_ = range_axes(weights_.asDiagonal() * B) * weights_.asDiagonal();
  A_ = axes_ * B;
  sqrt_epsilon_ = std::sqrt(relative_epsilon) * A_.norm();

  const bool weighted = method == AllocationMethod::bounded;
  inverse_ = weighted ? Eigen::MatrixXd{pseudo_inverse(A_) * axes_} : pseudo_inverse(B);
}

ActuatorValues ThrustAllocator::limited(const ActuatorValues& u) const noexcept {
  return u.cwiseMax(lowest_).cwiseMin(highest_);
}

ActuatorValues ThrustAllocator::allocate(const Wrench& tau) const noexcept {
  Wrench wanted = tau;
  for (double& axis : wanted) {
    if (!std::isfinite(axis)) axis = 0.0;
  }
  wanted = wanted.cwiseMax(-most_wrench).cwiseMin(most_wrench);
  const ActuatorValues unlimited = inverse_ * wanted;
  ActuatorValues u = limited(unlimited);
  if (method_ == AllocationMethod::pseudo_inverse || u == unlimited) return u;
  return nearest(axes_ * wanted, u);
}

ActuatorValues ThrustAllocator::nearest(const Coordinates& b, const ActuatorValues& start) const noexcept {
  ActuatorValues u = start;
  Holds holds{};
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    holds[static_cast<std::size_t>(i)] = u[i] <= lowest_[i]    ? Hold::lowest
                                         : u[i] >= highest_[i] ? Hold::highest
                                                               : Hold::free;
  }

  for (Eigen::Index changes = 0; changes < 4 * u.size(); ++changes) {
    const Solution solution = free_solution(b, u, holds);
    if (const Eigen::Index met = advance(u, solution.u, holds); met >= 0) {
      holds[static_cast<std::size_t>(met)] = u[met] == lowest_[met] ? Hold::lowest : Hold::highest;
      continue;
    }
    const Eigen::Index released = wrongly_held(solution, holds);
    if (released < 0) break;
    holds[static_cast<std::size_t>(released)] = Hold::free;
  }
  return u;
}

ThrustAllocator::Solution ThrustAllocator::free_solution(const Coordinates& b, const ActuatorValues& u,
                                                         const Holds& holds) const noexcept {
  std::array<Eigen::Index, max_actuators> thruster{};
  Eigen::Index free = 0;
  Coordinates b_free = b;
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    if (holds[static_cast<std::size_t>(i)] == Hold::free) {
      thruster[static_cast<std::size_t>(free++)] = i;
    } else {
      b_free -= u[i] * A_.col(i);
    }
  }

  Rows rows = Rows::Zero(free + A_.rows(), A_.rows());
  for (Eigen::Index i = 0; i < free; ++i) {
    rows.row(i) = A_.col(thruster[static_cast<std::size_t>(i)]).transpose();
  }
  rows.bottomRows(A_.rows()).diagonal().setConstant(sqrt_epsilon_);

  Solution solution{.u = u, .y = b_free};
  const Coordinates z = orthogonalise(rows, solution.y);
  for (Eigen::Index i = 0; i < free; ++i) {
    solution.u[thruster[static_cast<std::size_t>(i)]] = rows.row(i).dot(z);
  }
  return solution;
}

/// Solves (A_f A_f^T + epsilon I) y = b, with A_f the columns of the free thrusters, `rows` holding
/// [A_f^T; sqrt(epsilon) I] = Q R and `y` holding b: R^T z = b, R y = z. Gives z and leaves Q, since
/// u_f = A_f^T y = Q_f z; the product A_f A_f^T, whose condition is the square, is never made.
ThrustAllocator::Coordinates ThrustAllocator::orthogonalise(Rows& rows, Coordinates& y) noexcept {
  Eigen::Matrix<double, 6, 6> R = Eigen::Matrix<double, 6, 6>::Zero();
  Coordinates z = y;
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    // Gram-Schmidt, twice: where b cannot be met z is large, and once is not orthogonal enough
    for (Eigen::Index step = 0; step < 2 * k; ++step) {
      const Eigen::Index j = step % k;
      const double along = rows.col(j).dot(rows.col(k));
      R(j, k) += along;
      rows.col(k) -= along * rows.col(j);
    }
    R(k, k) = rows.col(k).norm();
    rows.col(k) /= R(k, k);
    for (Eigen::Index j = 0; j < k; ++j) z[k] -= R(j, k) * z[j];
    z[k] /= R(k, k);
  }

  y = z;
  for (Eigen::Index k = rows.cols(); k-- > 0;) {
    y[k] /= R(k, k);
    for (Eigen::Index j = 0; j < k; ++j) y[j] -= R(j, k) * y[k];
  }
  return z;
}

/// Moves the free thrusters toward `target` until the first meets a limit, and gives that one; -1 if none.
Eigen::Index ThrustAllocator::advance(ActuatorValues& u, const ActuatorValues& target,
                                      const Holds& holds) const noexcept {
  double share = 1.0;
  Eigen::Index met = -1;
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    if (holds[static_cast<std::size_t>(i)] != Hold::free) continue;
    if (target[i] >= lowest_[i] && target[i] <= highest_[i]) continue;
    const double limit = target[i] < lowest_[i] ? lowest_[i] : highest_[i];
    const double reached = (limit - u[i]) / (target[i] - u[i]);
    if (met >= 0 && reached >= share) continue;
    share = reached;
    met = i;
  }
  if (met < 0) {
    u = target;
    return met;
  }
  u = limited(u + share * (target - u));
  u[met] = target[met] < lowest_[met] ? lowest_[met] : highest_[met];
  return met;
}

/// The thruster at a limit that would most reduce the sum by leaving it, or -1: half its gradient over
/// epsilon is u_i - a_i y. What rounding can make of it is no reason to leave.
Eigen::Index ThrustAllocator::wrongly_held(const Solution& solution, const Holds& holds) const noexcept {
  const double reach = solution.y.norm();
  Eigen::Index worst = -1;
  double most = 0.0;
  for (Eigen::Index i = 0; i < solution.u.size(); ++i) {
    const double span = highest_[i] - lowest_[i];
    const Hold hold = holds[static_cast<std::size_t>(i)];
    if (hold == Hold::free || span <= 0.0) continue;
    const double slope = solution.u[i] - A_.col(i).dot(solution.y);
    const double gain = hold == Hold::lowest ? -slope : slope;
    const double rounding = 1e-9 * span + 1e-10 * A_.col(i).norm() * reach;
    if (gain <= rounding || gain <= most) continue;
    worst = i;
    most = gain;
  }
  return worst;
}

}  // namespace fairway
