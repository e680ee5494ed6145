// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "fairway/dynamics/composite/part.hpp"

namespace fairway {

/// Along which axes a body moves.
enum class DegreesOfFreedom {
  planar,  ///< surge, sway and yaw; depth is held and the body is taken as level
  six,
};

template <>
struct EnumNames<DegreesOfFreedom> {
  static constexpr std::array names{"planar", "six"};
};

/// Several submerged bodies fixed to one another, as one (derivation in README.md beside this file):
///
///     nu_i = H_i nu,   M = sum H_i^T M_i H_i,   D_l = sum H_i^T D_l,i H_i
///     d_q(nu) = sum H_i^T D_q,i |nu_i| nu_i     each part with its own velocity, not lumped
///     M nu_r' = tau - C(nu_r) nu_r - D_l nu_r - d_q(nu_r) - g(eta)
///
/// in relative velocity as SubmergedBody, of which this is the generalisation. With `planar`, M is restricted
/// to surge, sway and yaw and the other axes stay at rest: whatever holds them takes up heave, roll and
/// pitch.
///
/// Damping and buoyancy scale with the water's density, M_A does not.
///
/// Constants only. derivative(): O(drag lines), no trigonometry. A drag line is an axis of a part along which
/// it has quadratic drag; those that coincide are one.
class CompositeBody {
 public:
  struct Options {
    DegreesOfFreedom degrees_of_freedom{DegreesOfFreedom::six};
    bool coriolis{true};        ///< C(nu); without it momentum turns with the body
    bool quadratic_drag{true};  ///< d_q(nu)
  };

  /// Throws InputError without parts, or if M is not positive definite on the free axes.
  CompositeBody(std::span<const Part> parts, const Options& options);

  /// State derivative under the wrench `tau` of the actuators about the origin [N, N m, body]. With
  /// `planar` only X, Y and N of it, u, v, r and yaw of `x` are read.
  StateRate derivative(const VehicleState& x, const fossen::Vector6& tau, const Water& water) const noexcept;

  DegreesOfFreedom degrees_of_freedom() const { return options_.degrees_of_freedom; }
  const fossen::Matrix6& mass() const { return whole_.M; }              ///< M = M_RB + M_A, on all six axes
  const fossen::Matrix6& linear_damping() const { return whole_.D_l; }  ///< D_l, on all six axes

  /// d_q(nu) on all six axes, in water of the first part's density [N, N m, body].
  fossen::Vector6 quadratic_drag(const fossen::Vector6& nu) const noexcept;

  /// What the drag comes to along one axis alone: d_q,j(e_j) for each axis j [kg/m, kg m2/rad2].
  fossen::Vector6 quadratic_damping() const;

  /// g(eta) when level, in water of the first part's density; zero with `planar`.
  fossen::Vector6 level_restoring() const;

 private:
  /// Drag c |e nu| (e nu) e along the unit vector e of N velocities.
  template <int N>
  struct DragLine {
    Eigen::Matrix<double, N, 1> direction;
    double coefficient;
  };
  template <int N>
  using DragLines = std::vector<DragLine<N>>;

  /// The sums over all parts, on six axes, in water of the first part's density.
  struct Composition {
    Composition(std::span<const Part> parts, bool quadratic_drag);
    void add(const Part& part, double relative_density, bool quadratic_drag);

    fossen::Matrix6 M = fossen::Matrix6::Zero();
    fossen::Matrix6 M_C = fossen::Matrix6::Zero();  // whose momentum makes C(nu)
    fossen::Matrix6 D_l = fossen::Matrix6::Zero();
    DragLines<6> lines;
    double weight{};                      // W
    double buoyancy{};                    // B
    Vec3 weight_moment = Vec3::Zero();    // W r_g
    Vec3 buoyancy_moment = Vec3::Zero();  // B r_b
    double inverse_density{};
  };

  /// The equations on the N free axes.
  template <int N>
  struct Axes {
    using Matrix = Eigen::Matrix<double, N, N>;
    using Vector = Eigen::Matrix<double, N, 1>;

    Axes(const Composition& whole, const Eigen::Matrix<double, 6, N>& free);

    Matrix M_inverse;
    Matrix M_C;
    Matrix D_l;
    DragLines<N> lines;
  };

  template <int N>
  static void add_line(DragLines<N>& lines, const Eigen::Matrix<double, N, 1>& row, double coefficient);
  template <int N>
  static Eigen::Matrix<double, N, 1> drag_of(const DragLines<N>& lines,
                                             const Eigen::Matrix<double, N, 1>& nu) noexcept;

  StateRate rate(const Axes<3>& axes, const VehicleState& x, const fossen::Vector6& tau,
                 const Water& water) const noexcept;
  StateRate rate(const Axes<6>& axes, const VehicleState& x, const fossen::Vector6& tau,
                 const Water& water) const noexcept;

  Options options_;
  Composition whole_;
  std::variant<Axes<6>, Axes<3>> axes_;
};

}  // namespace fairway
