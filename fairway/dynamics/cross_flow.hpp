// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

#include "fairway/core/vec.hpp"

namespace fairway {

/// Two-dimensional cross-flow drag coefficient [-] of a ship's section by Hoerner's curve over beam / (2
/// draft), which are both in [m] (Fossen 2021, figure 6.16; points as digitised by Leite et al., Applied
/// Ocean Research 20, 1998). Constant beyond the ends of the curve, 0.011 and 4.003.
double hoerner_drag(double beam_m, double draft_m);

/// Two-dimensional drag coefficient [-] of a smooth circular cylinder of finite length over the Reynolds
/// number (DNV-RP-C205, 2025: drag crisis between 2e5 and 6e5, reduction by the flow around the ends).
/// Constant beyond the ends of the curve, 1.02e4 and 4.94e6.
///
/// The reduction has one value below a Reynolds number of 2e5 and one from there on: the coefficient jumps
/// there.
class CylinderDrag {
 public:
  /// `slenderness` is length / diameter; the reduction is constant beyond 2 and 100.
  explicit CylinderDrag(double slenderness);

  /// O(log n) in the 28 points of the curve.
  double at(double reynolds) const noexcept;

 private:
  double subcritical_reduction_;
  double supercritical_reduction_;
};

/// Cross-flow drag of a hull as the sum over its strips (Fossen 2021, 6.90-6.91, for heave and pitch alike):
///
///     Y = -1/2 rho T C_d sum |v + x r| (v + x r) dx       N = -1/2 rho T C_d sum x |v + x r| (v + x r) dx
///     Z = -1/2 rho T C_d sum |w - x q| (w - x q) dx       M = +1/2 rho T C_d sum x |w - x q| (w - x q) dx
///
/// The published models sum over the 21 edges of 20 strips, both ends in full: 5 % more than the integral in
/// sway, 10 % to 15 % more in yaw. Their other numbers were tuned with that, so it is kept.
class CrossFlow {
 public:
  /// Hull of `length_m` about the body origin, whose section is `depth_m` high, in water of `density_kgpm3`.
  CrossFlow(double length_m, double depth_m, double density_kgpm3);

  /// Force [N] and moment about the body origin [N m, body] at the velocities through the water. O(21).
  [[gnu::always_inline]] std::pair<Vec3, Vec3> drag(const Vec3& v, const Vec3& omega,
                                                    double coefficient) const noexcept {
    // both planes at once: the one of sway and yaw, the one of heave and pitch
    const Eigen::Array2d flow{v.y(), v.z()}, turn{omega.z(), -omega.y()};
    Eigen::Array2d force = Eigen::Array2d::Zero(), moment = Eigen::Array2d::Zero();
    for (const double x : x_) {
      const Eigen::Array2d local = flow + x * turn;
      const Eigen::Array2d strip = local.abs() * local;
      force += strip;
      moment += x * strip;
    }

    const double scale = -per_coefficient_ * coefficient;
    return {scale * Vec3{0.0, force[0], force[1]}, scale * Vec3{0.0, -moment[1], moment[0]}};
  }

 private:
  std::array<double, 21> x_{};  // [m]
  double per_coefficient_;      // rho T dx / 2 [kg/m]
};

}  // namespace fairway
