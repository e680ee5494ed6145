// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/stability.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <charconv>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/sim/divergence.hpp"

namespace fairway {
namespace {

// small deviations from a state: position [NED], attitude as a rotation vector [body], v_b, omega_b
using Deviation = Eigen::Matrix<double, 12, 1>;
using Jacobian = Eigen::Matrix<double, 12, 12>;

/// What rounding leaves of R(z) of a mode that neither grows nor decays.
constexpr double growth_tolerance = 1e-3;

VehicleState deviated(const VehicleState& x, const Deviation& by) {
  const Vec3 turn = by.segment<3>(3);
  VehicleState y = x;
  y.p_n += by.head<3>();
  const auto [sine, cosine] = math::sin_cos(0.5 * turn.norm());
  const Vec3 axis = sine * unit(turn);
  y.q_nb = (x.q_nb * Eigen::Quaterniond{cosine, axis.x(), axis.y(), axis.z()}).normalized();
  y.v_b += by.segment<3>(6);
  y.omega_b += by.tail<3>();
  return y;
}

/// Of the changes to both sides of a state: more is a jump.
constexpr double jump_ratio = 30.0;

/// What a velocity does so near to a state alone, as the lift of a hull that water meets exactly abeam, goes
/// no farther from it than that [m/s].
constexpr double nearby = 0.02;
constexpr double local_ratio = 10.0;  // of the slopes within a little and within that

/// How fast a deviation from a state changes, in that state.
class Linearisation {
 public:
  Linearisation(const Vehicle& vehicle, const ActuatorValues& u, const Water& water)
      : vehicle_{vehicle}, u_{u}, water_{water} {}

  Deviation rate(const VehicleState& x, const Deviation& by) const {
    const VehicleState y = deviated(x, by);
    const StateRate rate = vehicle_.rate(y, u_, water_);
    const Eigen::Quaterniond spin{rate.q_nb[3], rate.q_nb[0], rate.q_nb[1], rate.q_nb[2]};
    const Vec3 omega = 2.0 * (y.q_nb.conjugate() * spin).vec();
    const Vec3 turn = by.segment<3>(3);

    Deviation d;
    d << rate.p_n, omega + 0.5 * turn.cross(omega), rate.v_b, rate.omega_b;
    return d;
  }

  Jacobian jacobian(const VehicleState& x) const {
    constexpr double small = 1e-5;
    const Deviation here = rate(x, Deviation::Zero());
    Jacobian A;
    for (int i = 0; i < 12; ++i) {
      const Deviation by = small * Deviation::Unit(i);
      const Deviation after = rate(x, by), before = rate(x, -by);
      A.col(i) = (after - before) / (2.0 * small);
      // where the model jumps, as a cylinder's drag does by Reynolds number: the side on which it does not
      const double one = (after - here).norm(), other = (here - before).norm();
      if (one > jump_ratio * other) A.col(i) = (here - before) / small;
      if (other > jump_ratio * one) A.col(i) = (after - here) / small;
      if (i >= 6 && i < 9) {
        const Deviation wide = nearby * Deviation::Unit(i);
        const Deviation slope = (rate(x, wide) - rate(x, -wide)) / (2.0 * nearby);
        if (A.col(i).norm() > local_ratio * slope.norm()) A.col(i) = slope;
      }
    }
    return A;
  }

 private:
  const Vehicle& vehicle_;
  const ActuatorValues& u_;
  const Water& water_;
};

bool is_carried(std::complex<double> rate, double h) {
  const std::complex<double> z = h * rate;
  const std::complex<double> R = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
  const double itself = math::fmax(1.0, math::exp(z.real()));
  return std::abs(R) <= (1.0 + growth_tolerance) * itself;
}

/// The longest step up to `h` that carries a mode which `h` does not.
double longest_step(std::complex<double> rate, double h) {
  double carried = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (carried + h);
    (is_carried(rate, middle) ? carried : h) = middle;
  }
  return carried;
}

std::string_view axis_of(const Eigen::Matrix<std::complex<double>, 12, 1>& mode) {
  constexpr std::array<std::string_view, 6> axes{"surge", "sway", "heave", "roll", "pitch", "yaw"};
  Eigen::Index axis{};
  mode.tail<6>().cwiseAbs().maxCoeff(&axis);
  return axes[static_cast<std::size_t>(axis)];
}

/// To three digits.
std::string rounded_text(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3).ptr;
  return {text.data(), end};
}

}  // namespace

std::optional<StepLimit> step_limit(const Vehicle& vehicle, const VehicleState& x, const ActuatorValues& u,
                                    const Water& water, double h) {
  const Jacobian A = Linearisation{vehicle, u, water}.jacobian(x);
  if (!A.allFinite()) return {};
  const Eigen::EigenSolver<Jacobian> solver{A};
  if (solver.info() != Eigen::Success) return {};

  std::optional<StepLimit> limit;
  for (int i = 0; i < 12; ++i) {
    const std::complex<double> rate = solver.eigenvalues()[i];
    if (is_carried(rate, h)) continue;
    const double longest = longest_step(rate, h);
    if (limit && limit->step_s <= longest) continue;
    limit = {longest, {rate, axis_of(solver.eigenvectors().col(i))}};
  }
  return limit;
}

std::optional<VehicleState> steady_state(const Vehicle& vehicle, VehicleState x, const ActuatorValues& u,
                                         const Water& water) {
  constexpr double first_step = 0.25, longest_step = 10.0;
  const Linearisation motion{vehicle, u, water};
  double h = first_step;
  Deviation rate = motion.rate(x, Deviation::Zero());
  for (int i = 0; i < 20; ++i) {
    const Deviation moved = (Jacobian::Identity() - h * motion.jacobian(x)).partialPivLu().solve(h * rate);
    if (!moved.allFinite()) return {};
    x = deviated(x, moved);
    if (!why_impossible(x).empty()) return {};

    // where accelerations are limited, A says nothing of what lies ahead, and long steps lead beyond it
    const double before = rate.tail<6>().norm();
    rate = motion.rate(x, Deviation::Zero());
    h = rate.tail<6>().norm() < 0.99 * before ? math::fmin(1.6 * h, longest_step) : first_step;
  }
  return x;
}

std::string text_of(const MotionMode& mode) {
  const double imaginary = std::abs(mode.rate.imag());
  std::string text = rounded_text(mode.rate.real());
  if (imaginary > 1e-6 * std::abs(mode.rate)) text += " +- " + rounded_text(imaginary) + "i";
  return text + " 1/s";
}

}  // namespace fairway
