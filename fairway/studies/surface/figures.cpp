// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/surface/figures.hpp"

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/studies/page_blocks.hpp"
#include "fairway/studies/study_runs.hpp"

namespace fairway::surface {
namespace {

using nlohmann::json;

constexpr double millimetres = 1000.0;

double rounded(double value) { return page::rounded(value, millimetres); }

/// Where the vessel is, how it moves and how it should, five times a second.
class Log final : public FrameSink {
 public:
  explicit Log(const SteeringParams& steering) : steering_{steering} {}

  void write(const Frame& frame) override {
    if (count(frame.tick) % 4 != 0) return;
    const VehicleFrame& vehicle = frame.vehicles.front();
    const BodyRequest wanted = steer(steering_, vehicle.command, yaw_of(vehicle.state.q_nb));
    way_.add(frame.time, {vehicle.state.p_n.x(), vehicle.state.p_n.y(), 0.0});
    speed_.push_back(rounded(vehicle.state.v_b.x()));
    turn_rate_.push_back(rounded(vehicle.state.omega_b.z()));
    wanted_speed_.push_back(rounded(wanted.surge_mps));
    wanted_turn_rate_.push_back(rounded(wanted.yaw_rate_radps));
  }

  json track(const std::string& label) const { return way_.track(label); }

  json speeds(const std::string& title) const {
    const std::vector<double>& t = way_.t();
    return page::lines(title, "time [s]", "speed [m/s], turn rate [rad/s]",
                       {page::series("speed", t, speed_), page::series("turn rate", t, turn_rate_),
                        page::series("speed wanted", t, wanted_speed_),
                        page::series("turn rate wanted", t, wanted_turn_rate_)});
  }

 private:
  SteeringParams steering_;
  page::Way way_{millimetres};
  std::vector<double> speed_, turn_rate_, wanted_speed_, wanted_turn_rate_;
};

json way_of_the_other(const Layout& layout, double duration) {
  const Vec2 end = *layout.vessel + duration * layout.vessel_velocity;
  const auto pair = [](double a, double b) { return std::array{rounded(a), rounded(b)}; };
  return {{"label", "other vessel"},
          {"n", pair(layout.vessel->x(), end.x())},
          {"e", pair(layout.vessel->y(), end.y())},
          {"d", pair(0.0, 0.0)},
          {"t", pair(0.0, duration)}};
}

}  // namespace

Passage passage_of(Course course, const Method& method, const Overrides& overrides, const RunIndex& runs) {
  const Scenario scenario = under(overrides, passage(course, layout_of(course), Vessel::zarco, method, 1));
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.time_decisions();
  Log log{simulation.agents().front().ship().steering};
  const std::array<FrameSink*, 1> sinks{&log};
  simulation.run(sinks);

  const DecisionTimes& times = simulation.decision_times();
  const std::string label{method.name};
  const json run = runs.run_of(cell_labels(name_of(course), label, name_of(Vessel::zarco)), 1);
  return {
      .label = label,
      .track = page::linked(log.track(label), run, {}),
      .speeds = page::linked(log.speeds(label), run, {}),
      .mean_decision_us = 1e6 * times.total_s / static_cast<double>(std::max<std::int64_t>(times.count, 1)),
      .worst_decision_us = 1e6 * times.worst_s};
}

json ways(const std::string& title, Course course, const std::vector<Passage>& passages) {
  json tracks = json::array();
  double last = 0.0;
  for (const Passage& passage : passages) {
    tracks.push_back(passage.track);
    last = math::fmax(last, passage.track["t"].back().get<double>());
  }
  const Layout layout = layout_of(course);
  if (layout.vessel) tracks.push_back(way_of_the_other(layout, math::fmin(last, 40.0)));
  return page::scene(title, std::move(tracks), layout.obstacles(), layout.goal);
}

}  // namespace fairway::surface
