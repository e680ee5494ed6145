// SPDX-License-Identifier: Apache-2.0
#include "fairway/control/vehicle_limits.hpp"

#include <algorithm>
#include <optional>

#include "fairway/control/fin_autopilot.hpp"

namespace fairway {
namespace {

/// A smaller share of all effectiveness is rounding.
constexpr double least_share = 1e-6;

/// Rows of an effectiveness.
constexpr Eigen::Index surge_row = 0, sway_row = 1;

bool can_back(const Propulsion& propulsion, std::span<const ActuatorInfo> actuators) {
  const double least = least_share * propulsion.effectiveness.norm();
  for (Eigen::Index i = 0; i < propulsion.effectiveness.cols(); ++i) {
    const double ahead = propulsion.effectiveness(surge_row, i);
    const Range& range = actuators[static_cast<std::size_t>(i)].range;
    if (std::min(ahead * range.lo, ahead * range.hi) < -least) return true;
  }
  return false;
}

/// What a setpoint may be; nothing where the vehicle takes none of that name.
std::optional<Range> setpoints(std::span<const ActuatorInfo> actuators, std::string_view name) {
  const auto found = std::ranges::find(actuators, name, &ActuatorInfo::name);
  return found == actuators.end() ? std::nullopt : std::optional{found->range};
}

}  // namespace

bool can_sway(const Propulsion& propulsion) {
  return propulsion.effectiveness.row(sway_row).norm() > least_share * propulsion.effectiveness.norm();
}

Limits narrowed(const Limits& mission, const Vehicle& vehicle) {
  Limits limits = mission;
  const std::span<const ActuatorInfo> actuators = vehicle.actuators();
  if (const FinDrive* drive = vehicle.fin_drive()) {
    limits.min_speed = std::max(mission.min_speed, FinAutopilot{*drive, actuators}.steerage_way());
    limits.sternway = limits.sway = false;
  } else if (const Propulsion* propulsion = vehicle.propulsion()) {
    limits.sternway = mission.sternway && can_back(*propulsion, actuators);
    limits.sway = mission.sway && can_sway(*propulsion);
  } else if (const std::optional<Range> ahead = setpoints(actuators, "surge_mps")) {
    const Range sideways = setpoints(actuators, "sway_mps").value_or(Range{0.0, 0.0});
    limits.sternway = mission.sternway && ahead->lo < 0.0;
    limits.sway = mission.sway && sideways.lo < sideways.hi;
  }
  return limits;
}

}  // namespace fairway
