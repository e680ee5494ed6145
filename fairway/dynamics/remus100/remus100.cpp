// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/remus100/remus100.hpp"

#include <Eigen/LU>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/params.hpp"

namespace fairway {
namespace {

// hull; lengths in m, areas in m2
constexpr double hull_length = 1.6, diameter = 0.19;
constexpr double semi_axis_a = 1.0096 * hull_length / 2.0;  // of a spheroid of 31.9 kg
constexpr double semi_axis_b = 1.0096 * diameter / 2.0;
constexpr double planform = 0.7 * hull_length * diameter;
constexpr double aspect_ratio = diameter * diameter / planform;
constexpr double oswald_efficiency = 0.3;
constexpr double roll_added_inertia = 0.3;  // r_44, of I_x
constexpr double viscosity = 1e-6;          // kinematic [m2/s]
const Vec3 r_g{0.0, 0.0, 0.02};

// rudder and stern planes, a pair of fins each
constexpr double fin_area = 2.0 * 0.00665;
constexpr double fin_x = -semi_axis_a;
constexpr double largest_fin_angle = radians(20.0);

// propeller
constexpr double propeller_diameter = 0.14;
constexpr double max_propeller_rpm = 1525.0;
constexpr double thrust_deduction = 0.1;
constexpr double wake_fraction = 0.056;
constexpr double design_advance = 0.6632;                    // J_a
constexpr double K_T_bollard = 0.4566, K_T_design = 0.1798;  // at J_a = 0 and at design_advance
constexpr double K_Q_bollard = 0.0700, K_Q_design = 0.0312;
constexpr double roll_reaction = 0.1;  // of the propeller's torque, matched to trials

// The published model weighs the hull and cuts its strips in water of another density than all else.
constexpr double sea_density = 1026.0, ballast_density = 1025.0;
constexpr double gravity_at_trondheim = 9.821784864579081;  // WGS-84 at 63.446827 degrees north [m/s2]

/// Mass and principal moments of a homogeneous spheroid of density `density`: [m, I_x, I_y = I_z].
Vec3 spheroid(double density) {
  const double a2 = semi_axis_a * semi_axis_a, b2 = semi_axis_b * semi_axis_b;
  const double m = 4.0 / 3.0 * pi * density * semi_axis_a * b2;
  return {m, 0.4 * m * b2, 0.2 * m * (a2 + b2)};
}

/// Diagonal of M_A by Lamb's k-factors (Imlay 1961; Fossen 2021, section 8.4.2).
fossen::Vector6 added_mass() {
  const Vec3 water = spheroid(sea_density);
  const double e2 = 1.0 - semi_axis_b * semi_axis_b / (semi_axis_a * semi_axis_a);
  const double e = std::sqrt(e2), e3 = e * e2;
  const double logarithm = math::log((1.0 + e) / (1.0 - e));
  const double alpha_0 = 2.0 * (1.0 - e2) / e3 * (0.5 * logarithm - e);
  const double beta_0 = 1.0 / e2 - (1.0 - e2) / (2.0 * e3) * logarithm;
  const double k_1 = alpha_0 / (2.0 - alpha_0);
  const double k_2 = beta_0 / (2.0 - beta_0);
  const double k_prime =
      e2 * e2 * (beta_0 - alpha_0) / ((2.0 - e2) * (2.0 * e2 - (2.0 - e2) * (beta_0 - alpha_0)));

  fossen::Vector6 M_A;
  M_A << k_1 * water[0], k_2 * water[0], k_2 * water[0], roll_added_inertia * water[1], k_prime * water[2],
      k_prime * water[2];
  return M_A;
}

fossen::Matrix6 rigid_body() {
  const Vec3 hull = spheroid(ballast_density);
  return fossen::rigid_body_mass(hull[0], r_g, Vec3{hull[1], hull[2], hull[2]}.asDiagonal());
}

/// Linear damping by time constants and, where the weight makes a pendulum, by damping ratios.
fossen::Vector6 damping_of(const Remus100::Params& p, const fossen::Matrix6& M, double weight) {
  const double pendulum = weight * r_g.z();  // [N m/rad]
  fossen::Vector6 D;
  D << M(0, 0) / p.surge_time_constant_s, M(1, 1) / p.sway_time_constant_s, M(2, 2) / p.sway_time_constant_s,
      2.0 * p.roll_damping_ratio * std::sqrt(pendulum * M(3, 3)),
      2.0 * p.pitch_damping_ratio * std::sqrt(pendulum * M(4, 4)), M(5, 5) / p.yaw_time_constant_s;
  return D;
}

}  // namespace

Remus100::Remus100(const Params& p)
    : M_RB_{rigid_body()},
      M_A_{added_mass()},
      M_{M_RB_ + fossen::Matrix6{M_A_.asDiagonal()}},
      M_inverse_{M_.inverse()},
      weight_{M_RB_(0, 0) * gravity_at_trondheim},
      parasitic_drag_{checked_params(p).drag_ratio * pi * semi_axis_b * semi_axis_b / planform},
      rudder_lift_{0.5 * sea_density * fin_area * p.rudder_lift_ratio},
      stern_lift_{0.5 * sea_density * fin_area * p.stern_lift_ratio},
      cylinder_{hull_length / diameter},
      strips_{hull_length, diameter, ballast_density} {
  D_ = damping_of(p, M_, weight_);
  const Range fin{-largest_fin_angle, largest_fin_angle};
  actuators_ = {
      ActuatorInfo{"rudder_rad", "rudder angle, positive turns to starboard", fin, p.fin_time_constant_s},
      ActuatorInfo{"stern_rad", "stern plane angle, positive dives", fin, p.fin_time_constant_s},
      ActuatorInfo{"n_rpm",
                   "revolutions of the propeller per minute",
                   {0.0, max_propeller_rpm},
                   p.propeller_time_constant_s}};
  fin_drive_ = describe_drive();
}

FinDrive Remus100::describe_drive() const {
  // where thrust (1 - t) rho D^4 (K_0 n^2 - K_1 n u) is the drag d u^2 of the hull, without surge damping:
  // u = x n, with K_1 n u for the part that grows with the advance
  const double D = propeller_diameter;
  const double scale = (1.0 - thrust_deduction) * sea_density * D * D * D * D;
  const double K_1 = (K_T_bollard - K_T_design) / design_advance * (1.0 - wake_fraction) / D;  // [s/m]
  const double d = 0.5 * sea_density * planform * parasitic_drag_;
  const double x = (std::sqrt(scale * K_1 * scale * K_1 + 4.0 * d * scale * K_T_bollard) - scale * K_1) /
                   (2.0 * d);                      // [m]
  const double slope = 2.0 * d + scale * K_1 / x;  // of drag less thrust by u, over u

  return {.propeller = 2,
          .rudder = 0,
          .stern = 1,
          .speed_per_turn = x / 60.0,
          .surge_distance = M_(0, 0) / slope,
          .yaw_inertia = M_(5, 5),
          .yaw_damping = D_[5],
          .rudder_moment = -fin_x * rudder_lift_,
          .pitch_inertia = M_(4, 4),
          .pitch_damping = D_[4],
          .pitch_restoring = weight_ * r_g.z(),
          .stern_moment = fin_x * stern_lift_};
}

Remus100::Screw Remus100::propeller(double n_rps, double speed) noexcept {
  // K(J_a) n^2 along the line from the bollard to the design point, with J_a = V_a / (n D)
  const double n2 = n_rps * n_rps;
  const double advance = (1.0 - wake_fraction) * speed / propeller_diameter * n_rps / design_advance;
  const double D2 = propeller_diameter * propeller_diameter;
  return {
      sea_density * D2 * D2 * (K_T_bollard * n2 + (K_T_design - K_T_bollard) * advance),
      sea_density * D2 * D2 * propeller_diameter * (K_Q_bollard * n2 + (K_Q_design - K_Q_bollard) * advance)};
}

fossen::Vector6 Remus100::actuator_wrench(const ActuatorValues& u, const Vec3& v) const noexcept {
  const double rudder = u[0], stern = u[1];
  const Screw screw = propeller(u[2] / 60.0, v.norm());
  const double across_rudder = rudder_lift_ * (v.x() * v.x() + v.y() * v.y()) * rudder;
  const double across_stern = stern_lift_ * (v.x() * v.x() + v.z() * v.z()) * stern;

  fossen::Vector6 tau;
  tau << (1.0 - thrust_deduction) * screw.thrust_n - across_rudder * rudder - across_stern * stern,
      -across_rudder, -across_stern, roll_reaction * screw.torque_nm, fin_x * across_stern,
      -fin_x * across_rudder;
  return tau;
}

fossen::Vector6 Remus100::hull_wrench(const Vec3& v, const Vec3& omega) const noexcept {
  // lift and drag of the hull as a wing in the vertical plane, turned from flow to body axes
  const double lift_slope = pi * aspect_ratio / (1.0 + std::sqrt(1.0 + aspect_ratio * aspect_ratio / 4.0));
  const double alpha = math::atan2(v.z(), v.x());
  const double C_L = lift_slope * alpha;
  const double C_D = parasitic_drag_ + C_L * C_L / (pi * oswald_efficiency * aspect_ratio);
  const double pressure = 0.5 * sea_density * planform * v.squaredNorm();
  const double along = math::hypot(v.x(), v.z());
  const double cosine = along > 0.0 ? v.x() / along : 1.0, sine = along > 0.0 ? v.z() / along : 0.0;

  const double across = math::hypot(v.y(), v.z());
  const auto [drag, twist] = strips_.drag(v, omega, cylinder_.at(across * hull_length / viscosity));

  fossen::Vector6 wrench;
  wrench << drag + pressure * Vec3{sine * C_L - cosine * C_D, 0.0, -cosine * C_L - sine * C_D}, twist;
  return wrench;
}

fossen::Vector6 Remus100::coriolis(const Vec3& v, const Vec3& omega) const noexcept {
  fossen::Vector6 nu;
  nu << v, omega;
  fossen::Vector6 force = fossen::coriolis_force(M_RB_ * nu, v, omega);

  // C_A without the terms that pitch and yaw make with the velocity: those need the lift of a tail to be
  // stable. What is left of the moment v x a is its roll, which a body of revolution does not have.
  const Vec3 a = M_A_.head<3>().cwiseProduct(v), b = M_A_.tail<3>().cwiseProduct(omega);
  const Vec3 rolling{omega.x(), 0.0, 0.0};
  force.head<3>() += rolling.cross(a);
  force.tail<3>() += omega.cross(b);
  return force;
}

StateRate Remus100::derivative(const VehicleState& x, const ActuatorValues& u,
                               const Water& water) const noexcept {
  const Vec3& omega = x.omega_b;
  const fossen::Matrix3 R = fossen::rotation(x.q_nb);
  const Vec3 v_c = R.transpose() * water.current_n;
  const Vec3 v = x.v_b - v_c;

  // D(U) nu_r: in surge it vanishes as the vehicle gathers way
  fossen::Vector6 damping;
  damping << v, omega;
  damping.array() *= D_.array();
  damping[0] *= math::exp(-3.0 * std::sqrt(std::abs(v.x()) + v.y() * v.y()));

  const Vec3 down_b = R.row(2).transpose();
  const fossen::Vector6 force = actuator_wrench(u, v) + hull_wrench(v, omega) - coriolis(v, omega) - damping -
                                fossen::restoring(weight_, weight_, r_g, Vec3::Zero(), down_b);
  const fossen::Vector6 nu_dot = M_inverse_ * force;

  StateRate rate;
  rate.p_n.noalias() = R * x.v_b;
  rate.q_nb = fossen::quaternion_rate(x.q_nb, omega);
  rate.v_b = nu_dot.head<3>() - omega.cross(v_c) + R.transpose() * water.current_rate_n;
  rate.omega_b = nu_dot.tail<3>();
  return rate;
}

double Remus100::power(const ActuatorValues& u) const noexcept {
  const double n = u[2] / 60.0;
  return 2.0 * pi * n * sea_density * math::power(propeller_diameter, 5) * K_Q_design * n * n;
}

}  // namespace fairway
