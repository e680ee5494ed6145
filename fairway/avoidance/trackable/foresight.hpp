// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/trackable/turn_law.hpp"

namespace fairway::trackable {

/// A course and a speed to keep to, or a turn rate.
struct Plan {
  Vec2 direction = Vec2::UnitX();   ///< unit, to be made good [NED]
  double speed{};                   ///< along the heading once that is reached [m/s]
  std::optional<double> turn_rate;  ///< instead of a course [rad/s]
};

/// To stand over ground: with the bow up into what sets it aside, since it cannot go sideways against that.
Plan standing_still(const Vec2& ahead, const Vec2& drift) noexcept;

/// Vertical speed that it may gain unasked, of the greatest speed ahead.
inline constexpr double unasked_climb = 0.1;

/// What a foresight looks at.
struct Outlook {
  double hold{};              ///< how long a plan is kept until its backup begins [s]
  double window{};            ///< how far ahead all looks [s]
  double margin{};            ///< kept to every surface [m]
  Vec2 drift = Vec2::Zero();  ///< of the water, as far as it sets across the heading [m/s, NED]
  double climb{};             ///< greatest vertical speed that is commanded [m/s]
};

/// What a plan comes to.
enum class Prospect : std::uint8_t {
  lost,       ///< neither
  backed_up,  ///< clear if the backup begins after `hold`
  clear,      ///< clear to the end of the window
};

/// What a vehicle does that is told a plan, as its envelope says: turn rate and speed approach what the law
/// orders by first-order lags, within the accelerations, and the hull slips about its pivot. All that is near
/// keeps its velocity. A plan is clear if nothing comes nearer than the margin; where the margin is lost
/// already, nothing comes nearer by more than a tenth of what is left of it. The backup of a vehicle that can
/// stop is to stop, its bow up into the drift; of one that cannot it is to go round in a circle, to either
/// side.
class Foresight {
 public:
  static constexpr std::size_t steps = 48;
  static constexpr std::size_t most_hazards = 64;

  /// `law` must outlive it. O(solids).
  Foresight(const TurnLaw& law, const Situation& s, const Outlook& outlook) noexcept;

  /// Nothing can come near within the window.
  bool is_open() const noexcept { return count_ == 0; }
  /// Nine tenths of the way to the nearest surface; infinite where nothing is near [m].
  double room_now() const noexcept { return room_now_; }

  /// Vertical velocities, downwards positive, at which it does not come upon what it is just above or below,
  /// and passes [m/s].
  double held_to_depths(double sinking) const noexcept {
    return std::max(-most_rising_, std::min(most_sinking_, sinking));
  }

  /// What the plan comes to; one that is not clear is `lost` where no backup is sought. O(steps x hazards).
  Prospect of(const Plan& plan, bool seeks_backup = true) const noexcept;
  /// The least distance that the plan leaves beyond contact on the whole window [m]; of a plan that leaves no
  /// more than `too_little`, something that is no more than that. Likewise.
  double room_of(const Plan& plan, double too_little) const noexcept;
  /// What the autopilot is ordered now.
  TurnOrder order(const Plan& plan) const noexcept;
  /// Where the vehicle is after each step. [m]
  std::array<Vec2, steps> path(const Plan& plan) const noexcept;

 private:
  struct Hazard {
    Vec2 from, to;  // of its middle line, relative to own ship
    Vec2 velocity;
    double contact;  // own radius and its own [m]
    double keep;     // from the middle line, squared [m2]
    bool is_disc;
  };
  struct Motion {
    Vec2 position = Vec2::Zero();
    Vec2 ahead;  // unit
    double turn_rate;
    double speed;
    double sway;
    double error{};  // from the heading to that of the plan [rad]
  };

  void add(const Vec2& from, const Vec2& to, double radius, const Vec2& velocity) noexcept;
  bool is_kept(const Vec2& position, double time) const noexcept;
  /// Towards where the heading has to point for the direction to be made good.
  Vec2 heading_for(const Plan& plan) const noexcept;
  void advance(Motion& m, const TurnOrder& order) const noexcept;
  /// Follows the plan for one step; `heading` is its heading_for(), and `m.error` the way there.
  void follow(Motion& m, const Plan& plan, const Vec2& heading) const noexcept;
  /// `m` is where the plan was given up.
  bool stops(Motion m) const noexcept;
  bool circles(Motion m, double turn_rate) const noexcept;

  const TurnLaw& law_;
  Outlook outlook_;
  double own_radius_;
  double step_;
  double turn_share_, surge_share_, sway_share_;  // of the way to what is ordered, gone in a step
  double most_turn_, most_faster_, most_slower_;  // by which turn rate and speed change in a step
  std::size_t hold_steps_;
  double reach_;
  double room_now_;
  double most_sinking_ = std::numeric_limits<double>::infinity();
  double most_rising_ = std::numeric_limits<double>::infinity();
  Motion now_;
  std::array<Hazard, most_hazards> hazards_;
  std::size_t count_ = 0;
};

}  // namespace fairway::trackable
