// SPDX-License-Identifier: Apache-2.0
#include "fairway/metrics/encounters.hpp"

#include <algorithm>

namespace fairway {

const std::vector<QuantityInfo>& EncounterMetric::quantities() {
  static const std::vector<QuantityInfo> all{
      {"navigation_time_s", true, "from the first tick under way until arrival, or until counted as stuck",
       "arrived_ratio"},
      {"avoidance_time_s", true, "part of the navigation time with somebody within the detection distance"},
      {"avoided_count", true,
       "neighbours that came within the detection distance and left without a collision"},
      {"collision_count", true,
       "neighbours that came within the safety distance, counted once as they leave"},
      {"distance_m", true, "path length while navigating"},
      {"stuck_count", true, "1 if the navigation time passed the exam's limit before arrival"},
      {"start_distance_m", true, "straight line to the goal at the first tick under way"},
  };
  return all;
}

void EncounterMetric::begin(const Frame& frame, std::size_t index) {
  Count& count = counts_[index];
  const VehicleFrame& own = frame.vehicles[index];
  count.started = true;
  count.start_distance = (own.goal - own.state.p_n).norm();
  count.last_position = own.state.p_n;
  count.contacts.assign(frame.vehicles.size(), Contact::none);
}

bool EncounterMetric::update_contacts(const Frame& frame, std::size_t index) {
  Count& count = counts_[index];
  const Vec3& here = frame.vehicles[index].state.p_n;
  bool anyone = false;
  for (std::size_t j = 0; j < frame.vehicles.size(); ++j) {
    if (j == index) continue;
    Contact& contact = count.contacts[j];
    const double distance2 = (frame.vehicles[j].state.p_n - here).squaredNorm();
    if (distance2 <= rules_.crit_dist_m * rules_.crit_dist_m) {
      anyone = true;
      const bool collided = distance2 <= rules_.safety_distance_m * rules_.safety_distance_m;
      contact = std::max(contact, collided ? Contact::collided : Contact::near);
      if (collided && count.first_collision.other == Occasion::none)
        count.first_collision = {.other = static_cast<int>(j), .time = frame.time};
    } else if (contact != Contact::none) {
      ++(contact == Contact::collided ? count.collisions : count.avoided);
      contact = Contact::none;
    }
  }
  return anyone;
}

void EncounterMetric::see(const Frame& frame, std::size_t index) {
  Count& count = counts_[index];
  const VehicleFrame& own = frame.vehicles[index];
  if (count.finished || (!count.started && !is_avoiding(own.phase))) return;
  if (!count.started) begin(frame, index);

  count.distance += (own.state.p_n - count.last_position).norm();
  count.last_position = own.state.p_n;

  if (own.phase == Phase::under_way) {
    count.navigation_time += frame.period;
    if (update_contacts(frame, index)) count.avoidance_time += frame.period;
    return;
  }

  // whoever is still near on arrival counts; a stuck vehicle leaves its open encounters uncounted
  count.finished = true;
  count.stuck = own.phase == Phase::stuck;
  for (const Contact contact : count.contacts) {
    if (contact != Contact::none && !count.stuck)
      ++(contact == Contact::collided ? count.collisions : count.avoided);
  }
  count.contacts.clear();
}

void EncounterMetric::see(const Frame& frame) {
  if (counts_.empty()) counts_.resize(frame.vehicles.size());
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) see(frame, i);
}

void EncounterMetric::report(std::vector<Measure>& measures) const {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const Count& count = counts_[i];
    const int vehicle = static_cast<int>(i);
    measures.push_back({"navigation_time_s", vehicle, count.navigation_time});
    measures.push_back({"avoidance_time_s", vehicle, count.avoidance_time});
    measures.push_back({"avoided_count", vehicle, static_cast<double>(count.avoided)});
    const Occasion collision = count.collisions > 0 ? count.first_collision : Occasion{};
    measures.push_back({"collision_count", vehicle, static_cast<double>(count.collisions), collision});
    measures.push_back({"distance_m", vehicle, count.distance});
    measures.push_back({"stuck_count", vehicle, count.stuck ? 1.0 : 0.0});
    measures.push_back({"start_distance_m", vehicle, count.start_distance});
  }
}

}  // namespace fairway
