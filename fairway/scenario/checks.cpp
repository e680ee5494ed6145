// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <tuple>

#include "fairway/core/text.hpp"
#include "fairway/scenario/parts.hpp"

namespace fairway::yaml {
namespace {

std::string vehicle_path(std::size_t i) { return fmt::format("vehicles[{}]", i); }

std::string place(const Vec3& p) {
  return fmt::format("[{}, {}, {}]", number_text(p.x()), number_text(p.y()), number_text(p.z()));
}

/// The value of a vehicle's key, or the vehicle where it does not say.
const Tree& written(const Tree& vehicle, std::string_view key, std::string_view inner = {}) {
  const Tree* found = vehicle.find(key);
  if (found != nullptr && !inner.empty()) found = found->find(inner);
  return found == nullptr ? vehicle : *found;
}

/// Calls `refuse(earlier, later)` for the first two vehicles with equal keys. O(n log n).
template <class KeyOf, class Refuse>
void refuse_equal(std::size_t count, const KeyOf& key_of, const Refuse& refuse) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple_cat(key_of(i), std::tuple{i}); });
  for (std::size_t k = 1; k < count; ++k) {
    if (key_of(order[k - 1]) == key_of(order[k])) refuse(order[k - 1], order[k]);
  }
}

/// Whether each sphere overlaps each other. O(n) unless many do.
bool all_overlap(const std::vector<VehicleSpec>& vehicles) {
  for (std::size_t i = 1; i < vehicles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = (vehicles[i].position - vehicles[j].position).norm();
      if (distance >= vehicles[i].radius_m + vehicles[j].radius_m) return false;
    }
  }
  return vehicles.size() > 1;
}

/// A box around a solid seen from above: most vehicles start outside, and need no closer look.
struct Box {
  Eigen::Vector2d lo;
  Eigen::Vector2d hi;

  explicit Box(const ObstacleSpec& o)
      : lo{o.position.head<2>().array() - o.radius}, hi{o.position.head<2>().array() + o.radius} {
    if (o.vertices.empty()) return;
    lo = hi = o.vertices.front().head<2>();
    for (const Vec3& v : o.vertices) {
      lo = lo.cwiseMin(v.head<2>());
      hi = hi.cwiseMax(v.head<2>());
    }
  }
  bool holds(const Vec3& p) const {
    return (p.head<2>().array() >= lo.array()).all() && (p.head<2>().array() <= hi.array()).all();
  }
};

}  // namespace

void check_vehicles(const Value& list, const Scenario& scenario) {
  const std::vector<VehicleSpec>& vehicles = scenario.vehicles;
  const std::vector<Tree>& trees = list.tree().items;

  refuse_equal(
      vehicles.size(), [&](std::size_t i) { return std::tuple{vehicles[i].id}; },
      [&](std::size_t a, std::size_t b) {
        refuse_at(written(trees[b], "id").where, vehicle_path(b) + ".id",
                  fmt::format("id {} is that of {}", vehicles[b].id, vehicle_path(a)));
      });

  refuse_equal(
      vehicles.size(), [&](std::size_t i) { return std::tuple{std::string_view{vehicles[i].name}}; },
      [&](std::size_t a, std::size_t b) {
        const bool is_written = trees[b].find("name") != nullptr;
        refuse_at(written(trees[b], "name").where, vehicle_path(b) + ".name",
                  fmt::format("{} is the name of {}, too; expected {}", vehicles[b].name, vehicle_path(a),
                              is_written ? "a name of its own"
                                         : "another name there, since this one follows from an id"));
      });

  const auto start_of = [&](std::size_t i) -> const Tree& {
    return written(trees[i], "start", "position_m");
  };
  if (!scenario.coincident_start) {
    const auto key_of = [&](std::size_t i) {
      const Vec3& p = vehicles[i].position;
      return std::tuple{p.x(), p.y(), p.z()};
    };
    refuse_equal(vehicles.size(), key_of, [&](std::size_t a, std::size_t b) {
      refuse_at(start_of(b).where, vehicle_path(b) + ".start.position_m",
                fmt::format("{} starts at the same place, {}; move one, or write coincident_start: true",
                            vehicle_path(a), place(vehicles[b].position)));
    });
  }

  if (!scenario.coincident_start && all_overlap(vehicles)) {
    refuse_at(start_of(1).where, vehicle_path(1) + ".start.position_m",
              fmt::format("the spheres of radius_m of all {} vehicles overlap where they start; move them "
                          "apart, or write coincident_start: true",
                          vehicles.size()));
  }

  for (std::size_t k = 0; k < scenario.obstacles.size(); ++k) {
    const ObstacleSpec& obstacle = scenario.obstacles[k];
    if (obstacle.kind == Obstacle::Kind::segment) continue;
    const Box box{obstacle};
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      if (!box.holds(vehicles[i].position) ||
          nearest_point(obstacle.view(), vehicles[i].position).distance >= 0.0)
        continue;
      refuse_at(start_of(i).where, vehicle_path(i) + ".start.position_m",
                fmt::format("{} lies inside obstacles[{}]", place(vehicles[i].position), k));
    }
  }
}

}  // namespace fairway::yaml
