// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/encounters.hpp"

#include <algorithm>

namespace fairway {
namespace {

bool has_ended(Phase phase) { return phase == Phase::arrived || phase == Phase::stuck; }

}  // namespace

const std::vector<QuantityInfo>& EncounterMetric::quantities() {
  static const std::vector<QuantityInfo> all{
      {"navigation_time_s", true, "from the first tick under way until arrival, or until counted as stuck",
       "arrived_ratio"},
      {"avoidance_time_s", true, "part of the navigation time with somebody within the detection distance"},
      {"avoided_count", true,
       "neighbours that came within the detection distance and left without a collision"},
      {"collision_count", true,
       "neighbours that came within the safety distance, counted once, as they leave or the run ends"},
      {"distance_m", true, "path length while navigating"},
      {"stuck_count", true, "1 if the navigation time passed the exam's limit before arrival"},
      {"start_distance_m", true, "straight line to the goal at the first tick under way"},
  };
  return all;
}

void EncounterMetric::set_out(const Frame& frame, std::size_t index) {
  Count& count = counts_[index];
  const VehicleFrame& own = frame.vehicles[index];
  count.started = true;
  count.start_distance = (own.goal - own.state.p_n).norm();
  count.last_position = own.state.p_n;
}

bool EncounterMetric::update_contacts(const Frame& frame, std::size_t index, std::span<const Neighbour> near,
                                      std::vector<OpenEncounter>& detected) {
  Count& count = counts_[index];
  detected.clear();
  for (const auto& [j, distance2] : near) {
    if (!(distance2 <= rules_.crit_dist_m * rules_.crit_dist_m)) continue;
    const bool collided = distance2 <= rules_.safety_distance_m * rules_.safety_distance_m;
    detected.push_back({j, collided ? Contact::collided : Contact::near});
  }
  if (detected.empty() && count.open.empty()) return false;
  std::ranges::sort(detected, {}, &OpenEncounter::other);
  const auto hit = std::ranges::find(detected, Contact::collided, &OpenEncounter::worst);
  if (hit != detected.end() && count.first_collision.other == Occasion::none)
    count.first_collision = {.other = static_cast<int>(hit->other), .time = frame.time};

  // whoever was near before is near still, or has left; both lists ascend
  auto before = count.open.begin();
  for (OpenEncounter& now : detected) {
    for (; before != count.open.end() && before->other < now.other; ++before)
      count_closed(count, before->worst);
    if (before == count.open.end() || before->other != now.other) continue;
    now.worst = std::max(now.worst, before->worst);
    ++before;
  }
  for (; before != count.open.end(); ++before) count_closed(count, before->worst);
  count.open.assign(detected.begin(), detected.end());
  return !detected.empty();
}

double EncounterMetric::reach(const Frame& frame, std::size_t index) const {
  const Count& count = counts_[index];
  const Phase phase = frame.vehicles[index].phase;
  const bool is_on_its_way = count.started ? !count.finished : is_avoiding(phase);
  return is_on_its_way && !has_ended(phase) ? rules_.crit_dist_m : -1.0;
}

void EncounterMetric::see(const Frame& frame, std::span<const Neighbour> near, std::size_t index,
                          std::size_t hand) {
  Count& count = counts_[index];
  const VehicleFrame& own = frame.vehicles[index];
  if (count.finished || (!count.started && !is_avoiding(own.phase))) return;
  if (!count.started) set_out(frame, index);

  count.distance += (own.state.p_n - count.last_position).norm();
  count.last_position = own.state.p_n;

  if (!has_ended(own.phase)) {  // it may pause on its way
    count.navigation_time += frame.period;
    if (update_contacts(frame, index, near, detected_[hand])) count.avoidance_time += frame.period;
    return;
  }

  // whoever is still near on arrival counts; a stuck vehicle leaves its open encounters uncounted
  count.finished = true;
  count.stuck = own.phase == Phase::stuck;
  for (const OpenEncounter& encounter : count.open) {
    if (!count.stuck) count_closed(count, encounter.worst);
  }
  count.open.clear();
}

void EncounterMetric::begin(const Frame& frame, std::size_t hands) {
  const std::size_t vehicles = frame.vehicles.size();
  if (counts_.empty()) {
    counts_.resize(vehicles);
    for (Count& count : counts_) count.open.reserve(std::min(vehicles, Neighbours::usual_contacts));
  }
  while (detected_.size() < hands) detected_.emplace_back().reserve(Neighbours::usual_room(vehicles));
}

void EncounterMetric::see(const Frame& frame) {
  begin(frame, 1);
  const Neighbours& all = neighbours_.of(frame);
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    all.find(i, reach(frame, i), near_);
    see(frame, near_, i, 0);
  }
}

/// Those that the end of the run left open, of a vehicle that it left on its way.
int EncounterMetric::open_of(const Count& count, Contact worst) {
  return count.finished ? 0 : static_cast<int>(std::ranges::count(count.open, worst, &OpenEncounter::worst));
}

void EncounterMetric::report(std::vector<Measure>& measures) const {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const Count& count = counts_[i];
    const int vehicle = static_cast<int>(i);
    measures.push_back({"navigation_time_s", vehicle, count.navigation_time});
    measures.push_back({"avoidance_time_s", vehicle, count.avoidance_time});
    measures.push_back({"avoided_count", vehicle, static_cast<double>(count.avoided)});
    const int collisions = count.collisions + open_of(count, Contact::collided);
    const Occasion collision = collisions > 0 ? count.first_collision : Occasion{};
    measures.push_back({"collision_count", vehicle, static_cast<double>(collisions), collision});
    measures.push_back({"distance_m", vehicle, count.distance});
    measures.push_back({"stuck_count", vehicle, count.stuck ? 1.0 : 0.0});
    measures.push_back({"start_distance_m", vehicle, count.start_distance});
  }
}

}  // namespace fairway
