// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/transport/voyage_log.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "fairway/core/math.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/planning/rrt_star/rrt_star.hpp"
#include "fairway/studies/transport/field.hpp"

namespace fairway::transport {
namespace {

constexpr double arrived_within = 1.0;  // [m]

/// The sensors of the publication: at the tips of the four vehicles.
std::array<Vec3, 4> tips_of(const VehicleState& state) {
  std::array<Vec3, 4> tips;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const double angle = yaw_of(state.q_nb) + 0.5 * pi * static_cast<double>(i);
    tips[i] = state.p_n + footprint_radius * Vec3{math::cos(angle), math::sin(angle), 0.0};
  }
  return tips;
}

}  // namespace

VoyageLog::VoyageLog(const Scenario& scenario, const Trajectory* reference)
    : specs_{scenario.obstacles},
      sight_{scenario.perception.obstacle_range_m},
      in_sight_(scenario.obstacles.size()),
      goal_{scenario.vehicles.front().mission.front().position},
      reference_{reference},
      detections_(scenario.obstacles.size()) {
  for (const ObstacleSpec& spec : scenario.obstacles) obstacles_.push_back(spec.view());
}

void VoyageLog::write(const Frame& frame) {
  see_forces(frame);
  see_detection(frame.vehicles.front());
  see_progress(frame);
  see_danger(frame);
}

void VoyageLog::see_forces(const Frame& frame) {
  const std::optional<Wrench>& commanded = frame.vehicles.front().command.wrench;
  if (!commanded) return;
  if (!first_) first_ = commanded;
  greatest_ = greatest_.cwiseMax(*commanded);
  greatest_[5] = math::fmax(greatest_[5], -(*commanded)[5]);
}

void VoyageLog::see_detection(const VehicleFrame& vehicle) {
  const bool avoids = vehicle.command.mode == Mode::avoid;
  const bool begins = avoids && !avoiding_;
  avoiding_ = avoids;
  if (!avoids || !vehicle.command.wrench) return;

  // the obstacle that is nearest to any tip
  std::size_t nearest = 0;
  double surface = std::numeric_limits<double>::infinity();
  double centre = surface;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    for (const Vec3& tip : tips_of(vehicle.state)) {
      const double distance = nearest_point(obstacles_[i], tip).distance;
      if (distance >= surface) continue;
      surface = distance;
      centre = (tip - centre_of(obstacles_[i])).norm();
      nearest = i;
    }
  }
  if (obstacles_.empty()) return;
  if (begins && !switch_distance_) switch_distance_ = centre;
  if (!detections_[nearest])
    detections_[nearest] = {(*vehicle.command.wrench)[0], (*vehicle.command.wrench)[1]};
}

void VoyageLog::see_progress(const Frame& frame) {
  const Vec3& p = frame.vehicles.front().state.p_n;
  if (!goal_time_ && (p - goal_).norm() <= arrived_within) goal_time_ = frame.time;
  if (reference_ == nullptr || frame.time > reference_->duration()) return;
  const Vec2 error = p.head<2>() - reference_->sample(frame.time).position;
  square_error_.head<2>() += frame.period * error.cwiseAbs2();
  followed_time_ += frame.period;
}

void VoyageLog::see_danger(const Frame& frame) {
  const Vec3& p = frame.vehicles.front().state.p_n;
  double clearance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    const DriftingObstacle obstacle{obstacles_[i], specs_[i].velocity};
    const double gap = nearest_point(obstacle.at(frame.time), p).distance - footprint_radius;
    clearance = math::fmin(clearance, gap);
    const bool seen = gap <= sight_;
    if (seen && !in_sight_[i]) {
      surprised_at_ = p;
      surprise_time_ = frame.time;
    }
    in_sight_[i] = seen;
  }
  if (clearance < 0.0 && !touched_with_a_way_out_)
    touched_with_a_way_out_ = can_stay_clear(specs_, surprised_at_, surprise_time_);
}

void VoyageLog::report(std::vector<Measure>& measures) const {
  const auto add = [&](std::string quantity, double value) {
    measures.push_back({std::move(quantity), 0, value});
  };
  if (first_) {
    add("initial_surge_force_n", (*first_)[0]);
    add("initial_sway_force_n", (*first_)[1]);
    add("peak_surge_force_n", greatest_[0]);
    add("peak_sway_force_n", greatest_[1]);
    add("peak_yaw_moment_nm", greatest_[5]);
  }
  for (std::size_t i = 0; i < detections_.size(); ++i) {
    if (!detections_[i]) continue;
    add(fmt::format("detection_{}_surge_force_n", i + 1), detections_[i]->surge_force);
    add(fmt::format("detection_{}_sway_force_n", i + 1), detections_[i]->sway_force);
  }
  add("avoidable_touch_count", touched_with_a_way_out_.value_or(false) ? 1.0 : 0.0);
  if (switch_distance_) add("switch_distance_m", *switch_distance_);
  if (goal_time_) add("goal_time_s", *goal_time_);
  if (reference_ != nullptr) {
    std::vector<Vec2> waypoints{reference_->sample(0.0).position};
    for (std::size_t i = 0; i < reference_->segments().size(); ++i)
      waypoints.push_back(reference_->derivative(i, 0, 1.0));
    add("planned_length_m", length_of(waypoints));
  }
  if (followed_time_ > 0.0) {
    add("rmse_north_m", std::sqrt(square_error_.x() / followed_time_));
    add("rmse_east_m", std::sqrt(square_error_.y() / followed_time_));
  }
}

std::optional<Trajectory> printed_reference(const VehicleSpec& vehicle) {
  if (vehicle.avoider->name != RrtStar::info.name) return {};
  const auto params = params_of<RrtStar::Params>(vehicle.avoider->params);
  if (params.segment_time_s <= 0.0 || params.waypoints.size() < 2) return {};

  std::vector<Vec2> waypoints;
  for (const Waypoint& waypoint : params.waypoints) waypoints.emplace_back(waypoint.n_m, waypoint.e_m);
  return minimum_snap(waypoints, std::vector<double>(waypoints.size() - 1, params.segment_time_s));
}

std::vector<Measure> measure_voyage(const Scenario& scenario, const Catalogs& catalogs,
                                    const std::atomic<bool>* stop, std::span<FrameSink* const> more) {
  const std::optional<Trajectory> reference = printed_reference(scenario.vehicles.front());
  RunMetrics metrics = metrics_for(scenario);
  VoyageLog log{scenario, reference ? &*reference : nullptr};
  run_into(scenario, catalogs, sinks_of({&metrics, &log}, more), stop);

  std::vector<Measure> measures = metrics.measures();
  double net = 0.0;
  for (const Measure& m : measures) {
    if (m.quantity == "rms_surge_power_w" || m.quantity == "rms_sway_power_w" ||
        m.quantity == "rms_yaw_power_w")
      net += m.value;
  }
  measures.push_back({"net_power_w", 0, net});
  log.report(measures);
  return measures;
}

}  // namespace fairway::transport
