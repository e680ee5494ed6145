// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/cma_es.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr int most_draws = 20;
constexpr double least_root = 1e-10;  // of an eigenvalue's root: the matrix stays invertible

double in_double(std::size_t count) { return static_cast<double>(count); }

/// Logarithmic weights of the better half, which sum to one (equation 49).
std::vector<double> weights_of(std::size_t points) {
  std::vector<double> weights(points / 2);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = math::log((in_double(points) + 1.0) / 2.0) - math::log(in_double(i + 1));
    sum += weights[i];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

CmaEs::CmaEs(const Eigen::VectorXd& mean, double sigma)
    : mean_{mean},
      sigma_{sigma},
      population_{4 + static_cast<std::size_t>(3.0 * math::log(static_cast<double>(mean.size())))},
      covariance_{Eigen::MatrixXd::Identity(mean.size(), mean.size())},
      axes_{covariance_},
      deviations_{Eigen::VectorXd::Ones(mean.size())},
      step_path_{Eigen::VectorXd::Zero(mean.size())},
      path_{Eigen::VectorXd::Zero(mean.size())} {}

Eigen::VectorXd CmaEs::ask(Rng& rng) const {
  Eigen::VectorXd point;
  for (int draw = 0; draw < most_draws; ++draw) {
    Eigen::VectorXd z(mean_.size());
    for (double& component : z) component = rng.normal();
    point = mean_ + sigma_ * (axes_ * deviations_.cwiseProduct(z));  // equations 38 to 40
    if (point.minCoeff() >= 0.0 && point.maxCoeff() <= 1.0) return point;
  }
  return point.cwiseMax(0.0).cwiseMin(1.0);
}

void CmaEs::tell(std::span<const Eigen::VectorXd> best_first) {
  const double n = static_cast<double>(mean_.size());
  const std::vector<double> weights = weights_of(best_first.size());
  double squares = 0.0;
  for (const double weight : weights) squares += weight * weight;
  const double mass = 1.0 / squares;  // mu_eff, equation 8

  // the mean moves to the better points (equations 41 and 42)
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(mean_.size());
  for (std::size_t i = 0; i < weights.size(); ++i) moved += weights[i] * (best_first[i] - mean_) / sigma_;
  mean_ += sigma_ * moved;

  // step size: how long is the path that the mean has gone, against that of a random walk (43 and 44)
  const double c_step = (mass + 2.0) / (n + mass + 5.0);
  const double damping = 1.0 + 2.0 * std::max(0.0, std::sqrt((mass - 1.0) / (n + 1.0)) - 1.0) + c_step;
  const double expected = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  const Eigen::VectorXd whitened = axes_ * (axes_.transpose() * moved).cwiseQuotient(deviations_);
  step_path_ = (1.0 - c_step) * step_path_ + std::sqrt(c_step * (2.0 - c_step) * mass) * whitened;
  ++generations_;
  const double settled = std::sqrt(1.0 - math::power(1.0 - c_step, 2 * generations_));
  const bool stalls = step_path_.norm() / settled >= (1.4 + 2.0 / (n + 1.0)) * expected;

  // covariance: the path of the mean, and where the better points lay (45 to 47)
  const double c_path = (4.0 + mass / n) / (n + 4.0 + 2.0 * mass / n);
  const double c_one = 2.0 / ((n + 1.3) * (n + 1.3) + mass);
  const double c_rank =
      std::min(1.0 - c_one, 2.0 * (mass - 2.0 + 1.0 / mass) / ((n + 2.0) * (n + 2.0) + mass));
  path_ *= 1.0 - c_path;
  if (!stalls) path_ += std::sqrt(c_path * (2.0 - c_path) * mass) * moved;
  const double kept = 1.0 - c_one - c_rank + (stalls ? c_one * c_path * (2.0 - c_path) : 0.0);
  covariance_ = kept * covariance_ + c_one * path_ * path_.transpose();
  const Eigen::VectorXd old_mean = mean_ - sigma_ * moved;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Eigen::VectorXd step = (best_first[i] - old_mean) / sigma_;
    covariance_ += c_rank * weights[i] * step * step.transpose();
  }
  sigma_ *= math::exp(std::min(1.0, c_step / damping * (step_path_.norm() / expected - 1.0)));

  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{covariance_};
  axes_ = solver.eigenvectors();
  deviations_ = solver.eigenvalues().cwiseMax(least_root * least_root).cwiseSqrt();
}

}  // namespace fairway
