// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "fairway/avoidance/situation.hpp"
#include "fairway/avoidance/trackable/fan.hpp"
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
  static constexpr std::size_t steps = foresight_steps;
  static constexpr std::size_t most_plans = 80;

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

  /// Whether nothing comes nearer than the margin on the whole window. O(steps x hazards).
  bool is_clear(const Plan& plan) const noexcept;

  /// One of many plans.
  struct Pick {
    std::size_t at;  ///< as many as there are plans: the one that was asked for
    Prospect prospect;
  };
  /// The first of the plans that is clear; else the first that is backed up; else the one that leaves most
  /// room, the one that was asked for among them, which is known not to be clear. All are for a course, and
  /// at most `most_plans`. O(plans x steps x hazards).
  Pick best_of(const Plan& asked, std::span<const Plan> plans) const noexcept;

  /// What the autopilot is ordered now.
  TurnOrder order(const Plan& plan) const noexcept;
  /// Where the vehicle is after each step. [m]
  std::array<Vec2, steps> path(const Plan& plan) const noexcept;

 private:
  /// Several plans and what has been found out of them, in the order of the plans.
  struct Search;

  void add(const Vec2& from, const Vec2& to, double radius, const Vec2& velocity) noexcept;
  /// Towards where the heading has to point for the direction to be made good.
  Vec2 heading_for(const Plan& plan) const noexcept;
  /// Follows the plan for one step; `heading` is its heading_for(), and `m.error` the way there.
  void follow(Motion<double>& m, const Plan& plan, const Vec2& heading) const noexcept;
  Motion<double> start_of(const Vec2& heading) const noexcept;
  /// Of the way, a bound for every plan of no more than `speed` and `turn_rate`. [m/s]
  double fastest_way(double speed, double turn_rate) const noexcept;
  /// Of a hazard: so many steps are over before any plan whose way is no faster comes near.
  std::size_t first_step(std::size_t hazard, double fastest) const noexcept;
  /// The least distance beyond contact that the plan leaves, which is not clear. [m]
  double room_of(const Plan& plan) const noexcept;

  const TurnLaw& law_;
  Outlook outlook_;
  double own_radius_;
  Response response_;
  std::size_t hold_steps_;
  double reach_;
  double room_now_;
  double most_sinking_ = std::numeric_limits<double>::infinity();
  double most_rising_ = std::numeric_limits<double>::infinity();
  Motion<double> now_;
  std::array<Hazard, most_hazards> hazards_;
  std::array<double, most_hazards> keep2_;  // from the middle line, squared [m2]
  std::array<double, most_hazards> spare_;  // way to what is nearer than the margin [m]
  std::array<double, most_hazards> speeds_;
  std::size_t count_ = 0;
};

}  // namespace fairway::trackable
