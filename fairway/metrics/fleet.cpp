// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/fleet.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {
namespace {

bool takes_part(const VehicleFrame& vehicle) {
  return is_avoiding(vehicle.phase) || vehicle.phase == Phase::arrived;
}

}  // namespace

const std::vector<QuantityInfo>& FleetMetric::quantities() {
  static const std::vector<QuantityInfo> all{
      {"pair_collision_count", false,
       "times that the centres of two vehicles came within the safety distance"},
      {"min_separation_m", false, "least distance between the centres of any two vehicles"},
      {"makespan_s", false,
       "from the first tick under way to the last arrival; the end of the run if not all arrive",
       "arrived_ratio"},
      {"arrived_ratio", false, "share of the vehicles that arrived"},
      {"nearest_m", true, "least distance to any other vehicle"},
      {"obstacle_clearance_m", true,
       "least distance from the centre to the surface of an obstacle; negative inside one"},
      {"footprint_clearance_m", true,
       "least distance from the vehicle's sphere to the surface of an obstacle; negative once they touch"},
      {"energy_j", true, "drawn by the actuators while under way"},
      {"hold_time_s", true, "time waiting on purpose while under way"},
      {"infeasible_count", true, "decisions that found no safe choice"},
  };
  return all;
}

void FleetMetric::see(const Frame& frame) {
  if (own_.empty()) {
    own_.resize(frame.vehicles.size());
    touching_.resize(frame.vehicles.size() * frame.vehicles.size());
  }
  if (!started_) {
    started_ =
        std::ranges::any_of(frame.vehicles, [](const VehicleFrame& v) { return is_avoiding(v.phase); });
    if (!started_) return;
    start_time_ = frame.time;
  }
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) see_vehicle(frame, i);
  see_pairs(frame);
}

void FleetMetric::see_vehicle(const Frame& frame, std::size_t index) {
  const VehicleFrame& vehicle = frame.vehicles[index];
  Own& own = own_[index];
  if (is_avoiding(vehicle.phase)) {
    own.energy += vehicle.power * frame.period;
    if (vehicle.command.mode == Mode::hold) own.hold_time += frame.period;
    if (vehicle.command.mode == Mode::infeasible) ++own.infeasible;
  }
  for (const DriftingObstacle& obstacle : surroundings_.obstacles) {
    own.clearance =
        std::fmin(own.clearance, nearest_point(obstacle.at(frame.time), vehicle.state.p_n).distance);
  }
  if (vehicle.phase != Phase::arrived || !own.arrived) last_arrival_ = frame.time;
  own.arrived = vehicle.phase == Phase::arrived;
}

void FleetMetric::see_pairs(const Frame& frame) {
  const std::size_t n = frame.vehicles.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!takes_part(frame.vehicles[i])) continue;
    for (std::size_t j = i + 1; j < n; ++j) {
      if (!takes_part(frame.vehicles[j])) continue;
      const double distance2 = (frame.vehicles[i].state.p_n - frame.vehicles[j].state.p_n).squaredNorm();
      own_[i].nearest2 = std::fmin(own_[i].nearest2, distance2);
      own_[j].nearest2 = std::fmin(own_[j].nearest2, distance2);

      const bool touching = distance2 <= safety_distance_ * safety_distance_;
      if (touching && !touching_[i * n + j]) ++pair_events_;
      touching_[i * n + j] = touching;
    }
  }
}

void FleetMetric::report(std::vector<Measure>& measures) const {
  double nearest2 = std::numeric_limits<double>::infinity();
  int arrived = 0;
  for (const Own& own : own_) {
    nearest2 = std::fmin(nearest2, own.nearest2);
    arrived += own.arrived ? 1 : 0;
  }
  measures.push_back({"pair_collision_count", Measure::fleet, static_cast<double>(pair_events_)});
  measures.push_back({"min_separation_m", Measure::fleet, std::sqrt(nearest2)});
  measures.push_back({"makespan_s", Measure::fleet, started_ ? last_arrival_ - start_time_ : 0.0});
  measures.push_back(
      {"arrived_ratio", Measure::fleet, own_.empty() ? 0.0 : arrived / static_cast<double>(own_.size())});
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const int vehicle = static_cast<int>(i);
    measures.push_back({"nearest_m", vehicle, std::sqrt(own_[i].nearest2)});
    measures.push_back({"obstacle_clearance_m", vehicle, own_[i].clearance});
    const double radius = i < surroundings_.radii.size() ? surroundings_.radii[i] : 0.0;
    measures.push_back({"footprint_clearance_m", vehicle, own_[i].clearance - radius});
    measures.push_back({"energy_j", vehicle, own_[i].energy});
    measures.push_back({"hold_time_s", vehicle, own_[i].hold_time});
    measures.push_back({"infeasible_count", vehicle, static_cast<double>(own_[i].infeasible)});
  }
}

}  // namespace fairway
