// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "fairway/core/params.hpp"
#include "fairway/dynamics/propulsion.hpp"

namespace fairway {

/// How forces are shared out among the thrusters.
enum class AllocationMethod {
  bounded,         ///< the nearest wrench that the limits allow
  pseudo_inverse,  ///< u = B^+ tau, then each thruster held to its limits, as rehman2021 has it
};

template <>
struct EnumNames<AllocationMethod> {
  static constexpr std::array names{"bounded", "pseudo_inverse"};
};

/// Thrust for a wrench: B u = tau with B the thrust configuration matrix (Fossen 2021, section 11.2).
///
/// `bounded` solves
///
///     min |W (B u - tau)|^2 + epsilon |u|^2   subject to   lowest <= u <= highest
///
/// exactly, by a primal active set: thrusters are held at limits or free, the free ones take the least-norm
/// solution, and a thruster is let go where its multiplier says that it would do better. epsilon is 1e-12 of
/// |W B|^2, so that of equally near solutions the one of least thrust is chosen. W divides each axis by the
/// most that a newton of any one thruster gives there, and yaw counts 30 times: it is served first, and
/// gives up a newton's worth only where that saves 900 of them elsewhere. Where no limit is met, this is the
/// pseudo-inverse of W B.
///
/// A value; allocate() neither allocates nor throws. O(axes thrusters) for `pseudo_inverse`, and where no
/// limit is met; else O(axes^2 thrusters) per change of the active set, of which there are at most 4 per
/// thruster: after these the best thrusts so far are given, which are never farther off than the clipped
/// pseudo-inverse.
class ThrustAllocator {
 public:
  /// `actuators`: as many as `propulsion.effectiveness` has columns, else InputError.
  ThrustAllocator(const Propulsion& propulsion, std::span<const ActuatorInfo> actuators,
                  AllocationMethod method);

  /// Thrusts within their limits. Axes that the thrusters cannot push, and entries of `tau` that are not
  /// finite, are left at zero.
  ActuatorValues allocate(const Wrench& tau) const noexcept;

  /// The diagonal of W: how much of an error on each axis counts; zero where nothing pushes.
  const Wrench& weights() const { return weights_; }

 private:
  /// Where a thruster is while the nearest wrench is sought.
  enum class Hold : signed char { free, lowest, highest };
  using Holds = std::array<Hold, max_actuators>;

  /// The coordinates of a wrench in the range of W B along an orthonormal basis of it.
  using Coordinates = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

  /// Least-norm thrusts of the free thrusters, and the multiplier y that gives them: u_i = a_i y.
  struct Solution {
    ActuatorValues u;
    Coordinates y;
  };

  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_actuators + 6, 6>;

  ActuatorValues limited(const ActuatorValues& u) const noexcept;
  ActuatorValues nearest(const Coordinates& b, const ActuatorValues& start) const noexcept;
  Solution free_solution(const Coordinates& b, const ActuatorValues& u, const Holds& holds) const noexcept;
  static Coordinates orthogonalise(Rows& rows, Coordinates& y) noexcept;
  Eigen::Index advance(ActuatorValues& u, const ActuatorValues& target, const Holds& holds) const noexcept;
  Eigen::Index wrongly_held(const Solution& solution, const Holds& holds) const noexcept;

  AllocationMethod method_;
  Wrench weights_;
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 6, 6> axes_;                        // U^T W
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, max_actuators> A_;  // U^T W B, columns a_i
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, max_actuators, 6> inverse_;
  double sqrt_epsilon_{};
  ActuatorValues lowest_;
  ActuatorValues highest_;
};

}  // namespace fairway
