// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/scene_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/dynamics/minerva_transport/minerva_transport.hpp"
#include "fairway/dynamics/zarco/zarco.hpp"

namespace fairway {
namespace {

struct KnownHull {
  std::string_view model;
  std::string_view shape;
  double length;
  double beam;
};

// of those that come in one size
constexpr std::array known_hulls{
    KnownHull{"sparus2", "auv", 1.6, 0.23},
    KnownHull{"remus100", "torpedo", 1.6, 0.19},
    KnownHull{"minerva", "rov", 1.44, 0.82},
    KnownHull{"otter", "catamaran", 2.0, 1.08},
    KnownHull{"otter_by_thrust", "catamaran", 2.0, 1.08},
};

const KnownHull& known_hull(std::string_view model) {
  return *std::ranges::find(known_hulls, model, &KnownHull::model);
}

Hull hull_of_zarco(const ParamValues& params) {
  const auto p = params_of<Zarco::Params>(params);
  return {.shape = "catamaran", .length = p.length_m, .beam = 2.0 * p.hull_y_m + p.hull_beam_m, .parts = {}};
}

/// As long and wide as the box round all the Minervas, each in its place.
Hull hull_of_transport(const ParamValues& params) {
  const KnownHull& minerva = known_hull("minerva");
  const auto p = params_of<MinervaTransport::Params>(params);
  Hull hull{.shape = "transport", .length = p.payload_edge_m, .beam = p.payload_edge_m, .parts = {}};
  for (const MinervaTransport::Station& station : p.layout) {
    const double yaw = radians(station.yaw_deg);
    const double c = std::fabs(math::cos(yaw)), s = std::fabs(math::sin(yaw));
    hull.length =
        math::fmax(hull.length, 2.0 * std::fabs(station.x_m) + c * minerva.length + s * minerva.beam);
    hull.beam = math::fmax(hull.beam, 2.0 * std::fabs(station.y_m) + s * minerva.length + c * minerva.beam);
    hull.parts.push_back({station.x_m, station.y_m, station.z_m, yaw});
  }
  return hull;
}

}  // namespace

Hull hull_of(const VehicleSpec& spec) {
  const std::string& model = spec.model->name;
  if (model == Zarco::info.name) return hull_of_zarco(spec.model->params);
  if (model == MinervaTransport::info.name) return hull_of_transport(spec.model->params);
  const auto known = std::ranges::find(known_hulls, model, &KnownHull::model);
  if (known == known_hulls.end())
    return {.shape = "point", .length = 2.0 * spec.radius_m, .beam = 2.0 * spec.radius_m, .parts = {}};
  return {.shape = known->shape, .length = known->length, .beam = known->beam, .parts = {}};
}

}  // namespace fairway
