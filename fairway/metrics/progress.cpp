// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/progress.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/prefetch.hpp"
#include "fairway/core/text.hpp"

namespace fairway {
namespace {

constexpr double usual_reach = 5.0;  // a third of what is cruised in 30 s at 0.5 m/s [m]

}  // namespace

const std::vector<QuantityInfo>& ProgressMetric::quantities() {
  static const std::vector<QuantityInfo> all{
      {"no_progress_time_s", true,
       "time under way in stretches, each longer than the exam's window, in which it came neither nearer to "
       "its goal nor to a new place, whether it waited, was deadlocked or trapped"},
      {"deadlock_time_s", true,
       "part of that in which whoever was near and could have cleared the way was at rest as well"},
  };
  return all;
}

ProgressMetric::ProgressMetric(double window, std::shared_ptr<const Surroundings> surroundings)
    : window_{window}, surroundings_{std::move(surroundings)}, neighbours_{usual_reach} {
  for (const double radius : surroundings_->radii) largest_radius_ = math::fmax(largest_radius_, radius);
}

Goal ProgressMetric::goal_of(const Frame& frame, std::size_t index) const {
  const VehicleFrame& vehicle = frame.vehicles[index];
  const bool known = index < surroundings_->limits.size();
  const double fastest = known ? surroundings_->limits[index]->max_speed : Limits::none;
  return {.position = vehicle.goal, .cruise_speed = math::fmin(vehicle.goal_speed, fastest), .velocity = {}};
}

double ProgressMetric::radius_of(std::size_t index) const {
  return index < surroundings_->radii.size() ? surroundings_->radii[index] : 0.0;
}

void ProgressMetric::see(const Frame& frame) {
  begin(frame, 1);
  for (std::size_t i = 0; i < own_.size(); ++i) see(frame, i, 0);
  finish(frame, neighbours_.of(frame));
}

void ProgressMetric::begin(const Frame& frame, std::size_t hands) {
  if (own_.empty()) {
    own_.reserve(frame.vehicles.size());
    for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
      const bool keeps_pace = i < surroundings_->keeps_pace.size() && surroundings_->keeps_pace[i];
      const std::size_t room = keeps_pace ? Trail::usual_places : Trail::most_places;
      own_.push_back({.watch = ProgressWatch{window_, Trail{room}}});
    }
    bystanders_.reserve(Neighbours::usual_room(frame.vehicles.size()) + surroundings_->obstacles.size());
  }
  while (late_.size() < hands) late_.emplace_back().reserve(frame.vehicles.size());
}

void ProgressMetric::see(const Frame& frame, std::size_t index, std::size_t hand) {
  const VehicleFrame& vehicle = frame.vehicles[index];
  Own& own = own_[index];

  // of a large fleet hardly any watch is in the cache
  constexpr std::size_t ahead = 4;
  if (index + ahead < own_.size()) {
    prefetch(&own_[index + ahead], sizeof(Own));
  }

  own.watch.see(frame.time, vehicle.state.p_n, goal_of(frame, index), is_avoiding(vehicle.phase));
  if (own.watch.is_late()) {
    late_[hand].push_back(static_cast<std::uint32_t>(index));
  } else {
    own.report = own.watch.judge(vehicle.command.mode, {});
  }
}

void ProgressMetric::finish(const Frame& frame, const Neighbours& near) {
  for (std::vector<std::uint32_t>& late : late_) {
    for (const std::uint32_t index : late) {
      Own& own = own_[index];
      bystanders_.clear();
      find_bystanders(frame, index, near);
      own.report = own.watch.judge(frame.vehicles[index].command.mode, bystanders_);
      count(frame, index);
    }
    late.clear();
  }
}

void ProgressMetric::find_bystanders(const Frame& frame, std::size_t index, const Neighbours& near) {
  const Vec3& here = frame.vehicles[index].state.p_n;
  const double reach = own_[index].watch.reach();
  const auto see_one = [&](std::size_t id, double distance, double rests_since, bool may_clear_way) {
    const double gap = distance - radius_of(index);
    if (gap <= reach)
      bystanders_.push_back({TrackId{static_cast<std::uint32_t>(id)}, gap, rests_since, may_clear_way});
  };
  // of two that are equally near the one of the lesser index counts; a little more for rounding
  const double farthest = (1.0 + 1e-12) * (reach + radius_of(index) + largest_radius_);
  near.visit(index, farthest, [&](std::size_t j, double distance2) {
    see_one(j, std::sqrt(distance2) - radius_of(j), own_[j].watch.trail().since(),
            frame.vehicles[j].phase != Phase::arrived);
  });
  std::ranges::sort(bystanders_, {}, &Bystander::id);
  for (std::size_t k = 0; k < surroundings_->obstacles.size(); ++k) {
    if (surroundings_->obstacles[k].velocity.isZero(0.0)) continue;
    const Obstacle drifter = surroundings_->obstacles[k].at(frame.time);
    see_one(own_.size() + k, nearest_point(drifter, here).distance, frame.time, true);
  }
}

void ProgressMetric::count(const Frame& frame, std::size_t index) {
  Own& own = own_[index];
  const ProgressReport& report = own.report;

  // a stretch counts from its beginning, once it has proved to be one
  const bool begins = own.last_without.time != report.last_progress;
  own.no_progress_time += begins ? frame.time - report.last_progress + frame.period : frame.period;
  own.last_without = occasion(index);
  if (report.state != Headway::deadlocked) return;
  const double until = frame.time + frame.period;
  own.deadlock_time += until - math::fmax(report.since, own.counted_until);
  own.counted_until = until;
  own.last_deadlock = occasion(index);
  own.last_deadlock.time = report.since;
}

Occasion ProgressMetric::occasion(std::size_t index) const {
  const ProgressReport& report = own_[index].report;
  Occasion occasion{.vehicle = static_cast<int>(index), .time = report.last_progress};
  if (!report.with) return occasion;
  const std::size_t with = number(*report.with);
  if (with < own_.size()) {
    occasion.other = static_cast<int>(with);
  } else {
    occasion.obstacle = static_cast<int>(with - own_.size());
  }
  return occasion;
}

std::string text_of(const ProgressReport& report, std::string_view with) {
  if (note_of(report.state).empty()) return {};
  std::string text =
      "no progress since " + number_text(std::round(1e6 * report.last_progress) / 1e6) + " s: ";
  if (report.state == Headway::trapped) return text + "trapped, and nobody is near who could clear the way";
  if (with.empty()) return text + "its method holds on purpose, and nobody is near";
  text += report.state == Headway::waiting ? "waiting for " : "deadlocked with ";
  return text.append(with);
}

void ProgressMetric::report(std::vector<Measure>& measures) const {
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const Own& own = own_[i];
    const int vehicle = static_cast<int>(i);
    measures.push_back({"no_progress_time_s", vehicle, own.no_progress_time, own.last_without});
    measures.push_back({"deadlock_time_s", vehicle, own.deadlock_time, own.last_deadlock});
  }
}

}  // namespace fairway
