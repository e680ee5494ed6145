// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "fairway/dynamics/fossen.hpp"
#include "fairway/dynamics/integrate.hpp"

namespace fairway {

/// A vehicle without forces: its velocities through the water follow setpoints within limits, it keeps
/// level and, unless it is given sway, never slips sideways. README.md beside this file has the equations.
class Kinematic {
 public:
  static constexpr VehicleInfo info{.name = "kinematic",
                                    .title = "Limited velocities, no forces",
                                    .source =
                                        "unicycle with first-order, limited response; "
                                        "fairway/dynamics/kinematic/README.md"};

  struct Params {
    double max_speed_mps{0.5};
    double max_reverse_mps{0.5};
    double max_sway_mps{0.0};
    double max_heave_mps{0.5};
    double max_turn_rate_radps{0.45};
    double max_acceleration_mps2{0.5};
    double max_turn_acceleration_radps2{0.5};
    double time_constant_s{0.2};

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::max_speed_mps>({0, 50}, "fastest ahead through the water"),
          field<&P::max_reverse_mps>({0, 50}, "fastest astern"),
          field<&P::max_sway_mps>({0, 50}, "fastest to either side; 0 for a vehicle that cannot"),
          field<&P::max_heave_mps>({0, 50}, "fastest down and up; 0 for a surface vehicle"),
          field<&P::max_turn_rate_radps>({0, 10}, "fastest turn to either side"),
          field<&P::max_acceleration_mps2>({0.001, 100}, "of surge, sway and heave together"),
          field<&P::max_turn_acceleration_radps2>({0.001, 100}, "of the turn rate"),
          field<&P::time_constant_s>({0.02, 10},
                                     "of the approach to a setpoint; steps of up to 2.7 times it are stable"),
      };
    }
  };

  explicit Kinematic(const Params& params);

  /// surge_mps, heave_mps (positive down), yaw_rate_radps (positive to starboard) and, where there is sway,
  /// sway_mps (positive to starboard): setpoints through the water.
  std::span<const ActuatorInfo> actuators() const {
    return std::span{actuators_}.first(sways_ ? actuators_.size() : actuators_.size() - 1);
  }

  [[gnu::always_inline]] StateRate derivative(const VehicleState& x, const ActuatorValues& u,
                                              const Water& water) const noexcept {
    const fossen::Matrix3 R = fossen::rotation(x.q_nb);
    const Vec3 v_c = R.transpose() * water.current_n;

    // first-order approach, no faster than the acceleration limits
    const Vec3 v = x.v_b - v_c;
    const double sway = sways_ ? u[3] : 0.0;
    Vec3 a = rate_ * (Vec3{u[0], sway, u[1]} - v);
    if (a.squaredNorm() > max_acceleration_ * max_acceleration_) a *= max_acceleration_ / a.norm();
    const Vec3 alpha = rate_ * (Vec3{0.0, 0.0, u[2]} - x.omega_b);

    StateRate rate;
    rate.p_n.noalias() = R * x.v_b;
    rate.q_nb = fossen::quaternion_rate(x.q_nb, x.omega_b);
    rate.v_b = a - x.omega_b.cross(v_c) + R.transpose() * water.current_rate_n;
    rate.omega_b = alpha.cwiseMax(-max_turn_acceleration_).cwiseMin(max_turn_acceleration_);
    return rate;
  }

  /// `x` one step of `h` [s] later, to the bits of `rk4`; sooner where it is level, as it stays, and the
  /// water is still.
  VehicleState advanced(const VehicleState& x, const ActuatorValues& u, const Water& water,
                        double h) const noexcept {
    const bool still = water.current_n.isZero(0.0) && water.current_rate_n.isZero(0.0);
    return still && is_level(x) ? advanced_level(x, u, h) : rk4(*this, x, u, water, h);
  }

  /// Nothing is known about its drive: 0.
  double power(const ActuatorValues&) const noexcept { return 0.0; }

 private:
  /// What changes of whoever is level, side by side, so that the compiler takes two at a time.
  enum : std::size_t { north, east, down, surge, sway, heave, q_w, q_z, turn, level_size };
  struct Level {
    std::array<double, level_size + 1> all;  // an even number: nothing is in the last

    double operator[](std::size_t i) const { return all[i]; }
    [[gnu::always_inline]] friend inline Level moved(const Level& x, const Level& rate, double h) {
      Level y;
      for (std::size_t i = 0; i < y.all.size(); ++i) y.all[i] = x[i] + h * rate[i];
      return y;
    }
    [[gnu::always_inline]] friend inline Level mean_of(const Level& k1, const Level& k2, const Level& k3,
                                                       const Level& k4) {
      Level mean;
      for (std::size_t i = 0; i < mean.all.size(); ++i)
        mean.all[i] = (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) / 6;
      return mean;
    }
  };

  /// Zeros that are not negative: then no sign of a zero comes out otherwise than of the full equations.
  static bool is_level(const VehicleState& x) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return (bits(x.q_nb.x()) | bits(x.q_nb.y()) | bits(x.omega_b.x()) | bits(x.omega_b.y())) == 0;
  }

  /// `derivative` without what is zero of one that is level in still water.
  [[gnu::always_inline]] Level level_rate(const Level& x, const Vec3& setpoint,
                                          double turn_rate) const noexcept {
    const double two_z = 2.0 * x[q_z], sine = two_z * x[q_w], cosine = 1.0 - two_z * x[q_z];
    Vec3 a = rate_ * (setpoint - Vec3{x[surge], x[sway], x[heave]});
    if (a.squaredNorm() > max_acceleration_ * max_acceleration_) a *= max_acceleration_ / a.norm();
    const double half_turn = 0.5 * x[turn];
    const double alpha = rate_ * (turn_rate - x[turn]);
    return {{cosine * x[surge] - sine * x[sway], sine * x[surge] + cosine * x[sway], x[heave], a.x(), a.y(),
             a.z(), -(x[q_z] * half_turn), x[q_w] * half_turn,
             std::min(std::max(alpha, -max_turn_acceleration_), max_turn_acceleration_), 0.0}};
  }

  VehicleState advanced_level(const VehicleState& x, const ActuatorValues& u, double h) const noexcept {
    const Vec3 setpoint{u[0], sways_ ? u[3] : 0.0, u[1]};
    const Level from{{x.p_n.x(), x.p_n.y(), x.p_n.z(), x.v_b.x(), x.v_b.y(), x.v_b.z(), x.q_nb.w(),
                      x.q_nb.z(), x.omega_b.z(), 0.0}};
    const auto rate_of = [&](const Level& at) __attribute__((always_inline)) {
      return level_rate(at, setpoint, u[2]);
    };
    const Level to = runge_kutta(from, h, rate_of);
    const double length = std::sqrt(to[q_z] * to[q_z] + to[q_w] * to[q_w]);
    return {.p_n = {to[north], to[east], to[down]},
            .q_nb = {to[q_w] / length, 0.0, 0.0, to[q_z] / length},
            .v_b = {to[surge], to[sway], to[heave]},
            .omega_b = {0.0, 0.0, to[turn]}};
  }

  double rate_;  // 1 / time constant [1/s]
  double max_acceleration_;
  double max_turn_acceleration_;
  bool sways_;
  std::array<ActuatorInfo, 4> actuators_;
};

}  // namespace fairway
