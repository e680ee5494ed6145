// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "fairway/control/acceleration_observer.hpp"
#include "fairway/control/body_request.hpp"
#include "fairway/control/thrust_allocator.hpp"
#include "fairway/dynamics/actuators.hpp"
#include "fairway/dynamics/propulsion.hpp"

namespace fairway {

/// Drives body velocities to a request through thrusters, one loop per axis that the thrusters can push
/// independently, of surge, sway, heave and yaw; a request on another axis is ignored. Per axis, with m its
/// mass with added mass, omega its bandwidth, r the request and nu the velocity through the water:
///
///     tau  = g + (d_l + d_q |r|) r + m omega (r - nu) - m a     restoring and drag, P, what is unexplained
///     nu^' = (f - g - (d_l + d_q |nu|) nu) / m + a + 2 L (nu - nu^)             what the model expects
///     a'   = L^2 (nu - nu^)                                     acceleration that it does not explain
///     u    = B^+ tau
///
/// with f the thrust the actuators are giving: limits and lag of past commands included. The integral action
/// is the observer's a: without limits and lag this is PI control, both observer poles at L; and a request
/// beyond what the thrusters give cannot wind it up, since they do what the model expects of them.
///
/// Where the thrusters cannot give all of tau, yaw is served first, then heave, surge and sway, each as far
/// as the asymmetric limits leave room. With as many thrusters as axes there is no other way to share; with
/// more, ThrustAllocator finds the nearest wrench that the limits allow.
///
/// A value: a copy carries on alike. control(): O(axes x actuators), neither allocates nor throws.
class VelocityController {
 public:
  struct Params {
    double surge_bandwidth_radps{0.8};
    double sway_bandwidth_radps{0.6};
    double heave_bandwidth_radps{0.8};
    double yaw_bandwidth_radps{1.0};
    double observer_bandwidth_radps{0.8};

    static consteval auto fields() {
      using P = Params;
      constexpr Range bandwidth{0.01, 20};
      return std::tuple{
          field<&P::surge_bandwidth_radps>(bandwidth, "bandwidth of the surge controller"),
          field<&P::sway_bandwidth_radps>(bandwidth, "bandwidth of the sway controller"),
          field<&P::heave_bandwidth_radps>(bandwidth, "bandwidth of the heave controller"),
          field<&P::yaw_bandwidth_radps>(bandwidth, "bandwidth of the yaw rate controller"),
          field<&P::observer_bandwidth_radps>({0, 20},
                                              "how fast unexplained accelerations are learnt; 0 = never"),
      };
    }
  };

  /// `actuators`: as many as `propulsion.effectiveness` has columns. Throws InputError if no axis can be
  /// pushed.
  VelocityController(const Propulsion& propulsion, std::span<const ActuatorInfo> actuators,
                     const Params& params);

  /// Thruster commands for the next `h` [s], within their limits, from velocities through the water. It takes
  /// for granted that each command is carried out for its `h`. An axis whose request or velocity is not
  /// finite gets no thrust.
  ActuatorValues control(const BodyRequest& request, const Vec3& v_b, const Vec3& omega_b, double h) noexcept;

  /// Forgets the unexplained accelerations learnt so far.
  void reset() noexcept;

 private:
  struct Axis {
    int row{};           // of nu and tau
    double mass{};       // m [kg, kg m2]
    double bandwidth{};  // omega [rad/s]
    double linear_damping{};
    double quadratic_damping{};
    double restoring{};
    ActuatorValues push;    // column of B^+: thrust for a unit of tau
    ActuatorValues effect;  // row of B: tau for a unit of thrust
  };

  void observe(const Axis& axis, AccelerationObserver& memory, double velocity) const noexcept;
  ActuatorValues allocate(std::array<double, 4>& missing) const noexcept;
  ActuatorValues share_in_turn(std::array<double, 4>& missing) const noexcept;

  std::array<Axis, 4> axes_;  // in order of priority
  std::size_t axis_count_{};
  double observer_bandwidth_{};

  std::optional<ThrustAllocator> allocator_;  // of more thrusters than axes

  std::array<AccelerationObserver, 4> memories_{};
  Actuators thrusters_;        // as they should be
  ActuatorValues mean_;        // over their last step
  double kept_surprise_{1.0};  // exp(-L h) for their step
};

}  // namespace fairway
