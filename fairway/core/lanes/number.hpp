// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>

#include "fairway/core/vec.hpp"

/// What a text says that is compiled both for one number, `double`, and for several side by side, `Pack`
/// (pack.hpp). A comparison of one is a bool; of several it is a mask, a bool for each. Where a text for one
/// number would branch, it asks whether there is any, does the work, and selects.
namespace fairway::lanes {

inline bool any(bool mask) { return mask; }
inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline double square_root(double value) { return std::sqrt(value); }
inline double magnitude(double value) { return std::fabs(value); }
inline double with_sign_of(double size, double sign) { return std::copysign(size, sign); }

/// What comparing two of them gives.
template <class Real>
using MaskOf = decltype(std::declval<Real>() < std::declval<Real>());

template <class Mask>
bool none(const Mask& mask) {
  return !any(mask);
}

/// The larger of two; `a` where they are equal.
template <class Real>
Real larger(const Real& a, const Real& b) {
  return select(a < b, b, a);
}

template <class Real>
Real smaller(const Real& a, const Real& b) {
  return select(b < a, b, a);
}

/// A vector of numbers or of packs. One of numbers is a `Vec3` and the other way round; it is another type
/// since Eigen sums in an order of its own, and stores two numbers at once where one is read next.
template <class Real>
class VecOf {
 public:
  VecOf() = default;
  VecOf(const Real& x, const Real& y, const Real& z) : x_{x}, y_{y}, z_{z} {}
  template <class Derived>
    requires std::same_as<Real, double>
  VecOf(const Eigen::MatrixBase<Derived>& v)  // NOLINT(google-explicit-constructor): it is the same
      : x_{v.x()}, y_{v.y()}, z_{v.z()} {}
  operator Vec3() const  // NOLINT(google-explicit-constructor): it is the same
    requires std::same_as<Real, double>
  {
    return {x_, y_, z_};
  }

  const Real& x() const { return x_; }
  const Real& y() const { return y_; }
  const Real& z() const { return z_; }
  Real norm() const { return square_root(x_ * x_ + (y_ * y_ + z_ * z_)); }

  friend VecOf operator+(const VecOf& a, const VecOf& b) { return {a.x_ + b.x_, a.y_ + b.y_, a.z_ + b.z_}; }
  friend VecOf operator-(const VecOf& a, const VecOf& b) { return {a.x_ - b.x_, a.y_ - b.y_, a.z_ - b.z_}; }
  friend VecOf operator-(const VecOf& a) { return {-a.x_, -a.y_, -a.z_}; }
  friend VecOf operator*(const Real& k, const VecOf& a) { return {k * a.x_, k * a.y_, k * a.z_}; }
  friend VecOf operator/(const VecOf& a, const Real& k) { return {a.x_ / k, a.y_ / k, a.z_ / k}; }

 private:
  Real x_, y_, z_;
};

template <class Real>
VecOf<Real> select(const MaskOf<Real>& mask, const VecOf<Real>& yes, const VecOf<Real>& no) {
  return {select(mask, yes.x(), no.x()), select(mask, yes.y(), no.y()), select(mask, yes.z(), no.z())};
}

/// Each number of one times that of the other.
template <class Real>
VecOf<Real> by_axis(const VecOf<Real>& a, const VecOf<Real>& b) {
  return {a.x() * b.x(), a.y() * b.y(), a.z() * b.z()};
}

/// Of each number.
template <class Real>
VecOf<Real> magnitude(const VecOf<Real>& a) {
  return {magnitude(a.x()), magnitude(a.y()), magnitude(a.z())};
}

/// Sums in Eigen's order, a Vec3's first number last.
template <class Real>
Real dot(const VecOf<Real>& a, const VecOf<Real>& b) {
  return a.x() * b.x() + (a.y() * b.y() + a.z() * b.z());
}

template <class Real>
VecOf<Real> cross(const VecOf<Real>& a, const VecOf<Real>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

}  // namespace fairway::lanes
