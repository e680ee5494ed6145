// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace fairway {

/// The transcendental functions, the same bits on every machine, by every compiler: additions, products,
/// quotients and square roots as IEEE 754 has them, in the order that is written, and nothing of the C
/// library. Whatever decides a run calls these, and `scripts/check layers` forbids the others. They are to be
/// compiled with -ffp-contract=off, as the target is that links them.
///
/// Each is within one unit in the last place of the true value, whatever the argument: 0.9 is the most that
/// tests/math finds against MPFR, over dense, random and extreme ones. Infinities, zeros with their signs and
/// what is not a number come out as C has them. Angles are in radians.
namespace math {

struct SinCos {
  double sin;
  double cos;
};

SinCos sin_cos(double angle) noexcept;  ///< both, at the cost of one
double sin(double angle) noexcept;
double cos(double angle) noexcept;

double asin(double x) noexcept;             ///< in [-pi/2, pi/2]; not a number beyond [-1, 1]
double acos(double x) noexcept;             ///< in [0, pi]; not a number beyond [-1, 1]
double atan(double x) noexcept;             ///< in [-pi/2, pi/2]
double atan2(double y, double x) noexcept;  ///< the direction of (x, y), in [-pi, pi]

double exp(double x) noexcept;
double expm1(double x) noexcept;  ///< e^x - 1, true to the last place where x is small
double log(double x) noexcept;    ///< natural; not a number below 0

/// The lesser and the greater, the first of equal ones, and the other of what is not a number. Of a zero and
/// a negative one std::fmin takes either, as processor and compiler like.
constexpr double fmin(double x, double y) noexcept { return y < x || x != x ? y : x; }
constexpr double fmax(double x, double y) noexcept { return y > x || x != x ? y : x; }

/// sqrt(x^2 + y^2), where neither square overflows nor vanishes: within 1.3 units in the last place there.
inline double hypot(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

/// x^n by products: n - 1 roundings at most, or one more of the quotient where n < 0.
constexpr double power(double x, int n) noexcept {
  double product = 1.0;
  for (int i = 0; i < (n < 0 ? -n : n); ++i) product *= x;
  return n < 0 ? 1.0 / product : product;
}

}  // namespace math
}  // namespace fairway
