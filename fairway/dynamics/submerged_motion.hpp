// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/lanes/number.hpp"
#include "fairway/dynamics/runge_kutta.hpp"

/// The equations of SubmergedBody (submerged_body.hpp), of one body or of several of one kind side by side
/// (core/lanes/number.hpp). Sums are in Eigen's order.
namespace fairway::lanes {

/// A 6 x 6 matrix for products with two vectors. Working in threes keeps values in registers; a diagonal
/// matrix (CO at the centre of gravity, principal axes) takes 6 products instead of 36.
struct Blocks {
  double rows[6][6];
  bool diagonal;
};

/// What does not change of a body. Plain numbers: a file that is compiled for wider registers may hold no
/// function that others have too.
struct BodyNumbers {
  Blocks coriolis;           ///< the mass matrix whose momenta make C(nu)
  Blocks inverse_mass;       ///< M^-1
  double linear_damping[6];  ///< -[X_u ... N_r]
  double quadratic_damping[6];
  double r_b[3];         ///< [m, body]
  double weight_r_g[3];  ///< W r_g [N m, body]
  double weight;         ///< W [N]
  double buoyancy;       ///< B [N] in water of the numbers' density
  double inverse_density;
};

/// Where a body is and how it moves, or how fast that changes: p [m, NED], q as w, x, y, z, nu [body].
template <class Real>
struct MotionOf {
  VecOf<Real> p;
  Real q[4];
  VecOf<Real> v, omega;
};

/// The actuators' wrench about CO, the same for a whole step [N, N m, body].
template <class Real>
struct PushOf {
  VecOf<Real> force, moment;
};

/// The water around. Whether it moves, and is accelerated, is so of all that are side by side, or of none.
template <class Real>
struct FlowOf {
  VecOf<Real> current, current_rate;  ///< [m/s, m/s2, NED]
  Real density;                       ///< [kg/m3]
  bool flows, accelerates;
};

template <class Real>
VecOf<Real> vector_of(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

template <class Real>
struct Momenta {
  VecOf<Real> a, b;
};

template <class Real>
[[gnu::always_inline]] inline Momenta<Real> times(const Blocks& A, const VecOf<Real>& x,
                                                  const VecOf<Real>& y) {
  if (A.diagonal)
    return {by_axis(VecOf<Real>{A.rows[0][0], A.rows[1][1], A.rows[2][2]}, x),
            by_axis(VecOf<Real>{A.rows[3][3], A.rows[4][4], A.rows[5][5]}, y)};
  const auto row = [&](std::size_t i) {
    return dot(vector_of<Real>(A.rows[i]), x) + dot(vector_of<Real>(A.rows[i] + 3), y);
  };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}

/// The rows of R(q), body to NED.
template <class Real>
struct Rotation {
  VecOf<Real> north, east, down;

  [[gnu::always_inline]] explicit Rotation(const Real (&q)[4]) {
    const Real tx = 2.0 * q[1], ty = 2.0 * q[2], tz = 2.0 * q[3];
    const Real twx = tx * q[0], twy = ty * q[0], twz = tz * q[0];
    const Real txx = tx * q[1], txy = ty * q[1], txz = tz * q[1];
    const Real tyy = ty * q[2], tyz = tz * q[2], tzz = tz * q[3];
    north = {1.0 - (tyy + tzz), txy - twz, txz + twy};
    east = {txy + twz, 1.0 - (txx + tzz), tyz - twx};
    down = {txz - twy, tyz + twx, 1.0 - (txx + tyy)};
  }
  VecOf<Real> to_ned(const VecOf<Real>& v) const { return {dot(north, v), dot(east, v), dot(down, v)}; }
  VecOf<Real> to_body(const VecOf<Real>& v) const {
    return {dot(VecOf<Real>{north.x(), east.x(), down.x()}, v),
            dot(VecOf<Real>{north.y(), east.y(), down.y()}, v),
            dot(VecOf<Real>{north.z(), east.z(), down.z()}, v)};
  }
};

/// R^T v_c' [m/s2, body]. Not inlined: that would cost still water 4 % of the step.
template <class Real>
[[gnu::noinline, gnu::cold]] VecOf<Real> carried(const Real (&q)[4], const VecOf<Real>& rate) {
  const VecOf<Real> axis{-q[1], -q[2], -q[3]};
  const VecOf<Real> half = cross(axis, rate), whole = half + half;
  return rate + q[0] * whole + cross(axis, whole);
}

template <class Real>
[[gnu::always_inline]] inline MotionOf<Real> rate_of(const BodyNumbers& body, const MotionOf<Real>& x,
                                                     const PushOf<Real>& push, const FlowOf<Real>& water) {
  using Vec = VecOf<Real>;
  const Vec& omega = x.omega;
  const Real relative_density = water.density * body.inverse_density;

  // motion through the water: nu_r = [v; omega]
  const Rotation<Real> R{x.q};
  const Vec v_c = water.flows ? R.to_body(water.current) : Vec{Real{0.0}, Real{0.0}, Real{0.0}};
  const Vec v = water.flows ? x.v - v_c : x.v;

  // C(nu_r) nu_r = [omega x a; v x a + omega x b] from the momenta a, b
  const auto [a, b] = times(body.coriolis, v, omega);
  // D(nu_r) nu_r
  const Vec drag =
      vector_of<Real>(body.linear_damping) + by_axis(vector_of<Real>(body.quadratic_damping), magnitude(v));
  const Vec twist = vector_of<Real>(body.linear_damping + 3) +
                    by_axis(vector_of<Real>(body.quadratic_damping + 3), magnitude(omega));
  // g(eta)
  const Vec& down_b = R.down;
  const Real B = relative_density * body.buoyancy;

  const Vec f =
      push.force - cross(omega, a) - relative_density * by_axis(drag, v) + (body.weight - B) * down_b;
  const Vec m = push.moment - cross(v, a) - cross(omega, b) - relative_density * by_axis(twist, omega) +
                cross(vector_of<Real>(body.weight_r_g) - B * vector_of<Real>(body.r_b), down_b);
  auto [v_dot, omega_dot] = times(body.inverse_mass, f, m);
  if (water.flows) v_dot = v_dot - cross(omega, v_c);
  if (water.accelerates) [[unlikely]]
    v_dot = v_dot + carried(x.q, water.current_rate);

  const Real p = 0.5 * omega.x(), q = 0.5 * omega.y(), r = 0.5 * omega.z();
  return {R.to_ned(x.v),
          {-x.q[1] * p - x.q[2] * q - x.q[3] * r, x.q[0] * p + x.q[2] * r - x.q[3] * q,
           x.q[0] * q + x.q[3] * p - x.q[1] * r, x.q[0] * r + x.q[1] * q - x.q[2] * p},
          v_dot,
          omega_dot};
}

/// `x` moved along `rate` for `h` [s]; the quaternion is left as it falls.
template <class Real>
[[gnu::always_inline]] inline MotionOf<Real> moved(const MotionOf<Real>& x, const MotionOf<Real>& rate,
                                                   double h) {
  MotionOf<Real> y{x.p + h * rate.p, {}, x.v + h * rate.v, x.omega + h * rate.omega};
  for (int i = 0; i < 4; ++i) y.q[i] = x.q[i] + h * rate.q[i];
  return y;
}

template <class Real>
[[gnu::always_inline]] inline MotionOf<Real> mean_of(const MotionOf<Real>& k1, const MotionOf<Real>& k2,
                                                     const MotionOf<Real>& k3, const MotionOf<Real>& k4) {
  const auto mean = [](const auto& a, const auto& b, const auto& c, const auto& d) {
    return (a + 2.0 * b + 2.0 * c + d) / Real{6.0};
  };
  MotionOf<Real> all{mean(k1.p, k2.p, k3.p, k4.p),
                     {},
                     mean(k1.v, k2.v, k3.v, k4.v),
                     mean(k1.omega, k2.omega, k3.omega, k4.omega)};
  for (int i = 0; i < 4; ++i) all.q[i] = mean(k1.q[i], k2.q[i], k3.q[i], k4.q[i]);
  return all;
}

/// One step of length `h` [s] later, the quaternion normalised.
template <class Real>
[[gnu::always_inline]] inline MotionOf<Real> stepped(const BodyNumbers& body, const MotionOf<Real>& x,
                                                     const PushOf<Real>& push, const FlowOf<Real>& water,
                                                     double h) {
  MotionOf<Real> y = runge_kutta(
      x, h, [&](const MotionOf<Real>& at) __attribute__((always_inline)) {
        return rate_of(body, at, push, water);
      });
  const Real length2 = (y.q[1] * y.q[1] + y.q[2] * y.q[2]) + (y.q[3] * y.q[3] + y.q[0] * y.q[0]);
  const Real length = select(length2 > 0.0, square_root(length2), Real{1.0});
  for (Real& part : y.q) part = part / length;
  return y;
}

}  // namespace fairway::lanes
