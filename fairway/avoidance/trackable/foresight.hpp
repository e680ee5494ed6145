// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "fairway/avoidance/nearest_few.hpp"
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

inline constexpr double least_drift = 0.005;  ///< slower is none [m/s]

/// Vertical speed that it may gain unasked, of the greatest speed ahead.
inline constexpr double unasked_climb = 0.1;

/// What a foresight looks at.
struct Outlook {
  double hold{};              ///< how long a plan is kept until its backup begins [s]
  double window{};            ///< how far ahead all looks [s]
  double margin{};            ///< kept to every surface [m]
  Vec2 drift = Vec2::Zero();  ///< what sets it aside [m/s, NED]
  bool is_set_aside{};  ///< by that, on and on: what is clear to the end of the window may not be beyond
  Vec2 frame = Vec2::Zero();  ///< plans are of velocities relative to this one [m/s, NED]
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
/// keeps its velocity. Of a vehicle with a least speed all of that is relative to the water (`frame`),
/// through which that speed is. A plan is clear if nothing comes nearer than the margin, between steps
/// either; where that is lost already, nothing comes nearer by more than a tenth of what is left of it, and
/// nothing is met between steps. Where more is near than there is room for, the nearest tracks count, and
/// what is nearest besides. The backup of a vehicle that can stop is to stop, its bow up into what sets it
/// aside; of one that cannot it is to go round in a circle, to either side.
class Foresight {
 public:
  /// `law` must outlive it. The bow points `ahead`. O(solids).
  Foresight(const TurnLaw& law, const Situation& s, const Vec2& ahead, const Outlook& outlook) noexcept;

  /// Nothing can come near within the window.
  bool is_open() const noexcept { return places_.count() == 0; }
  /// More can come near within the window than is looked at.
  bool left_out() const noexcept { return places_.left_out(); }
  /// Nine tenths of the way to the nearest surface; infinite where nothing is near [m].
  double room_now() const noexcept { return room_now_; }
  /// Into how many the window is divided, and how long each is [s].
  std::size_t steps() const noexcept { return steps_; }
  double step() const noexcept { return response_.step; }

  /// Vertical velocities, downwards positive, at which it does not come upon what it is just above or below,
  /// and passes [m/s].
  double held_to_depths(double sinking) const noexcept {
    return std::max(-most_rising_, std::min(most_sinking_, sinking));
  }

  /// By the law or by `turn_rate`, whether nothing comes nearer than the margin on the whole window, or on
  /// that of who stops after so many steps. `quickest` [m/s] is the speed of the quickest plan among which it
  /// is chosen. O(steps x hazards).
  bool is_clear(const Plan& plan, double quickest, std::size_t stops_after = most_steps) const noexcept;
  /// For how many steps nothing comes nearer than the margin. Likewise.
  std::size_t clear_steps(const Plan& plan, double quickest) const noexcept;
  /// Clear, and of who is set aside backed up besides, but for what goes along: beyond the window it may be
  /// set on something.
  bool is_safe(const Plan& plan) const noexcept;

  /// One of many plans.
  struct Pick {
    std::size_t at;  ///< as many as there are plans: the turn rate that was asked for
    Prospect prospect;
  };
  /// What was asked for, if it is a turn rate, or else the first of `count` courses that is clear, and of who
  /// is set aside backed up besides, but for what goes along; else the first that is backed up; else that
  /// turn rate, or the first course, if it is clear; else, of what leaves nearly as much room as anything,
  /// what has most at the end, and of who cannot stop, of what is clear for longest, what leaves most room.
  /// O(courses x steps x hazards).
  Pick best_of(const Plan& asked, const Courses& courses, std::size_t count) const noexcept;

  /// Least distances beyond contact. [m]
  struct Room {
    double least;  ///< after any of the steps
    double last;   ///< at the end of the window
  };
  Room room_of(const Plan& plan) const noexcept;
  /// Whether a room is at least three quarters of `most`, or of an overlap no larger [m]. Of who cannot stop
  /// it is all of it: it passes what it gives way to, and would give away a quarter more at each decision.
  bool is_nearly(double room, double most) const noexcept {
    return room >= (most > 0.0 && !cannot_stop() ? 0.75 * most : most);
  }
  bool cannot_stop() const noexcept { return response_.law.least > 0.0; }
  bool is_set_aside() const noexcept { return outlook_.is_set_aside; }
  /// Nothing that is near moves.
  bool all_stand() const noexcept;

  /// To stand over ground: the bow up into what sets it aside, since it cannot go sideways against that, or
  /// `ahead`.
  Plan standing(const Vec2& ahead) const noexcept;
  /// Where the bow has to point. [unit, NED]
  Vec2 bow(const Plan& plan) const noexcept;

  /// What the autopilot is ordered now.
  TurnOrder order(const Plan& plan) const noexcept;

  /// Where the vehicle is after each step, over ground. [m]
  struct Path {
    std::array<Vec2, most_steps> points;
    std::size_t count;
  };
  Path path(const Plan& plan) const noexcept;

 private:
  /// What a bound on the speed says of each hazard.
  struct Bounds {
    std::array<double, most_hazards> near2;             ///< this near after a step is too near, squared [m2]
    std::array<std::size_t, most_hazards> first_steps;  ///< none comes near before so many are over
    std::array<double, most_hazards> within2;           ///< nor this near within a step; 0: it cannot [m2]
    bool any_within = false;                            ///< is not 0
  };
  /// One plan, step by step.
  struct Way;
  /// Several plans and what has been found out of them, in the order of the plans.
  struct Search;

  void divide_window() noexcept;
  void add(const Vec2& from, const Vec2& to, double radius, const Vec2& velocity) noexcept;
  /// Of the way, for every plan of no more than `speed` and `turn_rate`. [m/s]
  double fastest_way(double speed, double turn_rate) const noexcept;
  Bounds bounds(double speed, double turn_rate) const noexcept;
  /// Whether a hazard goes faster than the drift, and own ship with it rather than against it: beside that
  /// own ship could keep pace for ever.
  bool goes_along(std::size_t hazard) const noexcept;
  Bounds without_what_goes_along(Bounds all) const noexcept;
  /// Whether it may be set on something else beyond the window.
  bool needs_backup() const noexcept;
  std::size_t clear_steps(const Plan& plan, const Bounds& of, std::size_t stops_after) const noexcept;

  const TurnLaw& law_;
  Outlook outlook_;
  double own_radius_;
  Response response_;
  std::size_t steps_{}, hold_steps_{};
  double reach_;
  double room_now_;
  double most_sinking_ = std::numeric_limits<double>::infinity();
  double most_rising_ = std::numeric_limits<double>::infinity();
  Motion<double> now_;
  Vec2 velocity_;  // [m/s]
  std::array<Hazard, most_hazards> hazards_;
  std::array<double, most_hazards> distances_;  // from the middle line now [m]
  std::array<double, most_hazards> left_;       // what may be left of that at least, where the margin is lost
  std::array<double, most_hazards> speeds_;
  NearestFew<most_hazards> places_;
};

}  // namespace fairway::trackable
