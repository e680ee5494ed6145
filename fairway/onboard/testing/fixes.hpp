// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/onboard/helm.hpp"

namespace fairway::fixes {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double h = 0.1;  ///< between fixes [s]

/// Level, heading north, going so fast along its heading.
inline Fix north(double time, const Vec3& position, double speed = 0.5) {
  return {.time = time, .state = {.p_n = position, .v_b = {speed, 0, 0}}};
}

/// At `time` on its way north from `from` since time 0.
inline Fix on_course(double time, const Vec3& from = {0, 0, 10}, double speed = 0.5) {
  return north(time, from + Vec3{speed * time, 0, 0}, speed);
}

/// What a helm is made of, but for its method.
struct Parts : HelmSetup {
  Particulars ship;
  double period{};  ///< [s]
};

/// Vehicle 0 of two, decides ten times a second, 0.5 m/s, turns on the spot.
inline Parts setup() {
  Parts setup{{}, {.id = VehicleId{0}, .name = "zero", .radius = 1.5}, 0.1};
  setup.ship.limits.edit().max_speed = 0.5;
  setup.team = {{.id = VehicleId{1}, .name = "one", .radius = 1.5, .priority = 1}};
  return setup;
}

inline Helm helm_of(const Parts& setup, const char* algorithm = "orca3d", const ParamValues& params = {}) {
  return Helm{{setup.ship, setup.period}, setup, builtin_avoiders().make(algorithm, params)};
}

/// A helm that goes north, with good fixes of its own ten times a second until `until` [s].
inline Helm under_way(double until, const Parts& with = setup()) {
  Helm helm = helm_of(with);
  helm.go_to({500, 0, 10}, 0.5);
  for (int i = 0; 0.1 * i <= until + 1e-9; ++i) {
    helm.own_fix(on_course(0.1 * i), 0.1 * i);
    helm.update(0.1 * i);
  }
  return helm;
}

}  // namespace fairway::fixes
