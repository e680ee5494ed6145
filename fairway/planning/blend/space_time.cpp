// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/blend/space_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

constexpr double cell = 0.6;  // [m]
constexpr int half = 24;      // cells on either side of the vehicle
constexpr int rows = 2 * half + 1;
constexpr int steps = 40;
constexpr double near = 1.0;     // beyond the margin, where a place begins to cost [m]
constexpr float haste = 0.005F;  // of its cost, what a move costs more with every step that it is put off
constexpr float blocked = std::numeric_limits<float>::infinity();

struct Move {
  int north, east;
  float length;  // in cells
};
constexpr float diagonal = std::numbers::sqrt2_v<float>;
constexpr std::array moves{Move{0, 0, 0.2F},      Move{1, 0, 1.0F},      Move{-1, 0, 1.0F},
                           Move{0, 1, 1.0F},      Move{0, -1, 1.0F},     Move{1, 1, diagonal},
                           Move{1, -1, diagonal}, Move{-1, 1, diagonal}, Move{-1, -1, diagonal}};

/// Places are numbered row by row, with a blocked one round all of them, so that every place has neighbours.
constexpr int width = rows + 2;
constexpr int places = width * width;
constexpr int index(int row, int column) { return (row + 1) * width + column + 1; }
constexpr int start = index(half, half);

/// Of a place within the border.
Vec2 centre(const SpaceTimeTask& task, int row, int column) {
  return task.from + cell * Vec2{row - half, column - half};
}

/// What it costs to be somewhere with so much room to the nearest thing; infinite without the margin.
float price(double room, double margin) {
  if (room < margin) return blocked;
  return 2.0F * static_cast<float>(math::fmax(0.0, 1.0 - (room - margin) / near));
}

using Layer = std::vector<float>;

Layer standing_prices(const SpaceTimeTask& task) {
  Layer prices(places, blocked);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < rows; ++column) {
      double room = std::numeric_limits<double>::infinity();
      for (const PlanarMap* map : task.maps)
        room = math::fmin(room, map->clearance(centre(task, row, column)) + map->inflation() - task.radius);
      prices[static_cast<std::size_t>(index(row, column))] = price(room, task.margin);
    }
  }
  return prices;
}

/// The tracks at one time, where they are, and how far from there a place has a price.
class Crowd {
 public:
  Crowd(const SpaceTimeTask& task, double time) : task_{task} {
    for (const Track& track : task.tracks) {
      const Vec3 there = track.position + time * track.velocity;
      const double reach = (track.radius + task.radius + task.margin + near) * (1.0 + 1e-9);
      all_.push_back({there.head<2>(), track.radius, reach * reach});
    }
  }

  float price_at(const Vec2& p) const {
    float sum = 0.0F;
    for (const One& one : all_) {
      const double distance2 = (one.place - p).squaredNorm();
      if (distance2 <= one.reach2)
        sum += price(std::sqrt(distance2) - one.radius - task_.radius, task_.margin);
    }
    return sum;
  }

 private:
  struct One {
    Vec2 place;
    double radius;
    double reach2;
  };
  const SpaceTimeTask& task_;
  std::vector<One> all_;
};

/// What the cheapest ways to every place cost after so many steps.
class Ways {
 public:
  Ways(const SpaceTimeTask& task, double step_time)
      : task_{task}, standing_{standing_prices(task)}, costs_(steps + 1, Layer(places, blocked)) {
    costs_[0][start] = 0.0F;
    for (int step = 1; step <= steps; ++step) advance(step, Crowd{task, step * step_time});
  }

  std::optional<int> best_end() const {
    std::optional<int> best;
    float least = blocked;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < rows; ++column) {
        const int place = index(row, column);
        const auto left = static_cast<float>((task_.towards - centre(task_, row, column)).norm() / cell);
        const float total = costs_[steps][static_cast<std::size_t>(place)] + 3.0F * left;
        if (total < least) {
          least = total;
          best = place;
        }
      }
    }
    return best;
  }

  /// Where the way to `end` is after `step` steps.
  int place_at(int end, int step) const {
    for (int k = steps; k > step; --k) end = before(end, k);
    return end;
  }

 private:
  void advance(int step, const Crowd& crowd) {
    Layer& costs = costs_[static_cast<std::size_t>(step)];
    const int reach = std::min(step, half);
    for (int row = half - reach; row <= half + reach; ++row) {
      find_cheapest(step, row);
      for (int column = half - reach; column <= half + reach; ++column) {
        const auto place = static_cast<std::size_t>(index(row, column));
        if (standing_[place] == blocked) {
          costs[place] = blocked;
        } else if (costs[place] < blocked) {
          costs[place] += standing_[place] + crowd.price_at(centre(task_, row, column));
        }
      }
    }
  }

  /// Dearer with every step, else waiting first would cost the same.
  static float length_of(const Move& move, int step) {
    return (1.0F + haste * static_cast<float>(step)) * move.length;
  }

  /// Of the moves to each place of a row, all of which go the same way, several at a time.
  void find_cheapest(int step, int row) {
    const auto last = static_cast<std::size_t>(step) - 1;
    float* least = &costs_[last + 1][static_cast<std::size_t>(index(row, 0))];
    for (const Move& move : moves) {
      const float* from = &costs_[last][static_cast<std::size_t>(index(row - move.north, -move.east))];
      const float length = length_of(move, step);
      for (std::size_t i = 0; i < rows; ++i) {
        const float cost = from[i] + length;
        least[i] = cost < least[i] ? cost : least[i];
      }
    }
  }

  /// From where the cheapest way comes to a place with this step; of equal ones by the first move.
  int before(int place, int step) const {
    int best = place;
    float least = blocked;
    for (const Move& move : moves) {
      const int from = place - width * move.north - move.east;
      const float cost =
          costs_[static_cast<std::size_t>(step) - 1][static_cast<std::size_t>(from)] + length_of(move, step);
      if (cost < least) {
        least = cost;
        best = from;
      }
    }
    return best;
  }

  const SpaceTimeTask& task_;
  Layer standing_;
  std::vector<Layer> costs_;  ///< after each step, from 0 on
};

}  // namespace

std::optional<SpaceTimeLeg> way_through(const SpaceTimeTask& task) {
  constexpr int leg_steps = 2;
  const double step_time = cell * std::numbers::sqrt2 / task.speed;
  const Ways ways{task, step_time};
  const std::optional<int> end = ways.best_end();
  if (!end) return {};
  const int place = ways.place_at(*end, leg_steps);
  return SpaceTimeLeg{centre(task, place / width - 1, place % width - 1), leg_steps * step_time};
}

}  // namespace fairway
