// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/fleet.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fairway/avoidance/ability.hpp"
#include "fairway/core/math.hpp"

namespace fairway {

const std::vector<QuantityInfo>& FleetMetric::quantities() {
  static const std::vector<QuantityInfo> all{
      {"pair_collision_count", false,
       "times that the centres of two vehicles, one of which at least has set out, came within the safety "
       "distance"},
      {"min_separation_m", false,
       "least distance between the centres of any two vehicles, one of which at least has set out"},
      {"makespan_s", false,
       "from the first tick under way to the last arrival; the end of the run if not all arrive",
       "arrived_ratio"},
      {"arrived_ratio", false, "share of the vehicles that arrived"},
      {"nearest_m", true, "least distance to any other vehicle, from when it sets out"},
      {"obstacle_clearance_m", true,
       "least distance from the centre to the surface of an obstacle; negative inside one"},
      {"footprint_clearance_m", true,
       "least distance from the vehicle's sphere to the surface of an obstacle; negative once they touch"},
      {"energy_j", true, "drawn by the actuators while under way"},
      {"hold_time_s", true, "time waiting on purpose while under way"},
      {"infeasible_count", true, "ticks under way whose decision in force had found no safe choice"},
      {"unattainable_time_s", true,
       "time under way in which the command was beyond the vehicle: slower than it can go, or astern or "
       "sideways where it cannot"},
  };
  return all;
}

void FleetMetric::see(const Frame& frame) {
  begin(frame, 1);
  const Neighbours& all = neighbours_.of(frame);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    all.find(i, reach(all, i), near_);
    see(frame, near_, i, 0);
  }
  finish(frame);
}

void FleetMetric::begin(const Frame& frame, std::size_t hands) {
  const std::size_t n = frame.vehicles.size();
  const std::size_t usual_pairs = std::min(n * n / 2, n + 64);  // more take memory, once
  if (own_.empty()) {
    own_.resize(n);
    touching_.reserve(usual_pairs);
  }
  while (hands_.size() < hands) hands_.emplace_back().touch.reserve(usual_pairs);
  for (std::size_t i = 0; taking_part_ < n && i < n; ++i) {
    if (own_[i].takes_part || !has_set_out(frame.vehicles[i].phase)) continue;
    own_[i].takes_part = true;
    ++taking_part_;
  }
  last_time_ = frame.time;
  if (somebody_went_) return;
  somebody_went_ =
      std::ranges::any_of(frame.vehicles, [](const VehicleFrame& v) { return is_avoiding(v.phase); });
  start_time_ = frame.time;
}

/// Whoever comes nearer than anyone before is within the least distance so far, a little more for rounding.
double FleetMetric::reach(const Neighbours& near, std::size_t index) const {
  if (!own_[index].takes_part) return -1.0;
  constexpr double little = 1.0 + 1e-12;
  const double nearest2 = own_[index].nearest2;
  const double nearest = std::isinf(nearest2) ? near.reach_of_one(index) : little * std::sqrt(nearest2);
  return math::fmax(nearest, safety_distance_);
}

void FleetMetric::see(const Frame& frame, std::span<const Neighbour> near, std::size_t index,
                      std::size_t hand) {
  if (taking_part_ == 0) return;
  Hand& found = hands_[hand];
  found.somebody_goes |= see_vehicle(frame, index);
  if (own_[index].takes_part) see_others(frame, near, index, found.touch);
}

void FleetMetric::finish(const Frame& frame) {
  if (taking_part_ == 0) return;
  if (std::ranges::any_of(hands_, &Hand::somebody_goes)) last_arrival_ = frame.time;
  see_pairs(frame);
  for (Hand& hand : hands_) {
    hand.touch.clear();
    hand.somebody_goes = false;
  }
}

bool FleetMetric::is_beyond(const VehicleFrame& vehicle, std::size_t index) const {
  if (index >= surroundings_->limits.size()) return false;
  const Limits& limits = surroundings_->limits[index];
  if (const auto on_any = shortfall_on_any_heading(limits, vehicle.command))
    return *on_any != Shortfall::none;
  return shortfall(limits, vehicle.command, yaw_of(vehicle.state.q_nb)) != Shortfall::none;
}

/// Whether it is on its way, or has just arrived.
bool FleetMetric::see_vehicle(const Frame& frame, std::size_t index) {
  const VehicleFrame& vehicle = frame.vehicles[index];
  Own& own = own_[index];
  if (is_avoiding(vehicle.phase)) {
    own.energy += vehicle.power * frame.period;
    if (vehicle.command.mode == Mode::hold) own.hold_time += frame.period;
    if (vehicle.command.mode == Mode::infeasible && ++own.infeasible == 1)
      own.first_infeasible_time = frame.time;
    if (is_beyond(vehicle, index)) {
      if (own.unattainable_time == 0.0) own.first_unattainable_time = frame.time;
      own.unattainable_time += frame.period;
    }
  }
  if (own.takes_part) see_obstacles(frame, index);
  const bool rests = vehicle.phase == Phase::arrived && own.arrived;
  own.arrived = vehicle.phase == Phase::arrived;
  return !rests;
}

void FleetMetric::sort_obstacles() {
  const std::vector<DriftingObstacle>& all = surroundings_->obstacles;
  const auto drifts = [&](std::size_t k) { return !all[k].velocity.isZero(0.0); };
  if (all.size() > ObstacleIndex::handful)
    standing_ = {all.size(), [&](std::size_t k) { return drifts(k) ? nullptr : &all[k].start; }};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (standing_.size() == 0 || drifts(k)) one_by_one_.push_back(static_cast<std::uint32_t>(k));
  }
}

/// Only what is nearer than anything before can change the least clearance, so no others are looked for; of
/// those that are equally near the first counts.
void FleetMetric::see_obstacles(const Frame& frame, std::size_t index) {
  Own& own = own_[index];
  const Vec3& here = frame.vehicles[index].state.p_n;
  double least = own.clearance;
  std::size_t which = surroundings_->obstacles.size();
  const auto compare = [&](std::size_t k, const Obstacle& obstacle) {
    const double clearance = nearest_point(obstacle, here).distance;
    if (clearance < least || (clearance == least && k < which && least < own.clearance)) {
      least = clearance;
      which = k;
    }
    return least;
  };
  for (const std::uint32_t k : one_by_one_) compare(k, surroundings_->obstacles[k].at(frame.time));
  standing_.visit(here, least, [&](std::size_t k) { return compare(k, surroundings_->obstacles[k].start); });
  if (!(least < own.clearance)) return;
  own.clearance = least;
  own.nearest_obstacle = static_cast<int>(which);
  own.clearance_time = frame.time;
}

void FleetMetric::see_others(const Frame& frame, std::span<const Neighbour> near, std::size_t index,
                             std::vector<Pair>& touch) {
  Own& own = own_[index];
  double nearest2 = own.nearest2;
  std::size_t who = frame.vehicles.size();
  for (const auto& [j, distance2] : near) {
    const bool nearer = distance2 < nearest2 || (distance2 == nearest2 && j < who && nearest2 < own.nearest2);
    if (nearer) {
      nearest2 = distance2;
      who = j;
    }
    if (!(distance2 <= safety_distance_ * safety_distance_)) continue;
    const auto self = static_cast<std::uint32_t>(index);
    const bool is_told_by_the_other = j < index && own_[j].takes_part;
    if (!is_told_by_the_other) touch.push_back({std::min(self, j), std::max(self, j)});
  }
  if (!(nearest2 < own.nearest2)) return;
  own.nearest2 = nearest2;
  own.nearest_other = static_cast<int>(who);
  own.nearest_time = frame.time;
}

void FleetMetric::see_pairs(const Frame& frame) {
  std::vector<Pair>& touch = hands_[0].touch;
  for (const Hand& hand : std::span{hands_}.subspan(1))
    touch.insert(touch.end(), hand.touch.begin(), hand.touch.end());
  std::ranges::sort(touch);
  for (const Pair& pair : touch) {
    if (std::ranges::binary_search(touching_, pair) || ++pair_events_ > 1) continue;
    first_pair_event_ = {static_cast<int>(pair.one), static_cast<int>(pair.other), Occasion::none,
                         frame.time};
  }

  touching_.assign(touch.begin(), touch.end());
}

Occasion FleetMetric::not_arrived() const {
  const auto first = std::ranges::find(own_, false, &Own::arrived);
  if (first == own_.end()) return {};
  return {.vehicle = static_cast<int>(first - own_.begin())};
}

double FleetMetric::makespan() const {
  if (somebody_went_) return last_arrival_ - start_time_;
  return std::ranges::all_of(own_, &Own::arrived) ? 0.0 : last_time_;
}

void FleetMetric::report(std::vector<Measure>& measures) const {
  double nearest2 = std::numeric_limits<double>::infinity();
  Occasion nearest_at;
  int arrived = 0;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    arrived += own_[i].arrived ? 1 : 0;
    if (!(own_[i].nearest2 < nearest2)) continue;
    nearest2 = own_[i].nearest2;
    nearest_at = own_[i].nearest_at();
    nearest_at.vehicle = static_cast<int>(i);
  }
  measures.push_back(
      {"pair_collision_count", Measure::fleet, static_cast<double>(pair_events_), first_pair_event_});
  measures.push_back({"min_separation_m", Measure::fleet, std::sqrt(nearest2), nearest_at});
  measures.push_back({"makespan_s", Measure::fleet, makespan(), not_arrived()});
  measures.push_back({"arrived_ratio", Measure::fleet,
                      own_.empty() ? 0.0 : arrived / static_cast<double>(own_.size()), not_arrived()});
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const Own& own = own_[i];
    const int vehicle = static_cast<int>(i);
    measures.push_back({"nearest_m", vehicle, std::sqrt(own.nearest2), own.nearest_at()});
    measures.push_back({"obstacle_clearance_m", vehicle, own.clearance, own.clearance_at()});
    const double radius = i < surroundings_->radii.size() ? surroundings_->radii[i] : 0.0;
    measures.push_back({"footprint_clearance_m", vehicle, own.clearance - radius, own.clearance_at()});
    measures.push_back({"energy_j", vehicle, own.energy});
    measures.push_back({"hold_time_s", vehicle, own.hold_time});
    measures.push_back({"infeasible_count", vehicle, static_cast<double>(own.infeasible),
                        Occasion{.time = own.first_infeasible_time}});
    measures.push_back({"unattainable_time_s", vehicle, own.unattainable_time,
                        Occasion{.time = own.first_unattainable_time}});
  }
}

}  // namespace fairway
