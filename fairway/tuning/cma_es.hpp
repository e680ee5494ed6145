// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <span>

#include "fairway/core/rng.hpp"

namespace fairway {

/// Covariance matrix adaptation in the unit box [0, 1]^n, to be asked for points and told which were better:
/// N. Hansen, "The CMA Evolution Strategy: A Tutorial" (arXiv 1604.00772); equation numbers are of it. Only
/// the order of points counts, never how much better one is. Negative weights are left out. A value.
class CmaEs {
 public:
  /// Begins at `mean` with the standard deviation `sigma` along every axis.
  CmaEs(const Eigen::VectorXd& mean, double sigma);

  /// How many points a generation should have, 4 + 3 ln n (equation 48).
  std::size_t population() const { return population_; }

  /// One point of the present generation. What falls outside the box is drawn again, and after some draws
  /// put on its border.
  Eigen::VectorXd ask(Rng& rng) const;

  /// Moves on by one generation, whose points come best first; at least four of them. O(n³).
  void tell(std::span<const Eigen::VectorXd> best_first);

  const Eigen::VectorXd& mean() const { return mean_; }

  /// The largest standard deviation along any axis of the distribution.
  double spread() const { return sigma_ * deviations_.maxCoeff(); }

 private:
  Eigen::VectorXd mean_;
  double sigma_;
  std::size_t population_;
  Eigen::MatrixXd covariance_;
  Eigen::MatrixXd axes_;        ///< eigenvectors of the covariance, B
  Eigen::VectorXd deviations_;  ///< square roots of its eigenvalues, the diagonal of D
  Eigen::VectorXd step_path_;   ///< p_sigma
  Eigen::VectorXd path_;        ///< p_c
  int generations_{0};
};

}  // namespace fairway
