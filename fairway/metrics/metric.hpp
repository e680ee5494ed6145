// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

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

/// A fold over the frames of a run, the same live and from a file, in memory that does not grow with
/// the run. See each implementation for its quantities.
///
/// Several metrics see a frame together, vehicle by vehicle, as `see(frame)` of each does alone: after
/// `begin()`, `see()` of every vehicle once, in any order and by as many hands at a time as were announced,
/// and `finish()` where there is one. Those that ask who is near say how far they look (`reach()`, negative
/// where they do not), and are shown all who are as near as the farthest of these, or nearer.
class Metric {
 public:
  virtual ~Metric() = default;
  virtual void see(const Frame& frame) = 0;
  virtual void report(std::vector<Measure>& measures) const = 0;
};

}  // namespace fairway
