// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/fin_autopilot.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/params.hpp"

namespace fairway {
namespace {

constexpr double steerage_pitch = 0.2;   // [rad]
constexpr double steepest_pitch = 0.5;   // [rad]; the lift of fins and hull is linear to about there
constexpr double least_fin_speed = 0.1;  // [m/s]: steerage way of a body that nothing rights
constexpr double fin_share = 0.8;        // of the bandwidth of the fins' lag
constexpr double least_lag_s = 0.5;      // of fins, so that gains stay finite

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

Vec3 finite(const Vec3& v) { return {finite(v.x()), finite(v.y()), finite(v.z())}; }

/// How far it goes either way.
double largest(const ActuatorInfo& fin) { return math::fmin(-fin.range.lo, fin.range.hi); }

double limited_to(double value, double limit) { return std::clamp(value, -limit, limit); }

}  // namespace

FinAutopilot::FinAutopilot(const FinDrive& drive, std::span<const ActuatorInfo> actuators)
    : drive_{drive},
      largest_rudder_{largest(actuators[drive.rudder])},
      largest_stern_{largest(actuators[drive.stern])},
      actuators_{actuators},
      mean_{actuators_.rest()} {
  if (!(drive.rudder_moment * largest_rudder_ > 0.0 && drive.stern_moment * largest_stern_ < 0.0)) {
    throw InputError("rudder or stern planes do not turn the vehicle: it cannot be steered");
  }
  const double lag =
      std::max(actuators[drive.rudder].time_constant_s, actuators[drive.stern].time_constant_s);
  bandwidth_ = fin_share / std::max(lag, least_lag_s);
  steerage_way_ =
      std::sqrt(drive.pitch_restoring * math::sin(steerage_pitch) / (-drive.stern_moment * largest_stern_));
  steerage_way_ = std::max(steerage_way_, least_fin_speed);
}

double FinAutopilot::turning_radius(double speed) const {
  return drive_.yaw_damping / (drive_.rudder_moment * largest_rudder_ * speed);
}

void FinAutopilot::reset() noexcept { surge_ = yaw_ = pitch_ = {}; }

void FinAutopilot::observe(double pitch, const Vec3& v_b, const Vec3& omega_b, double U2) noexcept {
  const double h = actuators_.step();
  const auto setting = [&](std::size_t i) { return mean_[static_cast<Eigen::Index>(i)]; };
  surge_.observe(v_b.x(), h, kept_, [&](double nu) {
    return (drive_.speed_per_turn * setting(drive_.propeller) - nu) * std::abs(nu) / drive_.surge_distance;
  });
  yaw_.observe(omega_b.z(), h, kept_, [&](double nu) {
    return (drive_.rudder_moment * U2 * setting(drive_.rudder) - drive_.yaw_damping * nu) /
           drive_.yaw_inertia;
  });
  pitch_.observe(omega_b.y(), h, kept_, [&](double nu) {
    return (drive_.stern_moment * U2 * setting(drive_.stern) - drive_.pitch_damping * nu -
            drive_.pitch_restoring * math::sin(pitch)) /
           drive_.pitch_inertia;
  });
}

double FinAutopilot::propeller_for(double surge, double u) const noexcept {
  const double response = drive_.surge_distance / std::max(std::abs(u), steerage_way_);  // [s]
  return (surge + (bandwidth_ * (surge - u) - surge_.unexplained) * response) / drive_.speed_per_turn;
}

double FinAutopilot::rudder_for(double yaw_rate, double r, double U2) const noexcept {
  const double moment =
      drive_.yaw_damping * yaw_rate + drive_.yaw_inertia * (bandwidth_ * (yaw_rate - r) - yaw_.unexplained);
  return moment / (drive_.rudder_moment * U2);
}

double FinAutopilot::stern_for(double sinking, double pitch, const Vec3& v_b, double q,
                               double U2) const noexcept {
  // the pitch that sinks that fast, as steep as the planes can hold
  const double U = std::sqrt(U2);
  const double attack = v_b.x() > 0.0 ? math::atan2(v_b.z(), v_b.x()) : 0.0;
  const double held = -drive_.stern_moment * U2 * largest_stern_;  // the greatest moment [N m]
  const double steepest = drive_.pitch_restoring > held
                              ? std::min(steepest_pitch, math::asin(held / drive_.pitch_restoring))
                              : steepest_pitch;
  const double wanted = limited_to(attack - math::asin(limited_to(sinking / U, 1.0)), steepest);

  const double I = drive_.pitch_inertia;
  const double k_theta = std::max(0.0, I * bandwidth_ * bandwidth_ - drive_.pitch_restoring);
  const double k_q = std::max(0.0, 2.0 * bandwidth_ * I - drive_.pitch_damping);
  const double moment = drive_.pitch_restoring * math::sin(wanted) + k_theta * (wanted - pitch) - k_q * q -
                        I * pitch_.unexplained;
  return moment / (drive_.stern_moment * U2);
}

ActuatorValues FinAutopilot::control(const BodyRequest& request, double pitch, const Vec3& v_b,
                                     const Vec3& omega_b, double h) noexcept {
  const Vec3 v = finite(v_b), omega = finite(omega_b);
  const double theta = finite(pitch);
  const double U2 = std::max(v.squaredNorm(), steerage_way_ * steerage_way_);
  observe(theta, v, omega, v.squaredNorm());

  ActuatorValues u = actuators_.rest();
  u[static_cast<Eigen::Index>(drive_.propeller)] = propeller_for(finite(request.surge_mps), v.x());
  u[static_cast<Eigen::Index>(drive_.rudder)] = rudder_for(finite(request.yaw_rate_radps), omega.z(), U2);
  u[static_cast<Eigen::Index>(drive_.stern)] = stern_for(finite(request.heave_mps), theta, v, omega.y(), U2);
  u = actuators_.limited(u);

  if (h != actuators_.step()) kept_ = math::exp(-bandwidth_ * h);
  mean_ = actuators_.follow(u, h);
  return u;
}

}  // namespace fairway
