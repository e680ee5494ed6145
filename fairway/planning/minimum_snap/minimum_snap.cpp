// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/minimum_snap/minimum_snap.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "fairway/core/error.hpp"
#include "fairway/core/math.hpp"

namespace fairway {
namespace {

using Block = Eigen::Matrix3d;
using Rates = Eigen::Matrix<double, 3, 2>;  // velocity, acceleration, jerk of a waypoint; north and east

// A segment in its normalised time s: with the step d from its first to its last waypoint and the rates a, b
// by s at its ends, c_4 .. c_7 = tail * (d, a, b), and the integral of its squared snap is a quadratic form.
using Tail = Eigen::Matrix<double, 4, 7>;
using Form = Eigen::Matrix<double, 7, 7>;

/// The septic Hermite polynomial: what is left of position, velocity, acceleration and jerk at s = 1 after
/// c_0 .. c_3 is met by c_4 .. c_7.
Tail hermite_tail() {
  Eigen::Matrix4d by_rest;                  // columns: position, velocity, acceleration, jerk left over
  by_rest << 35.0, -15.0, 2.5, -1.0 / 6.0,  //
      -84.0, 39.0, -7.0, 0.5,               //
      70.0, -34.0, 6.5, -0.5,               //
      -20.0, 10.0, -2.0, 1.0 / 6.0;
  Eigen::Matrix<double, 4, 7> rest;                    // of (d, a, b)
  rest << 1.0, -1.0, -0.5, -1.0 / 6.0, 0.0, 0.0, 0.0,  //
      0.0, -1.0, -1.0, -0.5, 1.0, 0.0, 0.0,            //
      0.0, 0.0, -1.0, -1.0, 0.0, 1.0, 0.0,             //
      0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0;
  return by_rest * rest;
}

Form snap_form() {
  const std::array<double, 4> fourth{24.0, 120.0, 360.0, 840.0};  // (k)(k-1)(k-2)(k-3) for k = 4 .. 7
  Eigen::Matrix4d gram;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      gram(i, k) = fourth[static_cast<std::size_t>(i)] * fourth[static_cast<std::size_t>(k)] / (i + k + 1);
    }
  }
  const Tail tail = hermite_tail();
  return tail.transpose() * gram * tail;
}

/// Rates by s of a segment of this duration from those by the unit of time of a knot.
Eigen::Vector3d to_normalised(double duration, double unit_s) {
  const double ratio = duration / unit_s;
  return {ratio, ratio * ratio, ratio * ratio * ratio};
}

/// The normal equations for the rates at inner waypoints, each in a unit of time of its own, which keeps
/// the numbers of long and short segments alike: diagonal_k y_k + beside_k y_(k+1) + .. = right_k.
struct System {
  std::vector<Block> diagonal;
  std::vector<Block> beside;
  std::vector<Rates> right;
  std::vector<double> units_s;
};

/// The unit of time of each waypoint: of the segments it joins the shorter, which is the stiffer.
std::vector<double> units_of(std::span<const double> durations) {
  std::vector<double> units{durations.front()};
  for (std::size_t i = 1; i < durations.size(); ++i) {
    units.push_back(math::fmin(durations[i - 1], durations[i]));
  }
  units.push_back(durations.back());
  return units;
}

System system_of(std::span<const Vec2> steps, std::span<const double> durations) {
  const Form form = snap_form();
  const std::size_t inner = durations.size() - 1;
  System system{.diagonal = std::vector<Block>(inner, Block::Zero()),
                .beside = std::vector<Block>(inner, Block::Zero()),
                .right = std::vector<Rates>(inner, Rates::Zero()),
                .units_s = units_of(durations)};
  for (std::size_t i = 0; i < durations.size(); ++i) {
    // inner waypoint i - 1 is where the segment begins, i where it ends
    const double weight = math::power(durations[i], -7);
    const Eigen::Vector3d first = to_normalised(durations[i], system.units_s[i]);
    const Eigen::Vector3d last = to_normalised(durations[i], system.units_s[i + 1]);
    if (i > 0) {
      system.diagonal[i - 1] += weight * first.asDiagonal() * form.block<3, 3>(1, 1) * first.asDiagonal();
      system.right[i - 1] -= weight * first.asDiagonal() * form.block<3, 1>(1, 0) * steps[i].transpose();
    }
    if (i < inner) {
      system.diagonal[i] += weight * last.asDiagonal() * form.block<3, 3>(4, 4) * last.asDiagonal();
      system.right[i] -= weight * last.asDiagonal() * form.block<3, 1>(4, 0) * steps[i].transpose();
    }
    if (i > 0 && i < inner) {
      system.beside[i - 1] = weight * first.asDiagonal() * form.block<3, 3>(1, 4) * last.asDiagonal();
    }
  }
  return system;
}

/// Block Cholesky down the diagonal and back up.
std::vector<Rates> solve(System system) {
  const std::size_t count = system.diagonal.size();
  std::vector<Eigen::LLT<Block>> factors;
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0) {
      system.diagonal[k] -= system.beside[k - 1].transpose() * factors[k - 1].solve(system.beside[k - 1]);
      system.right[k] -= system.beside[k - 1].transpose() * factors[k - 1].solve(system.right[k - 1]);
    }
    factors.emplace_back(system.diagonal[k]);
  }
  std::vector<Rates> rates(count);
  for (std::size_t k = count; k-- > 0;) {
    Rates right = system.right[k];
    if (k + 1 < count) right -= system.beside[k] * rates[k + 1];
    rates[k] = factors[k].solve(right);
  }
  return rates;
}

void refuse_nonsense(std::span<const Vec2> waypoints, std::span<const double> durations) {
  if (waypoints.size() < 2) throw InputError("a trajectory needs at least two waypoints");
  if (durations.size() + 1 != waypoints.size()) {
    throw InputError("a trajectory through " + std::to_string(waypoints.size()) + " waypoints needs " +
                     std::to_string(waypoints.size() - 1) + " durations, not " +
                     std::to_string(durations.size()));
  }
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::string name = "waypoints[" + std::to_string(i) + "]";
    if (!waypoints[i].allFinite()) throw InputError(name + " is not finite");
    if (i > 0 && waypoints[i] == waypoints[i - 1]) {
      throw InputError(name + " is where the one before it is: a segment must have a length");
    }
    if (i > 0 && !(durations[i - 1] > 0.0 && std::isfinite(durations[i - 1]))) {
      throw InputError("durations[" + std::to_string(i - 1) + "] must be more than 0 s");
    }
  }
}

}  // namespace

Trajectory minimum_snap(std::span<const Vec2> waypoints, std::span<const double> durations, Joining joining) {
  refuse_nonsense(waypoints, durations);
  const std::size_t count = durations.size();
  std::vector<Vec2> steps;
  for (std::size_t i = 0; i < count; ++i) steps.push_back(waypoints[i + 1] - waypoints[i]);

  // rates at all waypoints; at the first and the last there are none
  const System system = system_of(steps, durations);
  std::vector<Rates> rates(count + 1, Rates::Zero());
  if (joining == Joining::smooth) std::ranges::copy(solve(system), rates.begin() + 1);

  const Tail tail = hermite_tail();
  std::vector<Trajectory::Segment> segments(count);
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Matrix<double, 7, 2> ends;
    ends.row(0) = steps[i].transpose();
    ends.middleRows<3>(1) = to_normalised(durations[i], system.units_s[i]).asDiagonal() * rates[i];
    ends.middleRows<3>(4) = to_normalised(durations[i], system.units_s[i + 1]).asDiagonal() * rates[i + 1];
    Trajectory::Coefficients& c = segments[i].coefficients;
    c.col(0) = waypoints[i];
    c.col(1) = ends.row(1).transpose();
    c.col(2) = ends.row(2).transpose() / 2.0;
    c.col(3) = ends.row(3).transpose() / 6.0;
    c.rightCols<4>() = (tail * ends).transpose();
    segments[i].duration = durations[i];
  }
  return Trajectory{std::move(segments)};
}

double minimum_snap_condition(std::span<const double> durations) {
  if (durations.size() < 2) return 1.0;
  const System system = system_of(std::vector<Vec2>(durations.size(), Vec2::UnitX()), durations);
  const auto count = static_cast<Eigen::Index>(system.diagonal.size());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    full.block<3, 3>(3 * k, 3 * k) = system.diagonal[static_cast<std::size_t>(k)];
    if (k + 1 == count) break;
    full.block<3, 3>(3 * k, 3 * k + 3) = system.beside[static_cast<std::size_t>(k)];
    full.block<3, 3>(3 * k + 3, 3 * k) = system.beside[static_cast<std::size_t>(k)].transpose();
  }
  const Eigen::VectorXd scale = full.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * full * scale.asDiagonal();
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{scaled}.eigenvalues();
  return values.maxCoeff() / values.minCoeff();
}

std::vector<double> durations_by_length(std::span<const Vec2> waypoints) {
  std::vector<double> durations;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    durations.push_back((waypoints[i] - waypoints[i - 1]).norm());
  }
  return durations;
}

Trajectory paced(const Trajectory& trajectory, const TrajectoryLimits& limits) {
  if (!(limits.max_speed_mps > 0.0 && limits.max_acceleration_mps2 > 0.0)) {
    throw InputError("a trajectory needs limits of speed and acceleration above 0");
  }
  if (trajectory.segments().empty()) return trajectory;
  const double by_speed = trajectory.peak_speed() / limits.max_speed_mps;
  const double by_acceleration = std::sqrt(trajectory.peak_acceleration() / limits.max_acceleration_mps2);
  return trajectory.slowed(math::fmax(by_speed, by_acceleration));
}

}  // namespace fairway
