// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/otter/otter_hull.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/params.hpp"

namespace fairway {
namespace {

// the boat; lengths in m, masses in kg
constexpr double length = 2.0, beam = 1.08;
constexpr double hull_mass = 55.0;
constexpr double gyration_roll = 0.4 * beam, gyration_pitch = 0.25 * length, gyration_yaw = 0.25 * length;
const Vec3 hull_centre{0.2, 0.0, -0.2};

// one pontoon
constexpr double pontoon_beam = 0.25, pontoon_y = OtterHull::propeller_y_m;
constexpr double waterplane_coefficient = 0.75, block_coefficient = 0.4;
constexpr double flotation_x = -0.2;

// damping ratios
constexpr double heave_damping_ratio = 0.3, roll_damping_ratio = 0.2, pitch_damping_ratio = 0.4;

constexpr double rho = OtterHull::density_kgpm3;
constexpr double g = fossen::gravity;

/// Boat and payload as one rigid body in the water.
struct Loaded {
  explicit Loaded(const OtterParams& p)
      : payload{p.payload_x_m, p.payload_y_m, p.payload_z_m},
        mass{hull_mass + p.payload_kg},
        centre{(hull_mass * hull_centre + p.payload_kg * payload) / mass},
        volume{mass / rho},
        draft{volume / (2.0 * block_coefficient * pontoon_beam * length)} {
    const fossen::Matrix3 hull_arm = fossen::skew(hull_centre - centre);
    const fossen::Matrix3 payload_arm = fossen::skew(payload - centre);
    const Vec3 gyration{gyration_roll, gyration_pitch, gyration_yaw};
    inertia = hull_mass * fossen::Matrix3{gyration.cwiseAbs2().asDiagonal()} -
              hull_mass * hull_arm * hull_arm - p.payload_kg * payload_arm * payload_arm;
  }

  Vec3 payload;             // r_p
  double mass;              // m + m_p
  Vec3 centre;              // r_g of both
  fossen::Matrix3 inertia;  // I_g of both about their centre
  double volume;            // nabla
  double draft;             // T
};

/// A_11 = 2.7 rho nabla^(5/3) / L^2 (Soeding 1982).
double added_mass_in_surge() {
  return 2.7 * rho * math::exp(5.0 / 3.0 * math::log(hull_mass / rho)) / (length * length);
}

fossen::Matrix6 mass_of(const Loaded& boat) {
  fossen::Vector6 added;
  added << added_mass_in_surge(), 1.5 * hull_mass, 1.0 * hull_mass, 0.2 * boat.inertia(0, 0),
      0.8 * boat.inertia(1, 1), 1.7 * boat.inertia(2, 2);
  return fossen::rigid_body_mass(boat.mass, boat.centre, boat.inertia) + fossen::Matrix6{added.asDiagonal()};
}

/// [G_33 G_44 G_55] about the centre of flotation (Fossen 2021, section 4.2).
Vec3 stiffness_of(const Loaded& boat) {
  const double waterplane = waterplane_coefficient * length * pontoon_beam;
  const double cw = waterplane_coefficient;
  const double transverse = 2.0 / 12.0 * length * math::power(pontoon_beam, 3) *
                                (6.0 * cw * cw * cw / ((1.0 + cw) * (1.0 + 2.0 * cw))) +
                            2.0 * waterplane * pontoon_y * pontoon_y;
  const double longitudinal = 0.8 * 2.0 / 12.0 * pontoon_beam * math::power(length, 3);

  const double buoyancy_above_keel = (2.5 * boat.draft - 0.5 * boat.volume / (length * pontoon_beam)) / 3.0;
  const double gravity_above_keel = boat.draft - boat.centre.z();
  const double lever = buoyancy_above_keel - gravity_above_keel;
  const double metacentric_roll = transverse / boat.volume + lever;
  const double metacentric_pitch = longitudinal / boat.volume + lever;
  if (!(std::min(metacentric_roll, metacentric_pitch) > 0.0)) {
    throw InputError("otter: its payload is too heavy or too high to float upright");
  }

  const double weight = rho * g * boat.volume;
  return {rho * g * 2.0 * waterplane, weight * metacentric_roll, weight * metacentric_pitch};
}

/// G of z, roll and pitch about the body origin: a pitch theta lifts the centre of flotation by -x theta.
fossen::Matrix3 stiffness_about_origin(const Vec3& stiffness) {
  fossen::Matrix3 G = stiffness.asDiagonal();
  G(0, 2) = G(2, 0) = -flotation_x * stiffness[0];
  G(2, 2) += flotation_x * flotation_x * stiffness[0];
  return G;
}

/// 2 zeta sqrt(k m), the linear damping of a mass on a spring.
double damping_of(double ratio, double stiffness, double mass) {
  return 2.0 * ratio * std::sqrt(stiffness * mass);
}

fossen::Vector6 damping_of(const OtterParams& p, const fossen::Matrix6& M, const Vec3& stiffness) {
  fossen::Vector6 D;
  D << 2.0 * OtterHull::max_ahead_n / p.max_speed_mps, M(1, 1) / p.sway_time_constant_s,
      damping_of(heave_damping_ratio, stiffness[0], M(2, 2)),
      damping_of(roll_damping_ratio, stiffness[1], M(3, 3)),
      damping_of(pitch_damping_ratio, stiffness[2], M(4, 4)), M(5, 5) / p.yaw_time_constant_s;
  return D;
}

double roll_of(const Vec3& down_b) { return math::atan2(down_b.y(), down_b.z()); }
double pitch_of(const Vec3& down_b) { return -math::asin(std::clamp(down_b.x(), -1.0, 1.0)); }

/// The third row of R at `roll` and `pitch`.
Vec3 down_at(double roll, double pitch) {
  const auto [sp, cp] = math::sin_cos(pitch);
  const auto [sr, cr] = math::sin_cos(roll);
  return {-sp, cp * sr, cp * cr};
}

}  // namespace

OtterHull::OtterHull(const OtterParams& p)
    : payload_{checked_params(p).payload_x_m, p.payload_y_m, p.payload_z_m},
      payload_weight_{p.payload_kg * g},
      strip_coefficient_{hoerner_drag(pontoon_beam, Loaded{p}.draft)},
      strips_{length, Loaded{p}.draft, rho} {
  const Loaded boat{p};
  const Vec3 stiffness = stiffness_of(boat);
  M_ = mass_of(boat);
  M_inverse_ = M_.inverse();
  D_ = damping_of(p, M_, stiffness);
  G_ = stiffness_about_origin(stiffness);
  G_inverse_ = G_.inverse();
}

OtterHull::Hydrostatic OtterHull::trim(const Vec3& down_b) const noexcept {
  const Vec3 force = payload_weight_ * down_b;
  const Vec3 moment = payload_.cross(force);
  return G_inverse_ * Hydrostatic{force.z(), moment.x(), moment.y()};
}

StateRate OtterHull::derivative(const VehicleState& x, double port_n, double starboard_n,
                                const Water& water) const noexcept {
  const Vec3& omega = x.omega_b;
  const fossen::Matrix3 R = fossen::rotation(x.q_nb);
  const Vec3 down_b = R.row(2).transpose();
  const double roll = roll_of(down_b), pitch = pitch_of(down_b);
  const Eigen::Vector2d heading = R.col(0).head<2>() / std::max(R.col(0).head<2>().norm(), 1e-9);
  const auto turned = [&](double forward, double starboard) {
    return Eigen::Vector2d{heading.x() * forward - heading.y() * starboard,
                           heading.y() * forward + heading.x() * starboard};
  };

  // motion through the water
  const auto ahead = [&](const Vec3& a) {
    return Vec3{heading.x() * a.x() + heading.y() * a.y(), heading.x() * a.y() - heading.y() * a.x(), a.z()};
  };
  const Vec3 v_c = ahead(water.current_n);
  const Vec3 v = x.v_b - v_c;

  // tau + D nu_r + cross-flow - C(nu_r) nu_r - G (eta_s - eta_0)
  fossen::Vector6 nu;
  nu << v, omega;
  fossen::Vector6 force = -fossen::coriolis_force(M_ * nu, v, omega) - D_.cwiseProduct(nu);
  force[5] -= D_[5] * yaw_quadratic_damping * std::abs(omega.z()) * omega.z();
  const auto [drag, twist] = strips_.drag(v, omega, strip_coefficient_);
  force.head<3>() += drag;
  force.tail<3>() += twist;
  force[0] += port_n + starboard_n;
  force[5] += propeller_y_m * (port_n - starboard_n);
  Vec3 normal_b = down_b;
  Hydrostatic eta_s{x.p_n.z() + water.elevation, roll, pitch};
  if (water.slope_n != Vec2::Zero()) {
    normal_b = R.transpose() * water.surface_normal();
    eta_s.tail<2>() = Vec2{roll_of(normal_b), pitch_of(normal_b)};
  }
  const Hydrostatic eta_0 = trim(normal_b);
  force.segment<3>(2) -= G_ * (eta_s - eta_0);
  const fossen::Vector6 nu_dot = M_inverse_ * force;

  // eta' = J(eta - eta_0) nu
  const auto [sr, cr] = math::sin_cos(roll - eta_0[1]);
  const auto [sp, cp] = math::sin_cos(pitch - eta_0[2]);
  const double lateral = cr * x.v_b.y() - sr * x.v_b.z(), vertical = sr * x.v_b.y() + cr * x.v_b.z();
  const double yaw_rate = (sr * omega.y() + cr * omega.z()) / cp;
  const double pitch_rate = cr * omega.y() - sr * omega.z();
  const double roll_rate = omega.x() + sp * yaw_rate;

  const math::SinCos upright = math::sin_cos(roll);
  // the angular velocity in body axes that turns roll, pitch and yaw of the state so
  const Vec3 turning =
      roll_rate * Vec3::UnitX() + pitch_rate * Vec3{0.0, upright.cos, -upright.sin} + yaw_rate * down_b;

  StateRate rate;
  rate.p_n << turned(cp * x.v_b.x() + sp * vertical, lateral), cp * vertical - sp * x.v_b.x();
  rate.q_nb = fossen::quaternion_rate(x.q_nb, turning);
  rate.v_b = nu_dot.head<3>() - omega.cross(v_c) + ahead(water.current_rate_n);
  rate.omega_b = nu_dot.tail<3>();
  return rate;
}

VehicleState OtterHull::floating() const {
  // eta = eta_0(eta): the payload's moment is weaker than the water's, so that repeating it converges
  Hydrostatic eta = Hydrostatic::Zero();
  for (int i = 0; i < 200; ++i) eta = trim(down_at(eta[1], eta[2]));

  VehicleState x;
  x.p_n.z() = eta[0];
  x.q_nb = quaternion_of({.roll = eta[1], .pitch = eta[2], .yaw = 0.0});
  return x;
}

}  // namespace fairway
