// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fairway/core/vicinity.hpp"
#include "fairway/record/frame.hpp"

namespace fairway {

/// Another vehicle, by index, and how far it is.
struct Neighbour {
  std::uint32_t index;
  double distance2;  ///< [m2]
};

/// Who of a frame's vehicles is near whom, for the metrics that ask. Does not allocate after the first frame.
class Neighbours {
 public:
  /// Of one vehicle at once there is room for so many contacts; whoever has more takes memory for them.
  static constexpr std::size_t usual_contacts = 8;

  /// The same of all that one vehicle looks at, of `count` that there are.
  static constexpr std::size_t usual_room(std::size_t count) { return std::min<std::size_t>(count, 128); }

  /// `reach` is how far the metrics usually look [m].
  explicit Neighbours(double reach) : vicinity_{{.least = reach, .usual_count = 5.0, .margin_ratio = 0.2}} {}

  /// Takes the next frame, of the same vehicles; its crew shares the work.
  const Neighbours& of(const Frame& frame) {
    const auto place_of = [&](std::size_t i) { return frame.vehicles[i].state.p_n; };
    vicinity_.update(frame.vehicles.size(), place_of, frame.crew);
    return *this;
  }

  /// Makes `found` all those whose squared distance from vehicle `index` is at most that of `reach` [m], in
  /// no order; nobody where that is negative.
  void find(std::size_t index, double reach, std::vector<Neighbour>& found) const {
    found.clear();
    if (reach < 0.0) return;
    visit(index, reach, [&](std::size_t other, double distance2) {
      found.push_back({static_cast<std::uint32_t>(other), distance2});
    });
  }

  /// Calls `visit(other, distance2)` for each other vehicle whose squared distance from vehicle `index` [m2]
  /// is at most that of `reach` [m], in no order.
  template <class Visit>
  void visit(std::size_t index, double reach, const Visit& visit) const {
    vicinity_.visit_others(index, vicinity_.place(index), reach, visit);
  }

  /// A distance within which there is another vehicle; infinite if there is none.
  double reach_of_one(std::size_t index) const {
    return vicinity_.reach_of(1, index, vicinity_.place(index));
  }

 private:
  Vicinity vicinity_;
};

}  // namespace fairway
