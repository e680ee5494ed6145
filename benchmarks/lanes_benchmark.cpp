// SPDX-License-Identifier: Apache-2.0
// What a step of a fleet costs whose vehicles are points that reach their velocities at once, under ORCA in
// space with at most 10 neighbours within 15 m, decided in the lanes of the processor's registers: looking
// round, deciding, moving. The places are those of `fairway bench --fleet`: a disturbed lattice of 11 m, all
// going their own ways at 0.5 m/s.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

constexpr double reach = 15.0, period = 0.05, cruise = 0.5;
constexpr std::size_t most = 10;

/// One cache line: the columns of lanes/kernel.hpp.
struct alignas(64) Point {
  std::array<double, 3> position, velocity;
  double radius = 1.0, speed = cruise;
};

/// Points sorted by the cells of a uniform grid over all of them, x by x in rows: three rows of rows of three
/// cells hold whoever is within reach, each row being one run of columns.
class Grid {
 public:
  void sort(const std::vector<Point>& points) {
    std::array<double, 3> high{};
    low_ = high = points.front().position;
    for (const Point& p : points)
      for (std::size_t c = 0; c < 3; ++c) {
        low_[c] = std::min(low_[c], p.position[c]);
        high[c] = std::max(high[c], p.position[c]);
      }
    for (std::size_t c = 0; c < 3; ++c) cells_[c] = cell_of(high[c], c) + 1;
    begins_.assign(cells_[0] * cells_[1] * cells_[2] + 1, 0);
    cell_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& p = points[i].position;
      cell_[i] = static_cast<std::uint32_t>(row(cell_of(p[1], 1), cell_of(p[2], 2)) + cell_of(p[0], 0));
      ++begins_[cell_[i]];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : begins_) begin = sum += begin;
    for (auto& column : columns_) column.resize(points.size() + lanes::most_lanes);
    for (std::size_t i = points.size(); i-- > 0;) {
      const std::uint32_t at = --begins_[cell_[i]];
      columns_[3][at] = static_cast<double>(i);
      for (std::size_t c = 0; c < 3; ++c) columns_[c][at] = points[i].position[c];
    }
  }

  /// Who is within reach of the point `own` in the order of the cells, itself too; returns how many.
  std::size_t look_round(const lanes::Kernel& kernel, std::size_t own, const lanes::Found& found) const {
    const std::array<const double*, 4> columns{columns_[0].data(), columns_[1].data(), columns_[2].data(),
                                               columns_[3].data()};
    const std::array<double, 3> place{columns[0][own], columns[1][own], columns[2][own]};
    std::array<std::size_t, 3> from, to;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t cell = cell_of(place[c], c);
      from[c] = cell > 0 ? cell - 1 : 0;
      to[c] = std::min(cell + 1, cells_[c] - 1);
    }
    std::size_t count = 0;
    for (std::size_t z = from[2]; z <= to[2]; ++z)
      for (std::size_t y = from[1]; y <= to[1]; ++y)
        count = kernel.within(columns.data(), begins_[row(y, z) + from[0]], begins_[row(y, z) + to[0] + 1],
                              place.data(), reach * reach, found, count);
    return count;
  }

  std::size_t point_of(std::size_t number) const { return static_cast<std::size_t>(columns_[3][number]); }

 private:
  std::size_t cell_of(double x, std::size_t c) const {
    return static_cast<std::size_t>((x - low_[c]) / reach);
  }
  std::size_t row(std::size_t y, std::size_t z) const { return (z * cells_[1] + y) * cells_[0]; }

  std::array<double, 3> low_;
  std::array<std::size_t, 3> cells_;
  std::array<std::vector<double>, 4> columns_;  // places, and the numbers of the points
  std::vector<std::uint32_t> begins_, cell_;
};

class Fleet {
 public:
  explicit Fleet(std::size_t count) {
    Rng rng{1};
    const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count)) - 1e-9));
    for (std::size_t i = 0; i < count; ++i) {
      Point point;
      const std::array<std::size_t, 3> cell{i % side, i / side % side, i / (side * side)};
      for (std::size_t c = 0; c < 3; ++c)
        point.position[c] = 11.0 * static_cast<double>(cell[c]) + rng.uniform(-2.0, 2.0);
      const double course = rng.uniform(-pi, pi);
      point.velocity = {cruise * std::cos(course), cruise * std::sin(course), 0.0};
      points_.push_back(point);
      preferred_.push_back(point.velocity);
    }
    chosen_.resize(count);
  }

  /// One step; returns how many neighbours all have had together.
  std::size_t step(const lanes::Kernel& kernel) {
    grid_.sort(points_);
    std::size_t all = 0;
    for (std::size_t first = 0; first < points_.size(); first += kernel.lanes) all += decide(kernel, first);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      points_[i].velocity = chosen_[i];
      for (std::size_t c = 0; c < 3; ++c) points_[i].position[c] += period * chosen_[i][c];
    }
    return all;
  }

 private:
  /// Of as many as there are lanes, next to each other in the order of the cells.
  std::size_t decide(const lanes::Kernel& kernel, std::size_t first) {
    const std::size_t width = kernel.lanes, here = std::min(width, points_.size() - first);
    std::array<std::size_t, lanes::most_lanes> counts{};
    crowd_->neighbours = 0;
    std::size_t all = 0;
    for (std::size_t lane = 0; lane < width; ++lane) {
      counts[lane] = write_vehicle(kernel, first + std::min(lane, here - 1), lane);
      crowd_->neighbours = std::max(crowd_->neighbours, counts[lane]);
      all += lane < here ? counts[lane] : 0;
    }
    for (std::size_t lane = 0; lane < width; ++lane)
      for (std::size_t k = counts[lane]; k < crowd_->neighbours; ++k)
        write({.position = {}, .velocity = {}, .radius = -1.0}, others(k, width) + lane, width, 0.0);
    alignas(64) std::array<double, 4 * lanes::most_lanes> answer;
    kernel.decide(*crowd_, answer.data());
    for (std::size_t lane = 0; lane < here; ++lane)
      for (std::size_t c = 0; c < 3; ++c) chosen_[grid_.point_of(first + lane)][c] = answer[c * width + lane];
    return all;
  }

  std::size_t write_vehicle(const lanes::Kernel& kernel, std::size_t number, std::size_t lane) {
    const std::size_t own = grid_.point_of(number), width = kernel.lanes;
    std::array<double, lanes::most_found + lanes::most_lanes> distances2, numbers;
    std::array<std::uint32_t, lanes::most_found> near;
    const lanes::Found found{distances2.data(), numbers.data()};
    const std::size_t within = grid_.look_round(kernel, number, found);
    kernel.order(found, within, near.data());
    write(points_[own], crowd_->own + lane, width, points_[own].speed);
    for (std::size_t c = 0; c < 3; ++c) crowd_->preferred[c * width + lane] = preferred_[own][c];
    const std::size_t count = std::min(within - 1, most);  // the nearest is itself
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t other = near[k + 1];
      write(points_[other], others(k, width) + lane, width, own <= other ? 0.5 : -0.5);
    }
    return count;
  }

  double* others(std::size_t k, std::size_t width) { return crowd_->others + k * lanes::columns * width; }

  static void write(const Point& point, double* at, std::size_t width, double last) {
    for (std::size_t c = 0; c < 3; ++c) {
      at[c * width] = point.position[c];
      at[(3 + c) * width] = point.velocity[c];
    }
    at[6 * width] = point.radius;
    at[7 * width] = last;
  }

  std::vector<Point> points_;
  std::vector<std::array<double, 3>> preferred_, chosen_;
  Grid grid_;
  std::shared_ptr<lanes::Crowd> crowd_ =
      std::make_shared<lanes::Crowd>(lanes::Crowd{.time_horizon = 5.0, .period = period});
};

void fleet(benchmark::State& bench) {
  const Fleet start{static_cast<std::size_t>(bench.range(0))};
  const lanes::Kernel& kernel = lanes::kernel_for(static_cast<std::size_t>(bench.range(1)));
  if (kernel.lanes != static_cast<std::size_t>(bench.range(1)))
    return bench.SkipWithError("this processor has no such registers");

  Fleet fleet = start;
  std::size_t steps = 0, neighbours = 0;
  for (auto _ : bench) {
    neighbours += fleet.step(kernel);
    if (++steps % 200 == 0) {  // ten seconds, before a small fleet has left itself
      bench.PauseTiming();
      fleet = start;
      bench.ResumeTiming();
    }
  }
  const double vehicle_steps = static_cast<double>(steps) * static_cast<double>(bench.range(0));
  bench.counters["neighbours"] = static_cast<double>(neighbours) / vehicle_steps;
  bench.counters["each"] =
      benchmark::Counter(vehicle_steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(fleet)
    ->ArgNames({"vehicles", "lanes"})
    ->ArgsProduct({{8, 64, 256, 1000, 10000, 100000}, {2, 4, 8}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fairway
