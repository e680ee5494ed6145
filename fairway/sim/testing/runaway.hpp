// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/dynamics/fossen.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// A vehicle that breaks: it goes ever faster ahead, u' = growth u.
class Runaway {
 public:
  static constexpr VehicleInfo info{.name = "runaway", .title = "It breaks", .source = "none"};

  struct Params {
    double growth_hz{1.0};
    static consteval auto fields() {
      return std::tuple{field<&Params::growth_hz>({-1e4, 1e4}, "of its speed")};
    }
  };

  explicit Runaway(const Params& p) : growth_{p.growth_hz} {}
  std::span<const ActuatorInfo> actuators() const { return actuators_; }
  StateRate derivative(const VehicleState& x, const ActuatorValues&, const Water&) const noexcept {
    StateRate rate;
    rate.p_n = x.v_n();
    rate.q_nb = fossen::quaternion_rate(x.q_nb, x.omega_b);
    rate.v_b.x() = growth_ * x.v_b.x();
    return rate;
  }
  double power(const ActuatorValues&) const noexcept { return 0.0; }

 private:
  double growth_;
  std::array<ActuatorInfo, 1> actuators_{ActuatorInfo{"surge_mps", "not listened to", {-1, 1}, 0.0}};
};

/// All that comes with fairway, and it.
inline Catalogs catalogs_with_runaway() {
  Catalogs catalogs = builtin_catalogs();
  catalogs.vehicles.add<Runaway>();
  return catalogs;
}

/// A whole vehicle and, as the second, one that breaks.
inline Scenario breaking_scenario(double growth_hz = 1.0) {
  Scenario scenario{.name = "breaking", .duration_s = 60};
  for (std::uint32_t i = 0; i < 2; ++i) {
    VehicleSpec spec{.id = i,
                     .name = i == 0 ? "whole" : "broken",
                     .model = Choice{.name = i == 0 ? "kinematic" : "runaway"},
                     .avoider = Choice{.name = "direct"},
                     .position = {0, 20.0 * i, 5},
                     .speed = i == 0 ? 0.0 : 1.0};
    if (i == 1) spec.model.edit().params = {{"growth_hz", growth_hz}};
    spec.mission = {{.kind = LegKind::transit, .position = {1000, 20.0 * i, 5}, .speed_mps = 0.5}};
    scenario.vehicles.push_back(spec);
  }
  return scenario;
}

}  // namespace fairway
