// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/core/ids.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// How a vehicle gets on. Progress is judged over a window: a vehicle makes none if in all of it it has
/// neither come nearer to its goal than ever before nor to a place where it has not just been, each by at
/// least a tenth of the way that it would cruise in the window.
enum class Headway : std::uint8_t {
  making,   ///< it has, within the last window
  holding,  ///< it is not meant to go anywhere: it has arrived, deploys, or was told to keep its place
  waiting,  ///< it makes none, and somebody near still moves on; or its method holds on purpose (Mode::hold)
            ///< and nobody is near
  deadlocked,  ///< it makes none, and whoever is near and could clear the way has not moved on for a window
  trapped,  ///< it makes none, and nobody is near who could clear the way: obstacles, whoever has arrived and
            ///< stays, the water, or nothing but its method
};

template <>
struct EnumNames<Headway> {
  static constexpr std::array names{"making", "holding", "waiting", "deadlocked", "trapped"};
};

/// "no progress: deadlocked with somebody who is at rest as well", empty while there is progress or none is
/// meant. Text that outlives the program's run.
std::string_view note_of(Headway headway) noexcept;

/// Where something has been of late. A place is a ball; it counts as new again to whoever has not been in it
/// for one and a half windows, so that a way back out of a blind alley is progress, while going to and fro,
/// or round and round, in less than that is none; nor is what it creeps, less than a place in a window. Of
/// places it remembers the last 32. A value, O(1) while it stays in a ball.
class Trail {
 public:
  /// At cruising speed a window and a half is 15 steps; whoever is twice as fast still fits.
  static constexpr std::size_t most_places = 32;
  static constexpr std::size_t usual_places = 16;

  /// Has memory for `room` places: `usual_places` are enough for who goes no faster than it cruises. With
  /// less than `most_places` whoever needs more takes it, once; with that nothing allocates but a copy.
  explicit Trail(std::size_t room) : rooms_(room - 1) { forget(); }
  Trail() : Trail{most_places} {}

  /// It is at `position` [m, NED] at `time` [s]; places have the radius `step` [m]. True if this one is new.
  bool see(double time, const Vec3& position, double step, double window) noexcept;

  /// When it last came to a new place [s]; minus infinity before the first.
  double since() const noexcept { return since_; }

  /// Is as one that has been nowhere yet, with the memory that it has.
  void forget() noexcept;

 private:
  struct Place {
    Vec3 position = Vec3::Zero();
    double seen{-std::numeric_limits<double>::infinity()};  // when it was last there
  };

  static constexpr std::uint8_t none = most_places;

  template <class IsRecent>
  void leave_for(std::uint8_t next, const IsRecent& is_recent) noexcept;

  Place here_;
  double entered_{};  // since when it is here
  double since_{};
  std::vector<Place> rooms_;                       // of the other places
  std::array<std::uint8_t, most_places> room_of_;  // of each place; none: it is here, or too long ago
  std::uint8_t present_{};                         // which place is here
  std::uint8_t newest_{};                          // made last; the next one replaces the one after it
};

/// Somebody else, as far as progress is concerned.
struct Bystander {
  TrackId id{};
  double gap{};              ///< between the two spheres [m]
  double rests_since{};      ///< when it last came to a new place [s]
  bool may_clear_way{true};  ///< false: if it is at rest it stays, as whoever has arrived does
};

/// What a watch has found.
struct ProgressReport {
  Headway state{Headway::holding};
  double last_progress{};  ///< when it last made some [s]; while holding: now
  double since{};  ///< of `deadlocked`: when the last of those in it came to rest; else `last_progress`
  std::optional<TrackId> with{};  ///< the nearest of those that it waits for, or is deadlocked with
};

/// Watches one vehicle's progress: `see()` at every instant, then `judge()`. A value; nothing throws, and
/// with a trail that has room for all of its places nothing allocates but a copy. What it cannot tell: a way
/// back to where it was, or a drift, that is faster than a tenth of cruising speed counts as progress, and so
/// does a round of more than a window and a half.
class ProgressWatch {
 public:
  /// `window` [s]; `trail` is of somebody who has been nowhere yet.
  explicit ProgressWatch(double window = 30.0, Trail trail = Trail{})
      : window_{window}, trail_{std::move(trail)} {}

  /// It is at `position` [m, NED] at `time` [s], and is meant to go to `goal.position` at
  /// `goal.cruise_speed`, if `under_way`.
  void see(double time, const Vec3& position, const Goal& goal, bool under_way) noexcept;

  /// Whether the last window has passed without progress: only then does it matter who is near.
  bool is_late() const noexcept { return under_way_ && time_ - last_progress_ > window_; }

  /// A place's radius, and the least way that counts: a tenth of what it cruises in a window [m].
  double step() const noexcept { return step_; }

  /// Bystanders matter that are no farther than a third of the way that it would cruise in a window [m].
  double reach() const noexcept;

  /// How it gets on, as of the last instant seen. `mode` is that of its command. O(bystanders).
  ProgressReport judge(Mode mode, std::span<const Bystander> bystanders) const noexcept;

  const Trail& trail() const noexcept { return trail_; }

  /// Is as one that has seen nothing yet, with the memory that it has.
  void forget() noexcept;

 private:
  double window_;
  double time_{};
  double step_{1.0};  // [m]; that of the first goal is not known before it
  double last_progress_{};
  double least_distance_{};  // to the goal, that counted as progress [m]
  double nearer_at_{};       // when that was set
  Vec3 goal_ = Vec3::Zero();
  bool under_way_{false};
  Trail trail_;
};

}  // namespace fairway
