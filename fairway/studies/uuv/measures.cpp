// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/measures.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/studies/uuv/timeline.hpp"

namespace fairway::uuv {
namespace {

/// One vehicle's quantities by name.
using Quantities = std::map<std::string_view, double>;

/// Adds up how much everyone's course changed while it was under way and made way.
class CourseLog final : public FrameSink {
 public:
  explicit CourseLog(std::size_t count) : courses_(count) {}

  void write(const Frame& frame) override {
    for (std::size_t i = 0; i < courses_.size(); ++i) {
      const VehicleFrame& vehicle = frame.vehicles[i];
      const Vec3 v = vehicle.state.v_n();
      if (!is_avoiding(vehicle.phase) || horizontal_norm(v) < slowest_way) continue;
      const double course = math::atan2(v.y(), v.x());
      if (courses_[i]) total_ += std::abs(wrap_angle(course - *courses_[i]));
      courses_[i] = course;
    }
  }

  double mean() const { return total_ / static_cast<double>(courses_.size()); }

 private:
  static constexpr double slowest_way = 0.1;  // below it a course means nothing [m/s]

  std::vector<std::optional<double>> courses_;
  double total_{};
};

std::vector<Quantities> by_vehicle(const std::vector<Measure>& measures, std::size_t count) {
  std::vector<Quantities> vehicles(count);
  for (const Measure& measure : measures) {
    if (measure.vehicle >= 0)
      vehicles[static_cast<std::size_t>(measure.vehicle)][measure.quantity] = measure.value;
  }
  return vehicles;
}

}  // namespace

std::vector<Measure> measure_encounter(const Scenario& scenario, const Catalogs& catalogs,
                                       const std::atomic<bool>* stop, std::span<FrameSink* const> more) {
  RunMetrics metrics = metrics_for(scenario);
  Timeline timeline{scenario};
  run_into(scenario, catalogs, sinks_of({&metrics, &timeline}, more), stop);
  std::vector<Measure> measures = metrics.measures();
  timeline.report(measures);
  return measures;
}

std::vector<Measure> measure_fleet(const Scenario& scenario, const Catalogs& catalogs,
                                   const std::atomic<bool>* stop, std::span<FrameSink* const> more) {
  RunMetrics metrics = metrics_for(scenario);
  CourseLog courses{scenario.vehicles.size()};
  run_into(scenario, catalogs, sinks_of({&metrics, &courses}, more), stop);

  const std::vector<Measure> all = metrics.measures();
  std::vector<Measure> kept;
  for (const Measure& measure : all) {
    if (measure.vehicle == Measure::fleet) kept.push_back(measure);
  }

  const std::size_t count = scenario.vehicles.size();
  const std::vector<Quantities> vehicles = by_vehicle(all, count);
  double time = 0.0, ratio = 0.0, infeasible = 0.0, arrived = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Quantities& own = vehicles[i];
    infeasible += own.at("infeasible_count");
    if (own.at("stuck_count") > 0.0) continue;
    arrived += 1.0;
    time += own.at("navigation_time_s");
    const double straight = own.at("start_distance_m") / scenario.vehicles[i].mission.back().speed_mps;
    ratio += own.at("navigation_time_s") / straight;
  }
  const auto add = [&](const char* quantity, double value) {
    kept.push_back({quantity, Measure::fleet, value});
  };
  if (arrived > 0.0) {
    add("mean_time_s", time / arrived);
    add("time_ratio", ratio / arrived);
  }
  add("mean_course_change_rad", courses.mean());
  add("mean_infeasible_count", infeasible / static_cast<double>(count));
  return kept;
}

}  // namespace fairway::uuv
