// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fairway/avoidance/avoa/velocity_grid.hpp"
#include "fairway/core/params.hpp"

namespace fairway {

/// What "imminent" is measured with.
enum class TimeToContact {
  bound,  ///< d_m / |v_A - v_B|, never more than the time to contact (campos2019, eq. 2)
  exact,  ///< when the ray meets the disc
};

template <>
struct EnumNames<TimeToContact> {
  static constexpr std::array names{"bound", "exact"};
};

}  // namespace fairway

namespace fairway::avoa {

/// An obstacle grown by own ship, B + A, as seen from her: axes ahead and to starboard.
struct MovingDisc {
  Vec2 position = Vec2::Zero();  ///< of its centre, p_B - p_A [m]
  double radius{};               ///< r_A + r_B and the margin [m]
  Vec2 velocity = Vec2::Zero();  ///< over ground [m/s]
  Vec2 inward = Vec2::UnitX();   ///< where its centre is taken to be if it is exactly here; unit
};

/// The velocities that lead to a collision within the window, PZ \ PZ_H of all discs together (campos2019,
/// eqs. 1 and 2), cell by cell: v is forbidden if the ray from here along v - v_B meets the disc and the time
/// to contact is at most the window. A disc that covers own position forbids what leads further in, (v - v_B)
/// towards its centre, and nothing else.
class ProtectiveZones {
 public:
  /// Allocates only when the grid grows. O(cells)
  void clear(const VelocityGrid& grid);

  /// Row by row: two half-planes and a disc are one or two intervals of a row. O(side + cells forbidden), and
  /// O(1) for a disc that no velocity of the grid meets within the window.
  void add(const MovingDisc& disc, double window, TimeToContact contact);

  /// No disc at all has forbidden a cell.
  bool empty() const { return empty_; }
  /// 1 where forbidden, one number per cell.
  const std::vector<std::uint8_t>& forbidden() const { return forbidden_; }
  const VelocityGrid& grid() const { return grid_; }

 private:
  void forbid(int row, int from, int to);

  VelocityGrid grid_;
  std::vector<std::uint8_t> forbidden_;
  bool empty_ = true;
};

}  // namespace fairway::avoa
