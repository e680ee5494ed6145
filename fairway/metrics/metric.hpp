// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "fairway/core/cell_index.hpp"
#include "fairway/metrics/measure.hpp"
#include "fairway/record/frame.hpp"

namespace fairway {

/// What to print about a quantity.
struct QuantityInfo {
  std::string_view name;     ///< ends in its unit
  bool per_vehicle{};        ///< else one for the fleet
  std::string_view meaning;  ///< with its counting rule
  /// For a time until something happens, the quantity of the fleet that is 1 in a run in which it happened to
  /// all. Below 1 the end of the run cut the time off, and it is at least what was measured.
  std::string_view complete_at_1{};
};

/// Who of a frame's vehicles is near whom, for the metrics that ask. It remembers how far from everyone each
/// vehicle was when it last looked round, so that for as long as nobody can have come within reach since, it
/// need not look again. Does not allocate after the first frame.
class Neighbours {
 public:
  /// Of one vehicle at once there is room for so many contacts; whoever has more takes memory for them.
  static constexpr std::size_t usual_contacts = 8;

  /// `reach` is how far the metrics usually look [m].
  explicit Neighbours(double reach) : reach_{reach} {}

  /// Takes the next frame, of the same vehicles.
  const Neighbours& of(const Frame& frame);

  /// Calls `visit(other, distance2)` for each other vehicle whose squared distance from vehicle `index` [m2]
  /// is at most that of `reach` [m], in no order.
  template <class Visit>
  void visit(std::size_t index, double reach, const Visit& visit) const {
    Own& own = own_[index];
    if (reach < own.clear) return;
    const double farther = reach + spare_ratio * reach_;
    double nearest2 = farther * farther;
    index_.visit(own.position, farther, [&](std::size_t other, double distance2) {
      if (other == index) return;
      nearest2 = std::fmin(nearest2, distance2);
      if (distance2 <= reach * reach) visit(other, distance2);
    });
    own.clear = shorter(std::sqrt(nearest2));
  }

  /// A distance within which `wanted(other)` is true of another vehicle; infinite if it is true of none.
  template <class Wanted>
  double reach_of_one(std::size_t index, const Wanted& wanted) const {
    return index_.reach_of(1, own_[index].position,
                           [&](std::size_t other) { return other != index && wanted(other); });
  }

 private:
  struct Own {
    Vec3 position = Vec3::Zero();
    double clear{};  // nobody is within this distance [m]
  };

  /// Looking a little farther than asked, it has to look less often.
  static constexpr double spare_ratio = 0.25;

  /// Less than `distance`, by more than all that is rounded on the way.
  static double shorter(double distance) { return distance * (1.0 - 1e-9) - 1e-9; }

  double reach_;
  CellIndex index_;
  mutable std::vector<Own> own_;
};

/// A fold over the frames of a run, the same live and from a file, in memory that does not grow with
/// the run. See each implementation for its quantities. Those that ask who is near take a frame together with
/// its `Neighbours` too, so that several share them.
class Metric {
 public:
  virtual ~Metric() = default;
  virtual void see(const Frame& frame) = 0;
  virtual void report(std::vector<Measure>& measures) const = 0;
};

}  // namespace fairway
