// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/minerva_transport/minerva_transport.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "fairway/core/params.hpp"

namespace fairway {
namespace {

using Params = MinervaTransport::Params;
using Station = MinervaTransport::Station;

Vec3 position_of(const Station& station) { return {station.x_m, station.y_m, station.z_m}; }

std::string item(std::size_t index) { return "layout[" + std::to_string(index) + "]"; }

/// Refuses vehicles that certainly overlap: those whose origins are nearer than a Minerva is broad.
void check_places(const Params& p) {
  for (std::size_t i = 0; i < p.layout.size(); ++i) {
    const Vec3 place = position_of(p.layout[i]);
    if (p.payload_edge_m > 0.0 && place.norm() < 0.5 * (Minerva::breadth_m + p.payload_edge_m)) {
      throw InputError(item(i) + " puts a vehicle into the payload");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if ((place - position_of(p.layout[k])).norm() < Minerva::breadth_m) {
        throw InputError(item(i) + " puts a vehicle into that of " + item(k));
      }
    }
  }
}

/// Refuses thrusters that cannot push along each axis with the others at zero. A thruster pushes both ways,
/// so an axis can be pushed where it lies in the span of the columns.
void check_thrust(const CompositeVehicle& vehicle) {
  const Eigen::MatrixXd B = vehicle.propulsion().effectiveness;
  const auto solver = B.completeOrthogonalDecomposition();
  const bool planar = vehicle.body().degrees_of_freedom() == DegreesOfFreedom::planar;
  for (const auto& [axis, name] : {std::pair{5, "yaw"}, {0, "surge"}, {1, "sway"}, {2, "heave"}}) {
    if (planar && axis == 2) continue;
    const fossen::Vector6 wanted = fossen::Vector6::Unit(axis);
    const Eigen::VectorXd u = solver.solve(wanted);
    if ((B * u - wanted).norm() > 1e-6) {
      throw InputError("layout: its thrusters cannot push along " + std::string(name) + " alone");
    }
  }
}

Minerva::Params minerva_params(const Params& p) {
  return {.plant = p.plant,
          .degrees_of_freedom = p.degrees_of_freedom,
          .density_kgpm3 = p.density_kgpm3,
          .max_propeller_speed_hz = p.max_propeller_speed_hz,
          .thruster_time_constant_s = p.thruster_time_constant_s};
}

Part vehicle_part(const Params& p, std::size_t index) {
  const Station& station = p.layout[index];
  Part part = minerva_part(minerva_params(p), station.thrust_ratio);
  part.position = position_of(station);
  part.orientation = quaternion_of({.roll = 0.0, .pitch = 0.0, .yaw = radians(station.yaw_deg)});
  const std::string owner = "vehicle" + std::to_string(index);
  for (Thruster& thruster : part.thrusters) {
    thruster.name = owner + "_" + thruster.name;
    thruster.meaning = owner + ": " + thruster.meaning;
  }
  return part;
}

/// A neutrally buoyant cube. Added mass 0.68 rho a^3 and drag coefficient 1.05 of a cube; added inertia and
/// drag in turning by strips of a square section (0.234 pi rho (a/2)^4 per metre, two pairs of faces).
Part payload_part(const Params& p) {
  const double a = p.payload_edge_m, rho = p.density_kgpm3;
  const double face_drag = 0.5 * rho * 1.05 * a * a;
  SubmergedBodyNumbers n;
  n.mass = n.displaced_mass = rho * a * a * a;
  n.density = rho;
  n.inertia.diagonal().setConstant(n.mass * a * a / 6.0);
  n.added_mass.diagonal().head<3>().setConstant(0.68 * n.mass);
  n.added_mass.diagonal().tail<3>().setConstant(0.234 * pi * n.mass * a * a / 16.0);
  n.quadratic_damping.head<3>().setConstant(face_drag);
  n.quadratic_damping.tail<3>().setConstant(2.0 * face_drag * a * a * a / 32.0);
  return {.numbers = n};
}

/// A neutrally buoyant round bar of `length` along its x axis: added mass of its displacement across, none
/// along; drag coefficient 1.1 across, also in turning (by strips), none along.
SubmergedBodyNumbers bar(double length, double diameter, double rho) {
  const double normal_drag = 0.5 * rho * 1.1 * diameter * length;
  const double slenderness = length * length / 12.0;
  SubmergedBodyNumbers n;
  n.mass = n.displaced_mass = rho * pi / 4.0 * diameter * diameter * length;
  n.density = rho;
  const double across = slenderness + diameter * diameter / 16.0;
  n.inertia.diagonal() << n.mass * diameter * diameter / 8.0, n.mass * across, n.mass * across;
  n.added_mass.diagonal() << 0.0, n.mass, n.mass, 0.0, n.mass * slenderness, n.mass * slenderness;
  n.quadratic_damping << 0.0, normal_drag, normal_drag, 0.0,
      Eigen::Vector2d::Constant(normal_drag * length * length * length / 32.0);
  return n;
}

/// The link to a vehicle: from half an edge off the payload's centre along the line to the vehicle's origin,
/// ending there at the latest. In two halves, since drag in turning grows with the cube of the arm.
void add_link(std::vector<Part>& parts, const Params& p, const Vec3& vehicle) {
  const double begin = 0.5 * p.payload_edge_m;
  const double length = std::min(p.link_length_m, vehicle.norm() - begin);
  if (length <= 0.0 || p.link_diameter_m <= 0.0) return;
  const SubmergedBodyNumbers half = bar(0.5 * length, p.link_diameter_m, p.density_kgpm3);
  const Vec3 outward = vehicle.normalized();
  for (const double centre : {0.25, 0.75}) {
    parts.push_back({.position = (begin + centre * length) * outward,
                     .orientation = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), outward),
                     .numbers = half});
  }
}

std::vector<Part> parts_of(const Params& p) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < p.layout.size(); ++i) parts.push_back(vehicle_part(p, i));
  if (p.payload_edge_m > 0.0) parts.push_back(payload_part(p));
  for (const Station& station : p.layout) add_link(parts, p, position_of(station));
  return parts;
}

CompositeVehicle assembled(const Params& p) {
  if (p.layout.empty()) throw InputError("layout: has no vehicle");
  check_places(p);
  CompositeVehicle vehicle{parts_of(p), equations_of(p.plant, p.degrees_of_freedom)};
  check_thrust(vehicle);
  return vehicle;
}

}  // namespace

MinervaTransport::MinervaTransport(const Params& params)
    : CompositeVehicle{assembled(checked_params(params))} {}

}  // namespace fairway
