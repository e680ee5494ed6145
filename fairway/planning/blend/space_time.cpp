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

constexpr int index(int row, int column) { return row * rows + column; }
constexpr int start = index(half, half);

Vec2 centre(const SpaceTimeTask& task, int place) {
  return task.from + cell * Vec2{place / rows - half, place % rows - half};
}

/// What it costs to be somewhere with so much room to the nearest thing; infinite without the margin.
float price(double room, double margin) {
  if (room < margin) return blocked;
  return 2.0F * static_cast<float>(math::fmax(0.0, 1.0 - (room - margin) / near));
}

using Layer = std::vector<float>;

Layer standing_prices(const SpaceTimeTask& task) {
  Layer prices(static_cast<std::size_t>(rows) * rows);
  for (int place = 0; place < rows * rows; ++place) {
    double room = std::numeric_limits<double>::infinity();
    for (const PlanarMap* map : task.maps)
      room = math::fmin(room, map->clearance(centre(task, place)) + map->inflation() - task.radius);
    prices[static_cast<std::size_t>(place)] = price(room, task.margin);
  }
  return prices;
}

float price_among(const SpaceTimeTask& task, const Vec2& p, double time) {
  float sum = 0.0F;
  for (const Track& track : task.tracks) {
    const Vec3 there = track.position + time * track.velocity;
    sum += price((there.head<2>() - p).norm() - track.radius - task.radius, task.margin);
  }
  return sum;
}

/// The cheapest ways to every place after so many steps, and the move that each ended with.
class Ways {
 public:
  Ways(const SpaceTimeTask& task, double step_time) : task_{task}, standing_{standing_prices(task)} {
    cost_.assign(standing_.size(), blocked);
    cost_[start] = 0.0F;
    for (int step = 1; step <= steps; ++step) advance(step, step_time);
  }

  std::optional<int> best_end() const {
    std::optional<int> best;
    float least = blocked;
    for (int place = 0; place < rows * rows; ++place) {
      const auto left = static_cast<float>((task_.towards - centre(task_, place)).norm() / cell);
      const float total = cost_[static_cast<std::size_t>(place)] + 3.0F * left;
      if (total < least) {
        least = total;
        best = place;
      }
    }
    return best;
  }

  /// Where the way to `end` is after `step` steps.
  int place_at(int end, int step) const {
    for (int k = steps; k > step; --k) {
      const Move& move = moves[last_move_[static_cast<std::size_t>(k) - 1][static_cast<std::size_t>(end)]];
      end -= index(move.north, move.east);
    }
    return end;
  }

 private:
  void advance(int step, double step_time) {
    Layer next(cost_.size(), blocked);
    std::vector<unsigned char> chosen(cost_.size(), 0);
    const int reach = std::min(step, half);
    const float dearer = 1.0F + haste * static_cast<float>(step);  // else waiting first would cost the same
    for (int row = half - reach; row <= half + reach; ++row) {
      for (int column = half - reach; column <= half + reach; ++column) {
        const auto place = static_cast<std::size_t>(index(row, column));
        if (standing_[place] == blocked) continue;
        for (std::size_t m = 0; m < moves.size(); ++m) {
          const int from_row = row - moves[m].north, from_column = column - moves[m].east;
          if (from_row < 0 || from_row >= rows || from_column < 0 || from_column >= rows) continue;
          const float cost =
              cost_[static_cast<std::size_t>(index(from_row, from_column))] + dearer * moves[m].length;
          if (cost < next[place]) {
            next[place] = cost;
            chosen[place] = static_cast<unsigned char>(m);
          }
        }
        if (next[place] < blocked)
          next[place] +=
              standing_[place] + price_among(task_, centre(task_, static_cast<int>(place)), step * step_time);
      }
    }
    cost_ = std::move(next);
    last_move_.push_back(std::move(chosen));
  }

  const SpaceTimeTask& task_;
  Layer standing_;
  Layer cost_;
  std::vector<std::vector<unsigned char>> last_move_;
};

}  // namespace

std::optional<SpaceTimeLeg> way_through(const SpaceTimeTask& task) {
  constexpr int leg_steps = 2;
  const double step_time = cell * std::numbers::sqrt2 / task.speed;
  const Ways ways{task, step_time};
  const std::optional<int> end = ways.best_end();
  if (!end) return {};
  return SpaceTimeLeg{centre(task, ways.place_at(*end, leg_steps)), leg_steps * step_time};
}

}  // namespace fairway
