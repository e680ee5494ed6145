// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "fairway/core/vec.hpp"

namespace fairway {

/// Who is near: points sorted by the cell of a uniform grid that they are in, so that whoever looks round
/// meets what is near, and not what there is. It finds exactly what a comparison with every point finds: the
/// size of the cells decides about the cost alone. Cells are hashed, so that the extent of the points does
/// not matter, and a row of cells along north is one run of memory. A value.
class CellIndex {
 public:
  /// Room for so many points, up to which `rebuild` does not allocate.
  void reserve(std::size_t count) {
    points_.reserve(count);
    begins_.reserve(bucket_count(count) + 1);
  }

  /// Takes the points `point_of(i)` [m], i from 0 to `count` - 1, in place of those before. Cells have the
  /// edge `edge` [m], which is usually how far the callers look, or a larger one where they would hold hardly
  /// anyone; what is no length leaves the choice to the index. A point that is not finite is nowhere.
  /// O(count).
  template <class PointOf>
  void rebuild(std::size_t count, double edge, const PointOf& point_of) {
    reserve(count);
    const double least = edge > least_edge && std::isfinite(edge) ? edge : least_edge;
    if (crowd_ > most_in_a_cell) edge_ *= 0.5;
    edge_ = std::max(edge_, least);
    sort(count, point_of);
    while (crowd_ < least_in_a_cell && edge_ < extent_) {
      edge_ *= 2.0;
      sort(count, point_of);
    }
  }

  /// Calls `visit(index, distance2)` for each point whose squared distance from `place` [m2] is at most that
  /// of `reach` [m], in no order; whoever is at `place` itself is among them. Returns how many it has looked
  /// at.
  template <class Visit>
  std::size_t visit(const Vec3& place, double reach, const Visit& visit) const {
    const double reach2 = reach * reach;
    const auto compare = [&](const Point& point) {
      const double distance2 = (point.position - place).squaredNorm();
      if (distance2 <= reach2) visit(std::size_t{point.index}, distance2);
    };
    // where the cells to look through are as many as the points, the points are sooner looked through
    const double around = 2.0 * reach / edge_ + 2.0;
    const bool few = points_.size() <= handful || !is_finite(place) ||
                     !(around * around * around < static_cast<double>(points_.size()));
    if (few) {
      std::ranges::for_each(points_, compare);
      return points_.size();
    }
    const Vec3 far = Vec3::Constant(reach) + 1e-9 * (place.cwiseAbs() + Vec3::Constant(reach));  // rounding
    const auto cells_along = [&](Eigen::Index axis) {
      return Span{cell_of(place[axis] - far[axis]), cell_of(place[axis] + far[axis])};
    };
    const Span x = cells_along(0), y = cells_along(1), z = cells_along(2);
    std::size_t looked_at = 0;
    for (Row row{y.first, z.first}; row.z <= z.last; ++row.z) {
      for (row.y = y.first; row.y <= y.last; ++row.y) looked_at += look_through(row, x, compare);
    }
    return looked_at;
  }

  /// A distance within which `wanted(index)` is true of at least `count` points, not much larger than it has
  /// to be; infinite if it is true of fewer.
  template <class Wanted>
  double reach_of(std::size_t count, const Vec3& place, const Wanted& wanted) const {
    for (double reach = edge_;; reach *= 2.0) {
      std::size_t found = 0;
      const std::size_t looked_at =
          visit(place, reach, [&](std::size_t index, double) { found += wanted(index) ? 1 : 0; });
      if (found >= count) return reach;
      if (looked_at == points_.size()) return std::numeric_limits<double>::infinity();
    }
  }

  /// Of the points that are somewhere.
  std::size_t size() const { return points_.size(); }
  /// Of a cell [m].
  double edge() const { return edge_; }
  /// How many are in a cell that anyone is in, on average.
  double crowd() const { return crowd_; }
  /// Of all points, along the axis where it is largest [m].
  double extent() const { return extent_; }

 private:
  static constexpr std::size_t handful = 24;          // so few are looked through faster than cells are found
  static constexpr double least_edge = 1e-3;          // [m]
  static constexpr double least_in_a_cell = 1.2;      // of those that hold anyone, on average
  static constexpr double most_in_a_cell = 16.0;      // likewise: less than 8 times that, the cells' growth
  static constexpr std::int32_t outermost = 1 << 30;  // cell, with all beyond

  struct Span {
    std::int32_t first;
    std::int32_t last;
  };
  struct Row {
    std::int32_t y;
    std::int32_t z;
    friend bool operator==(const Row&, const Row&) = default;
  };
  struct Point {
    Vec3 position;
    Row row;
    std::uint32_t index;
  };

  static std::size_t bucket_count(std::size_t count) { return 2 * std::bit_ceil(count + 1); }

  /// Rounded down; a library's floor would be called for each.
  std::int32_t cell_of(double x) const {
    constexpr double most = outermost;
    const double cells = std::clamp(x / edge_, -most, most);
    const auto whole = static_cast<std::int32_t>(cells);
    return whole - (cells < whole ? 1 : 0);
  }

  Row row_of(const Vec3& p) const { return {cell_of(p.y()), cell_of(p.z())}; }

  /// Of the cell x of a row; the next one has the next bucket, round the end.
  std::uint32_t bucket_of(const Row& row, std::int32_t x) const {
    std::uint64_t h =
        static_cast<std::uint32_t>(row.y) + (std::uint64_t{static_cast<std::uint32_t>(row.z)} << 32U);
    h *= 0x9E3779B97F4A7C15ULL;
    return (static_cast<std::uint32_t>(h >> 32U) + static_cast<std::uint32_t>(x)) & mask_;
  }

  template <class Compare>
  std::size_t look_through(const Row& row, const Span& x, const Compare& compare) const {
    const std::uint32_t first = bucket_of(row, x.first);
    const std::uint32_t end = first + static_cast<std::uint32_t>(x.last - x.first) + 1;
    const auto look = [&](std::uint32_t begin, std::uint32_t stop) {
      for (std::uint32_t k = begins_[begin]; k < begins_[stop]; ++k) {
        if (points_[k].row == row) compare(points_[k]);
      }
      return std::size_t{begins_[stop] - begins_[begin]};
    };
    if (end <= mask_ + 1) return look(first, end);
    return look(first, mask_ + 1) + look(0, end - mask_ - 1);
  }

  /// As they are.
  template <class PointOf>
  void keep(std::size_t count, const PointOf& point_of) {
    points_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 p = point_of(i);
      if (is_finite(p)) points_.push_back({p, {}, static_cast<std::uint32_t>(i)});
    }
    crowd_ = least_in_a_cell;
  }

  template <class PointOf>
  void sort(std::size_t count, const PointOf& point_of) {
    if (count <= handful) return keep(count, point_of);
    mask_ = static_cast<std::uint32_t>(bucket_count(count) - 1);
    begins_.assign(std::size_t{mask_} + 2, 0);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 p = point_of(i);
      if (!is_finite(p)) continue;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      ++begins_[bucket_of(row_of(p), cell_of(p.x()))];
    }

    // where the points of each bucket end; putting them there from the last one on leaves where they begin
    std::uint32_t sum = 0;
    std::size_t occupied = 0;
    for (std::uint32_t& begin : begins_) {
      occupied += begin > 0 ? 1 : 0;
      begin = sum += begin;
    }
    points_.resize(sum);
    for (std::size_t i = count; i-- > 0;) {
      const Vec3 p = point_of(i);
      if (!is_finite(p)) continue;
      const Row row = row_of(p);
      points_[--begins_[bucket_of(row, cell_of(p.x()))]] = {p, row, static_cast<std::uint32_t>(i)};
    }
    extent_ = sum > 0 ? (high - low).maxCoeff() : 0.0;
    crowd_ = occupied > 0 ? static_cast<double>(sum) / static_cast<double>(occupied) : least_in_a_cell;
  }

  double edge_{least_edge};
  double extent_{};  // of all points, along the axis where it is largest [m]
  double crowd_{};   // in a cell that anyone is in, on average
  std::uint32_t mask_{};
  std::vector<Point> points_;          // by bucket
  std::vector<std::uint32_t> begins_;  // of each bucket among the points, and the end
};

}  // namespace fairway
