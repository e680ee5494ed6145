// SPDX-License-Identifier: Apache-2.0
#include <ceres/ceres.h>

#include <cmath>
#include <memory>

#include "fairway/core/angles.hpp"
#include "fairway/planning/teb/optimise.hpp"

namespace fairway::teb {
namespace {

constexpr std::size_t knots_of(std::size_t offset, std::size_t width) { return (offset + width + 3) / 4; }

/// A cost of the band as one of Ceres, whose parameter blocks are knots.
template <class C>
class KnotCost final : public ceres::CostFunction {
 public:
  KnotCost(const C& cost, std::size_t offset)
      : cost_{cost}, offset_{offset}, knots_{knots_of(offset, C::Output::width)} {
    set_num_residuals(C::Output::rows);
    mutable_parameter_block_sizes()->assign(knots_, 4);
  }

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    std::array<double, 12> window;
    for (std::size_t k = 0; k < knots_; ++k) std::copy_n(blocks[k], 4, window.begin() + 4 * k);
    typename C::Output out;
    cost_(window.data() + offset_, out);
    if (!out.value.allFinite() || !out.slope.allFinite()) return false;

    std::copy_n(out.value.data(), C::Output::rows, residuals);
    if (jacobians == nullptr) return true;
    for (std::size_t k = 0; k < knots_; ++k) {
      if (jacobians[k] == nullptr) continue;
      for (int row = 0; row < C::Output::rows; ++row) {
        for (std::size_t i = 0; i < 4; ++i) {
          const auto column = static_cast<int>(4 * k + i) - static_cast<int>(offset_);
          const bool within = column >= 0 && column < C::Output::width;
          jacobians[k][4 * row + static_cast<int>(i)] = within ? out.slope(row, column) : 0.0;
        }
      }
    }
    return true;
  }

 private:
  C cost_;
  std::size_t offset_, knots_;
};

/// Ends the search after a number of accepted steps: Ceres counts the rejected ones too.
class AcceptedSteps final : public ceres::IterationCallback {
 public:
  explicit AcceptedSteps(int most) : most_{most} {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (summary.iteration > 0 && summary.step_is_successful) ++accepted_;
    return accepted_ >= most_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  int most_;
  int accepted_{};
};

void bind(const Problem& problem, Band& band, ceres::Problem& bound) {
  const auto add = [&]<class C>(std::size_t at, const C& cost) {
    std::vector<double*> blocks;
    for (std::size_t k = 0; k < knots_of(at % 4, C::Output::width); ++k) {
      blocks.push_back(band.knots[at / 4 + k].data());
    }
    bound.AddResidualBlock(new KnotCost<C>(cost, at % 4), nullptr, blocks);  // NOLINT: owned by the problem
  };
  for_each_motion_cost(problem, band.size(), add);
  for_each_barrier_cost(problem, add);

  // the first pose is given, not the time to the second
  bound.SetManifold(band.knots.front().data(), new ceres::SubsetManifold(4, {0, 1, 2}));
  bound.SetParameterBlockConstant(band.knots.back().data());
  if (!problem.params.robust) return;
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    bound.SetParameterLowerBound(band.knots[i].data(), static_cast<int>(time_of), 1e-3);
  }
}

}  // namespace

void improve_ceres(const Problem& problem, int iterations, Band& band) {
  ceres::Problem bound;
  bind(problem, band, bound);
  AcceptedSteps accepted{iterations};

  ceres::Solver::Options options;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 10 * iterations;
  options.max_num_consecutive_invalid_steps = 10;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0.0;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.callbacks = {&accepted};
  ceres::Solver::Summary summary;
  ceres::Solve(options, &bound, &summary);
  for (Knot& knot : band.knots) knot[heading_of] = wrap_angle(knot[heading_of]);
}

}  // namespace fairway::teb
