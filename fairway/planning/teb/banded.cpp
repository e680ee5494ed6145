// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/planning/teb/optimise.hpp"

namespace fairway::teb {
namespace {

constexpr std::size_t reach = 11;       ///< no cost is on more than so many consecutive variables
constexpr double shortest_time = 1e-3;  ///< of the robust variant [s]

/// The normal equations of a band's free variables, which follow one another: all but the first and the last
/// pose. Column j of the lower half holds rows j to j + 10.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t knots)
      : first_{3},
        last_{4 * (knots - 1)},
        columns_(4 * knots + reach),
        factor_(columns_.size()),
        downhill_(columns_.size()) {}

  std::size_t first() const { return first_; }
  std::size_t last() const { return last_; }
  double downhill(std::size_t i) const { return downhill_[i]; }

  void clear() {
    std::ranges::fill(columns_, Column{});
    std::ranges::fill(downhill_, 0.0);
  }

  template <int Rows, int Width>
  void add(std::size_t at, const Residual<Rows, Width>& r) {
    const std::size_t from = std::max(at, first_) - at;
    const std::size_t to = std::min(at + Width, std::max(at, last_)) - at;
    for (int k = 0; k < Rows; ++k) {
      const Eigen::Matrix<double, 1, Width> slope = r.slope.row(k);
      if (slope.isZero(0.0)) continue;  // within its limits
      for (std::size_t j = from; j < to; ++j) {
        Column& column = columns_[at + j];
        downhill_[at + j] -= slope[j] * r.value[k];
        for (std::size_t i = j; i < to; ++i) column[i - j] += slope[j] * slope[i];
      }
    }
  }

  double largest_diagonal() const {
    double largest = 0.0;
    for (std::size_t i = first_; i < last_; ++i) largest = math::fmax(largest, columns_[i][0]);
    return largest;
  }

  /// Solves (H + damping I) step = downhill by Cholesky's factorisation; false if that is not positive
  /// definite. What is stored beyond the last variable is zero and stays so.
  bool solve(double damping, std::vector<double>& step) {
    factor_ = columns_;
    step = downhill_;
    for (std::size_t j = first_; j < last_; ++j) {
      Column column = factor_[j];  // a copy, so that nothing written below may change it
      const double pivot = column[0] + damping;
      if (!(pivot > 0.0)) return false;
      const double inverse = 1.0 / std::sqrt(pivot);
      for (double& entry : column) entry *= inverse;
      column[0] = inverse;
      factor_[j] = column;
      step[j] *= inverse;
      take_away(column, step[j], &factor_[j], &step[j], std::make_index_sequence<reach - 1>{});
    }
    for (std::size_t j = last_; j-- > first_;) {
      double rest = step[j];
      for (std::size_t i = 1; i < reach; ++i) rest -= factor_[j][i] * step[j + i];
      step[j] = rest * factor_[j][0];
    }
    return true;
  }

 private:
  using Column = std::array<double, reach>;

  /// What is known of a variable is taken away from the equations of the next ones. Unrolled: each of these
  /// has a number of entries that the compiler knows, and several go together.
  template <std::size_t... I>
  static void take_away(const Column& column, double known, Column* factor, double* step,
                        std::index_sequence<I...>) {
    ((step[I + 1] -= column[I + 1] * known), ...);
    (take_away_from<I + 1>(column, factor[I + 1]), ...);
  }
  template <std::size_t I>
  static void take_away_from(const Column& column, Column& other) {
    for (std::size_t k = I; k < reach; ++k) other[k - I] -= column[I] * column[k];
  }

  std::size_t first_, last_;  ///< of the free variables; one past the last
  std::vector<Column> columns_, factor_;
  std::vector<double> downhill_;
};

void linearise(const Problem& problem, const Band& band, NormalEquations& equations) {
  equations.clear();
  const auto add = [&]<class C>(std::size_t at, const C& cost) {
    Residual<C::rows, C::width> out;
    cost(out);
    equations.add(at, out);
  };
  for_each_motion_cost(problem, band, add);
  for_each_barrier_cost(problem, band, add);
}

/// The band moved along `step`.
void move(const Problem& problem, const NormalEquations& equations, const std::vector<double>& step,
          Band& band) {
  for (std::size_t i = equations.first(); i < equations.last(); ++i) {
    double& number = band.knots[i / 4][i % 4];
    number += step[i];
    if (i % 4 == heading_of) number = wrap_angle(number);
    if (i % 4 == time_of && problem.params.robust) number = math::fmax(number, shortest_time);
  }
}

}  // namespace

void improve(const Problem& problem, int iterations, Band& band) {
  constexpr double first_damping = 1e-5;  // of the largest diagonal element
  constexpr int attempts = 10;
  NormalEquations equations{band.size()};
  std::vector<double> step;
  Band candidate;
  double cost = cost_of(problem, band).sum();
  double damping = 0.0;
  double growth = 2.0;

  for (int iteration = 0; iteration < iterations; ++iteration) {
    linearise(problem, band, equations);
    if (iteration == 0) damping = first_damping * equations.largest_diagonal();

    double gain = -1.0;
    for (int attempt = 0; attempt < attempts && !(gain > 0.0); ++attempt) {
      double reached = std::numeric_limits<double>::infinity();
      double expected = 1e-3;
      if (equations.solve(damping, step)) {
        candidate = band;
        move(problem, equations, step, candidate);
        reached = cost_of(problem, candidate).sum();
        for (std::size_t i = equations.first(); i < equations.last(); ++i) {
          expected += step[i] * (damping * step[i] + equations.downhill(i));
        }
      }
      gain = (cost - reached) / expected;
      if (gain > 0.0 && std::isfinite(reached)) {
        const double agreement = 2.0 * gain - 1.0;
        damping *= std::clamp(1.0 - agreement * agreement * agreement, 1.0 / 3.0, 2.0 / 3.0);
        growth = 2.0;
        cost = reached;
        std::swap(band, candidate);
      } else {
        gain = -1.0;
        damping *= growth;
        growth *= 2.0;
      }
    }
    if (!(gain > 0.0)) return;
  }
}

}  // namespace fairway::teb
