// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "fairway/dynamics/fossen.hpp"
#include "fairway/dynamics/integrate.hpp"
#include "fairway/dynamics/kinematic/level_motion.hpp"
#include "fairway/dynamics/lanes/kernel.hpp"

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
    const double most = numbers_.max_acceleration, most_turn = numbers_.max_turn_acceleration;
    Vec3 a = numbers_.rate * (setpoint(u) - v);
    if (a.squaredNorm() > most * most) a *= most / a.norm();
    const Vec3 alpha = numbers_.rate * (Vec3{0.0, 0.0, u[2]} - x.omega_b);

    StateRate rate;
    rate.p_n.noalias() = R * x.v_b;
    rate.q_nb = fossen::quaternion_rate(x.q_nb, x.omega_b);
    rate.v_b = a - x.omega_b.cross(v_c) + R.transpose() * water.current_rate_n;
    rate.omega_b = alpha.cwiseMax(-most_turn).cwiseMin(most_turn);
    return rate;
  }

  /// `x` one step of `h` [s] later, to the bits of `rk4`; sooner where it is level, as it stays, and the
  /// water is still.
  VehicleState advanced(const VehicleState& x, const ActuatorValues& u, const Water& water,
                        double h) const noexcept {
    return is_level(x, water) ? advanced_level(x, u, h) : rk4(*this, x, u, water, h);
  }

  /// Moves several by one step of `h` [s], each to the bits of `advanced`: those that are level in still
  /// water as many at a time as the processor has lanes. On the stack; allocates nothing.
  class SideBySide {
   public:
    SideBySide(const Kinematic& model, double h, const lanes::MotionKernel& kernel) noexcept
        : model_{model}, kernel_{kernel} {
      bodies_.h = h;
    }

    /// `x` is moved by and by, at the latest by `finish`.
    void add(VehicleState& x, const ActuatorValues& u, const Water& water) noexcept;
    void finish() noexcept;

   private:
    lanes::LevelBodies bodies_;
    const Kinematic& model_;
    const lanes::MotionKernel& kernel_;
    std::size_t count_ = 0;
    std::array<VehicleState*, lanes::most_bodies> states_;
  };

  /// Nothing is known about its drive: 0.
  double power(const ActuatorValues&) const noexcept { return 0.0; }

 private:
  /// Zeros that are not negative: then no sign of a zero comes out otherwise than of the full equations.
  static bool is_level(const VehicleState& x, const Water& water) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return water.current_n.isZero(0.0) && water.current_rate_n.isZero(0.0) &&
           (bits(x.q_nb.x()) | bits(x.q_nb.y()) | bits(x.omega_b.x()) | bits(x.omega_b.y())) == 0;
  }

  Vec3 setpoint(const ActuatorValues& u) const { return {u[0], sways_ ? u[3] : 0.0, u[1]}; }

  VehicleState advanced_level(const VehicleState& x, const ActuatorValues& u, double h) const noexcept {
    const lanes::LevelOf<double> from{{x.p_n.x(), x.p_n.y(), x.p_n.z(), x.v_b.x(), x.v_b.y(), x.v_b.z(),
                                       x.q_nb.w(), x.q_nb.z(), x.omega_b.z()}};
    const auto to = lanes::stepped<double>(numbers_, from, {setpoint(u), u[2]}, h);
    return level_state([&](std::size_t i) { return to[i]; });
  }

  /// Of what changes, in the order of LevelOf.
  static VehicleState level_state(const auto& of) {
    return {.p_n = {of(lanes::north), of(lanes::east), of(lanes::down)},
            .q_nb = {of(lanes::q_w), 0.0, 0.0, of(lanes::q_z)},
            .v_b = {of(lanes::surge), of(lanes::sway), of(lanes::heave)},
            .omega_b = {0.0, 0.0, of(lanes::turn)}};
  }

  lanes::LevelNumbers numbers_;
  bool sways_;
  std::array<ActuatorInfo, 4> actuators_;
};

}  // namespace fairway
